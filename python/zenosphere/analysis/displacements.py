"""Mean-square displacement, velocity autocorrelation and self-diffusion."""

import numpy as np

from .blocking import errors_of_means, mean_and_error, measured
from .frames import AXES
from .kinds import common_motion

FREE_TIMES = 40  # of flight, the length of a stretch: the fit begins at half of it
FEWEST_LAGS = 10
EVEN = 1e-6  # relative, of the times between snapshots
MOST_STRAIN = 0.3  # between snapshots; what a displacement along the flow then lacks: below 1 %
DIFFUSIVE = 0.2  # of the exponent about 1


class Displacements:
    """How far spheres come relative to the flow and to their common motion.

    The snapshots are cut into stretches of 40 mean free times; each begins anew at its first one,
    so that one set of displacements is kept at a time. A step between snapshots is unwrapped by its
    nearest image, less what the shear has carried the sphere along; that is certain only while
    the fastest sphere comes less than half a side. Between walls nothing is unwrapped along their
    normal, and the common motion is left in, as it is among immobile spheres, which do not count.

    frames: Frames
    """

    def __init__(self, frames):
        self.shear_rate = frames.shear_rate
        self._last = self._start = None
        self._interval = self._lags = None
        self._rate, self._steps, self._duration = (
            frames.collision_rate, len(frames) - 1, frames.duration)
        self._is_certain = np.ones(frames.dimension, dtype=bool)
        self._squares, self._correlations = [], []
        self._axes = frames.box.periodic
        self._kinds = frames.kinds
        self._counted = slice(None) if self._kinds is None else self._kinds.mobile
        self._is_carried = (frames.walls is None and frames.spheres > 1
                            and (self._kinds is None or self._kinds.mobile.all()))

    def add(self, frame):
        """Goes on to the next snapshot."""
        last, self._last = self._last, frame
        if last is None:
            return self._begin(frame)
        interval = frame.time - last.time
        if self._lags is None:
            self._interval = interval
            self._lags = self._stretch(interval)
        if not interval > 0 or abs(interval - self._interval) > EVEN * self._interval:
            return self._begin(frame)
        self._moved += self._step(last, frame)
        self._row.append(np.mean(self._moved[self._counted]**2, axis=0))
        self._products.append(self._product(self._start.velocities, frame.velocities))
        if len(self._row) == self._lags + 1:
            self._squares.append(self._row)
            self._correlations.append(self._products)
            self._begin(frame)
        return None

    def result(self):
        """mean_square_displacement, velocity_autocorrelation and diffusion."""
        if not self._squares:
            return {"mean_square_displacement": None, "velocity_autocorrelation": None,
                    "diffusion": measured([])}
        time = self._interval * np.arange(self._lags + 1)
        correlation = np.array(self._correlations)
        with np.errstate(invalid="ignore", divide="ignore"):
            correlation = correlation / correlation[:, :1]
        squares = np.where(self._is_certain, np.array(self._squares), np.nan)
        return {"mean_square_displacement": self._curve(time, squares),
                "velocity_autocorrelation": {
                    "time": time, "value": correlation.mean(axis=0),
                    "standard_error": errors_of_means(correlation)
                } if self._lags >= FEWEST_LAGS else None,
                "diffusion": self._diffusion(time, squares)}

    def _begin(self, frame):
        self._start = frame
        self._moved = np.zeros_like(frame.positions)
        self._row = [np.zeros(frame.dimension)]
        self._products = [self._product(frame.velocities, frame.velocities)]

    def _stretch(self, interval):
        """Steps in a stretch; at most all, without one at the end that is shorter."""
        if not interval > 0:
            return self._steps
        most = min(self._steps, int(self._duration / interval + EVEN))
        free = FREE_TIMES / (self._rate * interval) if self._rate else FEWEST_LAGS
        return int(np.clip(np.ceil(free), min(FEWEST_LAGS, most), most))

    def _step(self, last, frame):
        """Displacements (N, D) between two snapshots, relative to the flow."""
        interval = frame.time - last.time
        fastest = np.maximum(np.abs(last.velocities).max(axis=0),
                             np.abs(frame.velocities).max(axis=0))
        certain = fastest * interval < frame.box.sides / 2
        step = frame.positions - last.positions
        for axis in reversed(self._axes):
            if axis == 0:
                step[:, 0] -= self.shear_rate * interval * self._height(last, step)
            turns = np.rint(step[:, axis:axis + 1] / frame.box.sides[axis])
            step -= turns * frame.box.edges[axis]
        if self.shear_rate:
            certain[0] &= certain[1] and self.shear_rate * interval <= MOST_STRAIN
        certain[[axis for axis in range(frame.dimension) if axis not in self._axes]] = True
        self._is_certain &= certain
        return step - common_motion(self._kinds, step) if self._is_carried else step

    def _height(self, last, step):
        """Mean height above the middle of the box along the way, (N), for the imposed profile."""
        if not self.shear_rate:
            return 0.0
        return last.positions[:, 1] + step[:, 1] / 2 - last.box.sides[1] / 2

    def _curve(self, time, squares):
        by_axis = squares.mean(axis=0)
        total = squares.sum(axis=2)
        return {"time": time, "value": total.mean(axis=0), "standard_error": errors_of_means(total),
                "by_axis": {AXES[axis]: column for axis, column in enumerate(by_axis.T)}}

    def _diffusion(self, time, squares):
        """Half the slope over the second half of a stretch, along the certain periodic axes.

        Under shear along those across the flow: along it, the shear makes spheres spread faster.
        """
        axes = [axis for axis in self._axes
                if self._is_certain[axis] and not (axis == 0 and self.shear_rate)]
        if not axes or self._lags < FEWEST_LAGS:
            return measured([])
        rows = squares[:, :, axes].mean(axis=2)
        half = self._lags // 2
        mean = rows.mean(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            exponent = np.log(mean[-1] / mean[half]) / np.log(time[-1] / time[half])
        if not abs(exponent - 1) <= DIFFUSIVE:
            return measured([])
        slopes = np.polyfit(time[half:], rows[:, half:].T, 1)[0]
        return dict(zip(("value", "standard_error"), mean_and_error(slopes / 2)))

    def _product(self, first, second):
        return float(np.mean(np.sum(first * second, axis=1)[self._counted]))
