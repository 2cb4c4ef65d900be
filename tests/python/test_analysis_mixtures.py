"""What `analyse` measures of spheres that differ, where it is known."""

import numpy as np
import pytest
from placements import Given, independent_places, result_of

import zenosphere
from zenosphere.analysis import tables
from zenosphere.analysis.blocking import measured
from zenosphere.analysis.contacts import Contacts
from zenosphere.analysis.kinds import Kinds
from zenosphere.analysis.partial import PartialDistributions
from zenosphere.analysis.profiles import Profiles
from zenosphere.analysis.velocities import Velocities, VelocitiesOfKinds, ratio_of_means


def two_kinds(small, large, diameter=2.0, mass=8.0, immobile=False):
    """Kinds "a" of unit spheres and "b"."""
    number = small + large
    kind = np.repeat([0, 1], [small, large])
    return Kinds(np.where(kind, diameter, 1.0), np.where(kind, mass, 1.0), kind,
                 np.array([immobile and k == 1 for k in kind]).reshape(number), ("a", "b"))


def is_near(found, expected):
    return abs(found["value"] - expected) < 5 * found["standard_error"]


def test_independent_places_have_partial_distributions_of_one():
    kinds = two_kinds(80, 20)
    found = result_of(PartialDistributions, Given(
        independent_places(60, 100, (20.0, 20, 20)), np.diag([20.0, 20, 20]), kinds=kinds))
    pairs = found["partial_radial_distributions"]
    assert [pair["between"] for pair in pairs] == [["a", "a"], ["a", "b"], ["b", "b"]]
    assert [pair["contact_distance"] for pair in pairs] == [1, 1.5, 2]
    for curve, g in [(pair, pair["g"]) for pair in pairs] + [
            (found["radial_distribution"], found["radial_distribution"]["g"])]:
        known = curve["standard_error"] > 0
        assert known.sum() > 10
        deviation = (g - 1)[known] / curve["standard_error"][known]
        assert abs(deviation.mean()) < 5 / np.sqrt(known.sum())
    assert all(is_near(pair["contact_value"], 1) for pair in pairs)


def test_rods_of_two_lengths_have_their_exact_contact_value():
    """Additive hard rods: g_ab at contact = 1 / (1 - phi) for each two kinds, 2 at phi = 1/2."""
    random, kinds = np.random.default_rng(1), two_kinds(400, 200)
    length = kinds.diameter.sum() * 2
    places = []
    for _ in range(300):
        order = random.permutation(600)
        free = np.sort(random.random(600)) * length / 2
        before = np.cumsum(kinds.diameter[order]) - kinds.diameter[order] / 2
        centres = np.empty((600, 1))
        centres[order, 0] = (free + before + random.random() * length) % length
        places.append(centres)
    found = result_of(PartialDistributions, Given(places, [[length]], kinds=kinds, in_detail=2))
    for pair in found["partial_radial_distributions"]:
        assert is_near(pair["contact_value"], 2)
        assert pair["contact_value"]["standard_error"] < 0.2


def test_distributions_of_continuous_sizes_have_no_contact_distance():
    random = np.random.default_rng(3)
    kinds = Kinds(1 + random.random(60), np.ones(60), np.zeros(60, int), np.zeros(60, bool), ("a",))
    found = result_of(PartialDistributions, Given(
        independent_places(40, 60, (15.0, 15)), np.diag([15.0, 15]), kinds=kinds))
    pair, = found["partial_radial_distributions"]
    assert pair["contact_distance"] is None and is_near(pair["contact_value"], 1)


def test_velocities_count_in_units_of_the_temperature_of_their_kind():
    """Maxwellians of T = 1 and 9 (masses 1 and 8): the mean is (1 x 1 + 3 x 9) / 4 = 7."""
    random, kinds = np.random.default_rng(2), two_kinds(500, 1500)
    spread = np.sqrt(np.where(kinds.kind, 9, 1) / kinds.mass)[:, None]
    velocities = [spread * random.standard_normal((2000, 3)) for _ in range(40)]
    frames = Given([np.zeros((2000, 3))] * 40, np.diag([9.0, 9, 9]), velocities, kinds=kinds)
    found = result_of(Velocities, frames) | result_of(VelocitiesOfKinds, frames)
    assert is_near(found["granular_temperature"], 7)
    assert abs(found["sonine"]["a2"]) < 5 * found["sonine"]["a2_standard_error"]
    assert [each["spheres"] for each in found["species"]] == [500, 1500]
    assert is_near(found["species"][1]["temperature_ratio"], 9)
    for each, temperature in zip(found["species"], (1, 9)):
        assert is_near(each["granular_temperature"], temperature)
        assert is_near(each["sonine"]["a2"], 0)


