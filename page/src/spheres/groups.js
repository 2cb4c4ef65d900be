// Spheres worth singling out: the clusters of the anatomy, and the pairs that repeat.
import { length } from "./cell.js";
import { count, DASH, grouped, pairName } from "../shared/format.js";

const TITLES = { arrest: "at the arrest", hit: "at the first hit" };

/** Those of a dissection: its first cluster, and all of its clusters where there are more. */
function fromDissection(which, found, spheres) {
  const [first] = found.clusters;
  const named = found.pairs.map((pair) => pairName(pair, spheres)).join(", ");
  const pair = found.pairs.length === 1 ? ` with the pair ${named}` : "";
  const inFirst = new Set(first.spheres);
  const pairSpheres = [...new Set(found.pairs.flat())].filter((sphere) => sphere < spheres);
  const isWhole = pairSpheres.every((sphere) => inFirst.has(sphere));
  const common = { which, pairs: found.pairs, collision: found.collision };
  const groups = [
    {
      ...common,
      id: `${which}-cluster`,
      spheres: first.spheres,
      contacts: first.contacts,
      name: `cluster ${TITLES[which]}${pair} (${count(first.spheres.length, "sphere")})`,
      places: (dimension) => placesOf(first, dimension),
    },
  ];
  if (!isWhole) {
    groups.unshift({
      ...common,
      id: `${which}-pairs`,
      spheres: pairSpheres,
      contacts: found.pairs,
      name: `pairs that repeat ${TITLES[which]} (${pairSpheres.length} spheres)`,
    });
  }
  if (found.clusters.length > 1) {
    const all = found.clusters.flatMap((cluster) => cluster.spheres);
    groups.push({
      ...common,
      id: `${which}-clusters`,
      spheres: all,
      contacts: found.clusters.flatMap((cluster) => cluster.contacts),
      name: `all ${found.clusters.length} clusters ${TITLES[which]} (${all.length} spheres)`,
    });
  }
  return groups;
}

/** sphere => place from the mean of its cluster, three numbers, diameters */
function placesOf(cluster, dimension) {
  const at = (n) =>
    [0, 1, 2].map((d) => (d < dimension ? cluster.positions[n * dimension + d] : 0));
  return new Map(cluster.spheres.map((sphere, n) => [sphere, at(n)]));
}

/**
 * The groups of a run: {id, name, which, spheres, contacts: [[i, j, ...]], pairs, collision, places}.
 *
 * The pairs that repeat come first where there are any.
 */
export function groupsOf(run) {
  const groups = ["arrest", "hit"]
    .filter((which) => run.anatomy[which])
    .flatMap((which) => fromDissection(which, run.anatomy[which], run.spheres));
  const pairs = (run.summary.arrest?.pairs ?? []).filter(([i]) => i < run.spheres);
  if (pairs.length && !run.anatomy.arrest) {
    const spheres = [...new Set(pairs.flat())].filter((sphere) => sphere < run.spheres);
    groups.unshift({
      id: "pairs",
      which: "arrest",
      pairs,
      spheres,
      contacts: pairs,
      collision: run.summary.arrest.collision,
      name: `pairs that repeat (${count(spheres.length, "sphere")})`,
    });
  }
  return groups;
}

/**
 * sphere => place of the spheres of a group, each beside the one that it is in contact with rather
 * than at the other side of the cell.
 *
 * at(sphere) -> its place in the cell
 */
export function unwrapped({ spheres, contacts }, cell, at, count) {
  const places = new Map();
  const waiting = [];
  const put = (sphere, place) => {
    places.set(sphere, place);
    waiting.push(sphere);
  };
  const partner = (sphere, [i, j]) => (i === sphere ? j : j === sphere ? i : -1);
  for (const root of spheres) {
    if (!places.has(root)) put(root, at(root));
    while (waiting.length) {
      const from = waiting.pop();
      for (const next of contacts.map((contact) => partner(from, contact))) {
        if (next < 0 || next >= count || places.has(next)) continue;
        const d = cell.difference(at(from), at(next));
        const place = places.get(from).map((x, n) => x + d[n]);
        put(next, place);
      }
    }
  }
  return places;
}

/** A direction to look from that sees a row of places at its full length. */
export function acrossThe(places) {
  const centre = [0, 1, 2].map((d) => places.reduce((sum, at) => sum + at[d], 0) / places.length);
  const far = places
    .map((at) => at.map((x, d) => x - centre[d]))
    .reduce((a, b) => (length(b) > length(a) ? b : a));
  const size = length(far) || 1;
  const along = far.map((x) => x / size);
  const front = [0.15, 0.2, 1];
  const part = front.reduce((sum, x, d) => sum + x * along[d], 0);
  const across = front.map((x, d) => x - part * along[d]);
  return length(across) > 0.3 ? across : [1, 0.2, 0.1];
}

/** What is shown of a group, in words. */
export function captionOf(run, group, isCellShown, isMoment) {
  if (!group) return "";
  const isArrest = group.which === "arrest";
  const when = isArrest ? "the arrest" : "the first hit";
  const what = run.summary.verdict === "true" && isArrest ? "repeats for ever" : "was due next";
  const pair = group.pairs.length === 1 ? pairName(group.pairs[0], run.spheres) : "";
  const named = pair ? `Pair ${pair} (vermilion, ringed) ${what}; ` : "";
  const k = grouped(group.collision);
  const where = isMoment
    ? `places exactly as they were at ${when}, collision ${k}.`
    : `snapshot ${DASH} ${when} was at collision ${k}; contacts are drawn between ` +
      "spheres that are near each other here.";
  return `${named}${isCellShown ? "" : "its cluster alone; "}${where}`;
}
