// The averages of a run with their errors, whether they are steady, and their course in time.
import uPlot from "uplot";
import { linearNames } from "../plots/axes.js";
import { figureAsCanvas, figureAsSvg } from "../plots/figure.js";
import { BLUE, GREEN, GREY, INK, SKY, VERMILION } from "../shared/colours.js";
import { element, section, table } from "../shared/dom.js";
import { DASH, short } from "../shared/format.js";
import { averageRows, axisName, curvesOf } from "./average_rows.js";
import { csv, fileStem, saveMenu } from "../shared/save.js";

const COLOURS = [INK, VERMILION, BLUE, GREEN, SKY, GREY];
const MODES = ["(1, 0)", "(0, 1)", "(1, 1)", "(1, \u22121)"]; // (k_y, k_z), as the program has them
/** The plots: [id, title, [[key, component or null, name], ...]]; curves that there are are drawn. */
const PLOTS = [
  [
    "temperature",
    "Granular temperature (diameter\u00b2/time\u00b2)",
    [
      ["granular_temperature", null, "T"],
      ...[0, 1, 2].map((n) => ["temperature_diagonal", n, `along ${axisName(n)}`]),
    ],
  ],
  ["pressure", "Pressure", [["pressure", null, "p"]]],
  ["shear", "Shear work per volume and time", [["shear_work", null, "shear work"]]],
  ["rate", "Collisions per sphere and time", [["collision_rate", null, "collision rate"]]],
  [
    "streaks",
    "Streak amplitudes (diameter/time), modes (k_y, k_z)",
    MODES.map((name, n) => ["streak_modes", n, name]),
  ],
];

/** The section, or nothing where a file has neither averages nor a series. */
export function averagesSection(run) {
  const averages = run.summary.averages;
  const isKnown = typeof averages?.to_time === "number";
  const plots = seriesPlots(run);
  if (!isKnown && !plots.length) return [];
  return [
    section(
      "averages",
      "Averages",
      ...(isKnown ? [steadiness(averages), averagesTable(run, averages)] : []),
      ...plots,
    ),
  ];
}

/** The program's sentence, with the sign that the verdict has for what may be trusted. */
function steadiness({ steady, steady_reason: reason }) {
  const signs = { true: "\u25cb", false: "\u25a0" };
  return element(
    "p",
    { class: "steady" },
    element("span", { class: "sign", "aria-hidden": "true" }, signs[steady] ?? "?"),
    ` ${reason || "This file does not say whether the run was steady."}`,
  );
}

function averagesTable(run, averages) {
  const { from_time: from, to_time: to, blocks } = averages;
  const worth = blocks ? `, worth ${blocks} independent values or more` : "";
  return table(
    [["average", "value", "unit"], ...averageRows(averages, run.dimension)],
    `Over time ${short(from, 6)} to ${short(to, 6)}${worth}; 1.23(4) is 1.23 \u00b1 0.04`,
  );
}

function seriesPlots(run) {
  const { series } = run;
  if (!series || series.time.length < 2) return [];
  const shown = PLOTS.map(([id, title, wanted]) => [id, title, curvesOf(series, wanted)]);
  return shown
    .filter(([, , curves]) => curves.some(({ values }) => values.some((value) => value)))
    .map(([id, title, curves]) => seriesPlot(run, id, title, curves));
}

function seriesPlot(run, id, title, curves) {
  const scale = run.values.drive === "shear" ? run.values.shear_rate : 1;
  const name = scale === 1 && run.values.drive !== "shear" ? "Time" : "Strain";
  const x = run.series.time.map((time) => time * scale);
  const place = element("div", { id: `series-${id}`, class: "series" });
  const head = element("div", { class: "plot-head" }, element("h3", {}, title));
  place.append(head);
  requestAnimationFrame(() => {
    const chart = new uPlot(options(place, name, curves), [x, ...curves.map((c) => c.values)], place);
    const figure = () => ({ chart, title, subtitle: run.name, paint: (ctx) => paint(ctx, chart) });
    head.append(
      saveMenu(title, () => fileStem(run.name, "series", id), {
        png: () => figureAsCanvas(figure()),
        svg: () => figureAsSvg(figure()),
        csv: () =>
          csv(
            ["time", ...curves.map((curve) => curve.name)],
            run.series.time.map((time, n) => [time, ...curves.map(({ values }) => values[n])]),
          ),
      }),
    );
    new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height: 220 })).observe(place);
  });
  return place;
}

function options(place, name, curves) {
  const numbers = (_, places, __, ___, step) => linearNames(places, step);
  return {
    width: place.clientWidth,
    height: 220,
    padding: [10, 14, 0, 0],
    scales: { x: { time: false } },
    axes: [
      { label: `${name} at the end of the interval`, stroke: INK, size: 34, labelSize: 22, values: numbers },
      { size: 74, stroke: INK, values: numbers },
    ],
    series: [
      { label: name.toLowerCase(), value: (_, value) => short(value, 6) },
      ...curves.map(({ name: label }, n) => ({
        label,
        stroke: COLOURS[n],
        width: n ? 1 : 1.6,
        dash: n > 3 ? [6, 3] : undefined,
        points: { show: false },
        value: (_, value) => (value === undefined ? DASH : short(value, 5)),
      })),
    ],
  };
}

/** Draws the curves once more, for a figure. */
function paint(ctx, chart) {
  chart.series.slice(1).forEach((series, n) => {
    if (!series.show) return;
    ctx.strokeStyle = COLOURS[n];
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    chart.data[n + 1].forEach((value, k) => {
      if (value === null || Number.isNaN(value)) return;
      const at = [chart.valToPos(chart.data[0][k], "x", true), chart.valToPos(value, "y", true)];
      if (k === 0) ctx.moveTo(...at);
      else ctx.lineTo(...at);
    });
    ctx.stroke();
  });
}
