"""A sweep of eight runs of the small case, and how its store is looked at."""

import sqlite3

SWEEP = """\
[sweep]
case = "case.toml"
seeds = 2
master_seed = 3

[axes]
"system.restitution" = [0.2, 0.9]
"collision.overlap" = ["rewind", "guarded"]

[stop]
collisions_per_sphere = 10
"""
ENDLESS = SWEEP.replace("collisions_per_sphere = 10", "collisions_per_sphere = 1e9") \
    .replace("[0.2, 0.9]", "[0.95, 0.99]")


def rows(path, unequal=("wall_seconds", "adjudication_seconds")):
    """All rows of a store as dicts, without what differs between equal runs."""
    with sqlite3.connect(path) as store:
        store.row_factory = sqlite3.Row
        found = [dict(row) for row in store.execute("SELECT * FROM run ORDER BY run")]
    store.close()
    return [{key: row[key] for key in row if key not in unequal} for row in found]


def is_made(path):
    """Whether a sweep has begun its store: the rows come all at once."""
    if not path.exists():
        return False
    store = sqlite3.connect(path)
    try:
        return store.execute("SELECT count(*) FROM sqlite_master").fetchone()[0] > 0
    finally:
        store.close()


def runs_done(path):
    """How many runs of a store have ended; 0 where there is no store yet."""
    return sum(row["status"] == "done" for row in rows(path)) if is_made(path) else 0
