// One plot over the collision axis: bars from the smallest to the largest value of each entry.
import uPlot from "uplot";
import { COLLISIONS, LEFT, yAxis } from "./axes.js";
import { BLUE, GREY, INK, VERMILION } from "../shared/colours.js";
import { element } from "../shared/dom.js";
import { figureAsCanvas, figureAsSvg } from "./figure.js";
import { nameMarks } from "./marks.js";
import { csv, fileStem, saveMenu } from "../shared/save.js";

const HEIGHT = 168; // CSS pixels

export class Plot {
  /**
   * definition: {id, title, isLog, take(first, last, entries) -> {x, low, high}, range(data),
   *   paint(plot, context), read(n), rows, numbers(first, last) -> [head, rows], source}
   * selection: of collisions, or of what else the horizontal axis shows (axes.js)
   * marks: [{k, label}];  snapshotPlace() -> where on that axis the snapshot shown is
   */
  constructor(definition, selection, marks, snapshotPlace, horizontal = COLLISIONS) {
    Object.assign(this, { definition, selection, marks, snapshotPlace, horizontal });
    this.data = { x: [0], low: [NaN], high: [NaN] };
    this.readout = element("output", { class: "readout" });
    this.box = element(
      "div",
      {
        class: "plot",
        id: `plot-${definition.id}`,
        tabindex: "0",
        role: "group",
        "aria-label": `${definition.title}, against ${horizontal.name}`,
        onkeydown: (event) => this.key(event),
        onfocus: () => this.readout.setAttribute("aria-live", "polite"),
        onblur: () => this.readout.removeAttribute("aria-live"),
      },
      element(
        "div",
        { class: "plot-head" },
        element("h3", {}, definition.title),
        this.readout,
        this.saveMenu(),
      ),
    );
  }

  /** Draws for the first time; the box has to be in the page. */
  start() {
    const { definition } = this;
    this.chart = new uPlot(
      {
        width: this.box.clientWidth,
        height: definition.height ?? HEIGHT,
        legend: { show: false },
        padding: [10, 36, 0, 0],
        cursor: {
          sync: { key: this.horizontal.key, scales: ["x", null] },
          drag: { x: true, y: false, setScale: false },
          points: { show: !definition.rows, size: 7 },
          y: false,
        },
        scales: {
          x: { time: false, range: () => this.range() },
          y: {
            distr: definition.isLog ? 3 : 1,
            dir: definition.rows ? -1 : 1,
            range: () => definition.range(this.data),
          },
        },
        axes: [this.horizontal.axis, yAxis(definition)],
        series: [
          {},
          ...["high", "low"].map(() => ({
            stroke: INK,
            paths: () => null,
            points: { show: false },
          })),
        ],
        hooks: {
          draw: [(chart) => this.paint(chart.ctx)],
          setSelect: [(chart) => this.selected(chart)],
          setCursor: [(chart) => this.hover(chart)],
        },
      },
      [this.data.x, this.data.high, this.data.low],
      this.box,
    );
    this.box.addEventListener(
      "mousedown",
      () => {
        Plot.touched = this;
      },
      { capture: true },
    );
    this.chart.over.addEventListener("dblclick", () => this.selection.reset());
    new ResizeObserver(() => this.resize()).observe(this.box);
    this.update();
  }

  /** What the horizontal axis shows. */
  range() {
    const { first, last } = this.selection,
      margin = this.horizontal.margin(this.selection);
    return [first - margin, last + margin];
  }

  resize() {
    if (this.box.clientWidth !== this.chart.width && this.box.clientWidth > 0) {
      this.chart.setSize({ width: this.box.clientWidth, height: this.chart.height });
      this.update();
    }
  }

  /** Takes the data of what is selected. */
  update() {
    const { first, last } = this.selection;
    this.data = this.definition.take(first, last, Math.max(100, this.box.clientWidth - LEFT));
    this.chart.batch(() => {
      this.chart.setData([this.data.x, this.data.high, this.data.low], false);
      this.chart.setScale("x", { min: first, max: last });
    });
    const { min, max } = this.chart.scales.x;
    Object.assign(this.box.dataset, { first: min, last: max });
    this.hover(this.chart);
  }

  redraw() {
    this.chart.redraw(false);
  }

  /** A range was dragged: here, or in another plot, which will tell everybody. */
  selected(chart) {
    const { left, width } = chart.select;
    if (width === 0) return;
    chart.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    if (width < 3 || Plot.touched !== this) return;
    const [first, last] = [left, left + width].map((x) => chart.posToVal(x, "x"));
    this.selection.set(first, last);
  }

