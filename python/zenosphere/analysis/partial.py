"""Radial distributions of the spheres of a mixture: of all pairs, and of each pair of kinds."""

from itertools import combinations_with_replacement

import numpy as np

from .blocking import errors_of_means, measured
from .kinds import UNIT_SPHERE_VOLUME
from .radial import (BIN, FARTHEST, WIDEST_CONTACT, contact_range, end_weight, shell_volume,
                     surface)


class PartialDistributions:
    """g(r) of all pairs, and g_ab of each two kinds against the distance over the mean diameter.

    With x = r / sigma, sigma the mean diameter of the two spheres, spheres of any size touch at 1;
    where places are independent g_ab is 1 at each x. Counted is each pair over V / sigma^D and the
    volume of the shell in x. Between walls, where the room of a centre depends on its diameter,
    nothing is counted.

    frames: Frames, with kinds
    """

    def __init__(self, frames):
        self._kinds, self._dimension = frames.kinds, frames.dimension
        diameters = self._kinds.diameter
        self._largest = diameters.max()
        self._pairs = [pair for pair in combinations_with_replacement(
            range(len(self._kinds.names)), 2) if self._number(*pair) > 0]
        box = frames.box
        self._farthest = min(box.reach, FARTHEST * self._largest)
        self._edges = self._bins(diameters.min(), self._farthest)
        self._partial_edges = self._bins(1.0, self._farthest / self._largest)
        self._width = self._contact_width(frames)
        self._is_counted = frames.walls is None and frames.spheres > 1
        self._rows = []
        self._partial_rows = {pair: [] for pair in self._pairs}
        self._contacts = {pair: [] for pair in self._pairs}

    def add(self, frame):
        """Counts the pairs of a snapshot."""
        if not self._is_counted:
            return
        row = np.zeros(len(self._edges) - 1)
        parts = {pair: np.zeros(len(self._partial_edges) - 1) for pair in self._pairs}
        contacts = dict.fromkeys(self._pairs, 0.0)
        reach = self._farthest if frame.is_in_detail else self._largest * (1 + self._width)
        for i, j, distance in frame.box.neighbours(frame.positions, reach):
            if frame.is_in_detail:
                row += np.histogram(distance, self._edges)[0]
            sigma = (self._kinds.diameter[i] + self._kinds.diameter[j]) / 2
            x = distance / sigma
            for a, b in self._pairs:
                of_pair = (self._kinds.kind[i] == a) & (self._kinds.kind[j] == b)
                weight = frame.box.volume / sigma[of_pair]**self._dimension
                contacts[a, b] += np.sum(self._contact_weight(x[of_pair]) * weight)
                if frame.is_in_detail:
                    parts[a, b] += np.histogram(x[of_pair], self._partial_edges, weights=weight)[0]
        for pair in self._pairs:
            self._contacts[pair].append(contacts[pair] / self._number(*pair))
        if frame.is_in_detail:
            density = frame.spheres * (frame.spheres - 1) / frame.box.volume
            self._rows.append(row / (density * self._shells(self._edges)))
            shells = self._shells(self._partial_edges)
            for pair in self._pairs:
                self._partial_rows[pair].append(parts[pair] / (self._number(*pair) * shells))

    def result(self):
        """radial_distribution and partial_radial_distributions; one contact_value there is not."""
        partial = [{"between": [self._kinds.names[number] for number in pair],
                    "contact_distance": self._contact_distance(*pair)}
                   | self._curve("x", self._partial_edges, self._partial_rows[pair])
                   | {"contact_value": measured(self._contacts[pair])} for pair in self._pairs]
        return {"radial_distribution": self._curve("r", self._edges, self._rows),
                "radial_distribution_by_direction": None, "contact_value": measured([]),
                "partial_radial_distributions": partial if self._is_counted else []}

    def _number(self, a, b):
        """Ordered pairs of a sphere of the kind a and another one of the kind b."""
        first, second = (int(self._kinds.members[number].sum()) for number in (a, b))
        return first * (second - (a == b))

    def _contact_distance(self, a, b):
        """Mean diameter of the two kinds; None where it differs from pair to pair."""
        sizes = [np.unique(self._kinds.diameter[self._kinds.members[number]]) for number in (a, b)]
        return float(sizes[0][0] + sizes[1][0]) / 2 if all(len(s) == 1 for s in sizes) else None

    def _contact_width(self, frames):
        """Over which x from contact g_ab is taken for a cubic: of the smallest spheres' packing."""
        volume = (self._kinds.volumes(self._dimension).sum()
                  * UNIT_SPHERE_VOLUME[self._dimension])
        width = contact_range(self._dimension, volume / np.prod(frames.box.sides))
        smallest = self._kinds.diameter.min()
        return float(min(width * smallest / self._largest, WIDEST_CONTACT,
                         self._farthest / self._largest - 1))

    def _contact_weight(self, x):
        """What each pair adds to the contact value, before its volume over sigma^D."""
        weight = np.zeros(len(x))
        near = (x <= 1 + self._width) & (x >= 1 - 1e-6)  # a file may keep 24 bits of the places
        shell = surface(self._dimension, x[near]) * self._width
        weight[near] = end_weight(np.maximum(x[near] - 1, 0) / self._width) / shell
        return weight

    def _shells(self, edges):
        return shell_volume(self._dimension, edges)

    @staticmethod
    def _bins(first, last):
        bins = int((last - first) / BIN + 1e-9)
        return first + np.arange(bins + 1) * BIN if bins > 0 else np.array([first, last])

    @staticmethod
    def _curve(place, edges, rows):
        if not rows:
            return {place: np.empty(0), "g": np.empty(0), "standard_error": np.empty(0)}
        return {place: (edges[1:] + edges[:-1]) / 2, "g": np.mean(rows, axis=0),
                "standard_error": errors_of_means(rows)}
