"""Mean free path, and spheres that touch: their coordination and the clusters they form."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .blocking import mean_and_error, measured

TOUCHING = 0.01  # gap, diameters


class Contacts:
    """Pairs with a gap of 0.01 diameters at most, and the clusters that such pairs connect.

    The gap of spheres that differ is that over their mean diameter.

    frames: Frames
    """

    def __init__(self, frames):
        self._kinds = frames.kinds
        self._widest = 1.0 if self._kinds is None else float(self._kinds.diameter.max())
        self.gap = float(min(TOUCHING, frames.box.reach / self._widest - 1))
        self._coordination, self._clusters, self._largest, self._members = [], [], [], []
        self._neighbours = np.zeros(1)

    def add(self, frame):
        """Counts the pairs and clusters of a snapshot."""
        reach = self._widest * (1 + self.gap)
        pairs = [self._touching(*part) for part in frame.box.neighbours(frame.positions, reach)]
        i, j = (np.concatenate(column) for column in zip(*pairs))
        graph = coo_matrix((np.ones(len(i)), (i, j)), shape=(frame.spheres, frame.spheres))
        sizes = np.bincount(connected_components(graph, directed=False)[1])
        several = sizes[sizes > 1]
        self._coordination.append(len(i) / frame.spheres)
        self._clusters.append(len(several))
        self._members.append(several.sum() / frame.spheres)
        self._largest.append(sizes.max())
        self._count(np.bincount(np.bincount(i, minlength=frame.spheres)))

    def result(self):
        """touching: gap, coordination, share of spheres with each number of neighbours, ..."""
        if not self._coordination:  # no snapshot
            return {"touching": dict.fromkeys(
                ("coordination", "coordination_standard_error", "clusters", "share_in_clusters",
                 "largest_cluster")) | {"gap": self.gap, "neighbours": np.empty(0),
                                        "share": np.empty(0)}}
        coordination, error = mean_and_error(self._coordination)
        number = np.arange(len(self._neighbours))
        return {"touching": {
            "gap": self.gap, "coordination": coordination, "coordination_standard_error": error,
            "neighbours": number, "share": self._neighbours / self._neighbours.sum(),
            "clusters": float(np.mean(self._clusters)),
            "share_in_clusters": float(np.mean(self._members)),
            "largest_cluster": int(np.max(self._largest))}}

    def _touching(self, i, j, distance):
        """Of pairs that are near those that touch."""
        if self._kinds is None:
            return i, j
        diameter = self._kinds.diameter
        near = distance <= (diameter[i] + diameter[j]) / 2 * (1 + self.gap)
        return i[near], j[near]

    def _count(self, numbers):
        more = len(numbers) - len(self._neighbours)
        if more > 0:
            self._neighbours = np.pad(self._neighbours, (0, more))
        self._neighbours[:len(numbers)] += numbers


class FreePath:
    """Mean distance between the collisions of a sphere: mean peculiar speed / collision rate.

    Walls count: a bounce is a collision of one sphere, and half of one between two.

    frames: Frames
    """

    def __init__(self, frames):
        self._rate = frames.collision_rate
        self._speeds = []

    def add(self, frame):
        """Adds the speeds of a snapshot."""
        self._speeds.append(float(np.linalg.norm(frame.velocities, axis=1).mean()))

    def result(self):
        """mean_free_path, diameters; null where nothing collides."""
        return {"mean_free_path": measured([speed / self._rate for speed in self._speeds])
                if self._rate > 0 else {"value": None, "standard_error": None}}
