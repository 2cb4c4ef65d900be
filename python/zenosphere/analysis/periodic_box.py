"""The box of a snapshot: which spheres are near each other, through its faces too."""

import numpy as np
from scipy.spatial import cKDTree

PAIRS_AT_ONCE = 2_000_000  # about 150 MB


class PeriodicBox:
    """A box with periodic faces, slid under shear, or with two walls along one axis.

    edges: (D, D), rows are the box vectors, diameters; the second one with the Lees-Edwards offset
    walls: number of the axis that is not periodic, or None
    """

    def __init__(self, edges, walls=None):
        self.edges = np.asarray(edges, dtype=float)
        self.sides = np.diagonal(self.edges).copy()
        self.walls = walls

    @property
    def dimension(self):
        """1, 2 or 3."""
        return len(self.sides)

    @property
    def periodic(self):
        """Numbers of the periodic axes."""
        return [axis for axis in range(self.dimension) if axis != self.walls]

    @property
    def reach(self):
        """Distance within which two spheres meet in one image at most."""
        if not self.periodic:
            return float(self.sides[0])
        return float(min(self.sides[axis] for axis in self.periodic)) / 2

    @property
    def volume(self):
        """Volume in which centres can be: walls keep them half a diameter away."""
        sides = self.sides.copy()
        if self.walls is not None:
            sides[self.walls] -= 1
        return float(np.prod(sides))

    def nearest(self, arrows):
        """Vectors (M, D) between spheres, each moved by box vectors to its shortest image."""
        arrows = np.array(arrows, dtype=float)
        for axis in reversed(self.periodic):  # y before x: its image is shifted along x
            arrows -= np.rint(arrows[:, axis:axis + 1] / self.sides[axis]) * self.edges[axis]
        return arrows

    def neighbours(self, positions, reach):
        """Yields, part by part, all pairs of spheres within a distance, each of them both ways.

        positions: (N, D) in the box;  reach: at most `self.reach`
        Yields (i (M), j (M), distance (M)).
        """
        positions = self._inside(positions)
        places, owners = self._with_images(positions, reach)
        tree = cKDTree(places, boxsize=self._periods())
        count = len(positions)
        crowd = 1 + count / np.prod(self.sides) * 5 * reach**self.dimension
        step = int(np.clip(PAIRS_AT_ONCE / crowd, 1, count))
        for begin in range(0, count, step):
            part = cKDTree(positions[begin:begin + step], boxsize=self._periods())
            found = part.sparse_distance_matrix(tree, reach, output_type="ndarray")
            i, j = found["i"] + begin, found["j"]
            others = owners[j] != i
            yield i[others], owners[j[others]], found["v"][others]

    def share_inside(self, positions, distances):
        """Share of the surface around a sphere where centres can be, mean over the spheres.

        positions: (N, D);  distances: (K).  Returns float64 (K), 1 without walls.
        """
        if self.walls is None:
            return np.ones(len(distances))
        height = positions[:, self.walls]
        rooms = height - 0.5, self.sides[self.walls] - 0.5 - height
        return np.array([self._share(*(np.clip(room / distance, 0, 1) for room in rooms)).mean()
                         for distance in distances])

    def _share(self, below, above):
        """Of one surface; below, above: where it ends, in units of its radius."""
        if self.dimension == 3:
            return (below + above) / 2
        if self.dimension == 2:
            return 1 - (np.arccos(below) + np.arccos(above)) / np.pi
        return ((below >= 1).astype(float) + (above >= 1)) / 2

    def _inside(self, positions):
        """Positions with every periodic component in [0, side), whatever rounding has done."""
        places = np.array(positions, dtype=float)
        for axis in self.periodic:
            places[:, axis] %= self.sides[axis]
            places[places[:, axis] >= self.sides[axis], axis] = 0
        return places

    def _with_images(self, positions, reach):
        """Spheres, and of a slid box their images above and below; places and whose they are."""
        owners = np.arange(len(positions))
        if not self._is_slid():
            return positions, owners
        low, high = positions[:, 1] <= reach, positions[:, 1] >= self.sides[1] - reach
        above, below = positions[low] + self.edges[1], positions[high] - self.edges[1]
        places = np.concatenate((positions, above, below))
        places[:, 0] = self._inside(places)[:, 0]
        return places, np.concatenate((owners, owners[low], owners[high]))

    def _periods(self):
        """Sides for the tree; 0: it need not look across these faces."""
        periods = self.sides.copy()
        periods[[axis for axis in range(self.dimension)
                 if axis == self.walls or (axis == 1 and self._is_slid())]] = 0
        return periods

    def _is_slid(self):
        return self.dimension > 1 and self.walls != 1 and self.edges[1, 0] != 0
