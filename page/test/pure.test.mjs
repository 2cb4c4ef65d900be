// The parts of the page that draw nothing.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { linearNames, logNames, logTicks } from "../src/plots/axes.js";
import { bonds, Cell } from "../src/spheres/cell.js";
import { grouped, pairName, power, short, uncertain } from "../src/shared/format.js";
import { groupsOf, unwrapped } from "../src/spheres/groups.js";
import { averageRows, curvesOf } from "../src/run/average_rows.js";
import { Log, Stretch } from "../src/run/log.js";
import { besideOutline } from "../src/spheres/names.js";
import { pairsPlot } from "../src/plots/pairs_plot.js";
import { csv, fileStem } from "../src/shared/save.js";
import { Selection, wantedRange } from "../src/run/selection.js";
import { findingQuestions, QUESTIONS, share, wilson } from "../src/sweep/statistics.js";
import { SvgContext } from "../src/plots/svg_context.js";
import { axisName, symbol } from "../src/sweep/symbols.js";
import { caseText } from "../src/sweep/sweep_runs.js";
import { sentence } from "../src/run/verdict.js";

describe("numbers", () => {
  test("are written in few digits, with powers of ten where they are far from one", () => {
    assert.equal(short(0.123456), "0.1235");
    assert.equal(short(1e-16), "10\u207b\u00b9\u2076");
    assert.equal(short(-2.5e-7, 2), "\u22122.5\u00b710\u207b\u2077");
    assert.equal(short(0), "0");
    assert.equal(short(null), "\u2013");
    assert.equal(power(12), "10\u00b9\u00b2");
    assert.equal(grouped(1234567), "1\u202f234\u202f567");
  });

  test("carry their errors as physicists write them, as the program's texts do", () => {
    assert.equal(uncertain(1.1394, 0.0021), "1.139(2)");
    assert.equal(uncertain(1.1394, 0.0012), "1.1394(12)");
    assert.equal(uncertain(-0.5, 0.04), "\u22120.50(4)");
    assert.equal(uncertain(2.5e-7, 3e-9), "2.50(3)\u00b710\u207b\u2077");
    assert.equal(uncertain(123456, 2000), "1.23(2)\u00b710\u2075");
    assert.equal(uncertain(1.5, null), "1.5");
    assert.equal(uncertain(1.5, 0), "1.5");
    assert.equal(uncertain(null, null), "\u2013");
  });

  test("a partner beyond the spheres is a wall", () => {
    assert.equal(pairName([3, 9], 10), "3\u20139");
    assert.equal(pairName([3, 10], 10), "3\u2013lower wall");
    assert.equal(pairName([3, 11], 10), "3\u2013upper wall");
  });
});

describe("axes", () => {
  test("a logarithmic axis has at least two ticks, however short it is", () => {
    assert.deepEqual(logTicks(0.5e-3, 2), [1e-3, 1e-2, 1e-1, 1]);
    assert.deepEqual(logTicks(6e-3, 0.03), [0.01, 0.02]); // one decade alone
    assert.deepEqual(logTicks(2.1, 5.37), [3, 4, 5]); // none, and one of 1, 2, 5
    for (let low = 1e-3; low < 1; low *= 1.07) {
      for (const ratio of [1.02, 1.6, 2.56, 7, 40]) {
        const ticks = logTicks(low, low * ratio);
        assert.ok(ticks.length >= 2 && ticks.length <= 12, `${low} ${ratio}: ${ticks}`);
        assert.ok(ticks.every((y) => y >= low * 0.999999 && y <= low * ratio * 1.000001));
      }
    }
  });

  test("ticks are powers of ten where all of them are, and numbers elsewhere", () => {
    assert.deepEqual(logNames([1e-3, 1e-2]), ["10\u207b\u00b3", "10\u207b\u00b2"]);
    assert.deepEqual(logNames([0.01, 0.02]), ["0.01", "0.02"]);
  });

  test("linear ticks are written with all the decimals of their step", () => {
    assert.deepEqual(linearNames([0, 0.25, 0.5], 0.25), ["0.00", "0.25", "0.50"]);
    assert.deepEqual(linearNames([0, 0.2], 0.2), ["0.0", "0.2"]);
  });
});

