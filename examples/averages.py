"""Statistics of averages over runs with several seeds: what the scan scripts share."""

import numpy as np


def error_of_mean(sample):
    """Standard error of the mean of independent values; NaN of fewer than two."""
    return np.std(sample, ddof=1) / np.sqrt(len(sample)) if len(sample) > 1 else float("nan")


def root_mean_square(numbers):
    """Of errors that belong to equally good means."""
    return float(np.sqrt(np.mean(np.square(numbers))))


def spread_of_a_run(groups):
    """Standard deviation of one run over its mean, pooled over groups: few runs tell it badly."""
    shares = [(group - group.mean()) / group.mean() for group in groups]
    freedom = sum(len(share) - 1 for share in shares)
    return np.sqrt(sum(np.sum(share**2) for share in shares) / freedom)


def chance_of_one_mean(groups, trials=1000):
    """How often means lie as far apart as these if all runs are alike; by exchange of runs.

    groups: arrays of values, one of a run. Measured is the variance between means over that within.
    """
    sizes = np.cumsum([len(group) for group in groups])[:-1]
    pool, random = np.concatenate(groups), np.random.default_rng(1)

    def spread(sample):
        parts = np.split(sample, sizes)
        between = sum(len(part) * (part.mean() - pool.mean())**2 for part in parts)
        return between / sum(np.sum((part - part.mean())**2) for part in parts)

    seen = spread(pool)
    more = sum(spread(random.permutation(pool)) >= seen for _ in range(trials))
    return (more + 1) / (trials + 1)
