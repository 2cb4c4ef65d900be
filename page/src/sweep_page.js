// The page of a sweep: phase diagrams, and the runs and the case file of a point.
import { diagram, told } from "./diagram.js";
import { download, element, section, table } from "./dom.js";
import { DASH, grouped, short } from "./format.js";
import { licencesSection } from "./provenance.js";
import { hasResult, QUESTIONS, runsByPoint, share } from "./statistics.js";

/** Whether a value of an axis is the one of a column, where lists and true or false are text. */
const isSame = (value, stored) =>
  value === stored || JSON.stringify(value) === String(stored).replace(/\s/g, "");

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

const NO_AXIS = { key: "all runs", values: [""] };

export function sweepPage(root, sweep) {
  document.title = `${sweep.name} ${DASH} Zenosphere report`;
  root.append(header(sweep), ...new SweepView(sweep).parts, provenance(sweep), licencesSection());
}

function header(sweep) {
  const { status } = sweep.runs,
    of = (word) => status.filter((one) => one === word).length;
  const axes = sweep.axes.map(({ key, values }) => `${key} (${values.length})`).join(" \u00d7 ");
  const cut = status.filter((one, n) => one === "done" && !hasResult(sweep.runs, n)).length;
  const open = of("pending") + of("failed") + cut;
  const rest = open
    ? `, ${grouped(of("pending"))} still to be done, ${grouped(of("failed") + cut)} failed`
    : "";
  return element(
    "header",
    {},
    element("p", { class: "name" }, "Zenosphere report"),
    element("h1", {}, sweep.name),
    element(
      "p",
      {},
      `${grouped(status.length)} runs${rest}; ${axes || "no axes"}, ` +
        (sweep.seeds
          ? `${grouped(sweep.seeds)} seeds`
          : `a search along ${sweep.axes.at(-1).key}: the shares are those of the runs it made there`),
    ),
  );
}

/** What of the sweep is looked at: two axes in the plane, one value on each of the others. */
class SweepView {
  constructor(sweep) {
    this.sweep = sweep;
    this.byPoint = runsByPoint(sweep.runs);
    this.plane = [sweep.axes.length ? 0 : -1, sweep.axes.length > 1 ? 1 : -1];
    this.held = sweep.axes.map(() => 0);
    this.choices = element("div", { class: "row toolbar", role: "group", "aria-label": "Axes" });
    this.diagrams = element("div", { class: "diagrams" });
    this.detail = element(
      "div",
      { id: "point", "aria-live": "polite" },
      element(
        "p",
        { class: "hint" },
        "Choose a point of a diagram to see its runs and its case file.",
      ),
    );
    this.parts = [
      section(
        "diagrams",
        "Phase diagrams",
        this.choices,
        this.diagrams,
        element(
          "p",
          { class: "hint" },
          "Share of the runs that are done, with its 95 % interval (Wilson). " +
            "Click a point, or go there with the arrow keys and press Enter.",
        ),
      ),
      section("runs", "Runs of a point", this.detail),
    ];
    this.update();
  }

  axis(n) {
    return n < 0 ? null : this.sweep.axes[n];
  }

  update() {
    this.drawChoices();
    const [x, y] = this.plane.map((n) => this.axis(n));
    const cells = this.cells();
    this.diagrams.replaceChildren(
      ...Object.entries(QUESTIONS).map(([question, { name }]) => {
        const shares = cells.map((cell) => ({
          ...cell,
          share: share(this.sweep.runs, cell.runs, question),
        }));
        return element(
          "figure",
          { id: `diagram-${question}` },
          element("figcaption", {}, name),
          diagram(name, x ?? NO_AXIS, y, shares, (point) => this.choose(point)),
        );
      }),
    );
  }

  /** The points in the plane: {column, row, point, runs}. */
  cells() {
    const { axes, places } = this.sweep,
      [x, y] = this.plane;
    const index = (n, place) =>
      n < 0 ? 0 : axes[n].values.findIndex((value) => isSame(value, place[n]));
    const isHere = (place) =>
      axes.every((axis, n) => n === x || n === y || isSame(axis.values[this.held[n]], place[n]));
    return Object.entries(places)
      .filter(([, place]) => isHere(place))
      .map(([point, place]) => ({
        point: Number(point),
        column: index(x, place),
        row: index(y, place),
        runs: this.byPoint.get(Number(point)) ?? [],
      }))
      .sort((a, b) => a.row - b.row || a.column - b.column);
  }

