"""What zenosphere sweep --dry-run says a sweep will take."""

import json
import sqlite3

import pytest
from sweeps import SWEEP


def test_dry_run_tells_the_plan_and_runs_nothing(sweep):
    told = json.loads(sweep("sweep", "s.toml", "--dry-run", "--json").stdout)
    assert (told["points"], told["seeds"], told["pending"]) == (4, 2, 8)
    assert told["seconds_per_run"] > 0 and "probes" in told["source"]
    assert not (sweep.folder / "s.sqlite").exists()
    most = sweep("sweep", "s.toml", "--dry-run", "--json", "--threads", "1024").stdout
    assert json.loads(most)["workers"] == 1024
    sweep("sweep", "s.toml")
    text = sweep("sweep", "s.toml", "--dry-run").stdout
    assert "8 (8 done, 0 failed)" in text and "from the 8 runs done" in text


def altered(sweep, statement):
    with sqlite3.connect(sweep.folder / "s.sqlite") as store:
        store.execute(statement)
    store.close()


def planned(sweep):
    return json.loads(sweep("sweep", "s.toml", "--dry-run", "--json").stdout)


def test_runs_that_ended_early_are_not_taken_for_the_others(sweep):
    """At each of four points one run is done, which arrested in no time, and one is left."""
    sweep("sweep", "s.toml", "--quiet")
    altered(sweep, "UPDATE run SET wall_seconds = 1e-9, ended_by = 'arrest'")
    altered(sweep, "UPDATE run SET status = 'pending' WHERE replica = 1")
    told = planned(sweep)
    assert told["pending"] == 4 and told["source"].startswith("from 4 short probes")
    assert told["seconds_per_run"] > 1e-6  # no run of 540 collisions takes less


def test_run_that_went_to_its_limits_tells_what_the_others_at_its_point_take(sweep):
    sweep("sweep", "s.toml", "--quiet")
    altered(sweep, "UPDATE run SET wall_seconds = 1000 * (point + 1), ended_by = 'collisions'")
    altered(sweep, "UPDATE run SET status = 'pending' WHERE replica = 1 AND point < 2")
    told = planned(sweep)
    assert told["source"] == "from the runs done at 2 points"
    assert told["seconds_per_run"] == 1500
    assert told["seconds"] == 1500 * 2 / min(told["workers"], 2)


def test_every_run_that_is_left_at_a_point_takes_its_time(sweep):
    (sweep.folder / "s.toml").write_text(SWEEP.replace("seeds = 2", "seeds = 3"))
    sweep("sweep", "s.toml", "--quiet")
    altered(sweep, "UPDATE run SET wall_seconds = 1000 * (point + 1), ended_by = 'collisions'")
    altered(sweep, "UPDATE run SET status = 'pending' WHERE replica > point AND point < 2")
    told = planned(sweep)  # two of 1000 s at the first point, one of 2000 s at the second
    assert told["pending"] == 3 and told["seconds_per_run"] == pytest.approx(4000 / 3)


def test_estimate_adds_points_that_are_known_and_those_that_are_probed(sweep):
    sweep("sweep", "s.toml", "--quiet")
    altered(sweep, "UPDATE run SET wall_seconds = 1000, ended_by = "
            "CASE point WHEN 0 THEN 'time' ELSE 'arrest' END")
    altered(sweep, "UPDATE run SET status = 'pending' WHERE replica = 1 AND point < 2")
    told = planned(sweep)
    assert told["source"].startswith("from the runs done at 1 point and 1 short probe,")
    assert 500 < told["seconds_per_run"] < 600  # one of 1000 s, one of some milliseconds
    assert "time, estimated" in sweep("sweep", "s.toml", "--dry-run").stdout
