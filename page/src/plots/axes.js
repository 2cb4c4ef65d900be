// The axes of the plots over collisions.
import { INK } from "../shared/colours.js";
import { grouped, power, short } from "../shared/format.js";

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

/** Places of round numbers between two others, at least two of them. */
function roundPlaces(low, high) {
  const decade = 10 ** Math.floor(Math.log10(high - low));
  for (const part of [1, 0.5, 0.2, 0.1]) {
    const step = part * decade,
      first = Math.ceil(low / step - 1e-9),
      last = Math.floor(high / step + 1e-9);
    if (last > first) return Array.from({ length: last - first + 1 }, (_, n) => (first + n) * step);
  }
  return [];
}

/** Ticks of a logarithmic axis: decades, or, where fewer than two are in view, what lies between. */
export function logTicks(low, high) {
  const whole = decades(low, high);
  if (whole.length > 1 || !(high > low)) return whole;
  const first = Math.floor(Math.log10(low)),
    last = Math.ceil(Math.log10(high));
  const parts = [];
  for (let n = first; n <= last; ++n) {
    for (const digit of [1, 2, 5]) {
      const place = Number(`${digit}e${n}`);
      if (place >= low && place <= high) parts.push(place);
    }
  }
  return parts.length > 1 ? parts : roundPlaces(low, high);
}

/** Names of such ticks: powers of ten where all of them are. */
export function logNames(places) {
  const exponents = places.map(Math.log10);
  const isWhole = exponents.every((n) => Math.abs(n - Math.round(n)) < 1e-9);
  return isWhole ? exponents.map((n) => power(Math.round(n))) : places.map((y) => short(y, 3));
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
    splits: (_, __, low, high) => logTicks(low, high),
    filter: (_, places) => places,
    values: (_, places) => logNames(places),
  };
}

/** Numbers `step` apart; where that is far behind the point, from the second on what is added. */
export function linearNames(places, step) {
  let decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  const scaled = step * 10 ** decimals;
  if (Math.abs(scaled - Math.round(scaled)) > 1e-6) ++decimals; // steps of 0.25
  if (decimals <= 7) return places.map((y) => y.toFixed(decimals).replace("-", "\u2212"));
  return places.map((y, n) => (n ? `+${short(y - places[0], 2)}` : y.toPrecision(8)));
}

const horizontal = {
  font: FONT,
  labelFont: FONT,
  labelSize: 18,
  stroke: INK,
  size: 26,
  space: 90,
  grid: { stroke: "#f0f2f5", width: 1 },
  ticks: { stroke: "#c9d0d8", width: 1, size: 5 },
};

/** That of collision numbers: what plot.js asks of a horizontal axis. */
export const COLLISIONS = {
  name: "the number of collisions",
  key: "collisions",
  margin: () => 0.5,
  axis: {
    ...horizontal,
    label: "Collisions",
    values: (_, places) => places.map((k) => (Number.isInteger(k) ? grouped(k) : "")),
  },
};

/** That of the time, or of the strain. */
export const timeAxis = (label) => ({
  name: label.toLowerCase(),
  key: "time",
  margin: ({ first, last }) => 0.02 * (last - first),
  axis: { ...horizontal, label, values: (_, places, __, ___, step) => linearNames(places, step) },
});