  drawChoices() {
    const { axes } = this.sweep;
    const parts = ["across", "up"]
      .filter((_, n) => axes.length > n)
      .map((name, n) =>
        this.select(
          name,
          axes.map(({ key }) => key),
          this.plane[n],
          (value) => this.setPlane(n, value),
        ),
      );
    axes.forEach((axis, n) => {
      if (this.plane.includes(n)) return;
      parts.push(
        this.select(axis.key, axis.values.map(String), this.held[n], (value) => {
          this.held[n] = value;
        }),
      );
    });
    this.choices.replaceChildren(...parts);
  }

  /** An axis takes its place; what was there goes where it came from. */
  setPlane(n, axis) {
    const other = this.plane.indexOf(axis);
    if (other >= 0) this.plane[other] = this.plane[n];
    this.plane[n] = axis;
  }

  select(name, options, chosen, change) {
    const id = `axis-${name.replace(/\W/g, "-")}`;
    const made = element(
      "select",
      {
        id,
        onchange: () => {
          change(made.selectedIndex);
          this.update();
          document.getElementById(id)?.focus();
        },
      },
      ...options.map((text, n) => element("option", { selected: n === chosen }, text)),
    );
    return element("span", {}, element("label", { for: id }, `${name} `), made);
  }

  choose(point) {
    const { sweep } = this,
      numbers = this.byPoint.get(point) ?? [];
    const where = sweep.axes.map(({ key }, n) => `${key} = ${sweep.places[point][n]}`).join(", ");
    const shares = Object.entries(QUESTIONS).map(([question, { name }]) =>
      element("li", {}, `${name}: ${told(share(sweep.runs, numbers, question))}`),
    );
    this.caseBox = element("div", { id: "run-case" });
    this.detail.replaceChildren(
      element("h3", {}, where || "all runs"),
      element("ul", {}, ...shares),
      this.runTable(point, numbers),
      this.caseBox,
    );
    for (const cell of this.diagrams.querySelectorAll("[data-point]")) {
      cell.classList.toggle("chosen", cell.dataset.point === String(point));
    }
    this.showCase(point, numbers[0]);
  }

  runTable(point, numbers) {
    const { runs } = this.sweep;
    const cell = (value, digits) =>
      typeof value === "number" ? short(value, digits) : (value ?? DASH);
    const whole = (value) => (typeof value === "number" ? grouped(value) : DASH);
    const rows = numbers.map((n) => [
      element(
        "button",
        { type: "button", onclick: () => this.showCase(point, n) },
        `run ${runs.run[n]}`,
      ),
      runs.seed[n],
      runs.status[n] === "failed" ? `failed: ${runs.error[n]}` : runs.status[n],
      runs.verdict[n] ?? DASH,
      whole(runs.separation_hits[n]),
      whole(runs.separation_first_collision[n]),
      runs.arrest_met[n] === 1
        ? `${whole(runs.arrest_collision[n])}, ${pairsIn(runs.arrest_pairs[n])}`
        : DASH,
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

  showCase(point, n) {
    if (n === undefined) return;
    const { sweep } = this,
      run = sweep.runs.run[n];
    const text = caseText(sweep, point, sweep.runs.seed[n]);
    const file = `${sweep.name.replace(/\.\w+$/, "").replace(/[^\w.-]/g, "_")}-run-${run}.toml`;
    this.caseBox.replaceChildren(
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
    );
  }
}

/** The resolved case of a run: that of its point with its own seed. */
export function caseText({ cases }, point, seed) {
  const changed = cases.points[point] ?? {};
  const lines = Array.isArray(changed) ? changed : cases.first.map((line, n) => changed[n] ?? line);
  return lines.map((line) => line.replace(/^seed = \d+/, `seed = ${seed}`)).join("\n");
}

function provenance(sweep) {
  return section(
    "case",
    "The sweep, and how to run it again",
    element(
      "p",
      {},
      `Begun by zenosphere ${sweep.program_version} (${sweep.git_hash}); master seed ${sweep.master_seed}.`,
    ),
    element(
      "pre",
      { class: "commands", tabindex: "0" },
      "build/zenosphere sweep SWEEP.toml   # the file below, beside its base case",
    ),
    element(
      "details",
      { open: true },
      element("summary", {}, "Sweep file"),
      element("pre", { tabindex: "0" }, sweep.sweep_file),
    ),
  );
}
