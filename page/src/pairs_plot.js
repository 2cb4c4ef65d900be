// The plot of which pair collides.
import { INK, VERMILION } from "./colours.js";
import { count, grouped, pairName } from "./format.js";

const RASTER_ROWS = 10;

/** The pairs that collide most often in a part of a stretch, and the row of each collision. */
function ranked(stretch, begin, end, spheres) {
  const found = new Map();
  const key = (n) => stretch.i[n] * (spheres + 2) + stretch.j[n];
  for (let n = begin; n < end; ++n) found.set(key(n), (found.get(key(n)) ?? 0) + 1);
  const most = [...found]
    .sort((a, b) => b[1] - a[1])
    .slice(0, RASTER_ROWS)
    .map(([pair]) => pair);
  const rank = new Map(most.map((pair, n) => [pair, n]));
  const names = most.map((pair) =>
    pairName([Math.floor(pair / (spheres + 2)), pair % (spheres + 2)], spheres),
  );
  if (found.size > most.length) names.push(`${grouped(found.size - most.length)} others`);
  return {
    names,
    counts: most.map((pair) => found.get(pair)),
    row: (n) => rank.get(key(n)) ?? most.length,
  };
}

/** The definition of the plot; take(first, last, entries) gives a view of the log. */
export function pairsPlot(run, take) {
  let pairs = null,
    view = null;
  return {
    id: "pairs",
    title: "Pair that collides: the most frequent ones",
    isLog: false,
    height: 250,
    rows: () => pairs?.names ?? [],
    take(first, last, entries) {
      view = take(first, last, entries);
      pairs = null;
      if (!view?.stretch.i) return { x: [first, last], low: [NaN, NaN], high: [NaN, NaN] };
      const { stretch, begin } = view;
      const end = Math.min(stretch.size, begin + view.size * view.group);
      pairs = ranked(stretch, begin, end, run.spheres);
      return {
        x: stretch.k.subarray(begin, end),
        low: new Float64Array(end - begin),
        high: new Float64Array(end - begin),
      };
    },
    range: () => [-0.6, Math.max(pairs?.names.length ?? 1, 3) - 0.4],
    read(n) {
      if (!pairs) return "";
      const row = view.begin + n,
        { stretch } = view;
      if (row >= stretch.size) return "";
      const rank = pairs.row(row),
        often = pairs.counts[rank];
      return (
        `collision ${grouped(stretch.k[row])}: pair ` +
        pairName([stretch.i[row], stretch.j[row]], run.spheres) +
        (often ? ` (${count(often, "time")} in view)` : "")
      );
    },
    paint(plot, ctx) {
      if (!pairs) return tellWhere(plot, ctx);
      const half = Math.min(7, 60 / pairs.names.length) * devicePixelRatio;
      const wide =
        Math.max(1, Math.min(3, plot.chart.bbox.width / plot.data.x.length / 2)) * devicePixelRatio;
      const last = new Map(); // pixel drawn last in a row, so that none is drawn a thousand times
      plot.data.x.forEach((k, n) => {
        const isHit = view.stretch.flags[view.begin + n] & 1,
          rank = pairs.row(view.begin + n);
        const x = Math.round(plot.x(k) - wide / 2),
          place = 2 * rank + isHit;
        if (last.get(place) === x) return;
        last.set(place, x);
        ctx.fillStyle = isHit ? VERMILION : INK;
        ctx.fillRect(x, plot.y(rank) - half, wide, 2 * half);
      });
    },
  };
}

function tellWhere(plot, ctx) {
  const { left, top, width, height } = plot.chart.bbox;
  ctx.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
  ctx.fillStyle = INK;
  ctx.textAlign = "center";
  ctx.fillText(
    "Pairs are kept near hits and arrest: the buttons above go there.",
    left + width / 2,
    top + height / 2,
  );
}
