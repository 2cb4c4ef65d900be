"""A run that Python drives, chunk by chunk."""

import json
import operator
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from .case import Case, Grains, Overrides
from .errors import InputError, OutputError
from .toml_text import override_texts

COLLISION_DTYPE: np.dtype[np.void] = _core.collision_dtype
"""A row of the collision log, named as the datasets of /collisions in an output file:

k int64 (number, from 1), time float64, i and j int32 (spheres from 0, i < j; j = N and N + 1 are
the walls), gap float64 (of the pair that collides next, diameters), normal_speed float64
(diameters/time), flags uint8 (sum of the bits in `zenosphere.flags`).
"""


@dataclass(frozen=True, eq=False)
class State:
    """The N spheres in D dimensions at one time, in the laboratory frame.

    The engine keeps each sphere in the sliding frame of its layer and as it was at its own last
    event; so every array is a fresh copy, C-contiguous float64, that stays as it is while the run
    goes on.

    collisions: done so far
    time: since the start
    positions: (N, D), diameters, every component in [0, side)
    velocities: (N, D), laboratory, diameters/time
    peculiar_velocities: (N, D), relative to the imposed shear profile, diameters/time
    box_edges: (D, D), diameters; the rows are the box vectors, the second with the Lees-Edwards
    offset
    images: (N, D) int32, through how many boxes each sphere has come since the start, along the
    box vectors; None in a file of a program that did not count them
    angular_velocities: (N, 3), in two dimensions (N, 1), radians/time; None where nothing turns
    grains: what the spheres are; None: unit spheres
    """

    collisions: int
    time: float
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]
    peculiar_velocities: NDArray[np.float64]
    box_edges: NDArray[np.float64]
    images: NDArray[np.int32] | None = None
    angular_velocities: NDArray[np.float64] | None = None
    grains: Grains | None = None

    def __eq__(self, other: object) -> bool:
        """Whether all numbers are equal."""
        if not isinstance(other, State):
            return NotImplemented
        return all(np.array_equal(getattr(self, field.name), getattr(other, field.name))
                   for field in fields(self))

    __hash__ = None  # type: ignore[assignment]  # arrays can be changed

    @property
    def unwrapped_positions(self) -> NDArray[np.float64]:
        """Where the flights of each sphere have led it since the start, (N, D), diameters.

        In the laboratory: under shear a sphere that has left through the upper face goes on above
        it, with the flow that is there. Differences of two states are displacements.
        Raises InputError where the images are not known.
        """
        if self.images is None:
            raise InputError("unwrapped_positions: the file has no images of the spheres (its "
                             "program did not count them); run the case again")
        return self.positions + self.images @ self.box_edges

    @property
    def granular_temperature(self) -> float:
        """Mean of m v^2 / D of the mobile spheres now, v peculiar, mass (diameter/time)^2."""
        if self.grains is None:
            return float(np.mean(self.peculiar_velocities**2))
        mobile = ~self.grains.immobile
        return float(np.mean((self.grains.mass[:, None] * self.peculiar_velocities**2)[mobile]))