def test_ratio_of_temperatures_that_rise_and_fall_together_is_known_better_than_either():
    temperature = 1 + 0.1 * np.random.default_rng(1).standard_normal(200)
    ratio = ratio_of_means(3 * temperature, temperature)
    assert ratio["value"] == pytest.approx(3) and ratio["standard_error"] < 1e-12
    assert measured(temperature)["standard_error"] > 0.003


def test_profile_weighs_velocities_by_mass_and_spheres_by_volume():
    """In one layer: u = (1 x 9 - 8 x 1 x 1) / 9 = 1/9; (1 x (9 - u)^2 + 8 (1 + u)^2) / (2 x 2)."""
    kinds = two_kinds(1, 1)
    velocities = np.array([[9.0, 0], [-1.0, 0]])
    frames = Given([np.array([[1.0, 0.5], [3, 0.5]])], np.diag([5.0, 1.0]), [velocities],
                   kinds=kinds)
    found = result_of(Profiles, frames)["profiles"]
    mean = (9 - 8) / 9
    assert found["velocity"] == pytest.approx([mean])
    assert found["granular_temperature"] == pytest.approx(
        [((9 - mean)**2 + 8 * (1 + mean)**2) / 4])
    assert found["solids_volume_fraction"] == pytest.approx([np.pi / 4 * (1 + 4) / 5])
    assert found["species_solids_volume_fraction"]["b"] == pytest.approx([np.pi / 5])


def test_immobile_spheres_have_a_volume_and_no_velocity():
    kinds = two_kinds(2, 1, immobile=True)
    velocities = np.array([[1.0, 0], [-1.0, 0], [50.0, 0]])
    frames = Given([np.array([[1.0, 0.5], [3, 0.5], [4, 0.5]])] * 2, np.diag([6.0, 1.0]),
                   [velocities] * 2, kinds=kinds)
    profile = result_of(Profiles, frames)["profiles"]
    assert profile["granular_temperature"] == pytest.approx([0.5])
    assert profile["species_solids_volume_fraction"]["b"] == pytest.approx([np.pi / 6])
    found = result_of(VelocitiesOfKinds, frames)["species"][1]
    assert found["granular_temperature"]["value"] is None


def test_touching_is_of_surfaces():
    """0-1 touch at 1.5, 1-2 at 2.5 do not; unit spheres at 1.5 would not."""
    kinds = two_kinds(1, 2)
    places = np.array([[0.0], [1.505], [4.005]])
    touching = result_of(Contacts, Given([places], [[20.0]], kinds=kinds))["touching"]
    assert touching["coordination"] == pytest.approx(2 / 3) and touching["largest_cluster"] == 2


def test_analyse_of_a_mixture(tmp_path):
    case = {"system": {"dimension": 3, "spheres": 200, "restitution": 0.9,
                       "solids_volume_fraction": 0.3},
            "species": [{"name": "light", "diameter": 1, "share": 0.5},
                        {"name": "heavy", "diameter": 1.4, "mass": 5, "share": 0.5}],
            "start": {"arrangement": "random", "granular_temperature": 1},
            "drive": {"kind": "shear", "shear_rate": 1}, "run": {"collisions": 5000},
            "output": {"snapshot_interval": 0.05}}
    with zenosphere.Run(case, output=tmp_path / "out.h5") as run:
        run.advance(5000)
        summary = run.summary()
    found = zenosphere.analyse(tmp_path / "out.h5")
    assert [each["name"] for each in found["species"]] == ["light", "heavy"]
    assert found["granular_temperature"]["value"] == pytest.approx(
        summary["averages"]["granular_temperature"], rel=0.1)  # snapshots, and all of the time
    assert found["contact_value"]["value"] is None
    volumes = found["profiles"]["solids_volume_fraction"]
    assert np.mean(volumes) == pytest.approx(0.3)
    text = tables.as_text(found)
    assert "g at contact, light and heavy" in text and "granular temperature of heavy" in text
    assert "radial_distribution_light_heavy" in tables.curves(found)
