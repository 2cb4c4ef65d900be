"""The snapshots that an analysis looks at, one after the other."""

from bisect import bisect_left, bisect_right
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import InputError
from .kinds import Kinds, common_motion
from .periodic_box import PeriodicBox

MOST_IN_DETAIL = 40  # snapshots for what is costly: g(r) and S(k) as whole curves
AXES = "xyz"


@dataclass(frozen=True)
class Frame:
    """One snapshot.

    velocities: (N, D), peculiar: relative to the imposed profile, and to the mean of all spheres or
    between walls of each layer of about a hundred; of spheres that differ the mean by mass
    """

    number: int  # among those looked at, from 0
    time: float
    positions: np.ndarray
    velocities: np.ndarray
    profile_velocities: np.ndarray  # (N, D), relative to the imposed profile only
    box: PeriodicBox
    is_in_detail: bool
    kinds: Kinds | None = None  # None: unit spheres

    @property
    def spheres(self):
        """N."""
        return len(self.positions)

    @property
    def dimension(self):
        """D."""
        return self.box.dimension


class Frames:
    """The snapshots of an output from one time to another; iterating reads them one by one.

    output: zenosphere.Output
    from_time: None: where the averages of the run begin;  to_time: None: the last one
    Where none lies between them, `first` and `last` are the last one of the run, for its box.
    Raises InputError where there is no snapshot at all.
    """

    def __init__(self, output, from_time=None, to_time=None):
        self.output = output
        self.case = output.case.tables
        self.kinds = Kinds.of(output.case.grains_if_different,
                              [each["name"] for each in self.case.get("species", [])])
        snapshots = output.snapshots
        if not len(snapshots):
            raise InputError(f"{output.path}: no snapshots (the run has not got to its first"
                             " checkpoint, or was cut off before it); wait, or run it again")
        begin = self.begin = self._usual_start() if from_time is None else from_time
        self._first = bisect_left(snapshots, begin, key=lambda state: state.time)
        self._end = len(snapshots) if to_time is None else bisect_right(
            snapshots, to_time, key=lambda state: state.time)
        self._end = max(self._end, self._first)
        if len(self):
            self.first, self.last = snapshots[self._first], snapshots[self._end - 1]
        else:
            self.first = self.last = snapshots[-1]
        self._to_time = to_time

    def require_some(self):
        """Raises InputError where no snapshot lies in the time that was asked for."""
        snapshots = self.output.snapshots
        if len(self):
            return
        span = f"from {self.begin:g}" + (
            "" if self._to_time is None else f" to {self._to_time:g}")
        raise InputError(f"{self.output.path}: no snapshot in the time {span} (there are"
                         f" {len(snapshots)}, the last one at {snapshots[-1].time:g}), and no"
                         " samples (measure.sampling_interval); choose another time with"
                         " --from-time and --to-time")

    def __len__(self):
        return self._end - self._first

    def __iter__(self):
        snapshots, stride = self.output.snapshots, -(-len(self) // MOST_IN_DETAIL)
        for number in range(len(self)):
            state = snapshots[self._first + number]
            box = PeriodicBox(state.box_edges, self.walls)
            velocities = state.peculiar_velocities
            if not (np.isfinite(state.positions).all() and np.isfinite(velocities).all()):
                raise InputError(f"{self.output.path}: a place or a velocity in the snapshot at"
                                 f" time {state.time:g} is no number (the file is damaged); take"
                                 " another copy of it, or run its case again")
            yield Frame(number, state.time, state.positions, self._peculiar(state), velocities, box,
                        number % stride == 0, self.kinds)

    @property
    def span(self):
        """Times between which collisions count; rounding can put the first of a run before 0."""
        return (self.first.time if self._first else -np.inf), self.last.time

    @cached_property
    def shear_rate(self):
        """Of the imposed profile, 1/time; 0 without."""
        return float(self.case.get("drive", {}).get("shear_rate", 0.0))

    @cached_property
    def walls(self):
        """Number of the axis between walls, or None."""
        axis = self.case.get("walls", {}).get("axis")
        return None if axis is None else AXES.index(axis)

    @property
    def spheres(self):
        """N."""
        return len(self.first.positions)

    @property
    def dimension(self):
        """D."""
        return len(self.first.box_edges)

    @property
    def box(self):
        """That of the first snapshot."""
        return PeriodicBox(self.first.box_edges, self.walls)

    @property
    def collision_rate(self):
        """Collisions per sphere and time between the first snapshot and the last; 0 at one time."""
        done = self.last.collisions - self.first.collisions
        return 2 * done / (self.spheres * self.duration) if self.duration > 0 else 0.0

    @property
    def duration(self):
        """Time from the first snapshot to the last."""
        return self.last.time - self.first.time

    def _usual_start(self):
        begin = (self.output.summary.get("averages") or {}).get("from_time")
        if begin is None:  # nothing has been averaged
            begin = self.case.get("measure", {}).get("after_time", 0.0)
        return begin if isinstance(begin, (int, float)) else 0.0

    def _peculiar(self, state):
        velocities = state.peculiar_velocities
        if self.walls is None:
            common = common_motion(self.kinds, velocities) if len(velocities) > 1 else 0
            return velocities - common
        layers = max(len(velocities) // 100, 1)
        order = np.argsort(state.positions[:, self.walls], kind="stable")
        relative = velocities.copy()
        for layer in np.array_split(order, layers):
            relative[layer] -= (common_motion(self.kinds, relative, layer)
                                if len(velocities) > 1 else 0)
        return relative