describe("the name of an axis", () => {
  const square = (x, y) => [
    [
      [0, 0],
      [x, y],
    ],
    [
      [100, 100],
      [100 + x, 100 + y],
    ],
  ];

  test("is beside the outermost edge, outside", () => {
    assert.deepEqual(besideOutline(square(100, 0), [100, 50], 9), { x: 150, y: 109, angle: 0 });
    const upright = besideOutline(square(0, 100), [50, 100], 9);
    assert.deepEqual([upright.x, upright.y, Math.abs(upright.angle)], [-9, 50, Math.PI / 2]);
  });

  test("is left out where the axis points at the viewer", () => {
    assert.equal(besideOutline(square(3, 3), [50, 50], 9), null);
  });
});

/** A stretch of rows from number `first` on, with gaps of 1 but for `odd` {k: gap}. */
function stretch(first, rows, width, odd) {
  const bins = Math.ceil(rows / width);
  const columns = {
    k: [],
    time: [],
    gap_low: [],
    gap_high: [],
    speed_low: [],
    speed_high: [],
    flight_low: [],
    flight_high: [],
    flags: [],
    hits: [],
    i: [],
    j: [],
  };
  for (let bin = 0; bin < bins; ++bin) {
    const begin = first + bin * width,
      end = Math.min(begin + width, first + rows);
    const gaps = Array.from({ length: end - begin }, (_, n) => odd[begin + n] ?? 1);
    const values = {
      k: begin,
      time: end,
      gap_low: Math.min(...gaps),
      gap_high: Math.max(...gaps),
      speed_low: 1,
      speed_high: 1,
      flight_low: bin === 70 ? 0 : 1,
      flight_high: bin === 70 ? 3 : 1,
      flags: gaps.some((gap) => gap < 1e-16) ? 1 : 0,
      hits: gaps.filter((gap) => gap < 1e-16).length,
      i: 1,
      j: 2,
    };
    for (const [name, value] of Object.entries(values)) columns[name].push(value);
  }
  return new Stretch(
    { name: "log", width, bins, last: first + rows - 1 },
    (name) => columns[name.split(".")[1]],
  );
}

describe("a log", () => {
  const odd = { 777: 1e-17, 5001: 40 };
  const log = new Log([stretch(1, 10007, 10, odd), stretch(500, 600, 1, odd)]);

  test("keeps extremes and hits at every zoom", () => {
    for (const entries of [1, 7, 100, 5000]) {
      const view = log.view(1, 10007, entries);
      assert.equal(Math.min(...view.gapLow), 1e-17);
      assert.equal(Math.max(...view.gapHigh), 40);
      assert.equal(
        view.hits.reduce((a, b) => a + b),
        1,
      );
      assert.equal(
        view.count.reduce((a, b) => a + b),
        10007,
      );
      assert.ok(view.size <= Math.max(entries, 1) + 1);
    }
  });

  test("is shown row by row where rows are kept", () => {
    const view = log.view(770, 790, 100);
    assert.equal(view.width, 1);
    assert.deepEqual([...view.k.subarray(0, 3)], [770, 771, 772]);
    assert.equal(view.gapLow[7], 1e-17);
    assert.equal(log.view(400, 600, 1000).width, 10);
  });

  test("tells the extremes of the time per collision", () => {
    const view = log.view(770, 790, 100);
    assert.ok([...view.flightLow, ...view.flightHigh].every((flight) => flight === 1));
  });

  test("keeps the extremes of the time per collision within its bins", () => {
    const view = log.view(1, 10007, 7);
    assert.equal(Math.min(...view.flightLow), 0);
    assert.equal(Math.max(...view.flightHigh), 3);
  });

  test("loses no collision at which the clock stands still among others", () => {
    const still = stretch(1, 100, 1, {});
    still.time[49] = still.time[48]; // no time for this one, two for the next
    const view = new Log([still]).view(1, 100, 10);
    assert.equal(Math.min(...view.flightLow.subarray(1)), 0);
    assert.equal(Math.max(...view.flightHigh.subarray(1)), 2);
  });
});

