// The plots over the collision axis: the paper's, and which pair collides.
import { timeAxis } from "./axes.js";
import { paintLevel } from "./marks.js";
import { pairsPlot } from "./pairs_plot.js";
import { Plot } from "./plot.js";
import { INK } from "../shared/colours.js";
import { Selection } from "../run/selection.js";
import { count, DASH, grouped, pairName, short } from "../shared/format.js";

const FLAGS = [
  [2, "overlapping"],
  [4, "absorbed"],
  [8, "receding"],
  [16, "clock stood"],
  [32, "made elastic"],
];

/** Entries of a view as text: "collision 12" or "collisions 12–40". */
function place(view, n) {
  const first = view.k[n],
    last = first + view.count[n] - 1;
  return last > first
    ? `collisions ${grouped(first)}${DASH}${grouped(last)}`
    : `collision ${grouped(first)}`;
}

const extremes = (low, high, digits = 3) =>
  low === high || Number.isNaN(low)
    ? short(low, digits)
    : `${short(low, digits)} to ${short(high, digits)}`;

function details(view, n, spheres) {
  const flags = FLAGS.filter(([bit]) => view.flags[n] & bit).map(([, word]) => word);
  const { stretch } = view;
  const row = view.begin + n;
  if (stretch.i && view.group === 1)
    flags.unshift(pairName([stretch.i[row], stretch.j[row]], spheres));
  if (view.hits[n]) flags.push(view.count[n] > 1 ? count(view.hits[n], "hit") : "hit");
  return flags.length ? ` \u00b7 ${flags.join(", ")}` : "";
}

/** Smallest and largest of what is finite and above zero; [1e-16, 1e-12] where nothing is. */
function positiveRange(...columns) {
  let [low, high] = [Infinity, 0];
  for (const column of columns) {
    for (const value of column) {
      if (value > 0 && value < low) low = value;
      if (value > high && value < Infinity) high = value;
    }
  }
  return high > 0 ? [low, high] : [1e-16, 1e-12];
}

/** At most one view of the log for each selection and number of entries, shared by the plots. */
function sharedView(log) {
  let key = "",
    view = null;
  return (first, last, entries) => {
    const wanted = `${first} ${last} ${entries}`;
    if (wanted !== key) [key, view] = [wanted, log.view(first, last, entries)];
    return view;
  };
}

const floored = (values, floor) => values.map((value) => (value < floor ? floor : value));

/** Entries of a view, which they are: columns of a table. */
export function placesOf(view) {
  const last = (n) => view.k[n] + view.count[n] - 1;
  return view.width === 1
    ? { head: ["collision"], row: (n) => [view.k[n]] }
    : { head: ["first_collision", "last_collision"], row: (n) => [view.k[n], last(n)] };
}

/** A table [head, rows] of a view; columns: {name: values, or [lowest, highest]}. */
function tableOf(view, columns) {
  const places = placesOf(view),
    isSingle = view.width === 1;
  const parts = Object.entries(columns).flatMap(([name, [low, high]]) =>
    isSingle || !high
      ? [[name, low]]
      : [
          [`${name}_smallest`, low],
          [`${name}_largest`, high],
        ],
  );
  const rows = Array.from({ length: view.size }, (_, n) => [
    ...places.row(n),
    ...parts.map(([, values]) => values[n]),
    view.hits[n],
  ]);
  return [[...places.head, ...parts.map(([name]) => name), "hits"], rows];
}

/** Plots of a quantity that a view of the log has. */
class LogQuantity {
  constructor(about, take, run) {
    Object.assign(this, about, { takeView: take, run });
  }

  take(first, last, entries) {
    this.view = this.takeView(first, last, entries);
    if (!this.view) return { x: [first, last], low: [NaN, NaN], high: [NaN, NaN] };
    return { x: this.view.k, ...this.columns(this.view) };
  }

  /** Everything that the page has of a range, whether a plot can show it or not. */
  numbers(first, last) {
    const view = this.takeView(first, last, Infinity);
    return view ? tableOf(view, this.table(view)) : [["collision"], []];
  }

  read(n) {
    if (!this.view || n >= this.view.size) return "";
    return `${place(this.view, n)}: ${this.text(this.view, n)}${details(this.view, n, this.run.spheres)}`;
  }
}

function gapPlot(run, take) {
  const threshold = run.values.gap_threshold,
    floor = threshold > 0 ? threshold / 10 : 1e-17;
  return new LogQuantity(
    {
      id: "gap",
      title: "Gap of the next pair (diameters)",
      isLog: true,
      hasMarkNames: true,
      height: 210,
      columns: (view) => ({ low: floored(view.gapLow, floor), high: floored(view.gapHigh, floor) }),
      table: (view) => ({ gap: [view.gapLow, view.gapHigh] }),
      text: (view, n) =>
        view.gapLow[n] <= floor && view.gapHigh[n] === view.gapLow[n]
          ? `gap ${view.gapLow[n]}`
          : `gap ${extremes(view.gapLow[n], view.gapHigh[n])}`,
      range: ({ high }) => [floor / 6, Math.max(positiveRange(high)[1] * 30, threshold * 1e4)],
      paint(plot, ctx) {
        plot.paintBars(ctx);
        const hit = [...plot.data.x.keys()].filter((n) => this.view && this.view.hits[n] > 0);
        plot.paintTicks(ctx, hit, floor / 1.6);
        if (threshold > 0) paintLevel(plot, ctx, threshold, `threshold ${short(threshold)}`);
      },
    },
    take,
    run,
  );
}

