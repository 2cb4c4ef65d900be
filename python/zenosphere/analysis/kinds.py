"""What the spheres of a mixture are, as measurements need it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

UNIT_SPHERE_VOLUME = {1: 1.0, 2: np.pi / 4, 3: np.pi / 6}  # of diameter 1, by dimension


def common_motion(kinds, vectors, among=slice(None)):
    """Mean of a vector of some spheres, by mass, without immobile ones; of no sphere 0.

    kinds: Kinds, None for unit spheres;  vectors: (N, D), velocities or displacements
    """
    if kinds is None:
        return vectors[among].mean(axis=0)
    mass = np.where(kinds.mobile, kinds.mass, 0)[among]
    return mass @ vectors[among] / mass.sum() if mass.any() else 0


@dataclass(frozen=True)
class Kinds:
    """Spheres that differ.

    diameter, mass: (N);  kind: (N), number of the species;  immobile: (N), bool
    names: of the species
    """

    diameter: np.ndarray
    mass: np.ndarray
    kind: np.ndarray
    immobile: np.ndarray
    names: tuple[str, ...]

    @classmethod
    def of(cls, grains, names):
        """Of the grains of a case, None where there are none; names: of its species, maybe none."""
        if grains is None:
            return None
        return cls(grains.diameter, grains.mass, grains.kind, grains.immobile,
                   tuple(names) or ("spheres",))

    @cached_property
    def mobile(self):
        """(N), bool."""
        return ~self.immobile

    @cached_property
    def members(self):
        """Which spheres are of each kind, a list of (N) bool."""
        return [self.kind == number for number in range(len(self.names))]

    def volumes(self, dimension):
        """diameter^D of each sphere, (N): its volume over that of a unit sphere."""
        return self.diameter**dimension

    def temperatures(self, velocities):
        """Mean of m v^2 / D over the mobile spheres of each kind, (K); NaN where there are none."""
        energy = self.mass * np.sum(velocities**2, axis=1) / velocities.shape[1]
        return np.array([energy[member & self.mobile].mean()
                         if (member & self.mobile).any() else np.nan for member in self.members])

    def temperature(self, velocities):
        """The same over all mobile spheres."""
        energy = self.mass * np.sum(velocities**2, axis=1)
        return float(energy[self.mobile].mean()) / velocities.shape[1]
