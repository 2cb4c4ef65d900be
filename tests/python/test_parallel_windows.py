"""bench/parallel_windows.py on logs so short that the speed-ups can be worked out by hand."""

import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))

import parallel_windows as study  # noqa: E402


def log_of(pairs, owner):
    """A Log of these pairs on two cores; owner[sphere] is its core."""
    spheres = np.array(pairs)
    return study.Log(spheres, np.array(owner)[spheres], 2)


def test_cores_without_a_border_between_them_halve_the_time():
    log = log_of([(0, 1), (2, 3), (0, 1), (2, 3)], [0, 0, 1, 1])
    assert study.whole_windows(log, 4, exchange=0) == (2, 0)
    assert study.in_step(log, exchange=0) == (2, 0)
    assert study.undo(log, 4, exchange=0) == (2, 0)


def test_a_window_with_a_collision_across_a_border_is_done_again_on_one_core():
    # 1-2 crosses and counts on both cores: 3 + 2 on the busier one, then 4 again.
    log = log_of([(0, 1), (1, 2), (0, 1), (2, 3)], [0, 0, 1, 1])
    speed, thrown = study.whole_windows(log, 4, exchange=1)
    assert thrown == 1
    assert speed == pytest.approx(4 / (3 + 1 + 4))


def test_in_step_the_core_that_comes_first_waits():
    # Core 0 does two, core 1 none; both do 1-2 at 3 + 1; core 1 does one more.
    log = log_of([(0, 1), (0, 1), (1, 2), (2, 3)], [0, 0, 1, 1])
    speed, unforeseen = study.in_step(log, exchange=1)
    assert speed == pytest.approx(4 / 5)
    assert unforeseen == 1  # 1 has collided since the start


def test_a_crossing_of_spheres_that_have_not_collided_before_is_foreseen():
    log = log_of([(0, 1), (4, 2), (0, 1), (4, 2), (2, 3), (4, 2)], [0, 0, 1, 1, 0])
    # the first 4-2 is foreseen, the second too; the third comes after 2-3
    assert study.in_step(log, exchange=0)[1] == pytest.approx(1 / 3)


def test_undone_is_what_depends_on_a_crossing_and_nothing_else():
    pairs = [(1, 2), (5, 6), (0, 1), (0, 7), (5, 6)]
    assert study.chains(pairs, [True, False, False, False, False]) == 3
    assert study.undone(pairs, [True, False, False, False, False]) == 3
    # 1-2 comes after 0-1 now: unforeseen, and its chain of one counts twice
    assert study.undone([(0, 1), (1, 2), (5, 6)], [False, True, False]) == 2


def test_blocks_are_numbered_along_z_first():
    places = np.array([[0.1, 0.1, 0.1], [0.1, 0.1, 7.9], [0.1, 4.1, 0.1], [7.9, 7.9, 8.0]])
    assert list(study.block_numbers(places, np.full(3, 8.0), (1, 2, 2))) == [0, 1, 2, 3]


def test_owners_are_those_of_the_last_snapshot(tmp_path):
    with h5py.File(tmp_path / "out.h5", "w") as file:
        file["collisions/k"] = [1, 2, 3]
        file["collisions/i"] = [0, 0, 0]
        file["collisions/j"] = [1, 1, 1]
        file["particles/spheres/position/step"] = [0, 2, 3]
        low, high = [1.0, 1.0, 1.0], [1.0, 1.0, 6.0]
        file["particles/spheres/position/value"] = [[low, high], [high, high], [low, low]]
        file["particles/spheres/box/edges/value"] = np.tile(np.eye(3) * 8, (3, 1, 1))
    log = study.read_log(tmp_path / "out.h5", (1, 1, 2))
    assert log.owners.tolist() == [[0, 1], [0, 1], [1, 1]]
