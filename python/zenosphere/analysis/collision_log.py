"""Distributions over the collisions of a run: gaps, flight times, normal speeds."""

import numpy as np

from ..run_file import RunFile

ROWS = 1_000_000  # of the log at a time
PER_DECADE = 10
DECADES = {"gap": (-17, 3), "flight_time": (-17, 6), "normal_speed": (-12, 6)}
UNITS = {"gap": "diameters", "flight_time": "time", "normal_speed": "diameters/time"}


class LogarithmicHistogram:
    """Density of positive numbers in bins of equal width in the logarithm.

    decades: (first, last) powers of ten
    """

    def __init__(self, decades):
        self.edges = np.logspace(*decades, (decades[1] - decades[0]) * PER_DECADE + 1)
        self._counts = np.zeros(len(self.edges) - 1)
        self._number, self._sum, self._below = 0, 0.0, 0

    @classmethod
    def counted(cls, edges, counts, number, total, below):
        """The histogram of values that were counted elsewhere.

        number: of all values;  total: their sum;  below: how many lie below the bins
        """
        histogram = cls((0, 1))
        histogram.edges, histogram._counts = edges, counts
        histogram._number, histogram._sum, histogram._below = number, total, below
        return histogram

    def add(self, values):
        """Counts values; those that are not known (NaN) are left out."""
        values = values[np.isfinite(values)]
        self._counts += np.histogram(values, self.edges)[0]
        self._number += len(values)
        self._below += int(np.sum(values < self.edges[0]))
        self._sum += float(values.sum())

    def result(self):
        """value (centres of the bins that hold any), density, mean, number, below_smallest_bin."""
        held = np.flatnonzero(self._counts)
        span = slice(held[0], held[-1] + 1) if held.size else slice(0)
        widths = np.diff(self.edges)
        return {"value": np.sqrt(self.edges[1:] * self.edges[:-1])[span],
                "density": (self._counts / widths)[span] / max(self._number, 1),
                "mean": self._sum / self._number if self._number else None,
                "number": self._number, "below_smallest_bin": self._below}


def collision_distributions(path, from_time, to_time):
    """Distributions of gap, flight_time and normal_speed over the collisions of a time.

    The gap is that of the pair that collides next; the flight time is that of a sphere since its
    collision before, one value for each sphere of a collision.

    path: of a finished run with every collision in its log
    Returns None where there is no collision.
    """
    histograms = {name: LogarithmicHistogram(decades) for name, decades in DECADES.items()}
    with RunFile(path) as run:
        if not run.has_log:
            return None
        last_times = np.full(run.spheres, np.nan)
        log = run.collisions
        for first in range(log.first, log.last + 1, ROWS):
            time, i, j, gap, speed = log.read("time", "i", "j", "gap", "normal_speed", first=first,
                                              last=min(first + ROWS - 1, log.last))
            flights, moments = flights_of(time, i, j, last_times)
            inside = (time >= from_time) & (time <= to_time)
            histograms["gap"].add(gap[inside])
            histograms["normal_speed"].add(speed[inside])
            histograms["flight_time"].add(flights[(moments >= from_time) & (moments <= to_time)])
    results = {name: histogram.result() for name, histogram in histograms.items()}
    return results if results["normal_speed"]["number"] else None


def flights_of(time, i, j, last_times):
    """Time of each sphere of each collision since its collision before; NaN for its first.

    time, i, j: (K), in order;  last_times: (N), of each sphere, brought up to date
    Returns flights and the times at which they end, (2 K) each; walls, which come behind the
    spheres, have none.
    """
    spheres, moments = np.concatenate((i, j)), np.concatenate((time, time))
    order = np.argsort(np.concatenate((np.arange(len(i)),) * 2), kind="stable")
    order = order[np.argsort(spheres[order], kind="stable")]
    order = order[spheres[order] < len(last_times)]
    spheres, moments = spheres[order], moments[order]
    begins = np.flatnonzero(np.diff(spheres, prepend=-1))
    before = np.concatenate((moments[:1], moments[:-1]))
    before[begins] = last_times[spheres[begins]]
    ends = np.append(begins[1:], len(spheres)) - 1 if begins.size else begins
    last_times[spheres[ends]] = moments[ends]
    return moments - before, moments
