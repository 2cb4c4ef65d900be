"""Displacements that a run has accumulated itself (`measure.sampling_interval`)."""

import numpy as np

from .blocking import errors_of_means
from .displacements import FREE_TIMES, Displacements
from .frames import AXES


class AccumulatedDisplacements(Displacements):
    """Displacements of rows: of stretches of ten samples, of ten times every second one, and so on.

    The curves take all lags of the first level, and of each coarser one those that are new.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        edges = rows.edges("lag")
        self._interval, self._lags = edges[1], len(edges) - 1
        self._stretches = rows.sums("stretches")
        self._moving = rows.sums("moving_stretches")
        self._levels = int((self._stretches.sum(axis=0) > 0).sum())
        self._is_certain = rows.sums("uncertain_steps").sum(axis=0) == 0
        self._sums = np.where(self._is_certain, rows.sums("square_displacements"), np.nan)
        self._products = rows.sums("velocity_correlations")
        collisions = rows.sums("normal_speed_moments")[:, 0].sum()
        self._rate = 2 * collisions / (frames.spheres * (rows.ends - rows.begins).sum())

    def add(self, frame):
        """Nothing: snapshots do not count."""

    def result(self):
        """mean_square_displacement, velocity_autocorrelation and diffusion."""
        if not self._levels:
            return super().result()
        time = self._interval * self._composed(np.arange(1, self._lags + 1)
                                               * 2 ** np.arange(self._levels)[:, None])
        squares, counts = self._composed(self._sums), self._composed(self._counts(self._stretches))
        by_axis = _mean(squares, counts[:, :, None])
        correlations, moving = self._composed(self._products), self._composed(
            self._counts(self._moving))
        level = self._diffusive_level()
        rows = self._stretches[:, level] > 0
        one = self._sums[rows, level] / self._stretches[rows, level, None, None]
        return {
            "mean_square_displacement": {
                "time": np.append(0, time), "value": np.append(0, by_axis.sum(axis=1)),
                "standard_error": np.append(0, _error(squares.sum(axis=2), counts)),
                "by_axis": {AXES[axis]: np.append(0, column)
                            for axis, column in enumerate(by_axis.T)}},
            "velocity_autocorrelation": {
                "time": np.append(0, time), "value": np.append(1, _mean(correlations, moving)),
                "standard_error": np.append(0, _error(correlations, moving))},
            "diffusion": self._diffusion(self._interval * 2**level * np.arange(self._lags + 1),
                                         np.pad(one, ((0, 0), (1, 0), (0, 0))))}

    def _composed(self, of_levels):
        """(..., levels, lags, ...) as (..., K, ...): what each level adds to those below it."""
        axis = 0 if of_levels.ndim == 2 else 1
        parts = [of_levels.take(level, axis=axis) for level in range(self._levels)]
        coarser = np.arange(self._lags // 2, self._lags)
        return np.concatenate([part if level == 0 else part.take(coarser, axis=axis)
                               for level, part in enumerate(parts)], axis=axis)

    def _counts(self, stretches):
        """Of each row and level, for every lag."""
        return np.repeat(stretches[:, :, None], self._lags, axis=2)

    def _diffusive_level(self):
        """The first one whose stretches are 40 mean free times long, or the last one that there is."""
        lengths = self._lags * self._interval * 2.0 ** np.arange(self._levels)
        enough = np.flatnonzero(lengths * self._rate >= FREE_TIMES)
        return int(enough[0]) if enough.size else self._levels - 1


def _mean(sums, counts):
    with np.errstate(invalid="ignore", divide="ignore"):
        return sums.sum(axis=0) / counts.sum(axis=0)


def _error(sums, counts):
    """Of the mean, from the rows in which a stretch has ended."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return errors_of_means(sums / counts)