function timePlot(run, take) {
  const sheared = run.values.drive === "shear",
    scale = sheared ? run.values.shear_rate : 1;
  return new LogQuantity(
    {
      id: "time",
      title: sheared ? "Time (strain)" : "Time",
      isLog: false,
      columns: (view) => {
        const time = view.time.map((value) => value * scale);
        return { low: time, high: time };
      },
      table: (view) => ({
        time: [view.time],
        ...(sheared && { strain: [view.time.map((time) => time * scale)] }),
      }),
      text: (view, n) => `${sheared ? "strain" : "time"} ${view.time[n] * scale}`,
      range: ({ high }) => {
        const low = high.reduce((a, b) => Math.min(a, b), Infinity);
        const top = high.reduce((a, b) => Math.max(a, b), -Infinity);
        const margin = Math.max((top - low) * 0.06, Math.abs(top) * 1e-9, 1e-12);
        return Number.isFinite(low) ? [low - margin, top + margin] : [0, 1];
      },
      paint: (plot, ctx) => plot.paintLine(ctx),
    },
    take,
    run,
  );
}

function flightPlot(run, take) {
  let floor = 1e-17;
  return new LogQuantity(
    {
      id: "flight",
      title: "Time per collision",
      isLog: true,
      columns: (view) => {
        floor = positiveRange(view.flightLow, view.flightHigh)[0] / 10;
        return { low: floored(view.flightLow, floor), high: floored(view.flightHigh, floor) };
      },
      table: (view) => ({ time_per_collision: [view.flightLow, view.flightHigh] }),
      text: (view, n) => {
        if (view.flightHigh[n] === 0) return "the clock does not move";
        return extremes(view.flightLow[n], view.flightHigh[n], 4);
      },
      range: ({ high }) => [floor / 3, positiveRange(high)[1] * 3],
      paint(plot, ctx) {
        plot.paintBars(ctx);
        const { x, low } = plot.data;
        plot.paintTicks(
          ctx,
          [...x.keys()].filter((n) => low[n] <= floor),
          floor,
        );
      },
    },
    take,
    run,
  );
}

function speedPlot(run, take) {
  let floor = 1e-30;
  return new LogQuantity(
    {
      id: "speed",
      title: "Normal speed (diameters/time)",
      isLog: true,
      columns: (view) => {
        floor = positiveRange(view.speedLow, view.speedHigh)[0] / 2;
        return { low: floored(view.speedLow, floor), high: floored(view.speedHigh, floor) };
      },
      table: (view) => ({ normal_speed: [view.speedLow, view.speedHigh] }),
      text: (view, n) => extremes(view.speedLow[n], view.speedHigh[n]),
      range: ({ high }) => [floor, positiveRange(high)[1] * 2],
    },
    take,
    run,
  );
}

/** Temperatures of the snapshots against `places`, one for each. */
function temperaturePlot(run, id, title, places) {
  const { step, time, granular_temperature: temperature } = run.snapshots;
  return {
    id,
    title,
    isLog: true,
    take: () => ({ x: places, low: temperature, high: temperature }),
    numbers: (first, last) => [
      ["snapshot", "collision", "time", "granular_temperature"],
      [...places.keys()]
        .filter((n) => places[n] >= first && places[n] <= last)
        .map((n) => [n + 1, step[n], time[n], temperature[n]]),
    ],
    source: run.name,
    range({ high }) {
      const [low, top] = positiveRange(high);
      return [low / 1.6, top * 1.6];
    },
    read: (n) =>
      `snapshot ${n + 1}, collision ${grouped(step[n])}, time ${short(time[n], 6)}: ` +
      short(temperature[n], 5),
    paint(plot, ctx) {
      plot.paintLine(ctx, "#9aa5b1");
      const half = 3 * devicePixelRatio;
      ctx.fillStyle = INK;
      places.forEach((x, n) => {
        ctx.beginPath();
        ctx.arc(plot.x(x), plot.y(temperature[n]), half, 0, 7);
        ctx.fill();
      });
    },
  };
}

const TEMPERATURE = "Granular temperature of the snapshots (diameter\u00b2/time\u00b2)";

/** All plots over collisions, not drawn yet. */
export function collisionPlots(run, log, selection, marks, snapshotStep) {
  const take = sharedView(log);
  const cooling = () => temperaturePlot(run, "temperature", TEMPERATURE, run.snapshots.step);
  const definitions = [gapPlot, timePlot, flightPlot, speedPlot, cooling, pairsPlot];
  return definitions.map((make) => {
    const definition = Object.assign(make(run, take), { source: run.name });
    return new Plot(definition, selection, marks, snapshotStep);
  });
}

/**
 * The granular temperature against time (strain, where the cell is sheared), with a zoom of its own.
 *
 * marks: [{time, label}];  snapshotNumber() -> number of the snapshot shown
 */
export function temperatureOverTime(run, marks, snapshotNumber) {
  const sheared = run.values.drive === "shear",
    scale = sheared ? run.values.shear_rate : 1;
  const places = run.snapshots.time.map((time) => time * scale);
  const name = sheared ? "Strain" : "Time";
  const title = `${TEMPERATURE} against ${name.toLowerCase()}`;
  return new Plot(
    temperaturePlot(run, "cooling", title, places),
    Selection.ofTime(places[0] ?? 0, places.at(-1) ?? 1),
    marks
      .filter(({ time }) => time !== undefined)
      .map((mark) => ({ ...mark, k: mark.time * scale })),
    () => places[snapshotNumber()],
    timeAxis(name),
  );
}
