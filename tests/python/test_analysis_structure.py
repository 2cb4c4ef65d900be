"""g(r) and S(k) of placements for which both are known."""

import numpy as np
import pytest
from placements import (FCC, SIMPLE_CUBIC, Given, independent_places, lattice, result_of,
                        rods_in_equilibrium)

from zenosphere.analysis.contacts import Contacts, FreePath
from zenosphere.analysis.periodic_box import PeriodicBox
from zenosphere.analysis.radial import DEGREE, RadialDistribution, end_weight, shell_volume
from zenosphere.analysis.structure import StructureFactor
from zenosphere.analysis.waves import Waves

SLID_PLANE = [[12, 0], [5, 12]]


def within_errors(value, error, expected, count=1):
    """Whether a value lies within 5 standard errors, of which there are `count`."""
    return np.all(np.abs(value - expected) < 5 * error) and np.size(error) == count


def test_weight_of_the_end_takes_every_cubic_to_its_value_there():
    place = (np.arange(20000) + 0.5) / 20000
    for power in range(DEGREE + 1):
        assert np.mean(end_weight(place) * place**power) == pytest.approx(power == 0, abs=1e-6)


@pytest.mark.parametrize("edges, walls", [
    (np.diag([9.0, 9, 9]), None), (SLID_PLANE, None), ([[60.0]], None)])
def test_independent_places_have_g_and_s_of_one(edges, walls):
    frames = Given(independent_places(40, 60, np.diagonal(edges)), edges, walls=walls)
    found = result_of(RadialDistribution, frames) | result_of(StructureFactor, frames)
    radial, waves = found["radial_distribution"], found["structure_factor"]
    for curve, name in ((radial, "g"), (waves, "s")):
        known = np.isfinite(curve["standard_error"])
        assert known.sum() > 10
        assert within_errors(curve[name][known], curve["standard_error"][known], 1, known.sum())
    contact = found["contact_value"]
    assert within_errors(contact["value"], contact["standard_error"], 1)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_independent_places_between_walls_have_g_of_one(dimension):
    sides = np.array([8.0, 8.0, 4.0])[-dimension:]
    places = independent_places(40, 60, sides - np.eye(dimension)[-1])
    frames = Given([each + np.eye(dimension)[-1] / 2 for each in places], np.diag(sides),
                   walls=dimension - 1)
    curve = result_of(RadialDistribution, frames)["radial_distribution"]
    known = np.isfinite(curve["standard_error"])
    assert known.sum() > 10
    assert within_errors(curve["g"][known], curve["standard_error"][known], 1, known.sum())


def test_rods_have_their_exact_contact_value_and_compressibility():
    """Tonks: g(1) = 1 / (1 - phi) and S(0) = (1 - phi)^2, 2 and 1/4 at phi = 1/2."""
    places, length = rods_in_equilibrium(400, 800, 0.5)
    frames = Given(places, [[length]], in_detail=2)
    contact = result_of(RadialDistribution, frames)["contact_value"]
    assert within_errors(contact["value"], contact["standard_error"], 2)
    assert contact["standard_error"] < 0.04
    limit = result_of(StructureFactor, frames)["structure_factor"]["at_zero"]
    assert within_errors(limit["value"], limit["standard_error"], 0.25)
    assert limit["standard_error"] < 0.01


def test_fcc_lattice_has_its_neighbours_at_their_distances():
    """12 at the spacing / sqrt(2), 6 at the spacing; nothing between."""
    spacing, cells = 1.61, 4
    frames = Given([lattice(cells, spacing, FCC)], spacing * cells * np.eye(3))
    curve = result_of(RadialDistribution, frames)["radial_distribution"]
    number = curve["g"] * (4 * cells**3 - 1) / (spacing * cells) ** 3
    edges = 1 + 0.02 * np.arange(len(curve["r"]) + 1)
    held = {round(r, 2): neighbours for r, neighbours in
            zip(curve["r"], number * shell_volume(3, edges)) if neighbours > 0 and r < 1.9}
    assert held == {1.13: pytest.approx(12), 1.61: pytest.approx(6)}  # 1.138; 1.61


def test_lattice_scatters_at_its_reciprocal_vectors_and_nowhere_else():
    places, edges = lattice(5, 1.2, SIMPLE_CUBIC) + 0.3, 6.0 * np.eye(3)
    waves = Waves(PeriodicBox(edges), k=6.5, limit=np.inf)  # 6 wavelengths along each side
    power = waves.power(places, edges)
    peaks = power > 1e-9
    assert power[peaks] == pytest.approx(125)
    lengths = np.unique(np.round(waves.lengths(edges)[peaks] * 1.2 / (2 * np.pi), 9) ** 2)
    assert lengths == pytest.approx([1, 2, 3])
    assert waves.weight[peaks].sum() == 6 + 12 + 8


def test_waves_of_a_slid_box_follow_its_slanted_edge():
    """A lattice in the slanted cell, each place moved along x into the upright box."""
    edges = np.array([[6.0, 0, 0], [2.5, 6, 0], [0, 0, 6]])
    places = lattice(5, 0.2, SIMPLE_CUBIC) @ edges
    places[:, 0] %= 6
    waves = Waves(PeriodicBox(edges), k=5.5, limit=np.inf)
    power = waves.power(places, edges)
    assert np.sum(waves.weight[power > 1e-9]) == 26 and power.max() == pytest.approx(125)


