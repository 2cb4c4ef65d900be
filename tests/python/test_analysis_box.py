"""Which spheres are near each other, across periodic, sliding and hard faces."""

import itertools

import numpy as np
import pytest
from placements import independent_places

from zenosphere.analysis.periodic_box import PeriodicBox

CUBE = np.diag([7.0, 6.0, 8.0])


def slid(edges, offset):
    edges = np.array(edges)
    edges[1, 0] = offset
    return edges


def pairs_one_by_one(positions, box, reach):
    """Arrows of all pairs of spheres and images, by trying every image of each."""
    along = [(-2, -1, 0, 1, 2) if axis in box.periodic else (0,) for axis in range(box.dimension)]
    found = {}
    for turns in itertools.product(*along):  # two along x: a slid image can lie beside
        arrows = positions[None] - positions[:, None] + np.array(turns) @ box.edges
        for i, j in zip(*np.nonzero(np.linalg.norm(arrows, axis=2) <= reach)):
            if i != j:
                found[i, j] = tuple(np.round(arrows[i, j], 9))
    return found


def pairs_found(positions, box, reach):
    found = {}
    for i, j, distance in box.neighbours(positions, reach):
        arrows = box.nearest(positions[j] - positions[i])
        assert distance == pytest.approx(np.linalg.norm(arrows, axis=1))
        found |= dict(zip(zip(i.tolist(), j.tolist()), map(tuple, np.round(arrows, 9))))
    return found


@pytest.mark.parametrize("edges, walls", [
    (CUBE, None), (slid(CUBE, 2.5), None), (slid(CUBE, -3.1), None), (CUBE, 1), (CUBE, 0),
    (CUBE[:2, :2], None), (slid(CUBE[:2, :2], 2.5), None), (CUBE[:2, :2], 0), ([[9.0]], None),
    ([[9.0]], 0)])
def test_neighbours_are_those_of_a_search_through_all_images(edges, walls):
    box = PeriodicBox(edges, walls)
    [positions] = independent_places(1, 40, box.sides)
    reach = min(box.reach, 3.0)
    expected = pairs_one_by_one(positions, box, reach)
    assert len(expected) > 20
    assert pairs_found(positions, box, reach) == expected


def test_image_across_the_sliding_face_is_shifted_by_the_offset():
    """The image of (1, 0.6) above lies at (1 + 3, 10.6), straight over (4, 9.8)."""
    box = PeriodicBox([[10, 0], [3, 10]])
    pairs = pairs_found(np.array([[4, 9.8], [1, 0.6]]), box, 1.0)
    assert pairs == {(0, 1): (0, pytest.approx(0.8)), (1, 0): (0, pytest.approx(-0.8))}


def test_parts_of_a_large_system_give_the_same_pairs(monkeypatch):
    from zenosphere.analysis import periodic_box
    box = PeriodicBox(slid(CUBE, 1.5))
    [positions] = independent_places(1, 60, box.sides)
    whole = pairs_found(positions, box, 2.0)
    monkeypatch.setattr(periodic_box, "PAIRS_AT_ONCE", 100)
    assert pairs_found(positions, box, 2.0) == whole


def test_position_that_rounding_put_on_the_upper_face_is_taken():
    box = PeriodicBox([[5.0]])
    assert set(pairs_found(np.array([[5.0], [0.5], [-1e-17]]), box, 1.0)) == {
        (0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)}


@pytest.mark.parametrize("dimension, expected", [
    # Of the centres at the distance 1 from one 0.25 above the lowest centre: heights from -0.25 up.
    (3, (0.25 + 1) / 2), (2, 1 - np.arccos(0.25) / np.pi), (1, 0.5)])
def test_walls_leave_a_part_of_the_surface_around_a_sphere(dimension, expected):
    box = PeriodicBox(9 * np.eye(dimension), walls=dimension - 1)
    beside, middle = np.full((1, dimension), 0.75), np.full((1, dimension), 4.5)
    assert box.share_inside(beside, [1.0, 0.1]) == pytest.approx([expected, 1])
    assert box.share_inside(np.concatenate((beside, middle)), [1.0]) == pytest.approx(
        [(expected + 1) / 2])
    assert box.volume == 9 ** (dimension - 1) * 8
