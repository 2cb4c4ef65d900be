// Phase diagrams: shares over one axis as points with intervals, over two as coloured cells.
import { viridisCss } from "../shared/colours.js";
import { short } from "../shared/format.js";

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 470,
  HEIGHT = 360,
  LEFT = 62,
  BOTTOM = 46,
  TOP = 8,
  RIGHT = 10;

export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

const label = (value) => (typeof value === "number" ? short(value, 4) : String(value));
const percent = (share) => (Number.isNaN(share) ? "\u2013" : `${Math.round(100 * share)} %`);

/** "3 of 10 runs, 30 % (11 % to 60 %)" */
export const told = ({ hits, runs, share, low, high }) =>
  runs
    ? `${hits} of ${runs} runs, ${percent(share)} (95 %: ${percent(low)} to ${percent(high)})`
    : "no run done";

/**
 * A diagram.
 *
 * x, y: {key, name, symbol, values}, y null for one axis
 * cells: [{column, row, point, share: {share, low, high, hits, runs}}]
 * choose(point): what a click, Enter or Space does
 */
export function diagram(title, x, y, cells, choose) {
  const box = svg("svg", {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: "group",
    "aria-label": title,
    class: "diagram",
  });
  const [wide, high] = [WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM];
  const [stepX, stepY] = [wide / x.values.length, y ? high / y.values.length : 0];
  const at = { x: (n) => LEFT + (n + 0.5) * stepX, y: (n) => TOP + high - (n + 0.5) * stepY };
  names(box, x.values, stepX / 34, (n) => ({
    x: at.x(n),
    y: TOP + high + 16,
    "text-anchor": "middle",
  }));
  box.append(
    svg(
      "text",
      { x: LEFT + wide / 2, y: HEIGHT - 6, "text-anchor": "middle", class: "axis-name" },
      svg("title", {}, x.key),
      x.name,
    ),
  );
  if (y) {
    names(box, y.values, stepY / 14, (n) => ({
      x: LEFT - 6,
      y: at.y(n) + 4,
      "text-anchor": "end",
    }));
    const turned = `translate(12 ${TOP + high / 2}) rotate(-90)`;
    box.append(
      svg(
        "text",
        { transform: turned, "text-anchor": "middle", class: "axis-name" },
        svg("title", {}, y.key),
        y.name,
      ),
    );
  } else {
    shareGrid(box, high, wide);
  }
  const buttons = cells.map((cell, n) => {
    const parts = y ? square(cell, at, stepX, stepY) : interval(cell, at, high);
    const where = [
      [x, cell.column],
      [y, cell.row],
    ]
      .filter(([axis]) => axis)
      .map(([axis, index]) => `${axis.symbol} = ${label(axis.values[index])}`)
      .join(", ");
    const name = `${where}: ${told(cell.share)}`;
    return svg(
      "g",
      {
        role: "button",
        tabindex: n ? -1 : 0,
        "aria-label": name,
        "data-point": cell.point,
        onclick: () => choose(cell.point),
        onkeydown: (event) => walk(event, cells, buttons, n, choose),
      },
      svg("title", {}, name),
      ...parts,
    );
  });
  box.append(...buttons);
  return box;
}

/** Names of values, every few where there is no room for all. */
function names(box, values, room, attributes) {
  const step = Math.max(1, Math.ceil(1 / room));
  values.forEach((value, n) => {
    if (n % step === 0) box.append(svg("text", attributes(n), label(value)));
  });
}

function shareGrid(box, high, wide) {
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    const y = TOP + high * (1 - share);
    box.append(
      svg("line", { x1: LEFT, x2: LEFT + wide, y1: y, y2: y, class: "grid" }),
      svg("text", { x: LEFT - 6, y: y + 4, "text-anchor": "end" }, percent(share)),
    );
  }
}

