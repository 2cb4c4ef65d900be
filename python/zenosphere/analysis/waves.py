"""Density waves of a snapshot: sums over spheres of exp(i k r), k of waves that fit into a box."""

import itertools

import numpy as np
from scipy.fft import next_fast_len, rfftn
from scipy.interpolate import BSpline

ORDER = 6  # of the splines that put spheres on a mesh
SPHERES_AT_ONCE = 20_000
MOST_POINTS = 2**24  # of a mesh, 400 MB
_SPLINE = BSpline.basis_element(np.arange(-ORDER // 2, ORDER // 2 + 1), extrapolate=False)


class Waves:
    """All waves up to some number of wavelengths along each side of a box.

    Waves are 2 pi times whole numbers over the box vectors, the slanted one under shear included.
    k and -k are the same wave: one of them is here, with the weight 2.

    box: PeriodicBox; between walls, waves run along them
    k: which the waves reach along each axis, 1/diameter
    limit: of their number; it lowers k in a large system
    """

    def __init__(self, box, k, limit):
        sides = np.where(np.arange(box.dimension) == box.walls, 0, box.sides)
        wavelengths = k * sides / (2 * np.pi) + 1e-9
        reached = (np.floor(wavelengths * 0.9**step) for step in itertools.count())
        largest = next(most for most in reached if np.prod(2 * most + 1) / 2 <= limit)
        self.largest = np.maximum(largest, sides > 0).astype(int)
        last = len(sides) - 1
        counts = [np.arange(0 if axis == last else -most, most + 1)
                  for axis, most in enumerate(self.largest)]
        self._numbers = np.stack(np.meshgrid(*counts, indexing="ij"), axis=-1).reshape(-1, last + 1)
        self._is_wave = self._numbers.any(axis=1)
        self.weight = np.where(self._numbers[:, -1] > 0, 2.0, 1.0)[self._is_wave]

    def lengths(self, edges):
        """|k| of each wave in a box with these edges, float64 (K), 1/diameter."""
        vectors = 2 * np.pi * self._numbers[self._is_wave] @ np.linalg.inv(edges).T
        return np.linalg.norm(vectors, axis=1)

    def power(self, positions, edges):
        """|sum of exp(i k r)|^2 / N of each wave, float64 (K): exact, for few waves."""
        fractional = positions @ np.linalg.inv(edges)
        last = len(self.largest) - 1
        along = [_powers(column, most, axis < last)
                 for axis, (column, most) in enumerate(zip(fractional.T, self.largest))]
        if last == 0:
            return self._chosen(along[0].sum(axis=1), positions)
        others = along[1] if last == 2 else np.ones((1, len(positions)))
        return self._chosen(np.array([(row * others) @ along[-1].T for row in along[0]]), positions)

    def power_by_mesh(self, positions, edges):
        """The same by a Fourier transform of a mesh, for many waves.

        Right to 1e-4 up to half the largest waves; to 1 % at the end, where errors of either sign
        average out.

        Source: Essmann et al., J. Chem. Phys. 103 (1995) 8577 (B-splines, here of order 6 on a mesh
        of four points to the shortest wave).
        """
        fractional = positions @ np.linalg.inv(edges)
        points = [next_fast_len(max(4 * int(most), 1), real=True) for most in self.largest]
        mesh = np.zeros(int(np.prod(points)))
        for begin in range(0, len(positions), SPHERES_AT_ONCE):
            mesh += _spread(fractional[begin:begin + SPHERES_AT_ONCE], points)
        density = rfftn(mesh.reshape(points))
        for axis, (count, most) in enumerate(zip(points, self.largest)):
            number = np.arange(0 if axis == len(points) - 1 else -most, most + 1)
            shape = np.where(np.arange(len(points)) == axis, len(number), 1)
            smoothed = np.sinc(number / count) ** ORDER
            density = np.take(density, number, axis=axis) / smoothed.reshape(shape)
        return self._chosen(density, positions)

    def _chosen(self, density, positions):
        return np.abs(density.ravel()[self._is_wave]) ** 2 / len(positions)


def mesh_limit(dimension):
    """Most waves that a mesh has room for."""
    return MOST_POINTS / 2 ** (dimension + 1)


def _powers(places, most, is_both_ways):
    """exp(2 pi i n x) for n from 0 or -most to most, (n, N); one power after the other."""
    steps = np.broadcast_to(np.exp(2j * np.pi * places), (most, len(places)))
    powers = np.cumprod(np.concatenate((np.ones((1, len(places)), dtype=complex), steps)), axis=0)
    return np.concatenate((powers[:0:-1].conj(), powers)) if is_both_ways else powers


def _spread(fractional, points):
    """Spheres on a flat mesh, each on the 6^D points around it with the weights of a spline."""
    nodes = np.arange(1 - ORDER // 2, ORDER // 2 + 1)
    index, weight = np.zeros((len(fractional), 1), dtype=np.int64), np.ones((len(fractional), 1))
    for column, count in zip(fractional.T, points):
        place = (column % 1.0) * count
        near = np.floor(place).astype(np.int64)[:, None] + nodes
        share = np.nan_to_num(_SPLINE(place[:, None] - near))
        index = (index[:, :, None] * count + (near % count)[:, None, :]).reshape(len(index), -1)
        weight = (weight[:, :, None] * share[:, None, :]).reshape(len(weight), -1)
    return np.bincount(index.ravel(), weight.ravel(), int(np.prod(points)))
