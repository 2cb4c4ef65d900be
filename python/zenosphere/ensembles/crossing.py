"""Where a probability crosses one half: a logistic curve through counts, by maximum likelihood."""

from dataclasses import dataclass

import numpy as np

from .proportions import wilson_interval

DROP_95 = 1.9207  # half of the 95 % point of chi squared with one degree of freedom, 3.8415
NODES = 201  # places at which the profile is known; between them it is interpolated
STEEPEST = 50  # over the least distance of two x: 1e-11 is left of P = 1/2 at the next x


@dataclass(frozen=True)
class Crossing:
    """Where P = 1/2, and how that is known.

    place:     None where the counts show no crossing inside the range of x
    low, high: 95 % interval; None where it goes on beyond that end of the range
    how:       "fit" | "separated" | "below" | "above" | "unclear" | "nothing"
    """

    place: float | None
    low: float | None
    high: float | None
    how: str


EXPLAINED = {
    "fit": "logistic curve, profile likelihood",
    "separated": "no point in doubt: the interval is that of the neighbouring values",
    "below": "the probability is below 1/2 in the whole range",
    "above": "the probability is above 1/2 in the whole range",
    "unclear": "the counts do not tell whether there is a crossing",
    "nothing": "fewer than two values with a finished run",
}


def crossing(x, successes, trials):
    """The x at which a probability crosses one half, with its 95 % interval.

    Fits P = 1 / (1 + exp(-b (x - x_c))), b of either sign, by maximum likelihood; the interval
    holds every x_c whose likelihood, at its best b, is within 1.92 of the best in logarithm. Where
    the counts are separated (one run of ones, then zeros) b has no finite estimate, but the
    profile of x_c still has edges: the neighbouring values of x; the middle is given as the place.

    x: (K) any order;  successes, trials: (K) counts; x without trials are left out
    Source: profile likelihood D. J. Venzon & S. H. Moolgavkar, Appl. Stat. 37 (1988) 87; separation
    A. Albert & J. A. Anderson, Biometrika 71 (1984) 1.
    """
    x, successes, trials = (np.asarray(each, dtype=float) for each in (x, successes, trials))
    order = np.argsort(x[trials > 0])
    x, successes, trials = (each[trials > 0][order] for each in (x, successes, trials))
    if len(x) < 2:
        return Crossing(None, None, None, "nothing")
    if (successes == 0).all() or (successes == trials).all():
        return Crossing(None, None, None, _side(successes, trials))
    return _separated(x, successes, trials) or _fitted(x, successes, trials)


def _separated(x, successes, trials):
    """The crossing where all change to none, or none to all, between two values; else None."""
    full, empty = successes == trials, successes == 0
    for first, then in ((full, empty), (empty, full)):
        count = len(x) if first.all() else int(np.argmin(first))
        if 0 < count < len(x) and then[count:].all():
            left, right = x[count - 1], x[count]
            low, high = _interval(*_profile(x, successes, trials))
            return Crossing(float(left + right) / 2,  # few trials each: the profile goes further
                            None if low is None else min(low, float(left)),
                            None if high is None else max(high, float(right)), "separated")
    return None


def _fitted(x, successes, trials):
    mean = successes.sum() / trials.sum()
    flat = log_likelihood(np.full(len(x), np.log(mean / (1 - mean))), successes, trials)
    places, height = _profile(x, successes, trials)
    place = places[np.argmax(height)]
    if place in (x[0], x[-1]) or height.max() - flat < DROP_95:  # outside, or no trend at all
        return Crossing(None, None, None, _side(successes, trials))
    low, high = _interval(places, height)
    return Crossing(float(place), low, high, "fit")


def _profile(x, successes, trials):
    """Nodes from the first x to the last, denser around the best, and the profile there."""
    places = np.unique(np.concatenate([np.linspace(x[0], x[-1], NODES), x, (x[1:] + x[:-1]) / 2]))
    best = int(np.argmax(profile(places, x, successes, trials)))
    around = places[max(best - 1, 0)], places[min(best + 1, len(places) - 1)]
    places = np.unique(np.concatenate([places, np.linspace(*around, NODES // 2)]))
    return places, profile(places, x, successes, trials)


def _side(successes, trials):
    """Below or above one half everywhere, if each count is and all together are beyond doubt."""
    low, high = wilson_interval(successes.sum(), trials.sum())
    if (2 * successes < trials).all() and high < 0.5:
        return "below"
    return "above" if (2 * successes > trials).all() and low > 0.5 else "unclear"


def _interval(places, height):
    """(low, high) of the places within DROP_95 of the highest; None beyond the range."""
    excess = height - height.max() + DROP_95
    inside = np.flatnonzero(excess >= 0)
    first, last = inside[0], inside[-1]
    low = None if first == 0 else _zero(places, excess, first - 1)
    high = None if last == len(places) - 1 else _zero(places, excess, last)
    return low, high


def _zero(places, excess, left):
    """Zero of the straight line between nodes left and left + 1."""
    share = excess[left] / (excess[left] - excess[left + 1])
    return float(places[left] + share * (places[left + 1] - places[left]))


def profile(places, x, successes, trials):
    """Logarithm of the likelihood at each place of the crossing, at the best slope there, (M).

    Golden-section search, since the logarithm is concave in the slope b.

    places: (M) candidates for x_c;  x, successes, trials: (K)
    """
    steepest = STEEPEST / np.diff(x).min()
    distance = x - places[:, None]

    def value(slope):
        return log_likelihood(slope[:, None] * distance, successes, trials)

    low, high = np.full(len(places), -steepest), np.full(len(places), steepest)
    golden = (np.sqrt(5) - 1) / 2
    for _ in range(36):  # 0.618^36 = 3e-8 of the range of slopes, where the profile is flat
        left, right = high - golden * (high - low), low + golden * (high - low)
        rises = value(left) < value(right)
        low, high = np.where(rises, left, low), np.where(rises, high, right)
    return value((low + high) / 2)


def log_likelihood(logit, successes, trials):
    """Sum over the last axis of k log P + (n - k) log(1 - P), P = 1 / (1 + exp(-logit))."""
    return -(successes * np.logaddexp(0, -logit)
             + (trials - successes) * np.logaddexp(0, logit)).sum(axis=-1)
