// Names in the picture of the spheres: where those of the axes go, and how all are drawn on a canvas.

const LEAST_EDGE = 24; // pixels: an edge that points at the viewer gets no name

/**
 * Where the name of an axis goes: beside the outermost of its parallel edges, outside, along it.
 *
 * edges: [[from, to], ...], pixels;  centre of all;  away: pixels between the edge and the middle of
 * the name. Of two edges as far out as each other the lower one. Null where none is long enough.
 */
export function besideOutline(edges, centre, away) {
  let best = null;
  for (const [[ax, ay], [bx, by]] of edges) {
    const length = Math.hypot(bx - ax, by - ay);
    if (length < LEAST_EDGE) continue;
    const middle = [(ax + bx) / 2, (ay + by) / 2];
    let normal = [(ay - by) / length, (bx - ax) / length];
    let out = (middle[0] - centre[0]) * normal[0] + (middle[1] - centre[1]) * normal[1];
    if (out < 0 || (out < 1 && normal[1] < 0)) [normal, out] = [normal.map((x) => -x), -out];
    const score =
      out + (normal[1] > 0.01 || (Math.abs(normal[1]) <= 0.01 && normal[0] < 0) ? 2 : 0);
    if (best && best.score >= score) continue;
    const angle = Math.atan((by - ay) / (bx - ax || 1e-9)) || 0;
    const [x, y] = middle.map((at, d) => at + away * normal[d]);
    best = { score, x, y, angle: Math.abs(angle) > 1.57 ? -Math.PI / 2 : angle };
  }
  return best && { x: best.x, y: best.y, angle: best.angle };
}

/** Draws a name as its element looks. */
export function paintName(ctx, made) {
  const { font, color } = getComputedStyle(made);
  const isAxis = made.className === "axis";
  ctx.save();
  ctx.translate(parseFloat(made.style.left), parseFloat(made.style.top));
  if (isAxis) ctx.rotate(parseFloat(made.style.rotate) || 0);
  Object.assign(ctx, { font, textAlign: isAxis ? "center" : "left", textBaseline: "middle" });
  Object.assign(ctx, { strokeStyle: "#fff", lineWidth: 4, lineJoin: "round", fillStyle: color });
  ctx.strokeText(made.textContent, 0, 0);
  ctx.fillText(made.textContent, 0, 0);
  ctx.restore();
}