/** A cell of a map: colour and number say the same. */
function square({ column, row, share }, at, wide, high) {
  const [x, y] = [at.x(column), at.y(row)];
  const fill = Number.isNaN(share.share) ? "#eceff2" : viridisCss(share.share);
  const text = { x, "text-anchor": "middle", fill: share.share < 0.55 ? "#fff" : "#000" };
  const parts = [
    svg("rect", {
      x: x - wide / 2 + 0.5,
      y: y - high / 2 + 0.5,
      width: Math.max(wide - 1, 1),
      height: Math.max(high - 1, 1),
      fill,
    }),
  ];
  if (wide > 34 && high > 15)
    parts.push(svg("text", { ...text, y: y + (high > 30 ? -1 : 4) }, percent(share.share)));
  if (wide > 46 && high > 30 && share.runs) {
    const range = `${Math.round(100 * share.low)}\u2013${Math.round(100 * share.high)}`;
    parts.push(svg("text", { ...text, y: y + 12, class: "small" }, range));
  }
  return parts;
}

/** A point with its interval. */
function interval({ column, share }, at, high) {
  const x = at.x(column),
    y = (part) => TOP + high * (1 - part);
  if (!share.runs) return [];
  return [
    svg("rect", { x: x - 9, y: TOP, width: 18, height: high, fill: "transparent" }),
    svg("line", { x1: x, x2: x, y1: y(share.low), y2: y(share.high), class: "interval" }),
    ...[share.low, share.high].map((end) =>
      svg("line", { x1: x - 4, x2: x + 4, y1: y(end), y2: y(end), class: "interval" }),
    ),
    svg("circle", { cx: x, cy: y(share.share), r: 4.5, class: "share" }),
  ];
}

const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Arrow keys go to the neighbour; Enter and Space choose. */
function walk(event, cells, buttons, n, choose) {
  if (event.key === "Enter" || event.key === " ") {
    event.preventDefault();
    return choose(cells[n].point);
  }
  const step = STEPS[event.key];
  if (!step) return undefined;
  event.preventDefault();
  const next = cells.findIndex(
    ({ column, row }) => column === cells[n].column + step[0] && row === cells[n].row + step[1],
  );
  if (next < 0) return undefined;
  buttons[n].setAttribute("tabindex", -1);
  buttons[next].setAttribute("tabindex", 0);
  return buttons[next].focus();
}

const LOOK = ["fill", "stroke", "stroke-width", "font-size", "font-family", "font-weight"];
const TITLE = 24; // above a diagram that is saved
const SCALE = 3; // pixels of a PNG

/** The diagram as a file of its own, with its title and what the style sheet says of its parts. */
export function diagramAsSvg(box, title) {
  const copy = box.cloneNode(true);
  const parts = [...box.querySelectorAll("*")];
  [...copy.querySelectorAll("*")].forEach((part, n) => {
    const style = getComputedStyle(parts[n]);
    for (const name of LOOK) part.setAttribute(name, style.getPropertyValue(name));
    part.removeAttribute("tabindex");
  });
  const heading = { x: 8, y: 8 - TITLE / 2, "font-weight": 600, "font-size": 14 };
  const family = getComputedStyle(box).fontFamily;
  copy.prepend(
    svg("rect", { y: -TITLE, width: WIDTH, height: HEIGHT + TITLE, fill: "#fff" }),
    svg("text", { ...heading, "font-family": family }, title),
  );
  const size = { width: WIDTH, height: HEIGHT + TITLE };
  for (const [name, value] of Object.entries(size)) copy.setAttribute(name, value);
  copy.setAttribute("viewBox", `0 ${-TITLE} ${WIDTH} ${HEIGHT + TITLE}`);
  copy.removeAttribute("class");
  return new XMLSerializer().serializeToString(copy);
}

/** The same on a canvas. */
export async function diagramAsCanvas(box, title) {
  const picture = new Image();
  const text = diagramAsSvg(box, title);
  picture.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  await picture.decode();
  URL.revokeObjectURL(picture.src);
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [WIDTH * SCALE, (HEIGHT + TITLE) * SCALE];
  canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
  return canvas;
}
