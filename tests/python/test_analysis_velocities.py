"""Velocity distributions, profiles and stresses whose numbers are known."""

import numpy as np
import pytest
from placements import Given, independent_places, result_of

from zenosphere.analysis.frames import AXES
from zenosphere.analysis.profiles import Profiles
from zenosphere.analysis.stress import stresses
from zenosphere.analysis.velocities import Velocities


def maxwell_velocities(snapshots, spheres, dimension, temperatures=1.0, seed=1):
    """Gaussian velocities relative to their mean, a list of (N, D)."""
    random = np.random.default_rng(seed)
    roots = np.sqrt(np.broadcast_to(temperatures, spheres))[:, None]
    drawn = (random.standard_normal((spheres, dimension)) * roots for _ in range(snapshots))
    return [velocities - velocities.mean(axis=0) for velocities in drawn]


def moving(velocities, side=9.0):
    """Snapshots with these velocities."""
    dimension = velocities[0].shape[1]
    return Given([np.ones_like(velocities[0])] * len(velocities), side * np.eye(dimension),
                 velocities)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_maxwellian_has_no_cumulants_however_few_the_spheres(dimension):
    """Without what makes the moments unbiased, a2 of 10 spheres would be -2 / (9 D + 2)."""
    found = result_of(Velocities, moving(maxwell_velocities(2000, 10, dimension)))["sonine"]
    for name in ("a2", "a3"):
        assert abs(found[name]) < 5 * found[f"{name}_standard_error"]
    assert found["a2_standard_error"] < 0.4 / (9 * dimension + 2)


def test_mixture_of_two_temperatures_has_known_cumulants():
    """T = 4 of one quarter, 1 of the rest: <T> = 1.75, <T^2> = 4.75, <T^3> = 16.75.

    a2 = <T^2> / <T>^2 - 1, a3 = 1 + 3 a2 - <T^3> / <T>^3.
    """
    temperatures = np.repeat([4.0, 1.0], [1000, 3000])
    found = result_of(Velocities, moving(maxwell_velocities(100, 4000, 3, temperatures)))["sonine"]
    a2 = 4.75 / 1.75**2 - 1
    a3 = 1 + 3 * a2 - 16.75 / 1.75**3
    assert found["a2"] == pytest.approx(a2, abs=5 * found["a2_standard_error"])
    assert found["a3"] == pytest.approx(a3, abs=5 * found["a3_standard_error"])
    assert found["a2_standard_error"] < 0.01 and found["a3_standard_error"] < 0.03


def test_distributions_are_normalised_and_gaussian():
    velocities = maxwell_velocities(20, 2000, 2, temperatures=9.0)
    found = result_of(Velocities, moving(velocities))
    curve = found["velocity_distribution"]
    for kind, count in (("component", 80_000), ("speed", 40_000)):
        density, maxwell = curve[f"{kind}_density"], curve[f"{kind}_maxwell"]
        assert density.sum() * 0.1 == pytest.approx(1)
        noise = np.sqrt(np.maximum(maxwell, 1e-4) / (0.1 * count))
        assert (np.abs(density - maxwell) < 5 * noise + 3e-4).all()  # and the curve in a bin
    assert found["granular_temperature"]["value"] == pytest.approx(9, rel=0.03)


def test_spheres_at_rest_have_no_distribution():
    found = result_of(Velocities, moving([np.zeros((5, 2))]))
    assert found["sonine"]["a2"] is None and found["granular_temperature"]["value"] == 0


