// How often something happens, and how well that is known.

const Z = 1.959963984540054; // standard deviations of a 95 % interval

/**
 * Share of `hits` among `runs` with its 95 % interval.
 *
 * Source: E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
 */
export function wilson(hits, runs) {
  if (!runs) return { share: NaN, low: 0, high: 1, hits, runs };
  const share = hits / runs,
    z2 = Z * Z;
  const middle = (share + z2 / (2 * runs)) / (1 + z2 / runs);
  const half =
    (Z / (1 + z2 / runs)) * Math.sqrt((share * (1 - share)) / runs + z2 / (4 * runs * runs));
  return { share, low: Math.max(0, middle - half), high: Math.min(1, middle + half), hits, runs };
}

/** What is asked of a run that is done. */
export const QUESTIONS = {
  hit: { name: "separation criterion met", happens: (runs, n) => runs.separation_hits[n] > 0 },
  arrest: { name: "arrest (true collapse)", happens: (runs, n) => runs.arrest_met[n] === 1 },
  false: {
    name: "separation without arrest",
    happens: (runs, n) => runs.separation_hits[n] > 0 && runs.arrest_met[n] === 0,
  },
};

/** point => numbers of its runs */
export function runsByPoint(runs) {
  const found = new Map();
  runs.point.forEach((point, n) => {
    if (!found.has(point)) found.set(point, []);
    found.get(point).push(n);
  });
  return found;
}

/** Whether a run came to a result: done, and not ended by the wall time that it was given. */
export function hasResult(runs, n) {
  return runs.status[n] === "done" && runs.outcome[n] !== "interrupted";
}

/** The share of a question among those of some runs that have a result. */
export function share(runs, numbers, question) {
  const done = numbers.filter((n) => hasResult(runs, n));
  return wilson(done.filter((n) => QUESTIONS[question].happens(runs, n)).length, done.length);
}
