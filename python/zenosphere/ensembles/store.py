"""Reads the store of a sweep: how many runs of each point met which criterion."""

import json
import sqlite3
import tomllib
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ..errors import InputError
from . import findings
from .averages import QUANTITIES, Averages, read_averages

FORMAT_VERSIONS = (1, 2, 3, 4)  # 2 has the columns of [adjudicate], 3 the curvature, 4 errors
CRITERIA = ("separation", "arrest", "false positive", "open")
CONDITIONS = {  # SQL: the run met it, within :limit collisions per sphere
    "separation": "COALESCE(separation_first_collision * scale <= :limit, 0)",
    "arrest": "COALESCE(arrest_collision * scale <= :limit, 0)",
}
CONDITIONS["false positive"] = f"({CONDITIONS['separation']} = 1 AND {CONDITIONS['arrest']} = 0)"
CONDITIONS["open"] = "COALESCE(verdict = 'open', 0)"  # of these, those that might arrest yet
# Collisions per sphere = 2 collisions / N, and N need not be an axis. What a run came to that
# stop.wall_seconds ended depends on the machine: it is no result, whatever its status.
SCALED = ("(SELECT *, collisions_per_sphere / NULLIF(collisions, 0) AS scale,"
          " CASE WHEN ended_by = 'wall time' THEN 'failed' ELSE status END AS result FROM run)")


@dataclass(frozen=True)
class Axis:
    """A key that is varied, and its values as the runs have them: ascending, or words."""

    key: str
    values: tuple

    @property
    def is_numeric(self):
        """Whether it can be the x of a figure."""
        return all(isinstance(value, (int, float)) for value in self.values)


@dataclass(frozen=True)
class Counts:
    """Runs of each point; every array has one dimension an axis, in the order of the axes.

    Runs that stop.wall_seconds ended count as failed.
    """

    runs: np.ndarray
    done: np.ndarray
    failed: np.ndarray
    met: dict  # of CRITERIA: done runs that met it
    findings: dict = field(default_factory=dict)  # of findings.COUNTED; empty without the columns

    @property
    def pending(self):
        """Runs that wait."""
        return self.runs - self.done - self.failed

    def at(self, index):
        """The counts of a part: `index` as for a numpy array."""
        return self.mapped(lambda array: array[index])

    def mapped(self, change):
        """The counts with each array changed: `change` takes an array and gives another."""
        return Counts(*(change(array) for array in (self.runs, self.done, self.failed)),
                      *({name: change(array) for name, array in named.items()}
                        for named in (self.met, self.findings)))