describe("a selection", () => {
  test("stays inside the log", () => {
    const selection = new Selection(1, 1000);
    selection.set(-50, 100);
    assert.deepEqual([selection.first, selection.last], [1, 100]);
    selection.set(990, 2000);
    assert.equal(selection.last, 1000);
    selection.set(500, 400);
    assert.deepEqual([selection.first, selection.last], [400, 500]);
    selection.set(NaN, 3);
    assert.deepEqual([selection.first, selection.last], [400, 500]);
    selection.set(3, 3);
    assert.deepEqual([selection.first, selection.last], [3, 3 + Selection.narrowest]);
    selection.reset();
    selection.zoom(0.5, 1000);
    assert.deepEqual([selection.first, selection.last], [501, 1000]);
    selection.pan(-1);
    assert.deepEqual([selection.first, selection.last], [2, 501]);
  });
});

describe("a range that is typed", () => {
  const selection = new Selection(1, 12513);
  const range = (texts, changed) => {
    const { first, last, why } = wantedRange(selection, texts, changed);
    return [first, last, why];
  };

  test("is shown where the log has it", () => {
    assert.deepEqual(range(["100", "300"], 1), [100, 300, ""]);
  });

  test("that the log does not have is refused with the reason", () => {
    assert.deepEqual(range(["999999", "12513"], 0), [
      1,
      12513,
      "There is no collision 999\u202f999: the log ends at 12\u202f513; the range is as it was.",
    ]);
    assert.match(range(["1", "0"], 1)[2], /no collision 0: the log begins at 1;/);
    for (const text of ["", " ", "1e", "2.5"])
      assert.match(range([text, "9"], 0)[2], /whole number/);
  });

  test("whose ends have crossed moves its other end and says so", () => {
    selection.set(100, 200);
    assert.deepEqual(range(["5000", "200"], 0), [
      5000,
      5100,
      "A range ends after it begins: its other end was moved too.",
    ]);
    assert.deepEqual(range(["100", "50"], 1).slice(0, 2), [1, 101]);
    assert.deepEqual(range(["12500", "200"], 0).slice(0, 2), [12413, 12513]);
    assert.deepEqual(range(["100", "102"], 1).slice(0, 2), [94, 102]);
    selection.reset();
  });

  test("of times is not rounded", () => {
    const times = Selection.ofTime(0, 0.6);
    times.set(0.1, 0.25);
    assert.deepEqual([times.first, times.last], [0.1, 0.25]);
    assert.ok(Selection.ofTime(2, 2).last > 2);
  });
});

describe("the pairs that collide", () => {
  const run = { spheres: 10 };
  const view = (stretch) => () => ({ stretch, begin: 0, group: 1, size: stretch.size });

  test("of a binned log are those of the whole log", () => {
    const pairs = [
      [1, 2, 50],
      [3, 10, 40],
    ];
    const hit = (row) => (1 << row) | (1 << (row + 11));
    const stretch = {
      pairs,
      pairMask: [1 | hit(1), 1 << 10],
      k: Float64Array.of(1, 31),
      size: 2,
      last: 60,
    };
    const plot = pairsPlot(run, view(stretch));
    assert.deepEqual([...plot.take(1, 60, 100).x], [1, 31]);
    assert.deepEqual(plot.rows(), ["1\u20132", "3\u2013lower wall", "others"]);
    assert.equal(plot.read(0), "collisions 1\u201330: 1\u20132, 3\u2013lower wall");
    assert.equal(plot.read(1), "collisions 31\u201360: others");
    assert.deepEqual(plot.numbers(1, 60), [
      ["first_collision", "last_collision", "1-2", "3-10", "others"],
      [
        [1, 30, 1, 2, 0],
        [31, 60, 0, 0, 1],
      ],
    ]);
  });

  test("of eleven pairs each has a row, of twelve two are the others", () => {
    const rows = (count) => {
      const i = Int32Array.from({ length: count }, (_, n) => n);
      const k = Float64Array.from(i, (n) => n + 1);
      const stretch = { i, j: i.map((n) => n + 1), flags: i, k, size: count, last: count };
      const plot = pairsPlot({ spheres: 100 }, view(stretch));
      plot.take(1, count, 100);
      return plot.rows();
    };
    assert.equal(rows(11).at(-1), "10\u201311");
    assert.equal(rows(12).at(-1), "2 others");
  });
});

