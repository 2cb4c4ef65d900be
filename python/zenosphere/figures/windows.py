"""Which collisions a figure shows, chosen from the run itself.

Each window is a pair (first, last) of collision numbers, both included.
"""

import math

import numpy as np

from ..flags import HIT

# The paper: the criterion is met after fewer than ten collisions per particle.
EARLY_PER_SPHERE = 10
PASSAGE = 400  # collisions before and after the hits become continuous


def whole(run):
    """Everything the log holds."""
    return run.collisions.first, run.collisions.last


def early(run):
    """From the start to three times the first hit: the criterion met for the first time."""
    return _from_start(run, _times(run.separation["first_collision"], 3))


def temporary_stage(run):
    """From the start to half as far again as the last hit: the clock nearly stops, and goes on."""
    return _from_start(run, _times(run.separation["last_collision"], 1.5))


def long(run):
    """From the start to four times the last hit: the temporary stage and the steady state."""
    return _from_start(run, _times(run.separation["last_collision"], 4))


def to_arrest(run):
    """From the start to a tenth beyond the arrest; everything where there is none."""
    end = _times(run.arrest["collision"], 1.1)
    return _from_start(run, end) if end else whole(run)


def into_arrest(run):
    """The passage into the arrest: some hundred collisions on either side of where only hits are
    left, fewer where the run began not long before.

    Without an arrest, a tenth of the run on either side of the last hit; without a hit, the end.
    """
    first, last = whole(run)
    if run.arrest["met"]:
        centre = run_of_hits_begins(run)
        half = min(PASSAGE, max((centre - first) // 2, 1))
    else:
        centre = run.separation["last_collision"] or last
        half = max((last - first) // 10, 1)
    return max(first, centre - half), min(last, centre + half)


def pairs_change(run, half=PASSAGE):
    """A few hundred collisions about the beginning of the arrest, the last hit, or the end."""
    first, last = whole(run)
    settled = run_of_hits_begins(run) if run.arrest["met"] else None
    centre = settled or run.separation["last_collision"] or last
    return max(first, centre - half), min(last, max(centre + half, first))


def run_of_hits_begins(run):
    """Number of the first collision of the unbroken sequence of hits that ends at the arrest.

    Only for a run that met the arrest criterion.
    """
    arrest = run.arrest["collision"]
    k, flags = run.collisions.read("k", "flags", last=arrest)
    precise = np.flatnonzero((flags[:-1] & HIT) == 0)
    return int(k[precise[-1] + 1]) if precise.size else int(k[0]) if k.size else arrest


def _from_start(run, end):
    first, last = whole(run)
    if end is None:
        end = EARLY_PER_SPHERE * run.spheres / 2
    return first, max(min(last, _rounded_up(end)), first)


def _times(collision, factor):
    return None if collision is None else collision * factor


def _rounded_up(value):
    """The next number with at most two significant digits."""
    unit = 10 ** max(math.floor(math.log10(max(value, 1))) - 1, 0)
    return math.ceil(round(value / unit, 6)) * unit  # 1.1 x 800 is 880, not 880.0000000000001
