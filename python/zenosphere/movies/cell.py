"""The sheared cell of a snapshot, and how it is seen: places on paper. No drawing."""

import itertools

import numpy as np

FROM = (0.45, 0.3, 1.0)  # where spheres are seen from, as in the report page
MOST_ROWS = 100  # of a long line


class Cell:
    """A periodic cell in one to three dimensions.

    edges: (D, D), rows are the box vectors, diameters; the second one slanted by the Lees-Edwards
    offset;  walls: "x", "y", "z" or None: the axis that is not periodic
    """

    def __init__(self, edges, walls=None):
        self.edges = np.asarray(edges, dtype=float)
        self.walls = walls

    @property
    def dimension(self):
        """1, 2 or 3."""
        return len(self.edges)

    def slanted(self, positions):
        """Positions (N, D) of the upright box, each moved along x to its image in this cell."""
        places = np.array(positions, dtype=float)
        if self.dimension < 2 or self.walls == "x":
            return places
        left = self.edges[1, 0] * places[:, 1] / self.edges[1, 1]
        side = self.edges[0, 0]
        places[:, 0] -= np.floor((places[:, 0] - left) / side) * side
        return places

    def corners(self):
        """The 2^D corners, (2^D, D)."""
        return np.array(list(itertools.product((0, 1), repeat=self.dimension))) @ self.edges

    def sides(self):
        """Pairs of numbers of corners that a side joins, (D 2^(D-1), 2)."""
        count = 2**self.dimension
        return np.array([(n, n | bit) for bit in (2**d for d in range(self.dimension))
                         for n in range(count) if not n & bit])


class View:
    """How places are seen: disks from above, spheres along parallel rays, a long line in rows.

    length: of the line, for one dimension
    """

    def __init__(self, dimension, length=0.0):
        self.dimension = dimension
        self.rows = 1
        if dimension == 1:
            self.rows = int(np.clip(round(np.sqrt(length / 4)), 1, MOST_ROWS))
            self.row_length = length / self.rows
        toward = np.array(FROM) / np.linalg.norm(FROM)
        right = np.cross((0, 1, 0), toward)
        right /= np.linalg.norm(right)
        self._axes = np.array([right, np.cross(toward, right), toward])

    def seen(self, places):
        """Places (N, D) on paper, (N, 3): right, up, and towards the viewer, diameters."""
        if self.dimension == 3:
            return places @ self._axes.T
        flat = np.zeros((len(places), 3))
        flat[:, :self.dimension] = places
        if self.dimension == 1:
            row = np.clip(places[:, 0] // self.row_length, 0, self.rows - 1)
            flat[:, 0] -= row * self.row_length
            flat[:, 1] = -3 * row
        return flat

    def outline(self, cell):
        """Lines of the cell on paper, (M, 2, 2), and which of them are in front, (M)."""
        if self.dimension == 1:
            heights = -3.0 * np.arange(self.rows)
            lines = [[(0, height), (self.row_length, height)] for height in heights]
            return np.array(lines), np.zeros(self.rows, dtype=bool)
        corners = self.seen(cell.corners())
        sides = cell.sides()
        farthest = corners[:, 2].argmin() if self.dimension == 3 else -1
        return corners[sides][:, :, :2], ~(sides == farthest).any(axis=1)
