"""What an ensemble comes to, as tables: probabilities of each point, and where they cross 1/2."""

import itertools

import numpy as np

from .crossing import crossing
from .proportions import fraction, wilson_interval
from .store import CRITERIA


def probability_rows(ensemble, counts):
    """One dict a point, the last axis fastest: its values, its runs, P and interval of each
    criterion."""
    places = itertools.product(*(range(len(axis.values)) for axis in ensemble.axes))
    for place in places:
        row = {axis.key: axis.values[index] for axis, index in zip(ensemble.axes, place)}
        here = counts.at(place)
        row |= {"runs": int(here.runs), "done": int(here.done), "failed": int(here.failed),
                "pending": int(here.pending)}
        for name in CRITERIA:
            low, high = wilson_interval(here.met[name], here.done)
            key = name.replace(" ", "_")
            row |= {key: int(here.met[name]), f"P_{key}": fraction(here.met[name], here.done),
                    f"P_{key}_low": low, f"P_{key}_high": high}
        yield row


def crossing_rows(ensemble, counts, x):
    """One dict for each point of the other axes and each criterion: where P crosses 1/2 along x.

    x: position of the axis
    """
    others = [axis for place, axis in enumerate(ensemble.axes) if place != x]
    crossings = crossings_along(ensemble.axes[x].values, counts, x)
    for place in itertools.product(*(range(len(axis.values)) for axis in others)):
        for name in ("separation", "arrest"):
            found = crossings[name][place]
            yield ({axis.key: axis.values[index] for axis, index in zip(others, place)}
                   | {"criterion": name, ensemble.axes[x].key: found.place, "low": found.low,
                      "high": found.high, "how": found.how})


def crossings_along(values, counts, x):
    """For both criteria, an object array of Crossing over the other axes.

    values: (K) of the axis;  x: its position in the counts
    """
    done = np.moveaxis(counts.done, x, -1)
    found = {}
    for name in ("separation", "arrest"):
        met = np.moveaxis(counts.met[name], x, -1)
        found[name] = np.empty(done.shape[:-1], dtype=object)
        for place in np.ndindex(found[name].shape):
            found[name][place] = crossing(values, met[place], done[place])
    return found
