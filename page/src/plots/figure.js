// A plot as a figure of its own: title, axes and what is drawn, on any context.
import { GREY, INK } from "../shared/colours.js";
import { SvgContext } from "./svg_context.js";

const TITLE = 30; // CSS pixels above the plot
const FAMILY = "system-ui, sans-serif";
const LEAST_SCALE = 2; // pixels of a PNG a CSS pixel

/**
 * figure: {chart, title, subtitle, paint(ctx)}; chart of uPlot, paint in its pixels on a canvas
 */
function paintFigure(ctx, { chart, title, subtitle, paint }) {
  const unit = devicePixelRatio;
  const { width } = chart.ctx.canvas;
  ctx.textBaseline = "alphabetic";
  ctx.fillStyle = INK;
  ctx.textAlign = "left";
  ctx.font = `600 ${13 * unit}px ${FAMILY}`;
  ctx.fillText(title, 8 * unit, 20 * unit);
  ctx.fillStyle = GREY;
  ctx.textAlign = "right";
  ctx.font = `${11 * unit}px ${FAMILY}`;
  ctx.fillText(subtitle, width - 8 * unit, 20 * unit);
  ctx.save();
  ctx.translate(0, TITLE * unit);
  chart.axes.forEach((axis, n) => paintAxis(ctx, chart, axis, n === 1));
  paint(ctx);
  ctx.restore();
}

/** Grid, ticks and names of an axis, as uPlot has placed them. */
function paintAxis(ctx, chart, axis, isVertical) {
  const unit = devicePixelRatio;
  const { left, top, width, height } = chart.bbox;
  const line = (x1, y1, x2, y2, colour) => {
    ctx.strokeStyle = colour;
    ctx.lineWidth = unit;
    ctx.beginPath();
    ctx.moveTo(x1, y1);
    ctx.lineTo(x2, y2);
    ctx.stroke();
  };
  ctx.font = `${12 * unit}px ${FAMILY}`;
  ctx.textAlign = isVertical ? "right" : "center";
  ctx.textBaseline = isVertical ? "middle" : "top";
  const names = axis._values ?? [];
  (axis._splits ?? []).forEach((value, n) => {
    if (names[n] === "" || names[n] === undefined) return;
    const at = chart.valToPos(value, isVertical ? "y" : "x", true);
    if (axis.grid.show && isVertical) line(left, at, left + width, at, "#e6e9ee");
    else if (axis.grid.show) line(at, top, at, top + height, "#e6e9ee");
    ctx.fillStyle = INK;
    if (isVertical) ctx.fillText(names[n], left - 8 * unit, at);
    else ctx.fillText(names[n], at, top + height + 8 * unit);
  });
  if (axis.label) paintLabel(ctx, chart, axis.label, isVertical);
}

function paintLabel(ctx, chart, label, isVertical) {
  const unit = devicePixelRatio;
  const { left, top, width, height } = chart.bbox;
  ctx.save();
  ctx.fillStyle = INK;
  ctx.textAlign = "center";
  ctx.textBaseline = "alphabetic";
  if (isVertical) {
    ctx.translate(14 * unit, top + height / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.fillText(label, 0, 0);
  } else {
    ctx.fillText(label, left + width / 2, top + height + 36 * unit);
  }
  ctx.restore();
}

const sizeOf = ({ chart }) => {
  const { width, height } = chart.ctx.canvas;
  return [width, height + TITLE * devicePixelRatio];
};

/** The figure as a text in SVG. */
export function figureAsSvg(figure) {
  const ruler = document.createElement("canvas").getContext("2d");
  const measured = (font, text) => {
    ruler.font = font;
    return ruler.measureText(text).width;
  };
  const ctx = new SvgContext(...sizeOf(figure), measured);
  ctx.fillStyle = "#fff";
  ctx.fillRect(0, 0, ctx.width, ctx.height);
  paintFigure(ctx, figure);
  return ctx.toString();
}

/** The figure on a canvas, at least `LEAST_SCALE` pixels for each of the screen's. */
export function figureAsCanvas(figure) {
  const scale = Math.max(1, LEAST_SCALE / devicePixelRatio);
  const [width, height] = sizeOf(figure);
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width * scale, height * scale].map(Math.round);
  const ctx = canvas.getContext("2d");
  ctx.scale(scale, scale);
  ctx.fillStyle = "#fff";
  ctx.fillRect(0, 0, width, height);
  paintFigure(ctx, figure);
  return canvas;
}