  hover(chart) {
    const n = chart.cursor.idx;
    this.readout.textContent = n === null || n === undefined ? "" : (this.definition.read(n) ?? "");
  }

  key(event) {
    const { selection } = this;
    const at = this.chart.cursor.idx === null ? undefined : this.data.x[this.chart.cursor.idx];
    const actions = {
      ArrowLeft: () => (event.shiftKey ? selection.pan(-0.2) : this.step(-1)),
      ArrowRight: () => (event.shiftKey ? selection.pan(0.2) : this.step(1)),
      "+": () => selection.zoom(0.5, at),
      "=": () => selection.zoom(0.5, at),
      "-": () => selection.zoom(2, at),
      0: () => selection.reset(),
      Escape: () => selection.reset(),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    actions[event.key]();
  }

  /** Moves the cursor by an entry of at least a pixel. */
  step(direction) {
    const { chart, data } = this;
    const n = Math.max(
      0,
      Math.min(data.x.length - 1, (chart.cursor.idx ?? -direction) + direction),
    );
    const left = chart.valToPos(data.x[n], "x");
    chart.setCursor({ left, top: chart.bbox.height / 2 / devicePixelRatio }, true);
  }

  saveMenu() {
    const { definition, selection } = this;
    const figure = () => ({
      chart: this.chart,
      title: definition.title,
      subtitle: definition.source,
      paint: (ctx) => this.paint(ctx),
    });
    return saveMenu(definition.title, () => fileStem(definition.source, definition.id), {
      png: () => figureAsCanvas(figure()),
      svg: () => figureAsSvg(figure()),
      csv: () => csv(...definition.numbers(selection.first, selection.last)),
    });
  }

  /** Draws on a context that has the pixels of the chart's canvas. */
  paint(ctx) {
    const { bbox } = this.chart;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.textAlign = "start";
    ctx.textBaseline = "alphabetic";
    if (this.definition.paint) this.definition.paint(this, ctx);
    else this.paintBars(ctx);
    this.paintMarks(ctx);
    ctx.restore();
  }

  x(value) {
    return this.chart.valToPos(value, "x", true);
  }
  y(value) {
    return this.chart.valToPos(value, "y", true);
  }

  /** A bar, or a dot, for each entry. */
  paintBars(ctx, colour = INK) {
    const { x, low, high } = this.data;
    const wide = Math.max(1, Math.min(4, Math.round((this.chart.bbox.width / x.length) * 0.6)));
    const dot = Math.max(2, wide);
    ctx.fillStyle = colour;
    for (let n = 0; n < x.length; ++n) {
      if (Number.isNaN(low[n])) continue;
      const top = Math.round(this.y(high[n]) - dot / 2),
        bottom = Math.round(this.y(low[n]) + dot / 2);
      const isDot = bottom - top <= dot + 1; // a single value: as wide as high
      ctx.fillRect(Math.round(this.x(x[n]) - wide / 2), top, isDot ? dot : wide, bottom - top);
    }
  }

  /** A line through the entries. */
  paintLine(ctx, colour = INK) {
    const { x, high } = this.data;
    ctx.strokeStyle = colour;
    ctx.lineWidth = 1.4 * devicePixelRatio;
    ctx.beginPath();
    x.forEach((k, n) => ctx.lineTo(this.x(k), this.y(high[n])));
    ctx.stroke();
  }

  paintMarks(ctx) {
    const { top, height } = this.chart.bbox;
    const line = (k, colour, dash) => {
      ctx.strokeStyle = colour;
      ctx.setLineDash(dash.map((length) => length * devicePixelRatio));
      ctx.lineWidth = devicePixelRatio;
      ctx.beginPath();
      ctx.moveTo(this.x(k), top);
      ctx.lineTo(this.x(k), top + height);
      ctx.stroke();
      ctx.setLineDash([]);
    };
    for (const { k } of this.marks) line(k, BLUE, []);
    if (this.definition.hasMarkNames) nameMarks(this, ctx);
    line(this.snapshotPlace(), GREY, [4, 3]);
  }

  /** Ticks at the collisions of some entries. */
  paintTicks(ctx, entries, value, colour = VERMILION) {
    const half = 4 * devicePixelRatio;
    ctx.fillStyle = colour;
    for (const n of entries) {
      ctx.fillRect(
        this.x(this.data.x[n]) - devicePixelRatio / 2,
        this.y(value) - half,
        devicePixelRatio,
        2 * half,
      );
    }
  }
}
