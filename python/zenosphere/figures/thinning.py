"""What of a long collision log is drawn, and at which height. Pure functions on arrays."""

import numpy as np

# The paper plots 1e-17 for every separation at or below 1e-16, zero and negative ones included.
PLOT_LIMIT = 1e-16
PLOT_FLOOR = 1e-17


def plotted_separation(gap):
    """The height at which the paper draws a separation.

    gap: float64 (n), diameters; may be zero, negative or NaN
    Returns float64 (n), diameters: PLOT_FLOOR for every gap <= PLOT_LIMIT, else the gap itself.
    Source: Detection of Inelastic Collapse in 3-D Shear Flow, Figures 1, 2, 4 and 6.
    """
    return np.where(gap <= PLOT_LIMIT, PLOT_FLOOR, gap)


def thinned(x, y, keep, columns=1200, sample=40000):
    """Indices of points enough to draw y against x at a width of `columns` pixels.

    Never drops the lowest and highest y of a pixel column, the first and last point, or a point
    marked in `keep`. Of the rest stays one, drawn at random with a fixed seed, of each of `sample`
    equal blocks: a fixed stride would alias with collision sequences that repeat.

    x: (n) ascending;  y: (n) without NaN;  keep: bool (n)
    Returns int64 (m), ascending, m <= n.
    """
    count = len(x)
    if count <= sample:
        return np.arange(count)
    chosen = np.array(keep, dtype=bool)
    chosen[[0, -1]] = True
    chosen[_column_extremes(x, y, columns)] = True
    edges = np.linspace(0, count, sample + 1).astype(np.int64)
    inside = np.random.default_rng(seed=1).random(sample)
    chosen[edges[:-1] + (inside * np.diff(edges)).astype(np.int64)] = True
    return np.flatnonzero(chosen)


def _column_extremes(x, y, columns):
    """Index of the lowest and of the highest y in each pixel column, int64 (<= 2 columns)."""
    column = np.minimum((x - x[0]) * (columns / (x[-1] - x[0])), columns - 1).astype(np.int64)
    order = np.lexsort((y, column))
    begins = np.flatnonzero(np.diff(column[order], prepend=-1))
    ends = np.append(begins[1:], len(x)) - 1
    return np.concatenate((order[begins], order[ends]))