describe("files that are saved", () => {
  test("hold all digits of a number, and nothing where there is none", () => {
    const rows = [[1, 0.1 + 0.2, NaN, null, 'a "b", c']];
    assert.equal(
      csv(["k", "gap", "x", "y", "text"], rows),
      'k,gap,x,y,text\n1,0.30000000000000004,,,"a ""b"", c"\n',
    );
    assert.equal(fileStem("a/b <c>.h5", "gap"), "a_b_c_-gap");
  });

  test("SVG says what a canvas would show, and no text in it acts as markup", () => {
    const ctx = new SvgContext(200, 100, (_, text) => 7 * text.length);
    ctx.save();
    ctx.translate(0, 30);
    ctx.rect(0, 0, 50, 50);
    ctx.clip();
    ctx.fillStyle = "#123456";
    ctx.fillRect(1, 2, 3, 4);
    ctx.fillRect(5, 6, 7, 8);
    ctx.restore();
    ctx.font = "600 13px sans-serif";
    ctx.fillText('<b> & "c"', 8, 20);
    const text = ctx.toString();
    assert.match(
      text,
      /<clipPath id="clip1"><path d="M0 0h50v50h-50Z" transform="translate\(0 30\)"/,
    );
    assert.match(text, /d="M1 2h3v4h-3ZM5 6h7v8h-7Z" fill="#123456" transform="translate\(0 30\)"/);
    assert.match(
      text,
      /font-size="13" font-weight="600"[^>]*fill="#000">&#60;b&#62; &#38; &#34;c&#34;</,
    );
    assert.equal(ctx.measureText("abc").width, 21);
  });
});

describe("a sheared cell", () => {
  const cell = new Cell([10, 0, 0, 4, 10, 0, 0, 0, 10], 3, null);

  test("takes a position into its slanted sides", () => {
    assert.deepEqual(cell.slant([1, 5, 3]), [11, 5, 3]); // the left side is at x = 2 there
    assert.deepEqual(cell.slant([3, 5, 3]), [3, 5, 3]);
  });

  test("finds the nearest image through the sheared face, with its offset", () => {
    // From y = 0.2 down to y = 9.8: the image below lies 4 to the left.
    const [x, y, z] = cell.difference([1, 0.2, 5], [5.1, 9.8, 5]);
    assert.ok(Math.abs(x - 0.1) < 1e-12 && Math.abs(y + 0.4) < 1e-12 && z === 0, `${x} ${y} ${z}`);
  });

  test("draws a contact through a face at both of its ends", () => {
    const at = (n) =>
      [
        [0.2, 5, 5],
        [9.7, 5, 5],
        [5, 5, 5],
      ][n];
    const lines = bonds(
      cell,
      at,
      [
        [0, 1, 9],
        [0, 2, 3],
        [1, 7, 3],
      ],
      3,
    );
    assert.equal(lines.length, 2); // 0-2 is too far apart, 7 is a wall
    assert.ok(Math.abs(lines[0][1][0] + 0.3) < 1e-12);
    assert.ok(Math.abs(lines[1][0][0] - 10.2) < 1e-12);
  });

  test("a row that goes through a face is put together again", () => {
    const at = (n) =>
      [
        [9.7, 5, 5],
        [0.7, 5, 5],
        [1.7, 5, 5],
      ][n];
    const group = {
      spheres: [0, 1, 2],
      contacts: [
        [0, 1],
        [1, 2],
        [2, 3],
      ],
    }; // 3 is a wall
    const places = unwrapped(group, cell, at, 3);
    assert.deepEqual([...places.keys()], [0, 1, 2]);
    assert.ok(Math.abs(places.get(2)[0] - 11.7) < 1e-12);
  });

  test("does not go through walls", () => {
    const walled = new Cell([10, 0, 0, 10], 2, "y");
    assert.deepEqual(walled.difference([5, 1, 0], [5, 9, 0]), [0, 8, 0]);
  });

  test("a long line is folded into rows like a text", () => {
    const line = new Cell([400], 1, null);
    assert.equal(line.rows, 10);
    assert.deepEqual(line.drawn([41, 0, 0]), [1, -3, 0]);
  });
});

