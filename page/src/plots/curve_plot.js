// A plot of curves over something other than collisions, with its menu for saving.
import uPlot from "uplot";
import { BLUE, GREEN, GREY, INK, SKY, VERMILION } from "../shared/colours.js";
import { element } from "../shared/dom.js";
import { DASH, short } from "../shared/format.js";
import { csv, fileStem, saveMenu } from "../shared/save.js";
import { linearNames, logNames, logTicks } from "./axes.js";
import { figureAsCanvas, figureAsSvg } from "./figure.js";

const COLOURS = [INK, VERMILION, BLUE, GREEN, SKY, GREY];
const HEIGHT = 220;

/**
 * x: { label, name (in the legend), values, inTable ({ name, values }; default: the same) }
 * curves: [{ name, values }, ...], as long as x; null where nothing is known
 * scale of y: "logarithmic", "from zero" or, by default, that of the values
 * stem: parts of the name of a saved file, behind that of the run
 */
export function curvePlot({ id, title, run, stem, x, curves, scale }) {
  const place = element("div", { id, class: "series" });
  const head = element("div", { class: "plot-head" }, element("h3", {}, title));
  place.append(head);
  requestAnimationFrame(() => {
    const data = [x.values, ...curves.map((curve) => curve.values)];
    const chart = new uPlot(options(place, x, curves, scale), data, place);
    const figure = () => ({ chart, title, subtitle: run.name, paint: (ctx) => paint(ctx, chart) });
    head.append(
      saveMenu(title, () => fileStem(run.name, ...stem), {
        png: () => figureAsCanvas(figure()),
        svg: () => figureAsSvg(figure()),
        csv: () => tableOf(x.inTable ?? x, curves),
      }),
    );
    new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height: HEIGHT })).observe(
      place,
    );
  });
  return place;
}

function tableOf(x, curves) {
  return csv(
    [x.name, ...curves.map((curve) => curve.name)],
    x.values.map((value, n) => [value, ...curves.map(({ values }) => values[n])]),
  );
}

const SCALES = {
  logarithmic: { distr: 3 },
  "from zero": { range: (_, __, high) => [0, high > 0 ? 1.1 * high : 1] },
};

function options(place, x, curves, scale) {
  const numbers = (_, places, __, ___, step) => linearNames(places, step);
  const decades = {
    splits: (_, __, low, high) => logTicks(low, high),
    filter: (_, places) => places,
    values: (_, places) => logNames(places),
  };
  return {
    width: place.clientWidth,
    height: HEIGHT,
    padding: [10, 14, 0, 0],
    scales: { x: { time: false }, y: SCALES[scale] ?? {} },
    axes: [
      { label: x.label, stroke: INK, size: 34, labelSize: 22, values: numbers },
      { size: 74, stroke: INK, ...(scale === "logarithmic" ? decades : { values: numbers }) },
    ],
    series: [
      { label: x.name, value: (_, value) => short(value, 6) },
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
