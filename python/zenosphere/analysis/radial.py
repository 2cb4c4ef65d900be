"""The radial distribution function, its value at contact, and the same by direction."""

from math import gamma, pi

import numpy as np
from scipy.special import eval_legendre

from ..cooling.law import contact_value
from .blocking import errors_of_means, measured

BIN = 0.02  # diameters
FARTHEST = 5.0  # diameters
SECTORS = 12  # of half a turn
DEGREE = 3  # of the polynomial that g(r) is near contact
WIDEST_CONTACT = 0.2  # diameters, over which it is


def surface(dimension, radius):
    """Surface of a sphere: its area, its circumference, or two points."""
    return 2 * pi ** (dimension / 2) / gamma(dimension / 2) * radius ** (dimension - 1)


def shell_volume(dimension, edges):
    """Volumes between successive radii, (K) for (K + 1)."""
    return np.diff(edges**dimension) * surface(dimension, 1.0) / dimension


def end_weight(place):
    """Weight whose integral with any cubic over [0, 1] is the value of that at 0.

    The sum of (2k + 1) P_k(-1) P_k(2u - 1): a projection on Legendre polynomials.
    """
    return sum((2 * k + 1) * (-1) ** k * eval_legendre(k, 2 * place - 1) for k in range(DEGREE + 1))


class RadialDistribution:
    """g(r) of all pairs: 1 where places are independent.

    Counted are distances from each sphere, over the number N - 1 of others per volume and the
    volume of the shell, of which between walls the part that centres can reach counts.

    frames: Frames
    """

    def __init__(self, frames):
        box = frames.box
        reach = min(box.reach, FARTHEST)
        bins = max(int((reach - 1) / BIN + 1e-9), 1)
        self.edges = 1 + np.arange(bins + 1) * BIN if reach - 1 >= BIN else np.array([1, reach])
        self.contact = contact_width(frames, reach)
        # How far below 1 a distance can lie because a file stores 24 bits of the places.
        self._rounding = 4 * float(np.spacing(np.float32(box.sides.max())))
        self._centres = (self.edges[1:] + self.edges[:-1]) / 2
        self._rows, self._shares, self._contacts = [], [], []
        self._sectors = np.zeros((SECTORS, len(self.edges) - 1)) if frames.shear_rate else None
        self._shell = shell_volume(frames.dimension, self.edges)

    def add(self, frame):
        """Counts the pairs of a snapshot."""
        if frame.spheres < 2:
            return
        row, contact = np.zeros(len(self._shell)), 0.0
        weight = self._contact_weight(frame)
        reach = self.edges[-1] if frame.is_in_detail else 1 + self.contact
        density = (frame.spheres - 1) / frame.box.volume * frame.spheres
        for i, j, distance in frame.box.neighbours(frame.positions, reach):
            touching = (distance < 1) & (distance > 1 - self._rounding)
            distance[touching] = 1
            contact += np.sum(weight(distance))
            if frame.is_in_detail:
                row += self._counts(distance)
                self._count_sectors(frame, i, j, distance, density)
        self._contacts.append(contact / density)
        if frame.is_in_detail:
            self._rows.append(row / (density * self._shell))
            self._shares.append(frame.box.share_inside(frame.positions, self._centres))

    def result(self):
        """radial_distribution, radial_distribution_by_direction and contact_value."""
        centres = g = errors = np.empty(0)
        if self._rows:
            centres, share = self._centres, np.mean(self._shares, axis=0)
            with np.errstate(invalid="ignore", divide="ignore"):
                g = np.mean(self._rows, axis=0) / share
                errors = errors_of_means(self._rows) / share
        by_direction = None
        if self._sectors is not None and self._rows:
            share = self._shell * len(self._rows) / SECTORS
            by_direction = {"angle": (np.arange(SECTORS) + 0.5) * pi / SECTORS, "r": centres,
                            "g": self._sectors / share}
        return {"radial_distribution": {"r": centres, "g": g, "standard_error": errors},
                "radial_distribution_by_direction": by_direction,
                "contact_value": measured(self._contacts)}

    def _counts(self, distance):
        return np.histogram(distance, len(self.edges) - 1, (1, self.edges[-1]))[0]

    def _contact_weight(self, frame):
        """What each pair adds to the contact value, from its distance; 0 beyond the contact."""
        radii = np.linspace(1, 1 + self.contact, 9)
        share = frame.box.share_inside(frame.positions, radii)
        if not share.all():  # walls so near that no pair can be there
            return lambda distance: np.full(len(distance), np.nan)

        def weight(distance):
            near = distance[(distance >= 1) & (distance <= 1 + self.contact)]
            shell = surface(frame.dimension, near) * self.contact * np.interp(near, radii, share)
            return end_weight((near - 1) / self.contact) / shell
        return weight

    def _count_sectors(self, frame, i, j, distance, density):
        if self._sectors is None:
            return
        arrows = frame.box.nearest(frame.positions[j] - frame.positions[i])
        angle = np.arctan2(arrows[:, 1], arrows[:, 0]) % pi
        sector = np.minimum((angle * SECTORS / pi).astype(int), SECTORS - 1)
        for number in range(SECTORS):
            self._sectors[number] += self._counts(distance[sector == number]) / density


def contact_width(frames, reach):
    """Over which distance from contact g(r) is taken for a cubic, diameters.

    It falls there as exp(-(Z - 1) (r - 1)) or so; the width is 0.7 / (Z - 1) of elastic spheres at
    this density, where a cubic is right to some 1e-4.
    """
    dimension = frames.dimension
    spheres = frames.spheres * surface(dimension, 0.5) / (2 * dimension)  # their volume
    return float(min(contact_range(dimension, spheres / np.prod(frames.box.sides)), WIDEST_CONTACT,
                     reach - 1))


def contact_range(dimension, fraction):
    """0.7 / (Z - 1) of elastic spheres at this solids volume fraction."""
    fraction = min(fraction, 0.99)
    return 0.7 / (2 ** (dimension - 1) * fraction * contact_value(dimension, fraction))
