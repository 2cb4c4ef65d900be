"""The static structure factor, and its limit at long waves."""

import numpy as np

from .blocking import errors_of_means, measured
from .waves import Waves, mesh_limit

LARGEST = 15.0  # k, 1/diameter: two peaks of a fluid
LONG = 1.5  # k up to which S is taken for S(0) + a k^2
LEAST_SHELLS = 3  # of waves along one side for that, where a box is small
MOST_LONG = 1200  # waves
MOST_BINS = 300


class StructureFactor:
    """S(k) = |sum over spheres of exp(i k r)|^2 / N for the waves that fit into the box.

    Each bin of |k| is a mean over all its waves. The limit is that of a parabola through the long
    ones; it is taken in every snapshot.

    frames: Frames
    """

    def __init__(self, frames):
        box = frames.box
        width = 2 * np.pi / max((box.sides[axis] for axis in box.periodic), default=1.0)
        step = max(width, LARGEST / MOST_BINS)
        self.edges = width / 2 + step * np.arange(max(int(LARGEST / step), 1) + 1)
        self.long = max(LONG, LEAST_SHELLS * width * 1.001)
        self._all = Waves(box, LARGEST, mesh_limit(box.dimension))
        self._few = Waves(box, self.long, MOST_LONG)
        self._rows, self._places, self._limits = [], [], []

    def add(self, frame):
        """Adds the waves of a snapshot: the long ones, in detail all of them."""
        edges = frame.box.edges
        if not frame.box.periodic:
            return
        power = self._few.power(frame.positions, edges)
        self._limits.append(self._limit(self._few.lengths(edges), power, self._few.weight))
        if frame.is_in_detail:
            self._add_all(frame)

    def result(self):
        """structure_factor: k, s, standard_error, and at_zero."""
        k, s, error = self._curve()
        known = np.isfinite(k)
        return {"structure_factor": {"k": k[known], "s": s[known], "standard_error": error[known],
                                     "at_zero": measured(self._limits)}}

    def _curve(self):
        """k, S(k) and its error in each bin; NaN where there is no wave."""
        if not self._rows:
            return np.full((3, len(self.edges) - 1), np.nan)
        return (np.mean(self._places, axis=0), np.mean(self._rows, axis=0),
                errors_of_means(self._rows))

    def _add_all(self, frame):
        """Adds the waves of a snapshot to the bins."""
        edges = frame.box.edges
        k, weight = self._all.lengths(edges), self._all.weight
        power = self._all.power_by_mesh(frame.positions, edges)
        bins = np.digitize(k, self.edges) - 1
        inside = (bins >= 0) & (bins < len(self.edges) - 1)
        waves, powers, places = (np.bincount(bins[inside], values[inside], len(self.edges) - 1)
                                 for values in (weight, weight * power, weight * k))
        with np.errstate(invalid="ignore"):
            self._rows.append(powers / waves)
            self._places.append(places / waves)

    def _limit(self, k, power, weight):
        """S(0) of one snapshot, by least squares over the long waves."""
        near = k <= self.long
        if len(np.unique(np.round(k[near], 6))) < LEAST_SHELLS:
            return np.nan
        root = np.sqrt(weight[near])
        basis = np.stack((np.ones(near.sum()), k[near] ** 2), axis=1)
        return np.linalg.lstsq(basis * root[:, None], power[near] * root, rcond=None)[0][0]
