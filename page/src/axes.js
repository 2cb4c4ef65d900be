// The axes of the plots over collisions.
import { INK } from "./colours.js";
import { grouped, power, short } from "./format.js";

export const LEFT = 98; // CSS pixels, for its numbers and the names of pairs
const FONT = "12px system-ui, sans-serif";

/** Places of the ticks of a logarithmic axis: every decade, or every few. */
export function decades(low, high) {
  const first = Math.ceil(Math.log10(low) - 1e-9),
    last = Math.floor(Math.log10(high) + 1e-9);
  const step = Math.max(1, Math.ceil((last - first) / 6));
  const places = [];
  for (let n = Math.ceil(first / step) * step; n <= last; n += step) places.push(10 ** n);
  return places;
}

/** The vertical axis of a plot (plot.js says what a definition is), as uPlot wants it. */
export function yAxis(definition) {
  const common = {
    size: LEFT,
    font: FONT,
    stroke: INK,
    grid: { stroke: "#e6e9ee", width: 1 },
    ticks: { stroke: "#c9d0d8", width: 1, size: 5 },
  };
  if (definition.rows) {
    return {
      ...common,
      grid: { show: false },
      splits: () => definition.rows().map((_, n) => n),
      values: () => definition.rows(),
      font: "11px system-ui, sans-serif",
    };
  }
  if (!definition.isLog)
    return { ...common, values: (_, places, __, ___, step) => linearNames(places, step) };
  return {
    ...common,
    splits: (_, __, low, high) => decades(low, high),
    filter: (_, places) => places,
    values: (_, places) => places.map((y) => power(Math.round(Math.log10(y)))),
  };
}

/** Numbers `step` apart; where that is far behind the point, from the second on what is added. */
function linearNames(places, step) {
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  if (decimals <= 7) return places.map((y) => y.toFixed(decimals).replace("-", "\u2212"));
  return places.map((y, n) => (n ? `+${short(y - places[0], 2)}` : y.toPrecision(8)));
}

/** That of collision numbers. */
export const xAxis = {
  font: FONT,
  stroke: INK,
  size: 30,
  space: 90,
  grid: { stroke: "#f0f2f5", width: 1 },
  ticks: { stroke: "#c9d0d8", width: 1, size: 5 },
  values: (_, places) => places.map((k) => (Number.isInteger(k) ? grouped(k) : "")),
};
