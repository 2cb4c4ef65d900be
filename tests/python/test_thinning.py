"""The paper's clipping, and thinning that loses no extreme and no hit."""

import numpy as np

from zenosphere.figures.thinning import plotted_separation, thinned


def long_log(count=300000, seed=3):
    random = np.random.default_rng(seed)
    return np.arange(1, count + 1), 10 ** random.uniform(-9, -3, count)


def test_every_separation_at_or_below_1e_16_is_plotted_at_1e_17():
    gap = np.array([1e-16, 3e-17, 0.0, -0.0, -4.4e-16, -np.inf])
    np.testing.assert_array_equal(plotted_separation(gap), np.full(6, 1e-17))


def test_separation_above_1e_16_is_plotted_as_it_is():
    gap = np.array([np.nextafter(1e-16, 1), 1e-15, 0.2])
    np.testing.assert_array_equal(plotted_separation(gap), gap)


def test_unknown_separation_stays_unknown():
    assert np.isnan(plotted_separation(np.array([np.nan]))).all()


def test_thinning_keeps_lowest_and_highest_of_each_pixel_column():
    x, y = long_log()
    kept = thinned(x, y, keep=np.zeros(len(x), bool), columns=100, sample=1000)
    assert len(kept) < 1300  # 1000 samples, two extremes for each of 100 columns, two ends
    # 300 000 collisions in 100 columns, x from 1: column c holds indices 3000 c to 3000 c + 2999
    # but for the rounding of the column's edge; the inner ones are surely in it.
    for begin in range(0, len(x), 3000):
        inner = slice(begin + 2, begin + 2998)
        at = kept[(kept >= begin) & (kept < begin + 3000)]
        assert y[at].min() <= y[inner].min() and y[at].max() >= y[inner].max()


def test_thinning_keeps_every_hit():
    x, y = long_log()
    hits = np.random.default_rng(4).random(len(x)) < 0.05
    kept = thinned(x, y, keep=hits, columns=100, sample=1000)
    assert np.isin(np.flatnonzero(hits), kept).all()


def test_thinning_keeps_first_and_last_and_the_order():
    x, y = long_log()
    kept = thinned(x, y, keep=np.zeros(len(x), bool), columns=10, sample=50)
    assert kept[0] == 0 and kept[-1] == len(x) - 1
    assert (np.diff(kept) > 0).all()


def test_thinning_gives_the_same_points_every_time():
    x, y = long_log()
    keep = np.zeros(len(x), bool)
    np.testing.assert_array_equal(thinned(x, y, keep), thinned(x, y, keep))


def test_short_log_is_not_thinned():
    x, y = long_log(count=500)
    assert len(thinned(x, y, keep=np.zeros(500, bool), sample=500)) == 500


def test_repeating_pair_of_period_two_is_sampled_at_both_phases():
    x = np.arange(100000)
    y = np.where(x % 2, 1.0, 2.0)
    kept = thinned(x, y, keep=np.zeros(len(x), bool), columns=10, sample=1000)
    assert 400 < (y[kept] == 1.0).sum() < 600  # 500 expected, standard deviation 16
