// How the collapsing cluster decays: gap, closing speed and flight of its collisions.
import uPlot from "uplot";
import { logNames, logTicks } from "../plots/axes.js";
import { BLUE, INK, VERMILION } from "../shared/colours.js";
import { button, element, section } from "../shared/dom.js";
import { figureAsCanvas, figureAsSvg } from "../plots/figure.js";
import { grouped, pairName, short } from "../shared/format.js";
import { csv, fileStem, saveMenu } from "../shared/save.js";

const CURVES = [
  ["gap", "gap closed", INK, "gap", "diameters"],
  ["normal_speed", "closing speed", VERMILION, "speed", "diameters/time"],
  ["flight", "flight", BLUE, "flight", "time"],
];
const SHAPES = ["square", "triangle", "circle"]; // not colour alone
const TITLES = { hit: "first hit", arrest: "arrest" };

/** The section, or nothing where nothing collapsed. */
export function anatomySection(run) {
  const found = Object.keys(TITLES).filter((which) => run.anatomy[which]);
  if (!found.length) return [];
  const place = element("div", { class: "decay" }),
    text = element("p", { class: "caption", role: "status" });
  const show = (which) => {
    place.replaceChildren();
    text.textContent = describe(run.anatomy[which]);
    requestAnimationFrame(() => decayPlot(run, run.anatomy[which], place, which));
    buttons.forEach((made, n) => made.setAttribute("aria-pressed", String(found[n] === which)));
  };
  const buttons = found.map((which) => button(TITLES[which], () => show(which)));
  const box = section(
    "anatomy",
    "Anatomy: how its cluster decays",
    element("div", { class: "row" }, ...buttons),
    place,
    text,
  );
  show(found[0]);
  return [box];
}

function describe({ decay, clusters: [cluster], collision }) {
  const parts = CURVES.map(([, name, , key]) => {
    if (!decay[key]) return null;
    const exact = decay.exact
      ? ` (straight chain of ${cluster.chain.length}: ${short(decay.exact[key])})`
      : "";
    return `${name} \u00d7 ${short(decay[key].ratio)}${exact}`;
  }).filter(Boolean);
  const factors = parts.length
    ? `Factors per collision: ${parts.join("; ")}.`
    : "No factor could be measured.";
  const end =
    decay.collapse_time === null
      ? ""
      : ` The series would end at time ${short(decay.collapse_time, 10)}.`;
  return `Up to collision ${grouped(collision)}. ${factors}${end}`;
}

function decayPlot(run, { collisions: rows }, place, which) {
  const x = rows.k.map((_, n) => n + 1 - rows.k.length);
  const curves = CURVES.map(([key]) => rows[key].map((value) => (value > 0 ? value : null)));
  const readout = element("output", { class: "readout" });
  const head = element("div", { class: "plot-head" }, readout);
  place.append(head);
  const chart = new uPlot(
    {
      width: place.clientWidth,
      height: 300,
      padding: [10, 14, 0, 0],
      cursor: { drag: { x: true, y: false } },
      scales: { x: { time: false }, y: { distr: 3 } },
      axes: [
        {
          label: `Collisions of the cluster, up to the ${TITLES[which]}`,
          stroke: INK,
          size: 34,
          labelSize: 22,
          values: (_, at) => at.map((k) => (Number.isInteger(k) ? short(k) : "")),
        },
        {
          size: 74,
          stroke: INK,
          label: "gap, speed, flight (units below)",
          labelSize: 20,
          splits: (_, __, low, high) => logTicks(low, high),
          filter: (_, at) => at,
          values: (_, at) => logNames(at),
        },
      ],
      series: [
        { label: "collision", value: (_, k) => (k === null ? "" : short(k)) },
        ...CURVES.map(([, label, stroke, , unit], n) => ({
          label: `${label}, ${unit} (${SHAPES[n]})`,
          stroke,
          width: 1,
          paths: () => null,
          points: { show: false },
          value: (_, value) => short(value),
        })),
      ],
      hooks: {
        draw: [(drawn) => paintCurves(drawn.ctx, drawn)],
        setCursor: [
          ({ cursor: { idx } }) => {
            readout.textContent =
              idx === null
                ? ""
                : `collision ${grouped(rows.k[idx])}, pair ` +
                  pairName([rows.i[idx], rows.j[idx]], run.spheres);
          },
        ],
      },
    },
    [x, ...curves],
    place,
  );
  const title = `${CURVES.map(([, name], n) => `${name} (${SHAPES[n]})`).join(", ")}`;
  const figure = () => ({
    chart,
    title,
    subtitle: run.name,
    paint: (ctx) => paintCurves(ctx, chart),
  });
  const columns = ["k", "time", "i", "j", "gap", "normal_speed", "flight"];
  head.append(
    saveMenu(title, () => fileStem(run.name, which, "decay"), {
      png: () => figureAsCanvas(figure()),
      svg: () => figureAsSvg(figure()),
      csv: () =>
        csv(
          ["collision", ...columns.slice(1)],
          rows.k.map((_, n) => columns.map((name) => rows[name][n])),
        ),
    }),
  );
  new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height: 300 })).observe(place);
}

/** Draws the curves as points, each with a shape of its own. */
function paintCurves(ctx, chart) {
  const { left, top, width, height } = chart.bbox;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, height);
  ctx.clip();
  CURVES.forEach(([, , colour], series) => {
    ctx.fillStyle = colour;
    chart.data[series + 1].forEach((value, n) => {
      if (value === null) return;
      const x = chart.valToPos(chart.data[0][n], "x", true);
      ctx.beginPath();
      shapePath(ctx, SHAPES[series], x, chart.valToPos(value, "y", true));
      ctx.fill();
    });
  });
  ctx.restore();
}

function shapePath(ctx, name, x, y) {
  const half = 2.6 * devicePixelRatio;
  if (name === "square") ctx.rect(x - half, y - half, 2 * half, 2 * half);
  else if (name === "circle") ctx.arc(x, y, half, 0, 2 * Math.PI);
  else {
    ctx.moveTo(x, y - half);
    ctx.lineTo(x + half, y + half);
    ctx.lineTo(x - half, y + half);
    ctx.closePath();
  }
}
