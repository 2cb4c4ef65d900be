// The page of one run.
import { anatomySection } from "./anatomy.js";
import { averagesSection } from "./averages.js";
import { collisionPlots, temperatureOverTime } from "../plots/collision_plots.js";
import { column } from "../shared/data.js";
import { button, element, section, table } from "../shared/dom.js";
import { DASH, grouped, short } from "../shared/format.js";
import { Log, Stretch } from "./log.js";
import { samplesSection } from "./samples.js";
import { caseSection, licencesSection } from "../shared/provenance.js";
import { Choice, Selection, wantedRange } from "./selection.js";
import { SphereView } from "../spheres/sphere_view.js";
import { evidence, sentence } from "./verdict.js";

const AROUND = 1500; // collisions shown on each side of what a button names

export function runPage(root, run) {
  document.title = `${run.name} ${DASH} Zenosphere report`;
  const log = new Log(
    run.log.map((about, n) => {
      const pairs = n === 0 && run.pairs.length ? run.pairs : undefined;
      return new Stretch({ ...about, pairs }, column);
    }),
  );
  const steps = run.snapshots.step;
  const selection = log.isEmpty
    ? new Selection(steps[0] ?? 0, steps.at(-1) ?? 1)
    : new Selection(log.first, log.last);
  const snapshot = new Choice(nearestSnapshot(run));
  const frames = Object.fromEntries(
    ["positions", "speeds", "collisions"].map((name) => [name, column(`frames.${name}`)]),
  );
  const plots = plotsSection(run, log, selection, snapshot);
  const spheres = sphereSection(run, frames, snapshot);
  root.append(
    header(run),
    verdictSection(run),
    element("div", { class: "look" }, plots.box, spheres.box),
    ...averagesSection(run),
    ...samplesSection(run),
    ...anatomySection(run),
    ...adjudicationSection(run),
    caseSection(run),
    licencesSection(),
  );
  plots.start();
  return { selection, snapshot };
}

/** Of the snapshots shown the one nearest to the arrest, else to the first hit, else the last. */
function nearestSnapshot(run) {
  const { shown, step } = run.snapshots;
  const k = run.summary.arrest?.collision ?? run.summary.separation?.first_collision ?? Infinity;
  if (k === Infinity) return Math.max(0, shown.length - 1);
  const distance = (n) => Math.abs(step[shown[n]] - k);
  return shown.reduce((best, _, n) => (distance(n) <= distance(best) ? n : best), 0);
}

function header(run) {
  const { values } = run;
  const drive = {
    shear: `sheared at rate ${short(values.shear_rate)}`,
    random: "randomly driven",
    none: values.walls ? `between walls along ${values.walls}` : "not driven",
  };
  const facts = [
    `${grouped(run.spheres)} ${["rods", "disks", "spheres"][run.dimension - 1]}`,
    values.restitution === null ? values.restitution_law : `e = ${short(values.restitution)}`,
    values.solids_volume_fraction ? `volume fraction ${short(values.solids_volume_fraction)}` : "",
    drive[values.drive],
    `seed ${values.seed}`,
  ];
  return element(
    "header",
    {},
    element("p", { class: "name" }, "Zenosphere report"),
    element("h1", {}, run.name),
    element("p", {}, facts.filter(Boolean).join(", ")),
  );
}

function verdictSection(run) {
  const verdict = run.summary.verdict ?? "unknown";
  const signs = { true: "\u25a0", temporary: "\u25cb", none: "\u25cb", open: "?" };
  return element(
    "section",
    { id: "verdict", class: `verdict ${verdict}`, "aria-label": "Verdict" },
    element(
      "p",
      { class: "sentence" },
      element("span", { class: "sign", "aria-hidden": "true" }, signs[verdict] ?? "?"),
      sentence(run),
    ),
    element(
      "dl",
      {},
      ...evidence(run).map(([what, text]) =>
        element("div", {}, element("dt", {}, what), element("dd", {}, text)),
      ),
    ),
  );
}

/** The collisions worth a line. */
function marksOf(run) {
  const { separation, arrest } = run.summary;
  const found = [
    [separation?.first_collision, "first hit", separation?.first_time],
    [arrest?.collision, "arrest", arrest?.time],
    [arrest?.met ? null : separation?.last_collision, "last hit", separation?.last_time],
  ];
  return found
    .filter(([k]) => k !== null && k !== undefined)
    .sort(([a], [b]) => a - b)
    .map(([k, name, time]) => ({
      k,
      name,
      label: `${name} ${grouped(k)}`,
      time: time ?? undefined,
    }));
}

