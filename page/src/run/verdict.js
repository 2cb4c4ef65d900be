// The verdict of a run in one sentence, and its evidence.
import { count, grouped, pairName, short } from "../shared/format.js";

const unit = (run) => (run.values.drive === "shear" ? "strain" : "time");
const moment = (run, time) =>
  time === null ? "" : `, ${unit(run)} ${short(time * scale(run), 6)}`;
const scale = (run) => (run.values.drive === "shear" ? run.values.shear_rate : 1);

/** "pair 3619–3656" or "pairs 1–2, 3–4, …" of the arrest. */
export function arrestedPairs(run, most = 4) {
  const pairs = run.summary.arrest?.pairs ?? [];
  const names = pairs.slice(0, most).map((pair) => pairName(pair, run.spheres));
  const rest = pairs.length > most ? ` and ${pairs.length - most} more` : "";
  return `${pairs.length === 1 ? "pair" : "pairs"} ${names.join(", ")}${rest}`;
}

const SENTENCES = {
  true: (run, { arrest }) =>
    `Arrest: at collision ${grouped(arrest.collision)} this computation stands still at ` +
    `${unit(run)} ${short(arrest.time * scale(run), 8)}, and the ${arrestedPairs(run)} ` +
    `${arrest.pairs.length === 1 ? "repeats" : "repeat"} for ever. Whether the spheres had ` +
    `collapsed is for adjudication to tell.`,
  temporary: (run, { collisions, separation: hits }) =>
    `No arrest: this computation met the separation criterion and left it again. It met it ` +
    `${count(hits.hits, "time")}, first at collision ${grouped(hits.first_collision)}, last at ` +
    `${grouped(hits.last_collision)}, and went on for ` +
    `${grouped(collisions - hits.last_collision)} collisions without it. Whether the spheres had ` +
    `collapsed is for adjudication to tell.`,
  open: (run, { separation: hits }) =>
    `Not decided: the separation criterion was met ${count(hits.hits, "time")}, last at collision ` +
    `${grouped(hits.last_collision)}, too close to the end of the run to tell.`,
  none: (run, { collisions }) =>
    `No collapse: the separation criterion was never met in ${count(collisions, "collision")}.`,
};

/** The verdict in one sentence. */
export function sentence(run) {
  const { summary } = run;
  const made = SENTENCES[summary.verdict];
  if (!made) return "This file holds no verdict: its run was cut off before the first checkpoint.";
  const unfinished = summary.file.complete ? "" : "So far (the run is not finished): ";
  return unfinished + made(run, summary);
}

/** What the verdict rests on: [[what, text], ...]. */
export function evidence(run) {
  const { summary } = run;
  if (!summary.verdict)
    return [["written up to", `collision ${grouped(summary.file.last_collision)}`]];
  return [
    ...separationFacts(run, summary),
    ...arrestFacts(run, summary),
    ...clusterFacts(run),
    ...runFacts(run, summary),
  ];
}

function separationFacts(run, { separation: hits }) {
  const threshold = `gap of the next pair \u2264 ${short(run.values.gap_threshold)} diameters`;
  if (!hits.hits) return [["separation criterion", `never met (${threshold})`]];
  return [
    ["separation criterion", `met ${count(hits.hits, "time")} (${threshold})`],
    ["first hit", `collision ${grouped(hits.first_collision)}${moment(run, hits.first_time)}`],
    ["last hit", `collision ${grouped(hits.last_collision)}`],
  ];
}

function arrestFacts(run, { arrest }) {
  const window = `window of ${grouped(arrest.window)} collisions`;
  if (!arrest.met) return [["arrest criterion", `not met (${window})`]];
  return [
    [
      "arrest criterion",
      `met at collision ${grouped(arrest.collision)}${moment(run, arrest.time)} (${window})`,
    ],
    ["clock", `stands still at time ${arrest.time}`],
    ["what repeats", arrestedPairs(run, 12)],
  ];
}

const CLUSTERS = { hit: "cluster of the first hit", arrest: "cluster of the arrest" };

function clusterFacts(run) {
  return Object.entries(CLUSTERS)
    .filter(([which]) => run.anatomy[which])
    .map(([which, name]) => {
      const [cluster] = run.anatomy[which].clusters;
      const chain =
        cluster.chain.length > 2
          ? `, a chain of ${cluster.chain.length}, straightness ${short(cluster.straightness, 4)}`
          : "";
      return [name, `${count(cluster.spheres.length, "sphere")}${chain}`];
    });
}

function runFacts(run, summary) {
  const facts = [
    [
      "collisions",
      `${grouped(summary.collisions)} (` +
        `${short(summary.collisions_per_sphere, 5)} per sphere)${summary.ended_by ? `, ended by ${summary.ended_by}` : ""}`,
    ],
    [
      "time",
      `${short(summary.time, 8)}${
        run.values.drive === "shear" ? ` (strain ${short(summary.strain, 8)})` : ""
      }`,
    ],
    [
      "odd collisions",
      `${grouped(summary.absorbed)} absorbed by rounding,` +
        ` ${grouped(summary.overlap_collisions)} overlapping`,
    ],
    ["energy ledger", `closed to ${short(summary.ledger_error, 2)} (relative)`],
  ];
  const finding = run.adjudication?.finding;
  if (finding) facts.push(["physics or rounding?", `${finding} (adjudicated, see below)`]);
  if (summary.self_check) facts.push(["self-check", summary.self_check]);
  return facts;
}
