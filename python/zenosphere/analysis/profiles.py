"""Density, velocity and temperature across the gradient, or from wall to wall."""

import numpy as np

from .frames import AXES

THICK, THIN = 1.0, 0.5  # diameters, layers of a periodic box and between walls
MOST = 200


class Profiles:
    """Means in layers across one axis: y, or the normal of the walls; x in one dimension.

    The temperature of a layer is the variance of one velocity component about the mean velocity of
    that layer over all snapshots; the imposed profile is taken off before.

    frames: Frames
    """

    def __init__(self, frames):
        self.shear_rate, self.dimension = frames.shear_rate, frames.dimension
        self.axis = frames.walls if frames.walls is not None else min(frames.dimension - 1, 1)
        side = frames.box.sides[self.axis]
        thickness = THICK if frames.walls is None else THIN
        layers = int(np.clip(round(side / thickness), 1, MOST))
        self.edges = np.linspace(0, side, layers + 1)
        self._layer_volume = np.prod(frames.box.sides) / layers
        self._snapshots, self._number = 0, np.zeros(layers)
        self._velocity, self._square = np.zeros((layers, self.dimension)), np.zeros(layers)

    def add(self, frame):
        """Adds the spheres of a snapshot, by their centres."""
        layers = len(self._number)
        where = np.clip(np.digitize(frame.positions[:, self.axis], self.edges) - 1, 0, layers - 1)
        velocities = frame.profile_velocities
        self._snapshots += 1
        self._number += np.bincount(where, minlength=layers)
        self._square += np.bincount(where, np.sum(velocities**2, axis=1), layers)
        for axis in range(self.dimension):
            self._velocity[:, axis] += np.bincount(where, velocities[:, axis], layers)

    def result(self):
        """profiles: axis, y, solids_volume_fraction, velocity, mean_velocity, ..."""
        place = (self.edges[1:] + self.edges[:-1]) / 2
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = self._velocity / self._number[:, None]
            square = self._square / self._number - np.sum(mean**2, axis=1)
        mean[:, 0] += self.shear_rate * (place - self.edges[-1] / 2)
        sphere = {1: 1.0, 2: np.pi / 4, 3: np.pi / 6}[self.dimension]
        fraction = self._number * sphere / (self._snapshots * self._layer_volume)
        return {"profiles": {"axis": AXES[self.axis], "y": place,
                             "solids_volume_fraction": fraction, "velocity": mean[:, 0],
                             "mean_velocity": mean,
                             "granular_temperature": np.maximum(square, 0) / self.dimension}}
