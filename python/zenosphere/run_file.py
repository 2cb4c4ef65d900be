"""The output file of one run (docs/file-format.md, format version 1); the only user of h5py."""

import json
import tomllib
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np

from .anatomy import dissection
from .errors import InputError

FORMAT_VERSION = 1

COLUMNS = ("k", "time", "i", "j", "gap", "normal_speed", "flags")


class RunFile:
    """One finished run, read on demand.

    Use as a context manager. Nothing but the two texts /zenosphere/summary and
    /zenosphere/resolved is read before it is asked for.

    path: the HDF5 file that `zenosphere run` wrote
    Raises InputError where the file is missing, is not ours, or its run has not ended.
    """

    def __init__(self, path):
        self.path = Path(path)
        self._file = _opened(self.path)
        try:
            self._require_finished_run()
            self.summary = self._parsed("summary", json.loads)
            self.case = self._parsed("resolved", tomllib.loads)
        except BaseException:
            self._file.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self._file.close()

    @property
    def name(self):
        """File name without folder and suffix."""
        return self.path.stem

    @property
    def verdict(self):
        """none | temporary | open | true."""
        return self._stated(self.summary, "summary", "verdict")

    @property
    def spheres(self):
        """Number of spheres N."""
        return int(self._stated(self.case, "resolved", "system", "spheres"))

    @property
    def threshold(self):
        """Gap at or below which the separation criterion is met (diameters)."""
        return float(self._stated(self.case, "resolved", "collapse", "gap_threshold"))

    @property
    def separation(self):
        """The summary's `separation`: hits, first_collision, first_time, last_collision."""
        return self._stated(self.summary, "summary", "separation")

    @property
    def arrest(self):
        """The summary's `arrest`: met, collision, time, window, pairs."""
        return self._stated(self.summary, "summary", "arrest")

    @property
    def attributes(self):
        """Attributes of /zenosphere, dict: program_version, git_hash, compiler, ..."""
        return {key: _text(value) for key, value in self._file["zenosphere"].attrs.items()}

    @property
    def has_log(self):
        """Whether the run kept any of its collisions."""
        group = self._file.get("collisions")
        return group is not None and "k" in group and group["k"].shape[0] > 0

    @cached_property
    def collisions(self):
        """The collision log; InputError where the run kept none."""
        group = self._file.get("collisions")
        lacking = COLUMNS if group is None else [name for name in COLUMNS if name not in group]
        if lacking or not group["k"].shape[0]:
            why = f"/collisions lacks {', '.join(lacking)}" if lacking else "/collisions is empty"
            raise InputError(f"{self.path}: no collision log ({why}); run the case again with"
                             ' --set output.collision_log="all"')
        return CollisionLog(group)

    def complete_collisions(self):
        """The collision log, with every collision of the run in it; else InputError."""
        log = self.collisions
        if not log.complete:
            done = self.summary.get("collisions", "?")
            raise InputError(f"{self.path}: collision log is incomplete (collisions {log.first} to"
                             f" {log.last} of {done}); run the case again with"
                             ' --set output.collision_log="all", or draw this file with --run')
        return log

    @property
    def snapshot_times(self):
        """Times of the snapshots, float64 (T)."""
        return self._spheres()["position/time"][:]

    @property
    def snapshot_steps(self):
        """Collisions done at each snapshot, int64 (T)."""
        return self._spheres()["position/step"][:]

    def snapshots(self):
        """Yields (positions (N, D), velocities (N, D), box edges (D, D)) of each snapshot."""
        spheres = self._spheres()
        for number in range(spheres["position/value"].shape[0]):
            yield tuple(spheres[name][number]
                        for name in ("position/value", "velocity/value", "box/edges/value"))

    def dissection(self, which):
        """The anatomy of the first "hit" or of the "arrest"; None where there is none."""
        group = self._file.get(f"zenosphere/anatomy/{which}")
        return None if group is None else dissection.read(group)

    def setting(self, table, key):
        """The resolved value of `table.key`, or None where the case has no such key."""
        return self.case.get(table, {}).get(key)

    def _spheres(self):
        if "particles/spheres" not in self._file:
            raise InputError(f"{self.path}: no snapshots (no /particles/spheres);"
                             " run the case again")
        return self._file["particles/spheres"]

    def _require_finished_run(self):
        group = self._file.get("zenosphere")
        if group is None or "format_version" not in group.attrs:
            raise InputError(f"{self.path}: not a Zenosphere file (no /zenosphere with a"
                             " format_version); give a file that `zenosphere run` wrote")
        version = int(group.attrs["format_version"])
        if version != FORMAT_VERSION:
            raise InputError(f"{self.path}: format version {version} (this program reads"
                             f" {FORMAT_VERSION}); use the Python part of the same release")
        if not group.attrs.get("complete", 0):
            raise InputError(f"{self.path}: run has not ended (/zenosphere complete = 0);"
                             f" wait for it, or continue it with `zenosphere resume {self.path}`")

    def _parsed(self, dataset, parse):
        where = f"{self.path}:/zenosphere/{dataset}"
        repeat = "run the case again"
        if dataset not in self._file["zenosphere"]:
            raise InputError(f"{where}: missing (damaged file); {repeat}")
        try:
            return parse(_text(self._file["zenosphere"][dataset][()]))
        except ValueError as error:
            raise InputError(f"{where}: cannot be parsed ({error}); {repeat}") from error

    def _stated(self, table, dataset, *keys):
        for key in keys:
            if key not in table:
                raise InputError(f"{self.path}:/zenosphere/{dataset}: no {'.'.join(keys)}"
                                 " (damaged file); run the case again")
            table = table[key]
        return table


class CollisionLog:
    """The group /collisions: one row per logged collision, in the order they were done."""

    def __init__(self, group):
        self._group = group

    def __len__(self):
        return self._group["k"].shape[0]

    @property
    def complete(self):
        """Whether every collision of the run is here."""
        return bool(self._group.attrs.get("complete", 0))

    @property
    def first(self):
        """Number of the first logged collision; the run's first one is 1."""
        return int(self._group["k"][0])

    @property
    def last(self):
        """Number of the last logged collision."""
        return int(self._group["k"][-1])

    @cached_property
    def k(self):
        """Collision numbers, int64 (K), ascending."""
        return self._group["k"][:]

    def read(self, *names, first=None, last=None):
        """Columns of the collisions numbered first..last, both included.

        names: datasets of /collisions (`COLUMNS`); None for an end means as far as the log goes
        Returns one array per name, all of one length; units as in docs/file-format.md.
        """
        begin = 0 if first is None else int(np.searchsorted(self.k, first, "left"))
        end = len(self) if last is None else int(np.searchsorted(self.k, last, "right"))
        return tuple(self._group[name][begin:end] for name in names)


def _opened(path):
    if not path.is_file():
        raise InputError(f"{path}: does not exist; name an output file of a run")
    try:
        if not h5py.is_hdf5(path):
            raise InputError(f'{path}: not an HDF5 file (begins with "{_beginning(path)}");'
                             " give a file that `zenosphere run` wrote")
        return h5py.File(path, "r")
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error}); if a run still writes it, wait;"
                         " if it is damaged, run the case again") from error


def _beginning(path):
    """The first bytes, as text that a terminal can show."""
    with open(path, "rb") as file:
        return file.read(8).decode("latin-1").encode("unicode_escape").decode()


def _text(value):
    return value.decode() if isinstance(value, bytes) else value
