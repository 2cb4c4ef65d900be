"""Windows follow the hits and the arrest of the run."""

import numpy as np
import pytest

from zenosphere.figures import windows
from zenosphere.run_file import RunFile


@pytest.fixture
def temporary(written):
    """100 000 collisions, first hit 1234, last hit 5000."""
    gap = np.full(100000, 1e-4)
    gap[[1233, 4999]] = 0
    with RunFile(written(gap=gap)) as run:
        yield run


@pytest.fixture
def arrested(written):
    """1000 collisions, a hit at 100, only hits from 601 on, arrest at 800."""
    gap = np.full(1000, 1e-4)
    gap[99] = gap[600:] = 0
    with RunFile(written(gap=gap, arrest=800, window=200)) as run:
        yield run


def test_early_window_is_three_times_the_first_hit_in_two_digits(temporary):
    assert windows.early(temporary) == (1, 3800)  # 3702


def test_long_window_is_four_times_the_last_hit(temporary):
    assert windows.long(temporary) == (1, 20000)


def test_temporary_stage_goes_on_for_half_as_long_again(temporary):
    assert windows.temporary_stage(temporary) == (1, 7500)


def test_without_hits_early_is_ten_collisions_per_sphere(written):
    with RunFile(written(gap=np.full(50000, 1e-3))) as run:
        assert windows.early(run) == (1, 20000)  # 10 x 4000 / 2


def test_arrest_begins_after_the_last_precise_separation(arrested):
    assert windows.run_of_hits_begins(arrested) == 601


def test_passage_into_the_arrest_is_half_of_what_was_before_and_as_much_after(arrested):
    assert windows.into_arrest(arrested) == (301, 901)  # 601 -+ 300


def test_passage_into_a_late_arrest_is_400_collisions_before_and_after(written):
    gap = np.full(20000, 1e-4)
    gap[5000:] = 0  # from collision 5001 on
    with RunFile(written(gap=gap, arrest=20000, window=15000)) as run:
        assert windows.into_arrest(run) == (4601, 5401)
        assert windows.to_arrest(run) == (1, 20000)


def test_window_to_arrest_goes_a_tenth_beyond(arrested):
    assert windows.to_arrest(arrested) == (1, 880)


def test_without_arrest_figure_windows_stay_within_the_log(temporary):
    assert windows.to_arrest(temporary) == (1, 100000)
    assert windows.into_arrest(temporary) == (1, 14999)  # 5000 + 99 999 // 10


def test_every_window_of_a_one_collision_log_is_that_collision(written):
    with RunFile(written(gap=[1e-3])) as run:
        for window in (windows.whole, windows.early, windows.long, windows.temporary_stage,
                       windows.to_arrest, windows.into_arrest, windows.pairs_change):
            assert window(run) == (1, 1)
