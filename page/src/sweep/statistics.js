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
  arrest: { name: "arrest criterion met", happens: (runs, n) => runs.arrest_met[n] === 1 },
  left: {
    name: "hits, no arrest: left",
    happens: (runs, n) => runs.verdict[n] === "temporary",
  },
  open: {
    name: "hits, no arrest: still open at the end",
    happens: (runs, n) => runs.verdict[n] === "open",
  },
};

/** What `adjudicate` can find, the strongest first (docs/adjudication.md). */
const FINDINGS = [
  "proven",
  "singular",
  "arithmetic arrest",
  "near-collapse",
  "exact contact",
  "chance close pair",
  "undecided",
];

/**
 * The same of what the first hits of a run were, for the findings that there are; asked of the runs
 * that have been adjudicated. Nothing where the store has none.
 */
export function findingQuestions({ adjudication_first_finding: findings = [] }) {
  const there = new Set(findings.filter((finding) => finding !== null));
  const known = FINDINGS.filter((finding) => there.has(finding));
  const others = [...there].filter((finding) => !FINDINGS.includes(finding)).sort();
  return Object.fromEntries(
    [...known, ...others].map((finding) => [
      `finding-${finding.replace(/\W+/g, "-")}`,
      {
        name: `first hits: ${finding}`,
        isAsked: (_, n) => findings[n] !== null,
        happens: (_, n) => findings[n] === finding,
      },
    ]),
  );
}

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

/** The share of a question among those of some runs that have a result and are asked. */
export function share(runs, numbers, { isAsked = () => true, happens }) {
  const done = numbers.filter((n) => hasResult(runs, n) && isAsked(runs, n));
  return wilson(done.filter((n) => happens(runs, n)).length, done.length);
}