class Ensemble:
    """A store, opened for reading only; a sweep may go on writing it.

    path: of STORE.sqlite, one of FORMAT_VERSIONS (docs/sweep-file.md)
    Raises InputError where it is no such store.
    """

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_file():
            raise InputError(f"{path}: does not exist; name the store of a sweep")
        try:
            with closing(self._opened()) as store:
                self._read_plan(store)
        except (sqlite3.Error, ValueError, TypeError, IndexError) as error:
            raise InputError(f"{path}: is not the store of a sweep ({error});"
                             " give the .sqlite file that zenosphere sweep writes") from error

    def counts(self, limit=None):
        """Counts of every point; with a limit, of what happened within so many collisions per
        sphere (the end of a run where it ended earlier)."""
        shape = [len(axis.values) for axis in self.axes]
        conditions = self._conditions()
        numbers = np.zeros((3 + len(conditions), *shape), dtype=int)
        places = [{value: place for place, value in enumerate(axis.values)} for axis in self.axes]
        for row in self._grouped(conditions, np.inf if limit is None else limit):
            point = tuple(where[value] for where, value in zip(places, row))
            numbers[(slice(None), *point)] = row[len(self.axes):]
        runs, done, failed, *met = numbers
        named = dict(zip(conditions, met))
        return Counts(runs, done, failed, {name: named.pop(name) for name in CRITERIA}, named)

    def averages(self):
        """What the runs measured; empty where the store has no columns for it."""
        wanted = {column for quantity in QUANTITIES.values() for column in quantity.columns}
        with closing(self._opened()) as store:
            columns = [name for name, in store.execute("SELECT name FROM pragma_table_info('run')")
                       if name in wanted | {"averages_steady"}]
            if "granular_temperature" not in columns:
                return Averages()
            keys = [axis.key for axis in self.axes]
            named = ", ".join(map(quoted, keys + columns))
            rows = store.execute(f"SELECT {named}, replica FROM {SCALED} WHERE result = 'done'"
                                 " AND arrest_met = 0")
            names = [*keys, *columns, "replica"]
            return read_averages((dict(zip(names, row)) for row in rows), columns, self.axes,
                                 self.seeds)

    def boundaries(self):
        """Rows of the table `boundary` of an adaptive search as dicts; none for a grid."""
        with closing(self._opened()) as store:
            known = store.execute("SELECT 1 FROM sqlite_master WHERE name = 'boundary'").fetchone()
            if not known:
                return []
            store.row_factory = sqlite3.Row
            return [dict(row) for row in store.execute("SELECT * FROM boundary ORDER BY point")]

    def searched(self, point, key, criterion):
        """Places and results of the finished runs at a point of a search: float (K), bool (K)."""
        with closing(self._opened()) as store:
            rows = store.execute(
                f"SELECT {quoted(key)}, {CONDITIONS[criterion]} FROM {SCALED} WHERE point = :point"
                " AND result = 'done' ORDER BY run", {"point": point, "limit": np.inf}).fetchall()
        x, met = zip(*rows) if rows else ((), ())
        return np.array(x, dtype=float), np.array(met, dtype=bool)

    def _opened(self):
        return sqlite3.connect(f"{self.path.resolve().as_uri()}?mode=ro", uri=True)

    def _read_plan(self, store):
        version, self.seeds, self.program_version = store.execute(
            "SELECT format_version, seeds, program_version FROM sweep").fetchone()
        if version not in FORMAT_VERSIONS:
            raise ValueError(f"format version {version}, this program reads"
                             f" {' and '.join(map(str, FORMAT_VERSIONS))}")
        listed = store.execute('SELECT key, "values" FROM axis ORDER BY position').fetchall()
        if not listed:
            raise ValueError("no axis")
        self.axes = tuple(Axis(key, _values(store, key, json.loads(text)))
                          for key, text in listed)
        self.longest = store.execute("SELECT MAX(collisions_per_sphere) FROM run").fetchone()[0]
        case = tomllib.loads(store.execute("SELECT base_case FROM sweep").fetchone()[0])
        self.rule = self._overlap_rule(case)
        self.shear_flow = self._shear_flow(case)
        self.has_findings = self._adjudicates(store) and _has_column(store, findings.COLUMN)
        self.has_margins = _has_column(store, findings.MARGIN)

    def _adjudicates(self, store):
        """False where the sweep file has no [adjudicate]: the store has the columns, all NULL."""
        sweep = store.execute("SELECT * FROM sweep")
        names = [column[0] for column in sweep.description]
        return dict(zip(names, sweep.fetchone())).get("adjudicate_seconds", 0) is not None

    def _overlap_rule(self, case):
        """The rule that leaves or keeps the hits; None where it is an axis."""
        if any(axis.key == "collision.overlap" for axis in self.axes):
            return None
        return case.get("collision", {}).get("overlap", "rewind")  # the default of a case

    def _shear_flow(self, case):
        """None without shear; else solids_volume_fraction (None where it is an axis), and whether
        kinetic theory of smooth inelastic spheres of one kind, at shear rate 1, is about it."""
        drive, system = case.get("drive", {}), case.get("system", {})
        if drive.get("kind") != "shear":
            return None
        collision = set(case.get("collision", {})) - {"overlap", "precision"}
        varied = {axis.key for axis in self.axes} - {
            "system.restitution", "system.solids_volume_fraction", "system.spheres"}
        has_others = any(name in case for name in ("species", "contact", "polydispersity", "walls"))
        is_simple = not (collision or varied or has_others) and drive.get("shear_rate") == 1
        return {"solids_volume_fraction": system.get("solids_volume_fraction"),
                "has_theory": is_simple and system.get("dimension") == 3}

    def _conditions(self):
        """Name -> SQL of what is counted among the runs that are done."""
        counted = findings.COUNTED | (findings.CURVATURE if self.has_margins else {})
        return CONDITIONS | (counted if self.has_findings else {})

    def _grouped(self, conditions, limit):
        keys = ", ".join(quoted(axis.key) for axis in self.axes)
        sums = ", ".join(f"SUM(result = 'done' AND COALESCE({condition}, 0))"
                         for condition in conditions.values())
        with closing(self._opened()) as store:
            yield from store.execute(
                f"SELECT {keys}, COUNT(*), SUM(result = 'done'), SUM(result = 'failed'), {sums}"
                f" FROM {SCALED} GROUP BY {keys}",
                {"limit": limit * (1 + 1e-12)})  # what is compared has been rounded


def _has_column(store, name):
    return bool(store.execute("SELECT COUNT(*) FROM pragma_table_info('run') WHERE name = ?",
                              (name,)).fetchone()[0])


def quoted(key):
    """A column's name in SQL."""
    return '"' + key.replace('"', '""') + '"'


def _values(store, key, listed):
    """The values of the runs, numbers ascending, words in the order of the sweep file."""
    found = [value for value, in store.execute(f"SELECT DISTINCT {quoted(key)} FROM run")]
    if all(isinstance(value, (int, float)) for value in found):
        return tuple(sorted(found))
    order = {str(value): place for place, value in enumerate(listed)}
    return tuple(sorted(found, key=lambda value: order.get(str(value), len(order))))