describe("a sweep", () => {
  test("gives Wilson's interval of a share", () => {
    // Newcombe, Stat. Med. 17 (1998) 857, table I, method 3, to its four digits.
    for (const [hits, runs, least, most] of [
      [81, 263, 0.2553, 0.3662],
      [15, 148, 0.0624, 0.1605],
      [0, 20, 0, 0.1611],
      [1, 29, 0.0061, 0.1718],
    ]) {
      const { low, high } = wilson(hits, runs);
      assert.ok(
        Math.abs(low - least) < 5.1e-5 && Math.abs(high - most) < 5.1e-5,
        `${hits}/${runs}: ${low} ${high}`,
      );
    }
    assert.equal(wilson(0, 8).low, 0);
    assert.equal(wilson(8, 8).high, 1);
    assert.deepEqual([wilson(0, 0).low, wilson(0, 0).high], [0, 1]);
  });

  const runs = {
    status: ["done", "done", "done", "failed", "pending", "done", "done"],
    outcome: ["collapsed", "finished", "finished", null, null, "interrupted", "finished"],
    verdict: ["true", "temporary", "none", null, null, "open", "open"],
    separation_hits: [5, 9, 0, null, null, 3, 2],
    arrest_met: [1, 0, 0, null, null, 0, 0],
  };
  const counted = (question) => {
    const { hits, runs: asked } = share(runs, [...runs.status.keys()], question);
    return [hits, asked];
  };

  test("counts runs with a result only, and hits that are open apart from those that were left", () => {
    assert.deepEqual(counted(QUESTIONS.hit), [3, 4]);
    assert.deepEqual(counted(QUESTIONS.arrest), [1, 4]);
    assert.deepEqual(counted(QUESTIONS.left), [1, 4]);
    assert.deepEqual(counted(QUESTIONS.open), [1, 4]);
  });

  test("calls no hit false", () => {
    for (const { name } of Object.values(QUESTIONS)) assert.doesNotMatch(name, /false|true/);
  });

  test("asks what hits were of the runs that have been adjudicated", () => {
    assert.deepEqual(findingQuestions(runs), {});
    const found = ["singular", "near-collapse", null, null, null, null, "singular"];
    const questions = findingQuestions({ adjudication_first_finding: found });
    assert.deepEqual(
      Object.values(questions).map(({ name }) => name),
      ["first hits: singular", "first hits: near-collapse"],
    );
    assert.deepEqual(counted(questions["finding-singular"]), [2, 3]);
    assert.deepEqual(counted(questions["finding-near-collapse"]), [1, 3]);
  });

  test("names its axes as the figures do", () => {
    assert.deepEqual(["system.restitution", "system.spheres"].map(symbol), ["e", "N"]);
    assert.equal(axisName("system.solids_volume_fraction"), "Solids volume fraction \u03c6");
    assert.equal(symbol("collision.contact_duration"), "contact duration");
    assert.equal(axisName("collision.overlap"), "collision.overlap");
  });

  test("puts the case of a run together", () => {
    const cases = {
      first: ["a = 1", "seed = 5  # s", "b = 2"],
      points: { 0: {}, 3: { 2: "b = 7" }, 4: ["seed = 1"] },
    };
    assert.equal(
      caseText({ cases }, 3, "9007199254740993"),
      "a = 1\nseed = 9007199254740993  # s\nb = 7",
    );
    assert.equal(caseText({ cases }, 4, "2"), "seed = 2");
  });
});

