"""Means of correlated series with their standard errors."""

import numpy as np

FEWEST_BLOCKS = 8  # whose scatter gives an error
FEWEST_INDEPENDENT = 20  # values that a series must be worth
ROUNDING = 1e-12  # relative: what a conserved number scatters by


def mean_and_error(values):
    """Mean of a stationary series and its standard error; None for what cannot be known.

    The series is cut into blocks of 1, 2, 4, ... values. The error that the scatter of the blocks
    gives grows with their length until they are longer than the correlations; taken is the first
    that no later one exceeds by more than its own uncertainty, 1/sqrt(2 (blocks - 1)).

    values: (n), numbers that are not finite are left out
    Returns (mean, error); the error is None where the series is worth fewer than 20 independent
    values: it is too short, or too short for its correlations.
    Source: Flyvbjerg & Petersen, J. Chem. Phys. 91 (1989) 461.
    """
    values = np.asarray(values, dtype=float)
    values = values[np.isfinite(values)]
    if not values.size:
        return None, None
    return float(values.mean()), _error(values) if values.size >= FEWEST_INDEPENDENT else None


def errors_of_means(rows):
    """Standard error of the mean of each column of (n, K), float64 (K); NaN where unknown."""
    found = (mean_and_error(column)[1] for column in np.asarray(rows, dtype=float).T)
    return np.array([np.nan if error is None else error for error in found])


def measured(values):
    """`mean_and_error` as {"value": ..., "standard_error": ...}."""
    return dict(zip(("value", "standard_error"), mean_and_error(values)))


def _error(values):
    if np.ptp(values) <= ROUNDING * np.abs(values).max():
        return 0.0
    errors, uncertainties, blocks = [], [], values
    while len(blocks) >= FEWEST_BLOCKS:
        errors.append(np.std(blocks, ddof=1) / np.sqrt(len(blocks)))
        uncertainties.append(1 / np.sqrt(2 * (len(blocks) - 1)))
        blocks = blocks[:len(blocks) // 2 * 2].reshape(-1, 2).mean(axis=1)
    errors, limits = np.array(errors), 1 + np.array(uncertainties)
    plateau = next(error for level, error in enumerate(errors)
                   if (errors[level + 1:] <= error * limits[level + 1:]).all())
    independent = len(values) * (errors[0] / plateau) ** 2
    return float(plateau) if independent >= FEWEST_INDEPENDENT else None
