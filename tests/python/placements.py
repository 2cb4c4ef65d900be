"""Snapshots whose structure, velocities and displacements are known, without a run."""

import numpy as np

from zenosphere.analysis.frames import Frame
from zenosphere.analysis.periodic_box import PeriodicBox


class Given:
    """Stands for `Frames`: snapshots from arrays.

    positions: a sequence of (N, D), in the box;  velocities: of (N, D), peculiar; None: all 0
    edges: (D, D), or one for each snapshot;  interval: time between snapshots
    in_detail: how many of them are for whole curves;  kinds: Kinds, None: unit spheres
    """

    def __init__(self, positions, edges, velocities=None, interval=1.0, shear_rate=0.0, walls=None,
                 collision_rate=0.0, in_detail=40, kinds=None):
        self.positions = positions
        self.velocities = velocities
        edges = np.asarray(edges, dtype=float)
        self.edges = [edges] * len(positions) if edges.ndim == 2 else edges
        self.times = interval * np.arange(len(positions))
        self.shear_rate, self.walls, self.collision_rate = shear_rate, walls, collision_rate
        self.in_detail, self.kinds = in_detail, kinds
        self.spheres, self.dimension = np.shape(positions[0])
        self.box = PeriodicBox(self.edges[0], walls)

    @property
    def duration(self):
        return self.times[-1] - self.times[0]

    def __len__(self):
        return len(self.positions)

    def __iter__(self):
        for number, (time, places, edges) in enumerate(zip(self.times, self.positions, self.edges)):
            velocities = (np.zeros_like(places) if self.velocities is None
                          else self.velocities[number])
            box = PeriodicBox(edges, self.walls)
            yield Frame(number, time, places, velocities, velocities, box,
                        is_in_detail=number < self.in_detail, kinds=self.kinds)


def result_of(measurement, frames):
    """What a measurement finds in all the snapshots."""
    measure = measurement(frames)
    for frame in frames:
        measure.add(frame)
    return measure.result()


def independent_places(snapshots, spheres, sides, seed=1):
    """Uniform and independent, a list of (N, D)."""
    random = np.random.default_rng(seed)
    return [random.random((spheres, len(sides))) * sides for _ in range(snapshots)]


def rods_in_equilibrium(snapshots, rods, fraction, seed=1):
    """Rods of length 1 at random on a ring, exactly; places (N, 1) and the length of the ring.

    Without their lengths the rods are independent points.
    """
    random, length = np.random.default_rng(seed), rods / fraction
    places = []
    for _ in range(snapshots):
        points = np.sort(random.random(rods)) * (length - rods)
        places.append(((points + np.arange(rods) + random.random() * length) % length)[:, None])
    return places, length


def lattice(cells, spacing, basis):
    """Places of a cubic lattice of `cells` cells along each axis, (N, 3).

    basis: places in a cell, in units of its side
    """
    corners = np.stack(np.meshgrid(*(np.arange(cells),) * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return (corners[:, None] + np.asarray(basis)).reshape(-1, 3) * spacing


FCC = [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)]
SIMPLE_CUBIC = [(0, 0, 0)]