describe("what is said", () => {
  const run = (summary, values = {}) => ({
    spheres: 10,
    values: { drive: "none", ...values },
    anatomy: {},
    summary: { file: { complete: true }, collisions: 100, ...summary },
  });

  test("names the pairs of an arrest, which is one of the computation", () => {
    const arrest = {
      met: true,
      collision: 90,
      time: 2.5,
      window: 10,
      pairs: [
        [1, 2],
        [3, 4],
      ],
    };
    assert.equal(
      sentence(run({ verdict: "true", arrest })),
      "Arrest: at collision 90 this computation stands still at time 2.5, and the pairs 1\u20132, 3\u20134 " +
        "repeat for ever. Whether the spheres had collapsed is for adjudication to tell.",
    );
  });

  test("tells a run that is not finished, and one without a verdict", () => {
    assert.match(
      sentence(run({ verdict: "none", file: { complete: false } })),
      /^So far \(the run is not finished\): No collapse/,
    );
    assert.match(sentence(run({ file: { complete: false } })), /holds no verdict/);
  });

  test("pairs that are not in the first cluster are a group of their own", () => {
    const cluster = (spheres) => ({
      spheres,
      contacts: [],
      positions: spheres.flatMap(() => [0, 0, 0]),
      chain: spheres,
    });
    const found = {
      collision: 9,
      pairs: [
        [1, 2],
        [5, 6],
      ],
      clusters: [cluster([1, 2]), cluster([5, 6])],
    };
    const groups = groupsOf({
      ...run({ arrest: { pairs: found.pairs } }),
      anatomy: { arrest: found },
    });
    assert.deepEqual(
      groups.map(({ id }) => id),
      ["arrest-pairs", "arrest-cluster", "arrest-clusters"],
    );
    assert.deepEqual(groups[0].spheres, [1, 2, 5, 6]);
  });
});

describe("averages", () => {
  test("have a row for each component, and none for what a run does not have", () => {
    const averages = {
      granular_temperature: 0.5,
      temperature_diagonal: [0.4, 0.6],
      pressure_tensor: [
        [1, -2],
        [-2, 3],
      ],
      sonine_a2: null,
      standard_error: { granular_temperature: 0.02, temperature_diagonal: [0.01, null] },
    };
    const rows = averageRows(averages, 2);
    assert.deepEqual(
      rows.map(([name, value]) => `${name}: ${value}`),
      [
        "granular temperature T: 0.50(2)",
        "component T_x: 0.400(10)",
        "component T_y: 0.6",
        "pressure tensor P_xx: 1",
        "pressure tensor P_xy: \u22122",
        "pressure tensor P_yx: \u22122",
        "pressure tensor P_yy: 3",
      ],
    );
  });

  test("of a run that could not tell errors stand alone", () => {
    const averages = { granular_temperature: 0.5, standard_error: { granular_temperature: null } };
    assert.deepEqual(averageRows(averages, 3), [
      ["granular temperature T", "0.5", "(diameter/time)\u00b2"],
    ]);
  });

  test("are curves of the components that a series has", () => {
    const series = { time: [1, 2], columns: { streak_modes: [1, 2, 3, 4], pressure: [5, 6] } };
    const wanted = [
      ["pressure", null, "p"],
      ["streak_modes", 1, "(0, 1)"],
      ["streak_modes", 2, "(1, 1)"],
      ["shear_work", null, "none"],
    ];
    assert.deepEqual(curvesOf(series, wanted), [
      { name: "p", values: [5, 6] },
      { name: "(0, 1)", values: [2, 4] },
    ]);
  });
});
