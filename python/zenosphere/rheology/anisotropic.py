"""Simple shear with anisotropic Maxwellian velocities: the Enskog equation's second moments."""

import numpy as np
from scipy.optimize import root
from scipy.stats import norm

from ..errors import InputError
from .flow import ShearFlow, contact_value, number_density
from .navier_stokes import navier_stokes_flow

POLAR, AZIMUTHAL = 24, 48  # points of the integral over the directions of contacts


def anisotropic_flow(restitution, fraction):
    """The steady shear flow of spheres whose velocities are Gaussian with a full second moment K.

    restitution: in [0, 1);  fraction: of solids, by volume
    K follows from its own balance: what the shear feeds into it, collisions take out. Contacts are
    those of the Enskog equation, spheres at contact differing in mean velocity by the shear. All
    orders of the shear rate are kept, so that normal stresses differ; correlations of velocities
    are left out. Solved with numbers, without an expansion.
    Source: Jenkins & Richman, J. Fluid Mech. 192 (1988) 313; Chou & Richman, Physica A 259 (1998)
    430; Saha & Alam, J. Fluid Mech. 795 (2016) 549.
    Raises InputError where no such flow is found.
    """
    if not 0 <= restitution < 1:
        raise InputError(f"restitution = {restitution} (no steady flow outside [0, 1): elastic"
                         " spheres heat up for ever); choose another")
    collisions = _Collisions(restitution, fraction)
    isotropic = navier_stokes_flow(restitution, fraction)
    temperature = isotropic.granular_temperature
    scale = np.sqrt(temperature)  # of a rate: unknowns and equations of order one

    def imbalance(moments):
        second = _matrix(moments) * temperature
        change = collisions.change(second)
        change[0] -= second[1]
        change[:, 0] -= second[1]
        return _moments(change) / temperature / scale

    start = np.array([1.2, 0.9, 0.9, -isotropic.shear_stress / isotropic.pressure])
    found = root(imbalance, start, tol=1e-11)
    if not found.success:
        raise InputError(f"restitution = {restitution}, solids volume fraction = {fraction}: kinetic"
                         " theory has no shear flow there; choose values nearer to elastic spheres")
    return collisions.flow(_matrix(found.x) * temperature)


class _Collisions:
    """Averages over the collisions of spheres with Gaussian velocities, shear rate 1."""

    def __init__(self, restitution, fraction):
        self.restitution = restitution
        self.density = number_density(fraction)
        self.contact = contact_value(fraction)
        self.normals, self.weights = _directions()
        self.shift = -self.normals[:, 0] * self.normals[:, 1]  # mean closing speed, of the shear

    def flow(self, second):
        """What an observer measures."""
        moments = self._closing_speeds(second)[1]
        flux = self.density * self.contact * self.weights
        kinetic = self.density * second
        transfer = flux * self.density * (1 + self.restitution) / 4 * moments[1]
        tensor = kinetic + np.einsum("k,ka,kb->ab", transfer, self.normals, self.normals)
        pressure = np.trace(tensor) / 3
        return ShearFlow(
            granular_temperature=np.trace(second) / 3, pressure=pressure, shear_stress=-tensor[0, 1],
            n1=(tensor[0, 0] - tensor[1, 1]) / pressure,
            n2=(tensor[1, 1] - tensor[2, 2]) / pressure,
            sonine_a2=_sonine(second),
            collision_rate=float(np.sum(flux * moments[0])))

    def change(self, second):
        """Rate of change of the second moment K by collisions: a 3 x 3 matrix."""
        spread, (_, square, cube) = self._closing_speeds(second)
        flux = self.density * self.contact * self.weights
        # Given the closing speed g, the relative velocity has the mean K n (g - shift) / n.K.n.
        loss = flux * (1 + self.restitution) / 4 * (cube - self.shift * square) / spread
        gain = flux * (1 + self.restitution) ** 2 / 4 * cube
        mixed = np.einsum("k,ka,kb->ab", loss, self.normals, self.normals @ second)
        return np.einsum("k,ka,kb->ab", gain, self.normals, self.normals) - mixed - mixed.T

    def _closing_speeds(self, second):
        """n.K.n, and the mean of g, g^2 and g^3 over g > 0, for each direction n."""
        spread = np.einsum("ka,ab,kb->k", self.normals, second, self.normals)
        width, shift = np.sqrt(2 * spread), self.shift
        density, below = width * norm.pdf(shift / width), norm.cdf(shift / width)
        square = (shift**2 + width**2) * below + shift * density
        cube = (shift**3 + 3 * shift * width**2) * below + (shift**2 + 2 * width**2) * density
        return spread, (shift * below + density, square, cube)


def _directions():
    """Unit vectors and their weights, which add up to 4 pi."""
    height, weight = np.polynomial.legendre.leggauss(POLAR)
    angle = 2 * np.pi * (np.arange(AZIMUTHAL) + 0.5) / AZIMUTHAL
    height, angle = (array.ravel() for array in np.meshgrid(height, angle, indexing="ij"))
    radius = np.sqrt(1 - height**2)
    normals = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=1)
    return normals, np.repeat(weight, AZIMUTHAL) * 2 * np.pi / AZIMUTHAL


def _sonine(second):
    """a2 of Gaussian velocities: <v^4> = (tr K)^2 + 2 tr K^2."""
    return 3 / 5 * (1 + 2 * np.sum(second**2) / np.trace(second) ** 2) - 1


def _matrix(moments):
    xx, yy, zz, xy = moments
    return np.array([[xx, xy, 0], [xy, yy, 0], [0, 0, zz]])


def _moments(matrix):
    return np.array([matrix[0, 0], matrix[1, 1], matrix[2, 2], matrix[0, 1]])
