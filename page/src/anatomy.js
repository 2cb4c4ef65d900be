// How the collapsing cluster decays: gap, closing speed and flight of its collisions.
import uPlot from "uplot";
import { decades } from "./axes.js";
import { BLUE, INK, VERMILION } from "./colours.js";
import { button, element, section } from "./dom.js";
import { grouped, pairName, power, short } from "./format.js";

const CURVES = [
  ["gap", "gap closed", INK, "gap"],
  ["normal_speed", "closing speed", VERMILION, "speed"],
  ["flight", "flight", BLUE, "flight"],
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
  const columns = CURVES.map(([key]) => rows[key].map((value) => (value > 0 ? value : null)));
  const readout = element("output", { class: "readout" });
  place.append(readout);
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
          label: "in diameters, time unit of the case",
          labelSize: 20,
          splits: (_, __, low, high) => decades(low, high),
          filter: (_, at) => at,
          values: (_, at) => at.map((y) => power(Math.round(Math.log10(y)))),
        },
      ],
      series: [
        { label: "collision", value: (_, k) => (k === null ? "" : short(k)) },
        ...CURVES.map(([, label, stroke], n) => ({
          label: `${label} (${SHAPES[n]})`,
          stroke,
          width: 1,
          paths: () => null,
          points: { show: true, size: 5, fill: stroke, paths: shape(SHAPES[n]) },
          value: (_, value) => short(value),
        })),
      ],
      hooks: {
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
    [x, ...columns],
    place,
  );
  new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height: 300 })).observe(place);
}

/** Points of a shape, as uPlot wants them. */
function shape(name) {
  return (u, series) => {
    const path = new Path2D(),
      half = 2.6 * devicePixelRatio;
    u.data[series].forEach((value, n) => {
      if (value === null) return;
      const x = u.valToPos(u.data[0][n], "x", true),
        y = u.valToPos(value, u.series[series].scale, true);
      if (name === "square") path.rect(x - half, y - half, 2 * half, 2 * half);
      else if (name === "circle") {
        path.moveTo(x + half, y);
        path.arc(x, y, half, 0, 7);
      } else {
        path.moveTo(x, y - half);
        path.lineTo(x + half, y + half);
        path.lineTo(x - half, y + half);
        path.closePath();
      }
    });
    return { fill: path, stroke: null };
  };
}
