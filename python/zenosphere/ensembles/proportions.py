"""Probabilities from counts: a fraction and how well so many runs know it."""

import numpy as np

Z_95 = 1.959963984540054  # the normal distribution's two-sided 95 %


def wilson_interval(successes, trials, z=Z_95):
    """Wilson's score interval of a probability, as (low, high); [0, 1] where nothing was tried.

    It keeps its coverage near 0 and 1 and for few trials, where p +- z sqrt(p q / n) does not.

    successes, trials: counts, scalars or arrays of one shape, 0 <= successes <= trials
    z: half width in standard normal deviates; the default is for 95 %
    Source: E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209, eq. (8); recommended by
    L. D. Brown, T. T. Cai & A. DasGupta, Stat. Sci. 16 (2001) 101 for n <= 40.
    """
    successes, trials = np.asarray(successes, dtype=float), np.asarray(trials, dtype=float)
    n = np.maximum(trials, 1)
    p = successes / n
    middle = p + z**2 / (2 * n)
    half = z * np.sqrt(p * (1 - p) / n + z**2 / (4 * n**2))
    low, high = (middle - half) / (1 + z**2 / n), (middle + half) / (1 + z**2 / n)
    low = np.where(successes == 0, 0, low)  # exact there; rounding would leave 1e-17
    high = np.where(successes == trials, 1, high)
    return np.where(trials > 0, low, 0.0), np.where(trials > 0, high, 1.0)


def fraction(successes, trials):
    """successes / trials; nan where nothing was tried."""
    successes, trials = np.asarray(successes, dtype=float), np.asarray(trials, dtype=float)
    return np.where(trials > 0, successes / np.maximum(trials, 1), np.nan)
