"""Intervals of probabilities against worked-out numbers."""

import numpy as np
import pytest

from zenosphere.ensembles.proportions import fraction, wilson_interval


def test_interval_of_half_with_z_two_is_worked_out_by_hand():
    # n = 4, k = 2, z = 2: middle (1/2 + 1/2) / 2, half 2 sqrt(1/16 + 1/16) / 2 = sqrt(2) / 4
    assert wilson_interval(2, 4, z=2) == pytest.approx((0.5 - np.sqrt(2) / 4, 0.5 + np.sqrt(2) / 4))


def test_none_of_n_gives_zero_to_z2_over_n_plus_z2():
    low, high = wilson_interval(0, 10)
    assert low == 0
    assert high == pytest.approx(3.841459 / 13.841459, abs=1e-6)  # 0.2775


def test_all_of_n_mirrors_none():
    low, high = wilson_interval(10, 10)
    assert high == 1
    assert low == pytest.approx(1 - 0.2775328, abs=1e-6)


def test_interval_agrees_with_the_tabulated_one():
    # Brown, Cai & DasGupta's formula, evaluated for 15 of 50: 0.1910 to 0.4375
    low, high = wilson_interval(15, 50)
    assert (low, high) == (pytest.approx(0.19103, abs=1e-5), pytest.approx(0.43750, abs=1e-5))


def test_ends_of_the_interval_solve_the_score_equation():
    # By definition |k / n - p| = z sqrt(p (1 - p) / n) at both ends.
    for end in wilson_interval(7, 23):
        assert abs(7 / 23 - end) == pytest.approx(1.959963984540054 * np.sqrt(end * (1 - end) / 23))


def test_nothing_tried_says_nothing():
    low, high = wilson_interval([0, 1], [0, 2])
    assert (low[0], high[0]) == (0, 1)
    assert np.isnan(fraction(0, 0)) and fraction(1, 2) == 0.5


def test_interval_covers_the_true_probability_about_as_often_as_it_says():
    random = np.random.default_rng(1)
    hits = random.binomial(10, 0.3, size=20000)
    low, high = wilson_interval(hits, np.full(20000, 10))
    covered = np.mean((low <= 0.3) & (0.3 <= high))
    assert 0.9 < covered < 0.98  # 0.9244 by the binomial sum; 10 trials allow no finer steps
