"""What an output file holds, read with h5py, and distances computed from it in the test itself."""

import itertools

import h5py
import numpy as np

IMAGES = np.array(list(itertools.product(range(-2, 3), repeat=3)))


class Recorded:
    """Arrays of a run, one row a snapshot; axes that the run does not have are 0."""

    def __init__(self, path):
        with h5py.File(path) as file:
            spheres = file["particles/spheres"]
            self.position = in_space(spheres["position/value"][()])
            self.velocity = in_space(spheres["velocity/value"][()])
            self.image = in_space(spheres["image/value"][()])
            self.edges = spheres["box/edges/value"][()]
            self.step = spheres["position/step"][()]
            self.time = spheres["position/time"][()]
            self.log = {name: column[()] for name, column in file["collisions"].items()}
        self.dimension = self.edges.shape[-1]

    def cell(self, n):
        """The 3 x 3 cell of a snapshot: what is missing is one diameter thick."""
        cell = np.eye(3)
        cell[:self.dimension, :self.dimension] = self.edges[n]
        return cell

    def collisions(self, n):
        """How often each sphere has collided up to a snapshot."""
        rows = self.log["k"] <= self.step[n]
        partners = np.concatenate([self.log["i"][rows], self.log["j"][rows]])
        spheres = self.position.shape[1]
        return np.bincount(partners, minlength=spheres + 2)[:spheres]


def in_space(rows):
    """Rows of D numbers as rows of three."""
    return np.pad(rows, [(0, 0)] * (rows.ndim - 1) + [(0, 3 - rows.shape[-1])])


def sheared_cell(side, strain):
    """The cell of a cube after a strain of any size, from the strain alone."""
    return np.array([[side, 0, 0], [(strain % 1) * side, side, 0], [0, 0, side]])


def distances(position, cell, periodic=(True, True, True)):
    """Distance of each pair of spheres to the nearest image, in the order of np.triu_indices.

    Every image that can be nearest is tried; nothing is assumed of the cell but that positions are
    in it, or in the upright box with the same sides.
    """
    i, j = np.triu_indices(len(position), 1)
    apart = position[j] - position[i]
    images = IMAGES[np.all((IMAGES == 0) | np.array(periodic), axis=1)]
    nearest = np.full(len(apart), np.inf)
    for shift in images @ cell:
        nearest = np.minimum(nearest, np.sum((apart + shift) ** 2, axis=1))
    return np.sqrt(nearest)
