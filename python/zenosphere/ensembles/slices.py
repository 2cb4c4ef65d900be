"""Which axis of an ensemble plays which part in a figure, and the counts arranged for it."""

from dataclasses import dataclass, replace

import numpy as np

from ..errors import InputError
from .averages import Averages
from .store import Counts, Ensemble

USUAL = ("system.restitution", "system.solids_volume_fraction", "system.spheres")


@dataclass(frozen=True)
class Parts:
    """Positions of the axes: x of the curves, the panels, the series in one panel; the rest."""

    x: int
    y: int | None
    series: int | None
    rest: tuple


@dataclass(frozen=True)
class Slice:
    """An ensemble at one point of the rest, as arrays over (x, y, series) of length 1 or more."""

    ensemble: Ensemble
    parts: Parts
    counts: Counts
    others: tuple  # (key, value) of the rest
    averages: Averages  # the same with the seeds last

    def axis(self, name):
        """(key, values) of x, y or series; values (None,) where there is no such axis."""
        position = getattr(self.parts, name)
        if position is None:
            return None, (None,)
        return self.ensemble.axes[position].key, self.ensemble.axes[position].values

    def with_limit(self, limit):
        """The same with what happened within so many collisions per sphere."""
        return next(each for each in slices(self.ensemble, self.parts, limit)
                    if each.others == self.others)

    def last(self):
        """The same at the last value of the series only."""
        return replace(self, counts=self.counts.at((slice(None), slice(None), slice(-1, None))))


def chosen_parts(ensemble, x=None, y=None):
    """Which axis is what. Raises InputError for a key that is no axis, or no number."""
    axes = ensemble.axes
    if x is not None and x == y:
        raise InputError(f"{ensemble.path}: --x and --y are both {x} (a figure needs two axes);"
                         " choose another key or leave one out")
    named = [_position(ensemble, key) for key in (x, y) if key is not None]
    free = [place for place, axis in enumerate(axes)
            if axis.is_numeric and len(axis.values) > 1 and place not in named]
    free.sort(key=lambda place: (_usual(axes[place].key), -len(axes[place].values), place))
    take = iter(free)
    first = next(take, None) if x is None else _position(ensemble, x)
    if first is None:
        raise InputError(f"{ensemble.path}: no axis has two numbers (nothing can be the x of a"
                         " figure); read the table with zenosphere sweep csv")
    second = next(take, None) if y is None else _position(ensemble, y)
    third = next(take, None)
    rest = tuple(place for place in range(len(axes)) if place not in (first, second, third))
    return Parts(first, second, third, rest)


def _usual(key):
    return USUAL.index(key) if key in USUAL else len(USUAL)


def _position(ensemble, key):
    for place, axis in enumerate(ensemble.axes):
        if axis.key == key and axis.is_numeric:
            return place
    numeric = ", ".join(axis.key for axis in ensemble.axes if axis.is_numeric)
    raise InputError(f"{ensemble.path}: {key} is no axis with numbers (there are {numeric});"
                     " choose one of them with --x or --y")


def slices(ensemble, parts, limit=None):
    """The ensemble at each point of the rest."""
    counts, averages = ensemble.counts(limit), ensemble.averages()
    shown = [place for place in (parts.x, parts.y, parts.series) if place is not None]
    for point in np.ndindex(*(len(ensemble.axes[place].values) for place in parts.rest)):
        index = [slice(None)] * len(ensemble.axes)
        for place, value in zip(parts.rest, point):
            index[place] = value
        order = np.argsort(np.argsort(shown))  # axes that are left, ascending -> x, y, series
        others = tuple((ensemble.axes[place].key, ensemble.axes[place].values[value])
                       for place, value in zip(parts.rest, point))
        def arranged(array, index=tuple(index), order=order):
            return _arranged(array[index], order)
        yield Slice(ensemble, parts, counts.mapped(arranged), others, averages.mapped(arranged))


def _arranged(array, order):
    """An array over (x, y, series), with length 1 where there is no such axis; others stay last."""
    seeds = range(len(order), array.ndim)
    moved = np.transpose(array, (*order, *seeds))
    return moved.reshape(moved.shape[:len(order)] + (1,) * (3 - len(order))
                         + moved.shape[len(order):])
