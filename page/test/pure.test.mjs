// The parts of the page that draw nothing.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { bonds, Cell } from "../src/cell.js";
import { grouped, pairName, power, short } from "../src/format.js";
import { groupsOf, unwrapped } from "../src/groups.js";
import { Log, Stretch } from "../src/log.js";
import { Selection } from "../src/selection.js";
import { share, wilson } from "../src/statistics.js";
import { caseText } from "../src/sweep_page.js";
import { sentence } from "../src/verdict.js";

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

  test("a partner beyond the spheres is a wall", () => {
    assert.equal(pairName([3, 9], 10), "3\u20139");
    assert.equal(pairName([3, 10], 10), "3\u2013lower wall");
    assert.equal(pairName([3, 11], 10), "3\u2013upper wall");
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

  test("counts runs with a result only, and hits without arrest apart", () => {
    const runs = {
      status: ["done", "done", "done", "failed", "pending", "done"],
      outcome: ["collapsed", "finished", "finished", null, null, "interrupted"],
      separation_hits: [5, 9, 0, null, null, 3],
      arrest_met: [1, 0, 0, null, null, 0],
    };
    const counted = (question) => [
      share(runs, [0, 1, 2, 3, 4, 5], question).hits,
      share(runs, [0, 1, 2, 3, 4, 5], question).runs,
    ];
    assert.deepEqual(counted("hit"), [2, 3]);
    assert.deepEqual(counted("arrest"), [1, 3]);
    assert.deepEqual(counted("false"), [1, 3]);
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

  test("names the pairs of a true collapse", () => {
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
      "True collapse: at collision 90 time stands still at 2.5, and the pairs 1\u20132, 3\u20134 repeat for ever.",
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
