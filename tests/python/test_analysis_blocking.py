"""Standard errors of correlated series."""

import numpy as np
import pytest

from zenosphere.analysis.blocking import errors_of_means, mean_and_error


def correlated(length, memory, seed):
    """An autoregressive series x' = memory x + noise of variance 1, from its steady state."""
    noise = np.random.default_rng(seed).standard_normal(length + 400)
    series = np.empty_like(noise)
    value = 0.0
    for place, kick in enumerate(noise):
        series[place] = value = memory * value + kick
    return series[400:]


@pytest.mark.parametrize("memory", [0.0, 0.5, 0.9])
def test_two_errors_cover_the_true_mean_in_90_to_99_of_100_series(memory):
    found = [mean_and_error(correlated(4096, memory, seed)) for seed in range(100)]
    assert 90 <= sum(abs(mean) < 2 * error for mean, error in found) <= 99


def test_error_of_a_correlated_series_is_that_of_its_correlation_time():
    """The variance of the mean is 1 / ((1 - memory)^2 n): 10 / 128 at memory = 0.9."""
    errors = [mean_and_error(correlated(16384, 0.9, seed))[1] for seed in range(20)]
    assert np.mean(errors) == pytest.approx(10 / 128, rel=0.1)


def test_short_series_has_a_mean_and_no_error():
    assert mean_and_error(np.arange(19.0)) == (9.0, None)
    assert mean_and_error([]) == (None, None)


def test_series_that_is_too_short_for_its_correlations_has_no_error():
    assert mean_and_error(np.linspace(0, 1, 100)) == (pytest.approx(0.5), None)


def test_constant_has_the_error_zero():
    assert mean_and_error(np.full(50, 2.0)) == (2.0, 0.0)


def test_unknown_values_are_left_out():
    random = np.random.default_rng(1)
    values = random.standard_normal(100)
    with_gaps = np.insert(values, 50, np.nan)
    assert mean_and_error(with_gaps) == mean_and_error(values)


def test_columns_have_errors_of_their_own():
    random = np.random.default_rng(1)
    rows = np.stack((random.standard_normal(100), np.linspace(0, 1, 100)), axis=1)
    errors = errors_of_means(rows)
    assert errors[0] == mean_and_error(rows[:, 0])[1] and np.isnan(errors[1])