def test_profile_of_a_sheared_box_is_that_of_the_shear():
    """Imposed: 2 (y - 5); hot spheres in the upper half."""
    places = independent_places(40, 1000, (10.0, 10.0))
    random = np.random.default_rng(2)
    velocities = [random.standard_normal((1000, 2)) * np.where(each[:, 1:] > 5, 2, 1)
                  for each in places]
    frames = Given(places, 10 * np.eye(2), velocities, shear_rate=2.0)
    curve = result_of(Profiles, frames)["profiles"]
    assert curve["axis"] == "y" and curve["y"] == pytest.approx(np.arange(10) + 0.5)
    assert curve["velocity"] == pytest.approx(2 * (curve["y"] - 5), abs=0.15)  # 5 x 2 / sqrt(4000)
    assert curve["granular_temperature"] == pytest.approx([1] * 5 + [4] * 5, rel=0.08)
    assert curve["solids_volume_fraction"] == pytest.approx(10 * np.pi / 4, rel=0.08)
    # 40 snapshots of about 100 disks a layer, of which each has two components.
    for name, error in (("solids_volume_fraction", 0.1 / np.sqrt(40) * 10 * np.pi / 4),
                        ("velocity", np.repeat([1, 2], 5) / np.sqrt(4000)),
                        ("granular_temperature", np.repeat([1, 4], 5) / np.sqrt(4000))):
        ratio = curve[f"{name}_standard_error"] / error
        assert np.nanmean(ratio) == pytest.approx(1, rel=0.25)


def test_profile_between_walls_runs_along_their_normal():
    """10 spheres in the lower half of a column, moving up together: their temperature is 0."""
    places = np.full((10, 3), 2.0)
    places[:, 2] = np.linspace(0.6, 1.9, 10)
    velocities = np.tile([0.5, 0, 1], (10, 1))
    curve = result_of(Profiles, Given([places], np.diag([4.0, 4, 4]), [velocities], walls=2))
    curve = curve["profiles"]
    assert curve["axis"] == AXES[2] and len(curve["y"]) == 8
    held = curve["solids_volume_fraction"] > 0
    assert held.tolist() == [False, True, True, True] + [False] * 4
    assert curve["solids_volume_fraction"].sum() * 8 == pytest.approx(10 * np.pi / 6)
    assert curve["mean_velocity"][held] == pytest.approx(np.tile([0.5, 0, 1], (3, 1)))
    assert curve["granular_temperature"][held] == pytest.approx(0, abs=1e-15)
    assert np.isnan(curve["velocity"][~held]).all()


TENSOR = [[3.0, -0.8, 0], [-0.6, 2.0, 0], [0, 0, 1.5]]


def test_stresses_are_those_of_the_averages():
    found = stresses({"averages": {"pressure_tensor": TENSOR, "pressure": 2.0}}, 0.5)
    assert found["shear_viscosity"] == {"value": pytest.approx(1.4), "standard_error": None}
    assert found["normal_stress_differences"] == {
        "n1": 0.5, "n2": 0.25, "n1_standard_error": None, "n2_standard_error": None}


def test_errors_of_stresses_are_those_of_the_file():
    errors = {"pressure_tensor": [[0.3, 0.1, 0], [0.1, 0.4, 0], [0, 0, 0.3]]}
    averages = {"pressure_tensor": TENSOR, "pressure": 2.0, "standard_error": errors}
    found = stresses({"averages": averages}, 0.5)
    assert found["shear_viscosity"]["standard_error"] == 0.2
    assert found["normal_stress_differences"]["n1_standard_error"] == pytest.approx(0.25)


def test_disks_have_one_difference():
    averages = {"pressure_tensor": [[3.0, -1], [-1, 2.0]], "pressure": 2.5}
    found = stresses({"averages": averages}, 1.0)["normal_stress_differences"]
    assert found["n1"] == 0.4 and found["n2"] is None


@pytest.mark.parametrize("summary, rate", [({}, 1.0), ({"averages": {"pressure": None}}, 1.0), (
    {"averages": {"pressure": 1.0, "pressure_tensor": TENSOR}}, 0.0)])
def test_stresses_are_unknown_without_averages_or_shear(summary, rate):
    found = stresses(summary, rate)
    assert found["shear_viscosity"]["value"] is None
    assert set(found["normal_stress_differences"].values()) == {None}


def test_errors_of_normal_stress_differences_are_those_of_the_file():
    averages = {"pressure_tensor": TENSOR, "pressure": 2.0, "standard_error": {
        "pressure_tensor": [[0.3, 0.1, 0], [0.1, 0.4, 0], [0, 0, 0.3]],
        "normal_stress_differences": [0.01, None]}}
    found = stresses({"averages": averages}, 0.5)["normal_stress_differences"]
    assert found["n1_standard_error"] == 0.01 and found["n2_standard_error"] is None
