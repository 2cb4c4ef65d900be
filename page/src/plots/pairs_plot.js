// The plot of which pair collides.
import { INK, VERMILION } from "../shared/colours.js";
import { count, DASH, grouped, pairName } from "../shared/format.js";

const RASTER_ROWS = 10; // most_pairs of src/report/frequent_pairs.hpp
const MOST_NAMED = 4; // pairs of a bin

/** "3 others" as the name of the last row, "1 other" where it is one. */
const othersName = (number) => `${grouped(number)} other${number === 1 ? "" : "s"}`;

/**
 * Rows of a stretch that holds every collision: the pairs that collide most often in a part of it.
 *
 * Raster: {names, tell(n), each(n, draw(row, isHit)), numbers(n)} of the entries begin + n
 */
function rowsOfCollisions(stretch, begin, end, spheres) {
  const found = new Map();
  const key = (n) => stretch.i[n] * (spheres + 2) + stretch.j[n];
  for (let n = begin; n < end; ++n) found.set(key(n), (found.get(key(n)) ?? 0) + 1);
  const most = [...found]
    .sort((a, b) => b[1] - a[1])
    .slice(0, found.size === RASTER_ROWS + 1 ? found.size : RASTER_ROWS)
    .map(([pair]) => pair);
  const rank = new Map(most.map((pair, n) => [pair, n]));
  const names = most.map((pair) =>
    pairName([Math.floor(pair / (spheres + 2)), pair % (spheres + 2)], spheres),
  );
  if (found.size > most.length) names.push(othersName(found.size - most.length));
  const row = (n) => rank.get(key(begin + n)) ?? most.length;
  const isHit = (n) => stretch.flags[begin + n] & 1;
  return {
    names,
    each: (n, draw) => draw(row(n), isHit(n)),
    tell(n) {
      const often = found.get(key(begin + n));
      const pair = pairName([stretch.i[begin + n], stretch.j[begin + n]], spheres);
      const times = row(n) < most.length ? ` (${count(often, "time")} in view)` : "";
      return `collision ${grouped(stretch.k[begin + n])}: pair ${pair}${times}`;
    },
    head: ["collision", "i", "j", "hit"],
    numbers: (n) => [stretch.k[begin + n], stretch.i[begin + n], stretch.j[begin + n], isHit(n)],
  };
}

/** The same of bins: the pairs that are most frequent in the whole log. */
function rowsOfBins(stretch, begin, spheres) {
  const { pairs, pairMask, k, size, last } = stretch;
  const names = [...pairs.map((pair) => pairName(pair, spheres)), "others"];
  const collides = (n, row) => (pairMask[begin + n] >> row) & 1;
  const isHit = (n, row) => (pairMask[begin + n] >> (row + RASTER_ROWS + 1)) & 1;
  const bit = (row) => (row < pairs.length ? row : RASTER_ROWS);
  const rows = [...names.keys()].map(bit);
  const end = (n) => (begin + n + 1 < size ? k[begin + n + 1] - 1 : last);
  return {
    names,
    each(n, draw) {
      rows.forEach((at, row) => collides(n, at) && draw(row, isHit(n, at)));
    },
    tell(n) {
      const found = names.filter((_, row) => collides(n, rows[row]));
      const told = found.slice(0, MOST_NAMED).join(", ");
      const rest = found.length > MOST_NAMED ? ` and ${found.length - MOST_NAMED} more rows` : "";
      return `collisions ${grouped(k[begin + n])}${DASH}${grouped(end(n))}: ${told}${rest}`;
    },
    head: ["first_collision", "last_collision", ...pairs.map(([i, j]) => `${i}-${j}`), "others"],
    numbers: (n) => [
      k[begin + n],
      end(n),
      ...rows.map((at) => collides(n, at) + isHit(n, at)), // 0 no, 1 collides, 2 hits
    ],
  };
}

/** The rows for a part of a view of the log, and the numbers of its entries; null where unknown. */
function rasterOf(view, spheres) {
  const { stretch, begin } = view;
  const end = Math.min(stretch.size, begin + view.size * view.group);
  const made = stretch.i
    ? rowsOfCollisions(stretch, begin, end, spheres)
    : stretch.pairMask && rowsOfBins(stretch, begin, spheres);
  return made && { ...made, x: stretch.k.subarray(begin, end) };
}

/** The definition of the plot; take(first, last, entries) gives a view of the log. */
export function pairsPlot(run, take) {
  let raster = null;
  const rasterIn = (first, last, entries) => {
    const view = take(first, last, entries);
    return view && rasterOf(view, run.spheres);
  };
  return {
    id: "pairs",
    title: "Pairs that collide: the most frequent ones",
    isLog: false,
    height: 268,
    rows: () => raster?.names ?? [],
    take(first, last, entries) {
      raster = rasterIn(first, last, entries);
      if (!raster) return { x: [first, last], low: [NaN, NaN], high: [NaN, NaN] };
      const nothing = new Float64Array(raster.x.length);
      return { x: raster.x, low: nothing, high: nothing };
    },
    range: () => [-0.6, Math.max(raster?.names.length ?? 1, 3) - 0.4],
    read: (n) => (raster && n < raster.x.length ? raster.tell(n) : ""),
    numbers(first, last) {
      const all = rasterIn(first, last, Infinity);
      if (!all) return [["collision"], []];
      return [all.head, Array.from(all.x, (_, n) => all.numbers(n))];
    },
    paint(plot, ctx) {
      if (!raster) return tellNone(plot, ctx);
      const half = Math.min(7, 60 / raster.names.length) * devicePixelRatio;
      const wide =
        Math.max(1, Math.min(3, plot.chart.bbox.width / raster.x.length / 2)) * devicePixelRatio;
      const last = new Map(); // pixel drawn last in a row, so that none is drawn a thousand times
      raster.x.forEach((k, n) => {
        const x = Math.round(plot.x(k) - wide / 2);
        raster.each(n, (row, isHit) => {
          const place = 2 * row + isHit;
          if (last.get(place) === x) return;
          last.set(place, x);
          ctx.fillStyle = isHit ? VERMILION : INK;
          ctx.fillRect(x, plot.y(row) - half, wide, 2 * half);
        });
      });
    },
  };
}

function tellNone(plot, ctx) {
  const { left, top, width, height } = plot.chart.bbox;
  ctx.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
  ctx.fillStyle = INK;
  ctx.textAlign = "center";
  ctx.fillText("The run kept no collision log.", left + width / 2, top + height / 2);
}
