"""What the first group of hits of each run was: from the columns a store has by [adjudicate]."""

import itertools

from .proportions import fraction, wilson_interval

COLUMN = "adjudication_first_finding"
WORDS = ("proven", "singular", "arithmetic arrest", "near-collapse", "exact contact",
         "chance close pair", "undecided")
HIT = "separation_first_collision IS NOT NULL"
REAL = f"COALESCE({COLUMN} IN ('proven', 'singular'), 0)"
MARGIN = "adjudication_margin_per_decade"
ARREST = "COALESCE(arrest_met, 0)"
OPEN = "COALESCE(verdict = 'open', 0)"

# Name -> SQL; each run with a hit has one of them. What a run did after a collapse of the spheres:
# it arrested, it left the hits by rounding and its overlap rule, or it ended while it was hit.
KINDS = {
    "real, arrested": f"{REAL} = 1 AND {ARREST} = 1",
    "real, open": f"{REAL} = 1 AND {ARREST} = 0 AND {OPEN} = 1",
    "real, went on": f"{REAL} = 1 AND {ARREST} = 0 AND {OPEN} = 0",
    "near-collapse": f"{COLUMN} = 'near-collapse'",
    "arithmetic arrest": f"{COLUMN} = 'arithmetic arrest'",
    "chance or exact": f"{COLUMN} IN ('chance close pair', 'exact contact')",
    "undecided": f"{COLUMN} = 'undecided'",
    "not adjudicated": f"{HIT} AND {COLUMN} IS NULL",
}
COUNTED = KINDS | {"hit": HIT} | {f"is {word}": f"{COLUMN} = '{word}'" for word in WORDS}
# Whether the fall of a real one can go on by its law (docs/adjudication.md).
CURVATURE = {"real, curvature dies out": f"{REAL} = 1 AND {MARGIN} >= 0",
             "real, curvature grows": f"{REAL} = 1 AND {MARGIN} < 0"}


def finding_rows(ensemble, counts):
    """One dict a point, the last axis fastest: runs with each finding, and the share that is real.

    The share of the adjudicated runs takes `undecided` as not shown to be real; that of the decided
    ones leaves them out.
    """
    places = itertools.product(*(range(len(axis.values)) for axis in ensemble.axes))
    for place in places:
        row = {axis.key: axis.values[index] for axis, index in zip(ensemble.axes, place)}
        found = {name: int(array[place]) for name, array in counts.findings.items()}
        row |= {"done": int(counts.done[place]), "hit": found["hit"],
                "adjudicated": found["hit"] - found["not adjudicated"]}
        row |= {_key(word): found[f"is {word}"] for word in WORDS}
        row |= {_key(name): count for name, count in found.items() if name.startswith("real")}
        real = found["is proven"] + found["is singular"]
        yield row | _share("adjudicated", real, row["adjudicated"]) | _share(
            "decided", real, row["adjudicated"] - found["undecided"])


def _share(among, real, trials):
    low, high = wilson_interval(real, trials)
    name = f"real_of_{among}"
    return {name: fraction(real, trials), f"{name}_low": low, f"{name}_high": high}


def _key(name):
    return name.replace(", ", "_").replace(" ", "_").replace("-", "_")
