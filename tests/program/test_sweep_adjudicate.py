"""[adjudicate] in a sweep file: the hits of every run judged, the findings kept in the store."""

import csv
import io
import json
import signal
import subprocess

import pytest

from processes import MOST_SECONDS, has_worked, wait_for
from sweeps import is_made, rows
from test_sweep_mpi import has_mpi, mpirun

# 32 sheared discs: runs at e = 0.2 have hundreds of hits, those at e = 0.9 none.
DISCS = """\
[sweep]
seeds = 2
[case.system]
dimension = 2
spheres = 32
solids_volume_fraction = 0.5
[case.start]
arrangement = "random"
granular_temperature = 1.0
[case.drive]
kind = "shear"
shear_rate = 1.0
[case.collapse]
window = 500
[axes]
"system.restitution" = [0.2, 0.9]
[stop]
collisions_per_sphere = 60
"""
JUDGED = DISCS + "[adjudicate]\ngroups = 2\nseconds = 1000\n"


@pytest.fixture
def discs(program):
    (program.folder / "s.toml").write_text(JUDGED)
    return program


def findings(row):
    return {key.removeprefix("adjudication_"): row[key] for key in row if "adjudication" in key}


def test_findings_of_runs_with_hits_are_those_of_the_command(discs):
    discs("sweep", "s.toml", "--threads", "1")
    store = rows(discs.folder / "s.sqlite")
    assert [row["separation_hits"] > 0 for row in store] == [True, False, True, False]
    assert all(value is None for row in store[1::2] for value in findings(row).values())
    for row in store[::2]:
        (discs.folder / "run.toml").write_text(
            discs("sweep", "show", "s.sqlite", "--run", str(row["run"])).stdout)
        done = discs("adjudicate", "run.toml", "--groups", "2", "--seconds", "1000",
                     "--quiet", "--json")
        told = json.loads(done.stdout.splitlines()[-1])
        found = findings(row)
        first = [one for one in told["approaches"] if one["run_hit"] == told["first_hit"]]
        assert found["finding"] == told["finding"] == "singular"
        assert (found["groups"], found["left_out"]) == (2, told["groups_left_out"])
        assert told["groups_left_out"] == told["groups_beyond"] > 0
        assert "groups of hits were not asked for" in told["sentence"]
        assert "no time" not in told["sentence"]
        assert found["decades"] == max(one["decades"] for one in first)
        assert found["sentence"] in [one["sentence"] for one in first]
        assert found["first_finding"] in [one["finding"] for one in first]
        times = [one["collapse_time"] for one in told["approaches"] if one["finding"] == "singular"]
        assert found["collapse_time"] == float(times[0])
        assert sum(found[name] for name in (
            "proven", "singular", "near_collapse", "exact_contact", "chance_close_pair",
            "arithmetic_arrest", "undecided")) == 2


def test_findings_do_not_depend_on_who_does_the_runs(discs):
    discs("sweep", "s.toml", "--threads", "1", "-o", "one.sqlite")
    discs("sweep", "s.toml", "--threads", "2", "-o", "two.sqlite")
    assert rows(discs.folder / "one.sqlite") == rows(discs.folder / "two.sqlite")
    if has_mpi(discs):
        done = mpirun(discs, 3, "s.toml", "-o", "ranks.sqlite")
        assert done.returncode == 0, done.stderr
        assert rows(discs.folder / "one.sqlite") == rows(discs.folder / "ranks.sqlite")


def test_finished_store_is_adjudicated_without_doing_its_runs_again(discs):
    discs("sweep", "s.toml", "-o", "once.sqlite")
    (discs.folder / "s.toml").write_text(DISCS)
    discs("sweep", "s.toml")
    before = rows(discs.folder / "s.sqlite", unequal=())
    assert not any(row["adjudication_finding"] for row in before)
    (discs.folder / "s.toml").write_text(JUDGED)
    plan = discs("sweep", "s.toml", "--dry-run").stdout
    assert "comes on top: the first 2 groups of hits of each run with hits" in plan
    assert "2 of the runs done have hits to adjudicate" in plan
    assert rows(discs.folder / "s.sqlite", unequal=()) == before
    told = json.loads(discs("sweep", "s.toml", "--json").stdout.splitlines()[-1])
    assert (told["ended_here"], told["done"], told["to_adjudicate"]) == (2, 4, 0)
    after = rows(discs.folder / "s.sqlite", unequal=())
    for row, old in zip(after, before):
        assert {key: row[key] for key in row if "adjudication" not in key} == \
            {key: old[key] for key in old if "adjudication" not in key}
    assert rows(discs.folder / "s.sqlite") == rows(discs.folder / "once.sqlite")
    assert json.loads(discs("sweep", "s.toml", "--json").stdout.splitlines()[-1])["ended_here"] == 0


def test_csv_has_the_findings(discs):
    discs("sweep", "s.toml")
    table = list(csv.DictReader(io.StringIO(discs("sweep", "csv", "s.sqlite").stdout)))
    assert [row["adjudication_finding"] for row in table] == ["singular", "", "singular", ""]


def test_other_adjudication_in_a_store_with_findings_is_refused(discs):
    discs("sweep", "s.toml")
    (discs.folder / "s.toml").write_text(JUDGED.replace("groups = 2", "groups = 3"))
    assert "  adjudicate.groups is 3 (2 in the store)" in discs.fail("sweep", "s.toml")


def test_interrupt_ends_an_adjudication_at_once_and_the_run_stays_to_be_done(discs):
    # Ten thousand digits take minutes for a group; the runs themselves are over at once.
    (discs.folder / "s.toml").write_text(
        JUDGED.replace("groups = 2", 'up_to = "digits10000"').replace("[0.2, 0.9]", "[0.2]"))
    process = subprocess.Popen(discs.command("sweep", "s.toml", "--threads", "1"), text=True,
                               cwd=discs.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    wait_for(lambda: is_made(discs.folder / "s.sqlite"))
    wait_for(lambda: has_worked(process.pid, 1))
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=MOST_SECONDS)
    assert (process.returncode, errors) == (130, "")
    assert "the same command goes on" in output
    assert rows(discs.folder / "s.sqlite")[0]["status"] == "pending"


def test_hits_of_a_run_that_wall_time_ended_are_those_it_had(discs):
    text = JUDGED.replace("collisions_per_sphere = 60", "wall_seconds = 0.3") \
        .replace("groups = 2", "groups = 1").replace("seeds = 2", "seeds = 1") \
        .replace("[0.2, 0.9]", "[0.2]").replace("window = 500", "window = 100_000_000")
    (discs.folder / "s.toml").write_text(text + "[case.run]\ntime = 1e6\n")
    discs("sweep", "s.toml")
    row, = rows(discs.folder / "s.sqlite")
    assert (row["ended_by"], row["status"], row["error"]) == ("wall time", "done", None)
    assert row["adjudication_groups"] == 1  # without end, had its search for hits none