function plotsSection(run, log, selection, snapshot) {
  const marks = marksOf(run);
  const { shown, step } = run.snapshots;
  const plots = collisionPlots(run, log, selection, marks, () => step[shown[snapshot.value]]);
  const cooling = temperatureOverTime(run, marks, () => shown[snapshot.value]);
  const { fields, why } = rangeFields(selection);
  const buttons = marks.map(({ k, name }) =>
    button(name, () => selection.set(k - AROUND, k + AROUND)),
  );
  selection.listen(() => plots.forEach((plot) => plot.update()));
  cooling.selection.listen(() => cooling.update());
  const all = [...plots.slice(0, -1), cooling, plots.at(-1)]; // pairs last
  snapshot.listen(() => all.forEach((plot) => plot.redraw()));
  const box = section(
    "plots",
    "Collisions",
    element(
      "div",
      { class: "row toolbar", role: "group", "aria-label": "Collisions shown" },
      element("label", { for: "first-collision" }, "Collisions"),
      fields[0],
      DASH,
      element("label", { for: "last-collision", class: "hidden" }, "to"),
      fields[1],
      button("All", () => selection.reset(), { id: "reset" }),
      ...buttons,
      why,
    ),
    element(
      "p",
      { class: "hint" },
      "Drag in a plot to see a range in all of them, double-click for everything. " +
        `Keys: \u2190 \u2192 value, shift \u2190 \u2192 move, + ${DASH} zoom, 0 all. ` +
        "Blue: hits and arrest; dashed grey: the snapshot shown. " +
        thinningNote(run),
    ),
    ...all.map(({ box: plot }) => plot),
  );
  return { box, start: () => all.forEach((plot) => plot.start()) };
}

/** Two fields for the range of collisions, and a place that says why another one is shown. */
function rangeFields(selection) {
  const why = element("output", { class: "why", role: "status" });
  const choose = (changed) => {
    const texts = fields.map((field) => field.value);
    const range = wantedRange(selection, texts, changed);
    selection.set(range.first, range.last);
    why.textContent = range.why;
  };
  const fields = ["first", "last"].map((end, n) =>
    element("input", { type: "number", id: `${end}-collision`, onchange: () => choose(n) }),
  );
  selection.listen(() => {
    why.textContent = "";
    showRange(selection, fields);
  });
  showRange(selection, fields);
  return { fields, why };
}

function thinningNote(run) {
  const [all] = run.log;
  if (!all) return "The run kept no collision log.";
  const part = run.log_complete ? "" : " The log holds a part of the run only.";
  if (all.width === 1) return `Every logged collision is in this page.${part}`;
  return (
    `A dash reaches from the smallest to the largest value of ${all.width} or more collisions; ` +
    `near hits and arrest every collision is in this page. Pairs of wider ranges are the most ` +
    `frequent ones of the whole log.${part}`
  );
}

function showRange(selection, fields) {
  fields.forEach((field, n) => {
    field.min = selection.whole.first;
    field.max = selection.whole.last;
    field.value = String(n ? selection.last : selection.first);
  });
}

function sphereSection(run, frames, snapshot) {
  const { shown, step } = run.snapshots;
  if (!shown.length)
    return {
      box: section(
        "spheres",
        "Spheres",
        element(
          "p",
          {},
          step.length
            ? "There are too many spheres to be drawn in a page."
            : "The file holds no snapshot.",
        ),
      ),
    };
  const title = ["Rods", "Disks", "Spheres"][run.dimension - 1];
  const note =
    shown.length < step.length
      ? [
          element(
            "p",
            { class: "hint" },
            `${shown.length} of ${step.length} snapshots are in this page.`,
          ),
        ]
      : [];
  try {
    return { box: section("spheres", title, new SphereView(run, frames, snapshot).box, ...note) };
  } catch (error) {
    return {
      box: section(
        "spheres",
        title,
        element(
          "p",
          { class: "error" },
          `The 3-D view needs WebGL 2, which this browser does not give (${error.message}).`,
        ),
      ),
    };
  }
}

/** Approaches of spheres, in the order of the run's hits; files of older versions have none. */
function approachesTable(approaches) {
  if (!Array.isArray(approaches) || approaches.length === 0) return [];
  const rows = approaches.map((one) => [
    grouped(one.run_hit),
    one.finding,
    one.precision,
    grouped(one.spheres?.length ?? 0),
    `1e-${one.decades}`,
    String(one.collapse_time ?? DASH).slice(0, 24),
  ]);
  return [
    table(
      [
        ["the run's hit", "finding", "seen in", "spheres", "smallest gap", "collapse time"],
        ...rows,
      ],
      "Approaches of spheres, followed in more digits from before the hits",
    ),
  ];
}

function adjudicationSection(run) {
  const found = run.adjudication;
  if (!Array.isArray(found?.trials)) return [];
  const number = (value) => (typeof value === "number" ? grouped(value) : DASH);
  const rows = found.trials.map((trial) => [
    `${trial.precision}, ${trial.overlap}`,
    number(trial.first_hit),
    String(trial.first_hit_time ?? DASH).slice(0, 24),
    number(trial.hits),
    number(trial.absorbed),
    number(trial.arrest),
    `${number(trial.collisions)}, ${trial.ended_by}`,
  ]);
  return [
    section(
      "adjudication",
      "Physics or rounding?",
      element("p", {}, element("strong", {}, `${found.finding}. `), found.sentence ?? ""),
      ...approachesTable(found.approaches),
      table(
        [
          ["digits, overlap rule", "first hit", "at time", "hits", "absorbed", "arrest", "end"],
          ...rows,
        ],
        "The state before the first hit, gone on with in more digits and under other rules",
      ),
    ),
  ];
}
