"""What a run has recorded, as NumPy arrays."""

import json
import operator
import os
from collections.abc import Iterator, Sequence
from functools import cached_property
from types import TracebackType
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from .case import Case, Grains
from .run import State


class Output:
    """The output file of a run: finished, interrupted, or still going on.

    The journal beside the file is read too: of a run that is still going on you see what it had
    recorded at its last checkpoint when the file was opened; open it again to see more.
    Collisions and snapshots are read when they are accessed. Nothing is written or locked, and the
    file is open only while it is read; so there is nothing to close, though `with` works.

    path: the file that `zenosphere run -o` or `Run(..., output=...)` wrote
    Raises InputError where it is missing, damaged, or no output file.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = os.fspath(path)
        self._core = _core.Output.open(self.path)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The summary of the run, as `--json` prints it (docs/summary.md).

        `outcome` is "unfinished" where the run is going on or was cut off. The summary is empty
        where such a file has no checkpoint yet.
        """
        summary: dict[str, Any] = json.loads(self._core.info)
        del summary["file"]
        return summary

    @cached_property
    def file(self) -> dict[str, Any]:
        """What the file says about itself: complete, program_version, snapshots, ..."""
        file: dict[str, Any] = json.loads(self._core.info)["file"]
        return file

    @property
    def adjudication(self) -> dict[str, Any] | None:
        """What `zenosphere adjudicate` found and left in the file (docs/adjudication.md).

        None where it has not been done, or the run has been made longer since.
        """
        adjudication: dict[str, Any] | None = self.file["adjudication"]
        return adjudication

    @property
    def verdict(self) -> str | None:
        """The verdict of the run: none | temporary | open | true; None before any checkpoint."""
        return self.summary.get("verdict")

    @property
    def is_complete(self) -> bool:
        """Whether the run has ended and everything is written."""
        return bool(self.file["complete"])

    @cached_property
    def case(self) -> Case:
        """The case of the run: `Run(output.case)` repeats it."""
        return Case._of(_core.Case.restored(self._core.resolved, self._core.text))

    @cached_property
    def grains(self) -> Grains:
        """What each sphere is: arrays of diameter, mass, kind and immobile."""
        return self.case.grains

    @cached_property
    def collisions(self) -> NDArray[np.void]:
        """The collision log, a structured array (K,) of `COLLISION_DTYPE`.

        It lacks what the case did not keep: see `has_every_collision`.
        """
        return self._core.collisions()

    @property
    def has_every_collision(self) -> bool:
        """Whether the run has ended and the log holds all of its collisions."""
        return self._core.has_every_collision

    @cached_property
    def observables(self) -> dict[str, NDArray[Any]]:
        """The time series of the run: averages over successive intervals of equal length.

        "step" and "time" (K), the collisions and the time at the end of each interval, and each
        observable under the name that it has in `summary["averages"]`: (K), (K, D) or (K, D, D).
        Of no rows where the run was too short for an interval, or an older program wrote it.
        """
        return self._core.series()

    @cached_property
    def samples(self) -> dict[str, Any]:
        """What the run has accumulated with `measure.sampling_interval`; empty where nothing was.

        Sums over the samples of successive rows, (K, ...) each, as docs/file-format.md has them,
        with "step" and "time" (K) of the last sample of each row; and "edges", a dict of those of
        the bins. `zenosphere.analyse` makes the curves of them.
        """
        return self._core.samples()

    @property
    def snapshots(self) -> "Snapshots":
        """The states of the spheres that were recorded, a sequence of `State`."""
        return Snapshots(self)

    def __enter__(self) -> "Output":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 traceback: TracebackType | None) -> None:
        pass

    def __repr__(self) -> str:
        return f"<zenosphere.Output: {self.path}>"


class Snapshots(Sequence[State]):
    """The snapshots of an output in the order of their times; each is read when it is accessed.

    `snapshots[0]` is the start, `snapshots[-1]` the last one; `snapshots[::10]` is a list. Reading
    one takes a few milliseconds more than its numbers do.
    """

    def __init__(self, output: Output) -> None:
        self._core = output._core
        self._grains = output.case.grains_if_different
        self._shear_rate = float(output.case.tables["drive"].get("shear_rate", 0.0))

    def __len__(self) -> int:
        return self._core.snapshots

    @overload
    def __getitem__(self, number: int) -> State: ...
    @overload
    def __getitem__(self, number: slice) -> list[State]: ...

    def __getitem__(self, number: int | slice) -> State | list[State]:
        if isinstance(number, slice):
            return [self._read(each) for each in range(*number.indices(len(self)))]
        index = operator.index(number)
        if not -len(self) <= index < len(self):
            raise IndexError(f"snapshots[{index}]: there are {len(self)}")
        return self._read(index % len(self))

    def __iter__(self) -> Iterator[State]:
        return (self._read(number) for number in range(len(self)))

    def _read(self, number: int) -> State:
        collisions, time, positions, velocities, box_edges, images, spins = (
            self._core.snapshot(number))
        peculiar = velocities.copy()
        if self._shear_rate:  # the imposed profile (docs/file-format.md)
            peculiar[:, 0] -= self._shear_rate * (positions[:, 1] - box_edges[1, 1] / 2)
        return State(collisions, time, positions, velocities, peculiar, box_edges, images, spins,
                     self._grains)


def open(path: str | os.PathLike[str]) -> Output:  # noqa: A001
    """Opens the output file of a run: its summary, case, collisions and snapshots.

    `with zenosphere.open("run.h5") as output: print(output.verdict, len(output.collisions))`
    """
    return Output(path)
