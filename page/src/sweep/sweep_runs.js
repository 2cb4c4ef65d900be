// The runs of a point of a sweep, and the case file of each.
import { download, element, table } from "../shared/dom.js";
import { DASH, grouped, short } from "../shared/format.js";

/** Pairs in a JSON text, a few of them. */
function pairsIn(text, most = 3) {
  const pairs = JSON.parse(text ?? "[]");
  const rest = pairs.length > most ? ` and ${pairs.length - most} more` : "";
  return (
    pairs
      .slice(0, most)
      .map(([i, j]) => `${i}${DASH}${j}`)
      .join(", ") + rest
  );
}

/** A table of the runs of a point, and what is to be known of one of them, first of the first. */
export function runsOfPoint(sweep, point, numbers) {
  const box = element("div", { id: "run-case" });
  const showCase = (n) => box.replaceChildren(...caseOf(sweep, point, n));
  if (numbers.length) showCase(numbers[0]);
  return [runTable(sweep, numbers, showCase), box];
}

function runTable({ runs }, numbers, showCase) {
  const cell = (value, digits) =>
    typeof value === "number" ? short(value, digits) : (value ?? DASH);
  const isAdjudicated = runs.adjudication_first_finding?.some((finding) => finding !== null);
  const findings = isAdjudicated ? [runs.adjudication_first_finding] : [];
  const whole = (value) => (typeof value === "number" ? grouped(value) : DASH);
  const rows = numbers.map((n) => [
    element("button", { type: "button", onclick: () => showCase(n) }, `run ${runs.run[n]}`),
    runs.seed[n],
    runs.status[n] === "failed" ? `failed: ${runs.error[n]}` : runs.status[n],
    runs.verdict[n] ?? DASH,
    whole(runs.separation_hits[n]),
    whole(runs.separation_first_collision[n]),
    runs.arrest_met[n] === 1
      ? `${whole(runs.arrest_collision[n])}, ${pairsIn(runs.arrest_pairs[n])}`
      : DASH,
    ...findings.map((column) => column[n] ?? DASH),
    whole(runs.collisions[n]),
    cell(runs.time[n], 6),
    cell(runs.granular_temperature[n], 5),
    cell(runs.collision_rate[n], 5),
  ]);
  return table(
    [
      [
        "",
        "seed",
        "status",
        "verdict",
        "hits",
        "first hit",
        "arrest",
        ...findings.map(() => "first hits (adjudicated)"),
        "collisions",
        "time",
        "granular temperature",
        "collision rate",
      ],
      ...rows,
    ],
    "Runs of this point; a button shows the case file of its run",
  );
}

function caseOf(sweep, point, n) {
  const run = sweep.runs.run[n];
  const text = caseText(sweep, point, sweep.runs.seed[n]);
  const file = `${sweep.name.replace(/\.\w+$/, "").replace(/[^\w.-]/g, "_")}-run-${run}.toml`;
  return [
    ...adjudicated(sweep.runs, n),
    element("h3", {}, `Case file of run ${run} `),
    element(
      "p",
      {},
      download(text, file, file),
      ", the same that ",
      element("code", {}, `zenosphere sweep show ${sweep.name} --run ${run}`),
      " prints.",
    ),
    element(
      "pre",
      { class: "commands", tabindex: "0" },
      `build/zenosphere run ${file} -o run-${run}.h5\n` +
        `build/zenosphere report run-${run}.h5 -o run-${run}.html`,
    ),
    element("pre", { tabindex: "0", class: "case" }, text),
  ];
}

/** What was found of the hits of a run, where it has been adjudicated. */
function adjudicated(runs, n) {
  const finding = runs.adjudication_finding?.[n];
  if (!finding) return [];
  const [groups, rest] = [runs.adjudication_groups?.[n], runs.adjudication_left_out?.[n]];
  const counted =
    typeof groups === "number"
      ? ` Groups of hits judged: ${grouped(groups)}${rest ? `, left out ${grouped(rest)}` : ""}.`
      : "";
  return [
    element("h3", {}, `What the hits of run ${runs.run[n]} were`),
    element(
      "p",
      {},
      `First: ${runs.adjudication_first_finding?.[n] ?? DASH}; the strongest of all: ${finding}. `,
      runs.adjudication_sentence?.[n] ?? "",
      counted,
    ),
  ];
}

/** The resolved case of a run: that of its point with its own seed. */
export function caseText({ cases }, point, seed) {
  const changed = cases.points[point] ?? {};
  const lines = Array.isArray(changed) ? changed : cases.first.map((line, n) => changed[n] ?? line);
  return lines.map((line) => line.replace(/^seed = \d+/, `seed = ${seed}`)).join("\n");
}
