"""Stores of sweeps as zenosphere sweep writes them (docs/sweep-file.md), with outcomes given."""

import itertools
import json
import sqlite3

COLUMNS = """run INTEGER PRIMARY KEY, point INTEGER, replica INTEGER, seed INTEGER, {axes},
 status TEXT, error TEXT, outcome TEXT, ended_by TEXT, verdict TEXT, collisions INTEGER,
 collisions_per_sphere REAL, time REAL, strain REAL, separation_hits INTEGER,
 separation_first_collision INTEGER, separation_first_time REAL,
 separation_last_collision INTEGER, arrest_met INTEGER, arrest_collision INTEGER,
 arrest_time REAL, wall_seconds REAL, program_version TEXT"""
FINDING = """adjudication_finding TEXT, adjudication_first_finding TEXT,
 adjudication_margin_per_decade REAL"""


def write_store(path, axes, outcome, seeds=10, spheres=100, adjudicated=False):
    """Writes a store and returns its path.

    axes: {key: values};  outcome: (values of the point as dict, replica) -> (first hit, arrest) in
    collisions per sphere, each None where it did not happen; or "pending"; or "failed"
    adjudicated: an outcome has a third value, the finding of the first group of hits, None where
    it is not known; a fourth, if any, is the verdict, and a fifth the change of the margin
    """
    with sqlite3.connect(path) as store:
        store.execute("CREATE TABLE sweep (format_version INTEGER, sweep_file TEXT,"
                      " base_case TEXT, master_seed INTEGER, seeds INTEGER, program_version TEXT)")
        store.execute("INSERT INTO sweep VALUES (1, '', '', 1, ?, '0.1.0')", (seeds,))
        store.execute('CREATE TABLE axis (position INTEGER PRIMARY KEY, key TEXT, "values" TEXT)')
        store.executemany("INSERT INTO axis VALUES (?, ?, ?)", (
            (place, key, json.dumps(list(values))) for place, (key, values) in
            enumerate(axes.items())))
        columns = COLUMNS.format(axes=_declared(axes)) + (f", {FINDING}" if adjudicated else "")
        store.execute(f"CREATE TABLE run ({columns})")
        points = list(itertools.product(*axes.values()))
        for run, (replica, (point, values)) in enumerate(
                itertools.product(range(seeds), enumerate(points))):
            keys = dict(zip(axes, values))
            row = {"run": run, "point": point, "replica": replica, **keys,
                   **_came_to(outcome(keys, replica), keys.get("system.spheres", spheres))}
            names = ", ".join(f'"{name}"' for name in row)
            store.execute(f"INSERT INTO run ({names}) VALUES ({', '.join('?' * len(row))})",
                          list(row.values()))
    return path


def _declared(axes):
    return ", ".join(f'"{key}" {"TEXT" if isinstance(values[0], str) else "REAL"}'
                     for key, values in axes.items())


def _came_to(outcome, spheres, length=500):
    """Columns of a run that ends at its arrest or after `length` collisions per sphere."""
    if isinstance(outcome, str):
        return {"status": outcome, "error": "start" if outcome == "failed" else None}
    hit, arrest = (None if moment is None else round(moment * spheres / 2)
                   for moment in outcome[:2])
    collisions = length * spheres // 2 if arrest is None else arrest
    verdict = "true" if arrest else "none" if hit is None else "open"
    row = {"status": "done", "collisions": collisions,
           "collisions_per_sphere": 2 * collisions / spheres, "separation_hits": int(hit or 0),
           "separation_first_collision": hit, "arrest_met": int(arrest is not None),
           "arrest_collision": arrest, "verdict": (*outcome[3:4], verdict)[0]}
    return row | dict(zip(("adjudication_first_finding", "adjudication_margin_per_decade"),
                          (*outcome[2:3], *outcome[4:5])))


def write_search(path, findings, axis="system.restitution", other="system.solids_volume_fraction"):
    """Writes the store of an adaptive search with eight runs a point, and returns its path.

    findings: {value of the other axis: (finding, place, low, high)}
    """
    write_store(path, {other: tuple(findings), axis: (0.1, 0.2, 0.3, 0.4)},
                lambda keys, _: (5, None) if keys[axis] < 0.25 else (None, None), seeds=2)
    with sqlite3.connect(path) as store:
        places = {value: number for number, value in enumerate(findings)}
        for value, number in places.items():
            store.execute(f'UPDATE run SET point = ? WHERE "{other}" = ?', (number, value))
        store.execute(f'CREATE TABLE boundary (point INTEGER PRIMARY KEY, "{other}" REAL,'
                      ' axis TEXT, criterion TEXT, "from" REAL, "to" REAL, finding TEXT,'
                      ' place REAL, low REAL, high REAL, rounds INTEGER, runs INTEGER,'
                      ' failed INTEGER)')
        store.executemany(f"INSERT INTO boundary VALUES ({', '.join('?' * 13)})", (
            (number, value, axis, "separation", 0.1, 0.4, *findings[value], 1, 8, 0)
            for value, number in places.items()))
    return path