def test_wave_numbers_of_a_slid_box_are_those_of_its_reciprocal_vectors():
    """In units of 2 pi / 6: (n0, n1 - n0 / 2) for the offset 3 of a square of side 6."""
    edges = np.array([[6.0, 0], [3, 6]])
    waves = Waves(PeriodicBox(edges), k=1.2, limit=np.inf)
    expected = np.sqrt([1, 1.25, 1.25, 1.25, 3.25])
    assert np.sort(waves.lengths(edges)) * 6 / (2 * np.pi) == pytest.approx(expected)


@pytest.mark.parametrize("edges, walls", [
    ([[6.0, 0, 0], [2.5, 7, 0], [0, 0, 5]], None), (SLID_PLANE, None), ([[60.0]], None),
    (np.diag([6.0, 7, 5]), 2), (np.diag([6.0, 7]), 0)])
def test_waves_by_mesh_are_the_exact_ones(edges, walls):
    box = PeriodicBox(edges, walls)
    [places] = independent_places(1, 50, box.sides)
    waves = Waves(box, k=9, limit=np.inf)
    exact, meshed = (power(places, box.edges) for power in (waves.power, waves.power_by_mesh))
    assert meshed == pytest.approx(exact, abs=0.01 * exact.max())
    long = Waves(box, k=4.5, limit=np.inf)
    inner = (np.abs(waves._numbers[waves._is_wave]) <= long.largest).all(axis=1)
    assert inner.sum() == len(long.weight)
    assert meshed[inner] == pytest.approx(long.power(places, box.edges), rel=1e-4, abs=1e-4)
    if walls is not None:
        assert waves.largest[walls] == 0


def test_spheres_spread_on_a_mesh_in_parts_give_the_same_waves(monkeypatch):
    from zenosphere.analysis import waves as module
    box = PeriodicBox(SLID_PLANE)
    [places] = independent_places(1, 50, box.sides)
    waves = Waves(box, k=3, limit=np.inf)
    whole = waves.power_by_mesh(places, box.edges)
    monkeypatch.setattr(module, "SPHERES_AT_ONCE", 7)
    assert waves.power_by_mesh(places, box.edges) == pytest.approx(whole)


def test_large_system_has_fewer_waves_and_each_has_some():
    box = PeriodicBox(100.0 * np.eye(3))
    assert Waves(box, 1.5, 10**6).largest.tolist() == [23] * 3
    few = Waves(box, 15, 1000)
    assert len(few.weight) <= 1000 and (few.largest >= 1).all()
    assert Waves(box, 15, 1).largest.tolist() == [1] * 3


def test_box_of_the_longest_sides_has_some_waves():
    box = PeriodicBox(np.eye(3) * 1e9)  # the longest that a case may have
    waves = Waves(box, 15, 1000)
    assert (waves.largest >= 1).all()
    assert len(waves.weight) <= 1000


def test_pairs_along_one_direction_are_found_in_its_sector():
    """Dimers at 50 degrees; each of 12 sectors has 15."""
    random = np.random.default_rng(1)
    arrow = 1.05 * np.array([np.cos(np.radians(50)), np.sin(np.radians(50))])
    places = []
    for _ in range(20):
        ends = random.random((20, 2)) * 30
        places.append(np.concatenate((ends, ends + arrow)) % 30)
    found = result_of(RadialDistribution, Given(places, 30 * np.eye(2), shear_rate=1.0))
    curve = found["radial_distribution_by_direction"]
    first = curve["g"][:, 2]  # r from 1.04 to 1.06
    assert np.degrees(curve["angle"][first.argmax()]) == pytest.approx(52.5)
    assert first.max() > 10 * np.sort(first)[-2]


def test_sectors_together_are_the_radial_distribution():
    frames = Given(independent_places(20, 60, (12, 12)), SLID_PLANE, shear_rate=1.0)
    found = result_of(RadialDistribution, frames)
    assert found["radial_distribution_by_direction"]["g"].mean(axis=0) == pytest.approx(
        found["radial_distribution"]["g"])


def test_contact_that_24_bits_have_rounded_to_an_overlap_counts_in_the_first_bin():
    frames = Given([np.array([[1.0], [2.0 - 1e-7]])], [[9.0]])
    assert result_of(RadialDistribution, frames)["radial_distribution"]["g"][0] > 0


def test_one_sphere_has_no_structure():
    found = result_of(RadialDistribution, Given([np.ones((1, 2))], 5 * np.eye(2)))
    assert found["radial_distribution"]["g"].size == 0
    assert found["contact_value"] == {"value": None, "standard_error": None}


def test_touching_spheres_form_clusters():
    """A chain of three across a face, a pair, and one alone: 2 x 3 contacts of 6 spheres."""
    places = np.array([[9.5], [0.5], [1.505], [4.0], [5.0], [7.0]])
    touching = result_of(Contacts, Given([places], [[10.0]]))["touching"]
    assert touching["coordination"] == 1.0
    assert touching["share"].tolist() == [1 / 6, 4 / 6, 1 / 6]
    assert (touching["clusters"], touching["largest_cluster"]) == (2, 3)
    assert touching["share_in_clusters"] == pytest.approx(5 / 6)


def test_mean_free_path_is_the_mean_speed_over_the_collision_rate():
    velocities = [np.array([[3.0, 4], [0, 1]])]
    frames = Given([np.ones((2, 2))], 9 * np.eye(2), velocities, collision_rate=6.0)
    assert result_of(FreePath, frames)["mean_free_path"]["value"] == pytest.approx(0.5)
    frames.collision_rate = 0.0
    assert result_of(FreePath, frames)["mean_free_path"]["value"] is None
