"""Density, velocity and temperature across the gradient, or from wall to wall."""

import numpy as np

from .blocking import errors_of_means
from .frames import AXES
from .kinds import UNIT_SPHERE_VOLUME

THICK, THIN = 1.0, 0.5  # diameters, layers of a periodic box and between walls
MOST = 200


class Profiles:
    """Means in layers across one axis: y, or the normal of the walls; x in one dimension.

    The temperature of a layer is the variance of one velocity component about the mean velocity of
    that layer over all snapshots; the imposed profile is taken off before. Of spheres that differ
    velocities count by their masses, as in the temperature m v^2 / D, and those of immobile ones
    do not.

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
        self._kinds = frames.kinds
        # Of each snapshot, per layer: spheres that move, mass, momentum, m v^2, volumes of kinds
        self._rows = []

    def add(self, frame):
        """Adds the spheres of a snapshot, by their centres."""
        layers = len(self.edges) - 1
        where = np.clip(np.digitize(frame.positions[:, self.axis], self.edges) - 1, 0, layers - 1)
        velocities = frame.profile_velocities
        number, mass, volumes = self._weights(len(where))
        summed = [number, mass, *(mass * velocities.T), mass * np.sum(velocities**2, axis=1),
                  *volumes]
        self._rows.append(np.array([np.bincount(where, each, layers) for each in summed]).T)

    def result(self):
        """profiles: axis, y, solids_volume_fraction, velocity, mean_velocity, ..."""
        rows = np.array(self._rows)  # (snapshots, layers, 2 + D + 1 + kinds)
        number, mass, square = rows[:, :, 0], rows[:, :, 1], rows[:, :, 2 + self.dimension]
        momentum, volumes = rows[:, :, 2:2 + self.dimension], rows[:, :, 3 + self.dimension:]
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = momentum.sum(axis=0) / mass.sum(axis=0)[:, None]
            about = square - 2 * np.sum(momentum * mean, axis=2) + mass * np.sum(mean**2, axis=1)
            temperature = about.sum(axis=0) / (self.dimension * number.sum(axis=0))
            errors = {"velocity": errors_of_means(momentum[:, :, 0] / mass),
                      "granular_temperature": errors_of_means(about / (self.dimension * number))}
        place = (self.edges[1:] + self.edges[:-1]) / 2
        mean[:, 0] += self.shear_rate * (place - self.edges[-1] / 2)
        sphere = UNIT_SPHERE_VOLUME[self.dimension] / self._layer_volume
        volume = volumes.sum(axis=2)
        errors["solids_volume_fraction"] = errors_of_means(volume * sphere)
        return {"profiles": {
            "axis": AXES[self.axis], "y": place,
            "solids_volume_fraction": volume.mean(axis=0) * sphere, "velocity": mean[:, 0],
            "mean_velocity": mean, "granular_temperature": np.maximum(temperature, 0),
            **self._of_kinds(volumes.mean(axis=0) * sphere),
            **{f"{name}_standard_error": error for name, error in errors.items()}}}

    def _weights(self, spheres):
        """Of each sphere: 1 if it moves, its mass then, and its volume in the row of its kind."""
        if self._kinds is None:
            return np.ones(spheres), np.ones(spheres), [np.ones(spheres)]
        volume = self._kinds.volumes(self.dimension)
        return (self._kinds.mobile.astype(float), np.where(self._kinds.mobile, self._kinds.mass, 0),
                [np.where(member, volume, 0) for member in self._kinds.members])

    def _of_kinds(self, fractions):
        """The part of the solids volume fraction that is of each kind; nothing of unit spheres."""
        if self._kinds is None:
            return {}
        return {"species_solids_volume_fraction": dict(zip(self._kinds.names, fractions.T))}
