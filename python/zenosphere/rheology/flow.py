"""What theory and simulation say about a steady simple shear flow, in one form."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class ShearFlow:
    """Averages of a steady simple shear flow, u_x = y; shear rate = diameter = mass = 1.

    What a theory does not tell is nan.
    """

    granular_temperature: float
    pressure: float
    shear_stress: float  # -P_xy
    n1: float  # (P_xx - P_yy) / pressure
    n2: float  # (P_yy - P_zz) / pressure
    sonine_a2: float
    collision_rate: float  # per sphere


def number_density(fraction):
    """Spheres per volume, of a solids volume fraction."""
    return 6 * fraction / np.pi


def contact_value(fraction):
    """Radial distribution function at contact of elastic hard spheres.

    Source: Carnahan & Starling, J. Chem. Phys. 51 (1969) 635.
    """
    return (1 - fraction / 2) / (1 - fraction) ** 3
