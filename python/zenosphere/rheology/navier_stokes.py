"""Simple shear with the transport coefficients of Navier-Stokes order."""

import numpy as np

from .flow import ShearFlow, contact_value, number_density


def navier_stokes_flow(restitution, fraction):
    """The shear flow in which viscous heating makes up for the cooling rate.

    restitution: below 1;  fraction: of solids, by volume
    Viscosity and cooling rate from the Enskog equation, first Sonine approximation, to first order
    in the gradients: for nearly elastic spheres. To that order the normal stresses are equal.
    Source: Garzo & Dufty, Phys. Rev. E 59 (1999) 5895.
    """
    density, contact = number_density(fraction), contact_value(fraction)
    viscosity, cooling = shear_viscosity(restitution, fraction), cooling_rate(restitution, fraction)
    temperature = viscosity / (1.5 * density * cooling)  # both go with the root of T
    return ShearFlow(
        granular_temperature=temperature,
        pressure=density * temperature * (1 + 2 * (1 + restitution) * fraction * contact),
        shear_stress=viscosity * np.sqrt(temperature), n1=0.0, n2=0.0, sonine_a2=np.nan,
        collision_rate=4 * density * contact * np.sqrt(np.pi * temperature))


def shear_viscosity(restitution, fraction):
    """Over the root of the granular temperature."""
    e, contact, cumulant = restitution, contact_value(fraction), _cumulant(restitution)
    dense = fraction * contact * (1 + e)
    rate = contact * (1 - (1 - e) ** 2 / 4) * (1 - cumulant / 64)
    kinetic = (1 - 0.4 * dense * (1 - 3 * e)) / (rate - _reduced_cooling(e, contact) / 2)
    bulk = 128 / (5 * np.pi) * fraction * dense * (1 - cumulant / 32)
    return _dilute_viscosity() * (kinetic * (1 + 0.8 * dense) + 0.6 * bulk)


def cooling_rate(restitution, fraction):
    """Relative loss of granular temperature per time, over the root of it."""
    return (_reduced_cooling(restitution, contact_value(fraction)) * number_density(fraction)
            / _dilute_viscosity())


def _dilute_viscosity():
    return 5 / (16 * np.sqrt(np.pi))


def _reduced_cooling(e, contact):
    return 5 / 12 * contact * (1 - e**2) * (1 + 3 / 32 * _cumulant(e))


def _cumulant(e):
    """Twice the Sonine coefficient a2 of a cooling gas."""
    return 32 * (1 - e) * (1 - 2 * e**2) / (81 - 17 * e + 30 * e**2 * (1 - e))