class Run:
    """A run that advances in chunks.

    In chunks it gives the same bits as the program in one go, in its summary and its output file.
    While it advances, other Python threads run, and Ctrl-C works: the KeyboardInterrupt comes out
    of the call and the run stays valid. One thread at a time may use a run; `stop` may be called
    from any.

    As a context manager it is finished at the end of the block, whatever happened there, so that
    its output can be read and resumed.

    case: a Case, nested dicts as for `Case(...)`, or the path of a TOML file
    overrides: keys and the values that replace theirs, `{"system.restitution": 0.2}`; not for
    a Case
    output: where to keep snapshots and collisions (HDF5, as `zenosphere run -o`); None keeps
    nothing
    overwrite: replace an existing output
    Raises InputError where the case is wrong, OutputError where the output cannot be written.
    """

    def __init__(self, case: Case | Mapping[str, Mapping[str, Any]] | str | os.PathLike[str], *,
                 overrides: Overrides | None = None, output: str | os.PathLike[str] | None = None,
                 overwrite: bool = False) -> None:
        start = _core.Run.start_replacing if overwrite else _core.Run.start
        self._core = start(_checked(case, overrides)._core,
                           None if output is None else _path(output))

    @classmethod
    def resume(cls, output: str | os.PathLike[str], *, overrides: Overrides | None = None) -> "Run":
        """Continues a run from the last checkpoint of its output file.

        overrides: a run that has ended needs a larger limit, for instance
        `{"run.collisions": 3_000_000}`
        Raises InputError where the file cannot be resumed, OutputError where it cannot be written.
        """
        run = cls.__new__(cls)
        run._core = _core.Run.resume(os.fspath(output), override_texts(overrides))
        return run

    def advance(self, collisions: int | None = None, *,
                until: float | None = None) -> NDArray[np.void]:
        """Advances, and returns the collisions as a structured array (K,) of `COLLISION_DTYPE`.

        Ends after `collisions` more of them, at the time `until` since the start, or with the run,
        whichever comes first; without both, with the run. The array owns its rows; none was copied.

        A row holds the gap of the pair that collides *next*, which is known one collision later. So
        the last row waits and comes first in the next chunk; at the end of the run it comes at
        once, with a gap of NaN. The chunks together are /collisions of the output file, row by row.
        """
        return self._core.advance(_count(collisions), until)

    def skip(self, collisions: int | None = None, *, until: float | None = None) -> None:
        """As `advance`, without keeping the collisions."""
        self._core.skip(_count(collisions), until)

    def chunks(self, collisions: int = 10_000) -> Iterator[NDArray[np.void]]:
        """Advances to the end of the run, and yields the collisions in chunks, as `advance` does."""
        if collisions < 1:
            raise InputError(f"chunks: collisions = {collisions} (must be > 0)")
        while not self.is_over:
            yield self.advance(collisions)

    def state(self) -> State:
        """Positions and velocities now; copies, see `State`."""
        return State(*self._core.state(), self._grains)

    @cached_property
    def _grains(self) -> Grains | None:
        return self.case.grains_if_different

    def summary(self) -> dict[str, Any]:
        """The summary of the run so far, as `--json` prints it (docs/summary.md).

        `outcome` is "unfinished" until the run is over.
        """
        summary: dict[str, Any] = json.loads(self._core.summary())
        return summary

    @property
    def separation(self) -> dict[str, Any]:
        """The separation criterion so far: hits, first_collision, first_time, last_collision."""
        separation: dict[str, Any] = self.summary()["separation"]
        return separation

    @property
    def arrest(self) -> dict[str, Any]:
        """The arrest criterion so far: met, collision, time, window, pairs, ..."""
        arrest: dict[str, Any] = self.summary()["arrest"]
        return arrest

    @property
    def verdict(self) -> str:
        """The verdict if the run ended here: none | temporary | open | true."""
        verdict: str = self.summary()["verdict"]
        return verdict

    @property
    def case(self) -> Case:
        """The case of the run."""
        return Case._of(self._core.case)

    @property
    def collisions(self) -> int:
        """Collisions done; any thread may read it, as of 0.1 s ago while another one advances."""
        return self._core.collisions

    @property
    def time(self) -> float:
        """Time since the start, in the case's unit; any thread may read it likewise."""
        return self._core.time

    @property
    def is_over(self) -> bool:
        """Whether a limit of the case was reached, the system collapsed, or `stop` was called."""
        return self._core.is_over

    def stop(self) -> None:
        """Ends the run at its next collision; any thread may call it while the run advances."""
        self._core.stop()

    def save(self) -> None:
        """Makes a checkpoint now: `resume` continues from here, whatever happens to this process.

        Raises InputError where the run has no output, OutputError where it cannot be written.
        """
        self._core.save()

    def finish(self) -> dict[str, Any]:
        """Ends the run, writes the rest of its output, and returns its summary.

        A run that is not over gets the outcome "interrupted"; `resume` continues it. Called
        again, it only returns the summary.
        """
        summary: dict[str, Any] = json.loads(self._core.finish())
        return summary

    def __enter__(self) -> "Run":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 traceback: TracebackType | None) -> None:
        try:
            self.finish()
        except OutputError:
            if error is None:  # else it is what ended the block already
                raise

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("zenosphere.Run: cannot be pickled (it belongs to its process); pass its"
                        " case, or the path of its output")

    def __repr__(self) -> str:
        return f"<zenosphere.Run: {self.collisions} collisions, time {self.time:.6g}>"


def _checked(case: Case | Mapping[str, Mapping[str, Any]] | str | os.PathLike[str],
             overrides: Overrides | None) -> Case:
    if isinstance(case, Case):
        if overrides:
            raise TypeError("Run: overrides are for a dict or a file; give them to the Case")
        return case
    if isinstance(case, Mapping):
        return Case(case, overrides=overrides)
    return Case.read(case, overrides=overrides)


def _path(output: str | os.PathLike[str]) -> str:
    path = os.fsdecode(output)
    if not path or "\0" in path:
        raise InputError(f"output = {path!r} (is no name of a file); name one, or None to keep"
                         " nothing")
    return path


def _count(collisions: int | None) -> int | None:
    if collisions is None:
        return None
    count = operator.index(collisions)
    if abs(count) >= 2**63:
        raise InputError(f"advance: collisions = {count} (needs 64 bits); leave it out to go on"
                         " to the end")
    return count
