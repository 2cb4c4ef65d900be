// The averages of a run with their errors, whether they are steady, and their course in time.
import { curvePlot } from "../plots/curve_plot.js";
import { element, section, table } from "../shared/dom.js";
import { short } from "../shared/format.js";
import { averageRows, axisName, curvesOf } from "./average_rows.js";

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
  const name = run.values.drive === "shear" ? "Strain" : "Time";
  const { time } = run.series;
  return curvePlot({
    id: `series-${id}`,
    title,
    run,
    stem: ["series", id],
    x: {
      label: `${name} at the end of the interval`,
      name: name.toLowerCase(),
      values: time.map((each) => each * scale),
      inTable: { name: "time", values: time },
    },
    curves,
  });
}
