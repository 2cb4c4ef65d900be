"""Rows of what a run has accumulated (`measure.sampling_interval`)."""

import numpy as np

ROUNDING = 1e-9  # of the times of rows, relative to their length


class Rows:
    """Rows of samples of an output: sums, and means over the samples of each row.

    samples: of Output.samples;  from_time, to_time: rows that lie between them as a whole count;
    None: no limit
    """

    def __init__(self, samples, from_time=None, to_time=None):
        self._samples = samples
        span = samples["span"] if samples else np.empty(0)
        self.ends = samples["time"] if samples else np.empty(0)
        self.begins = self.ends - span
        inside = np.ones(len(span), dtype=bool)
        if from_time is not None:
            inside &= self.begins >= from_time - ROUNDING * span
        if to_time is not None:
            inside &= self.ends <= to_time + ROUNDING * span
        self._inside = inside
        self.ends, self.begins = self.ends[inside], self.begins[inside]

    def __len__(self):
        return len(self.ends)

    def __contains__(self, name):
        return name in self._samples

    def edges(self, name):
        """Of the bins of a quantity, (K + 1)."""
        return self._samples["edges"][name]

    def sums(self, name):
        """Of a quantity, (rows, ...)."""
        return self._samples[name][self._inside]

    def means(self, name):
        """Over the samples of each row, (rows, ...)."""
        sums = self.sums(name)
        return sums / self.sums("samples").reshape(-1, *[1] * (sums.ndim - 1))

    def rates(self, name):
        """Of what is summed over collisions: per time, (rows, ...)."""
        sums = self.sums(name)
        return sums / self.sums("span").reshape(-1, *[1] * (sums.ndim - 1))

    def told(self):
        """The object `accumulated` of the results."""
        return {"samples": int(self.sums("samples").sum()), "rows": len(self),
                "from_time": float(self.begins[0]), "to_time": float(self.ends[-1])}
