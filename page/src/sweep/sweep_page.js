// The page of a sweep: phase diagrams, and the runs and the case file of a point.
import { diagram, diagramAsCanvas, diagramAsSvg, told } from "./diagram.js";
import { element, section } from "../shared/dom.js";
import { DASH, grouped } from "../shared/format.js";
import { licencesSection } from "../shared/provenance.js";
import { csv, fileStem, saveMenu } from "../shared/save.js";
import { findingQuestions, hasResult, QUESTIONS, runsByPoint, share } from "./statistics.js";
import { runsOfPoint } from "./sweep_runs.js";
import { axisName, symbol } from "./symbols.js";

/** Whether a value of an axis is the one of a column, where lists and true or false are text. */
const isSame = (value, stored) =>
  value === stored || JSON.stringify(value) === String(stored).replace(/\s/g, "");

const NO_AXIS = { key: "", name: "all runs", symbol: "all runs", values: [""] };

/** "e = 0.2", with the key for those who want to know. */
const placeOn = (axis, value) =>
  element("span", { title: axis.key }, `${symbol(axis.key)} = ${value}`);

/** Parts with commas in between. */
const listed = (parts) => parts.flatMap((part, n) => (n ? [", ", part] : [part]));

export function sweepPage(root, sweep) {
  document.title = `${sweep.name} ${DASH} Zenosphere report`;
  root.append(header(sweep), ...new SweepView(sweep).parts, provenance(sweep), licencesSection());
}

function header(sweep) {
  const { status } = sweep.runs,
    of = (word) => status.filter((one) => one === word).length;
  const axes = sweep.axes.flatMap(({ key, values }, n) => [
    n ? " \u00d7 " : "",
    element("span", { title: key }, `${symbol(key)} (${values.length})`),
  ]);
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
      `${grouped(status.length)} runs${rest}; `,
      ...(axes.length ? axes : ["no axes"]),
      sweep.seeds
        ? `, ${grouped(sweep.seeds)} seeds`
        : `, a search along ${symbol(sweep.axes.at(-1).key)}: the shares are those of the runs it made there`,
    ),
  );
}

/** What of the sweep is looked at: two axes in the plane, one value on each of the others. */
class SweepView {
  constructor(sweep) {
    this.sweep = sweep;
    this.findings = findingQuestions(sweep.runs);
    this.questions = { ...QUESTIONS, ...this.findings };
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
          "Share of the runs that are done, with its 95 % interval (Wilson). Met, left and open " +
            "are said of the computation; what hits were is for zenosphere adjudicate to tell" +
            (Object.keys(this.findings).length
              ? ": its findings are shares of the runs that have been adjudicated. "
              : ". ") +
            "Click a point, or go there with the arrow keys and press Enter.",
        ),
      ),
      section("runs", "Runs of a point", this.detail),
    ];
    this.update();
  }

  axis(n) {
    if (n < 0) return null;
    const { key, values } = this.sweep.axes[n];
    return { key, values, name: axisName(key), symbol: symbol(key) };
  }

  update() {
    this.drawChoices();
    const [x, y] = this.plane.map((n) => this.axis(n));
    const cells = this.cells();
    this.diagrams.replaceChildren(
      ...Object.entries(this.questions).map(([id, question]) => {
        const shares = cells.map((cell) => ({
          ...cell,
          share: share(this.sweep.runs, cell.runs, question),
        }));
        const { name } = question;
        const drawn = diagram(name, x ?? NO_AXIS, y, shares, (point) => this.choose(point));
        const menu = saveMenu(name, () => fileStem(this.sweep.name, id), {
          png: () => diagramAsCanvas(drawn, name),
          svg: () => diagramAsSvg(drawn, name),
          csv: () => this.table(shares),
        });
        return element(
          "figure",
          { id: `diagram-${id}` },
          element("div", { class: "plot-head" }, element("figcaption", {}, name), menu),
          drawn,
        );
      }),
    );
  }

  /** Shares as CSV, with the point on all axes. */
  table(shares) {
    const { axes, places } = this.sweep;
    return csv(
      [...axes.map(({ key }) => key), "runs_with", "runs", "share", "low", "high"],
      shares.map(({ point, share: { hits, runs, share: part, low, high } }) => [
        ...places[point],
        hits,
        runs,
        part,
        low,
        high,
      ]),
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
          { id: name, name },
          axes.map(({ key }) => ({ value: key, text: symbol(key) })),
          this.plane[n],
          (value) => this.setPlane(n, value),
        ),
      );
    axes.forEach((axis, n) => {
      if (this.plane.includes(n)) return;
      parts.push(
        this.select(
          { id: axis.key, name: symbol(axis.key), title: axis.key },
          axis.values.map((value) => ({ value: String(value), text: String(value) })),
          this.held[n],
          (value) => {
            this.held[n] = value;
          },
        ),
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

  /** about: {id, name, title};  options: [{value, text}] */
  select(about, options, chosen, change) {
    const id = `axis-${about.id.replace(/\W/g, "-")}`;
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
      ...options.map(({ value, text }, n) =>
        element("option", { value, title: value, selected: n === chosen }, text),
      ),
    );
    return element(
      "span",
      { title: about.title },
      element("label", { for: id }, `${about.name} `),
      made,
    );
  }

  choose(point) {
    const { sweep } = this,
      numbers = this.byPoint.get(point) ?? [];
    const where = sweep.axes.map((axis, n) => placeOn(axis, sweep.places[point][n]));
    const shares = Object.values(this.questions).map((question) =>
      element("li", {}, `${question.name}: ${told(share(sweep.runs, numbers, question))}`),
    );
    this.detail.replaceChildren(
      element("h3", {}, ...(where.length ? listed(where) : ["all runs"])),
      element("ul", {}, ...shares),
      ...runsOfPoint(sweep, point, numbers),
    );
    for (const cell of this.diagrams.querySelectorAll("[data-point]")) {
      cell.classList.toggle("chosen", cell.dataset.point === String(point));
    }
  }
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
