// What the colours of spheres mean.
import { viridis, viridisCss } from "../shared/colours.js";
import { element } from "../shared/dom.js";
import { short } from "../shared/format.js";

/** Value of every sphere in a frame, and how to read it: what colours can mean. */
export function colouringsOf(run, frames) {
  const { spheres: N, dimension: D } = run;
  const axis = Math.min(1, D - 1);
  const found = {
    speed: {
      name: "speed (peculiar)",
      unit: "diameters/time",
      isLog: true,
      value: (frame, n) => frames.speeds[frame * N + n],
    },
    layer: {
      name: `layer at the start (${"xyz"[axis]})`,
      unit: "diameters",
      isLog: false,
      value: (_, n) => Math.floor(frames.positions[n * D + axis]),
    },
  };
  if (run.grains?.kinds.length) {
    found.kind = {
      name: `species (${run.grains.names.map((name, k) => `${k} ${name}`).join(", ")})`,
      unit: "",
      isLog: false,
      value: (_, n) => run.grains.kinds[n],
    };
  }
  if (run.grains?.radii.length) {
    found.diameter = {
      name: "diameter",
      unit: "",
      isLog: false,
      value: (_, n) => 2 * run.grains.radii[n],
    };
  }
  if (frames.collisions.length) {
    found.collisions = {
      name: "collisions so far",
      unit: "",
      isLog: true,
      value: (frame, n) => frames.collisions[frame * N + n],
    };
  }
  return found;
}

/** From values to [0, 1], by the second and the ninety-eighth hundredth; extremes are clipped. */
function scaleOf(values, isLog) {
  const sorted = Float64Array.from(values)
    .filter((value) => !isLog || value > 0)
    .sort();
  if (!sorted.length) return { low: 0, high: 1, part: () => 0 };
  const at = (part) => sorted[Math.round(part * (sorted.length - 1))];
  const [low, high] = isLog ? [at(0.02), at(0.98)] : [sorted[0], sorted[sorted.length - 1]];
  const shape = isLog ? (value) => Math.log(Math.max(value, low * 1e-3)) : (value) => value;
  const span = shape(high) - shape(low) || 1;
  return { low, high, part: (value) => (shape(value) - shape(low)) / span };
}

/** The colour of each sphere in a frame, tint(n), and the parts of a legend for it. */
export function tintsOf({ value, isLog, unit }, frame, spheres) {
  const values = Float64Array.from({ length: spheres }, (_, n) => value(frame, n));
  const { low, high, part } = scaleOf(values, isLog);
  const ramp = element("canvas", {
    width: 120,
    height: 12,
    role: "img",
    "aria-label": "from dark violet over green to yellow",
  });
  paintRamp(ramp);
  return {
    tint: (n) => viridis(part(values[n])),
    parts: [short(low, 3), ramp, `${short(high, 3)} ${unit}`],
  };
}

function paintRamp(canvas) {
  const ctx = canvas.getContext("2d");
  for (let x = 0; x < canvas.width; ++x) {
    ctx.fillStyle = viridisCss(x / (canvas.width - 1));
    ctx.fillRect(x, 0, 1, canvas.height);
  }
}
