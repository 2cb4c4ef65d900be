// The sheared cell: where spheres are in it, and how they lie to each other. No drawing here.

const MOST_ROWS = 100;

/**
 * A periodic cell in up to three dimensions.
 *
 * edges: D x D, rows are the box vectors, the second one slanted by the Lees-Edwards offset
 * walls: "x", "y", "z" or null: the axis that is not periodic
 */
export class Cell {
  constructor(edges, dimension, walls) {
    this.dimension = dimension;
    this.sides = [0, 1, 2].map((d) => (d < dimension ? edges[d * dimension + d] : 0));
    this.offset = dimension > 1 ? edges[dimension] : 0;
    this.rows =
      dimension > 1
        ? 1
        : Math.min(MOST_ROWS, Math.max(1, Math.round(Math.sqrt(this.sides[0] / 4))));
    this.rowLength = this.sides[0] / this.rows;
    this.periodic = [0, 1, 2].map((d) => d < dimension && "xyz"[d] !== walls);
  }

  /** Puts a position (three numbers, changed in place) from the upright box into the slanted cell. */
  slant(position) {
    if (!this.periodic[0] || this.dimension < 2) return position;
    const left = (this.offset * position[1]) / this.sides[1];
    position[0] -= Math.floor((position[0] - left) / this.sides[0]) * this.sides[0];
    return position;
  }

  /**
   * Where a position is drawn: a long line is folded into rows, like a text.
   *
   * Rows are three diameters apart and so many that they fill a page.
   */
  drawn(position) {
    if (this.dimension > 1 || this.rows === 1) return position;
    const row = Math.min(Math.max(Math.floor(position[0] / this.rowLength), 0), this.rows - 1);
    return [position[0] - row * this.rowLength, -3 * row, 0];
  }

  /** From a to the nearest image of b, diameters. */
  difference(a, b) {
    const d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    if (this.periodic[2]) d[2] -= Math.round(d[2] / this.sides[2]) * this.sides[2];
    if (this.periodic[1]) {
      const images = Math.round(d[1] / this.sides[1]);
      d[1] -= images * this.sides[1];
      d[0] -= images * this.offset;
    }
    if (this.periodic[0]) d[0] -= Math.round(d[0] / this.sides[0]) * this.sides[0];
    return d;
  }

  /** The eight corners (or four, or two), the first coordinate running fastest. */
  corners() {
    if (this.rows > 1)
      return [0, this.rows - 1].flatMap((n) => [
        [0, -3 * n, 0],
        [this.rowLength, -3 * n, 0],
      ]);
    const found = [];
    for (let n = 0; n < 2 ** this.dimension; ++n) {
      const [x, y, z] = [n & 1, (n >> 1) & 1, (n >> 2) & 1];
      found.push([x * this.sides[0] + y * this.offset, y * this.sides[1], z * this.sides[2]]);
    }
    return found;
  }

  /** Pairs of corners that an edge joins. */
  edges() {
    if (this.rows > 1) {
      return Array.from({ length: this.rows }, (_, n) => [
        [0, -3 * n, 0],
        [this.rowLength, -3 * n, 0],
      ]);
    }
    return this.edgesByAxis().flat();
  }

  /** For each axis the pairs of corners that an edge along it joins; of rows the first and the last. */
  edgesByAxis() {
    const corners = this.corners();
    return Array.from({ length: this.dimension }, (_, d) =>
      corners.flatMap((corner, n) => (n & (1 << d) ? [] : [[corner, corners[n | (1 << d)]]])),
    );
  }

  centre() {
    const corners = this.corners();
    return [0, 1, 2].map(
      (d) => corners.reduce((sum, corner) => sum + corner[d], 0) / corners.length,
    );
  }
}

export const length = (vector) => Math.hypot(...vector);

/** Contacts further apart than this are not drawn: the spheres have not met yet, or not lately. */
export const NEAR = 1.25; // diameters between centres

/**
 * Lines between spheres in contact: [[from, to], ...]. Where the nearest image of the second is not
 * where it is drawn, each of the two gets its own line.
 *
 * at(sphere) -> position drawn;  contacts: [[i, j, ...], ...]
 */
export function bonds(cell, at, contacts, spheres) {
  const lines = [];
  for (const [i, j] of contacts) {
    if (j >= spheres) continue; // a wall
    const from = at(i),
      to = at(j);
    const d = cell ? cell.difference(from, to) : to.map((x, n) => x - from[n]);
    if (length(d) > NEAR) continue;
    lines.push([from, from.map((x, n) => x + d[n])]);
    const isThere = length(from.map((x, n) => x + d[n] - to[n])) < 0.5;
    if (!isThere) lines.push([to.map((x, n) => x - d[n]), to]);
  }
  return lines;
}
