"""Kinetic theory of the simple shear flow against what is known of it."""

import numpy as np
import pytest
from zenosphere.errors import InputError
from zenosphere.rheology.anisotropic import _Collisions, anisotropic_flow
from zenosphere.rheology.flow import contact_value, number_density
from zenosphere.rheology.navier_stokes import cooling_rate, navier_stokes_flow, shear_viscosity


def test_viscosity_of_elastic_spheres_is_that_of_enskog():
    # 5/16 sqrt(T/pi) [1/g + 0.8 bn + 0.7614 g (bn)^2], bn = 4 phi, in the first approximation:
    # there the last factor is 0.16 + 48/(25 pi).
    for fraction in (0.1, 0.3, 0.45):
        g, volume = contact_value(fraction), 4 * fraction
        enskog = 5 / 16 / np.sqrt(np.pi) * (
            1 / g + 0.8 * volume + (0.16 + 48 / (25 * np.pi)) * g * volume**2)
        assert shear_viscosity(1.0, fraction) == pytest.approx(enskog, rel=1e-12)


def test_cooling_rate_is_that_of_haff():
    # (1 - e^2)/3 x collisions per sphere and time x (1 + 3 a2/16), a2 = -0.01463 at e = 0.9
    fraction, a2 = 0.3, 16 * 0.1 * (1 - 1.62) / (81 - 15.3 + 24.3 * 0.1)
    rate = 4 * number_density(fraction) * contact_value(fraction) * np.sqrt(np.pi)
    assert cooling_rate(0.9, fraction) == pytest.approx(0.19 / 3 * rate * (1 + 3 * a2 / 16))


@pytest.mark.parametrize("fraction", (0.1, 0.3, 0.45))
def test_both_theories_meet_for_nearly_elastic_spheres(fraction):
    whole, expanded = anisotropic_flow(0.9999, fraction), navier_stokes_flow(0.9999, fraction)
    for name in ("granular_temperature", "pressure", "shear_stress", "collision_rate"):
        assert getattr(whole, name) == pytest.approx(getattr(expanded, name), rel=3e-4), name
    assert abs(whole.n1) < 2e-4 and abs(whole.n2) < 2e-4 and abs(whole.sonine_a2) < 1e-4


def test_collisions_change_the_energy_by_the_work_of_contacts_less_what_they_lose():
    # For any second moment. Contacts hand momentum over to where the flow is faster: their part of
    # the shear stress works. Lost for each: (1 - e^2)/4 g^2, n omega/2 of them a volume and time.
    e = 0.7
    collisions, second = _Collisions(e, 0.2), np.diag([1.3, 0.9, 0.8])
    _, (_, square, cube) = collisions._closing_speeds(second)
    pairs = collisions.density**2 / 2 * collisions.contact * collisions.weights
    transfer = pairs * (1 + e) / 2 * square
    work = -np.sum(transfer * collisions.normals[:, 0] * collisions.normals[:, 1])
    loss = np.sum(pairs * cube) * (1 - e**2) / 4
    change = np.trace(collisions.change(second)) * collisions.density / 2
    assert change == pytest.approx(work - loss, rel=1e-10)
    assert work > 0.05 * loss


# Sheared spheres of phi = 0.3, N = 4000: simulations of this program and of a separate one
# (docs/results-shear.md); the theory leaves out correlations and is good to some per cent.
@pytest.mark.parametrize("restitution, temperature, pressure, stress", [
    (0.9, 1.139, 2.561, 0.714), (0.8, 0.5171, 1.1429, 0.4407)])
def test_anisotropic_theory_is_near_simulations(restitution, temperature, pressure, stress):
    flow = anisotropic_flow(restitution, 0.3)
    assert flow.granular_temperature == pytest.approx(temperature, rel=0.025)
    assert flow.pressure == pytest.approx(pressure, rel=0.025)
    assert flow.shear_stress == pytest.approx(stress, rel=0.025)
    assert navier_stokes_flow(restitution, 0.3).granular_temperature > 1.05 * temperature


def test_signs_of_normal_stress_differences():
    dilute, dense = anisotropic_flow(0.8, 0.01), anisotropic_flow(0.8, 0.45)
    assert dilute.n1 > 0.25 and -0.05 < dilute.n2 < 0
    assert 0 < dense.n1 < dense.n2  # the collisional part goes against the kinetic one


def test_elastic_spheres_have_no_steady_shear_flow():
    with pytest.raises(InputError, match="restitution = 1.0"):
        anisotropic_flow(1.0, 0.3)
