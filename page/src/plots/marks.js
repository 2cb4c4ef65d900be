// Lines with names in a plot.
import { BLUE } from "../shared/colours.js";

const MARK_FONT = 11; // CSS pixels

/** Names the marks of a plot (plot.js), one below the other. */
export function nameMarks(plot, ctx) {
  ctx.font = `${MARK_FONT * devicePixelRatio}px system-ui, sans-serif`;
  const { left, top, width: wide } = plot.chart.bbox,
    space = 4 * devicePixelRatio;
  const high = (MARK_FONT + 4) * devicePixelRatio;
  const { first, last } = plot.selection;
  plot.marks
    .filter(({ k }) => k >= first && k <= last)
    .forEach(({ k, label }, n) => {
      const width = ctx.measureText(label).width + 2 * space;
      const at = Math.min(Math.max(left, plot.x(k) + space), left + wide - width);
      ctx.fillStyle = "rgb(255 255 255 / 0.9)";
      ctx.fillRect(at, top + n * high, width, high);
      ctx.fillStyle = BLUE;
      ctx.fillText(label, at + space, top + (n + 0.8) * high);
    });
}

/** A horizontal dashed line with a name. */
export function paintLevel(plot, ctx, value, name) {
  const { left, width } = plot.chart.bbox;
  ctx.strokeStyle = ctx.fillStyle = "black";
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([6 * devicePixelRatio, 3 * devicePixelRatio]);
  ctx.beginPath();
  ctx.moveTo(left, plot.y(value));
  ctx.lineTo(left + width, plot.y(value));
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.font = `${MARK_FONT * devicePixelRatio}px system-ui, sans-serif`;
  const wide = ctx.measureText(name).width,
    space = 4 * devicePixelRatio;
  ctx.fillStyle = "rgb(255 255 255 / 0.9)";
  ctx.fillRect(
    left + width - wide - 2 * space,
    plot.y(value) - 4 * space,
    wide + 2 * space,
    3.6 * space,
  );
  ctx.fillStyle = "black";
  ctx.fillText(name, left + width - wide - space, plot.y(value) - 1.3 * space);
}
