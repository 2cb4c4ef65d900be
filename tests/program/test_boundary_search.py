"""zenosphere sweep with [boundary]: a real search, in threads, killed, resumed, with MPI."""

import re
import shutil
import signal
import sqlite3
import subprocess

import pytest
from processes import MOST_SECONDS, wait_for
from sweeps import runs_done

SEARCH = """\
[sweep]
case = "case.toml"
master_seed = 3

[axes]
"system.solids_volume_fraction" = [0.1, 0.3]

[boundary]
axis = "system.restitution"
criterion = "separation"
from = 0.05
to = 0.65
resolution = 0.1
runs = 60

[stop]
collisions_per_sphere = 100
"""


@pytest.fixture
def search(program):
    """The program in a folder with a search among 108 sheared spheres from random starts."""
    case = program.case.read_text().replace("collisions = 2000", "collisions = 1_000_000_000")
    program.case.write_text(case.replace('"fcc"', '"random"'))
    (program.folder / "s.toml").write_text(SEARCH)
    return program


def content(path):
    """All that two stores of one search share."""
    with sqlite3.connect(path) as store:
        found = [store.execute(f"SELECT * FROM {table}").fetchall()
                 for table in ("boundary", 'axis')]
        found.append(store.execute('SELECT run, point, replica, seed, "system.restitution", status,'
                                   " collisions, time, separation_hits FROM run").fetchall())
    store.close()
    return found


def test_search_finds_a_boundary_with_its_interval(search):
    done = search("sweep", "s.toml", "--threads", "1")
    lines = re.findall(r"fraction = (\S+)  (\S+) \(95 %: (\S+) to (\S+)\), (\d+) runs", done.stdout)
    assert [line[0] for line in lines] == ["0.1", "0.3"]
    for _, place, low, high, runs in lines:
        assert 0.05 <= float(low) < float(place) < float(high) <= 0.65
        assert float(high) - float(low) <= 0.1
        assert 16 <= int(runs) <= 60


def test_store_does_not_depend_on_threads(search):
    search("sweep", "s.toml", "--threads", "1", "-o", "one.sqlite")
    search("sweep", "s.toml", "--threads", "3", "-o", "three.sqlite")
    assert content(search.folder / "one.sqlite") == content(search.folder / "three.sqlite")


def test_killed_search_goes_on_as_if_nothing_had_happened(search):
    (search.folder / "s.toml").write_text(SEARCH.replace("per_sphere = 100", "per_sphere = 400"))
    search("sweep", "s.toml", "-o", "whole.sqlite")
    killed = search.folder / "killed.sqlite"
    for runs in (1, 10, 20):  # of the 32 at least that it takes
        process = subprocess.Popen(
            search.command("sweep", "s.toml", "--threads", "1", "-o", killed.name),
            cwd=search.folder, stdout=subprocess.DEVNULL)
        wait_for(lambda: runs_done(killed) >= runs)
        process.send_signal(signal.SIGKILL)
        assert process.wait() == -signal.SIGKILL  # it had not ended before
    assert runs_done(killed) < runs_done(search.folder / "whole.sqlite")
    search("sweep", "s.toml", "-o", "killed.sqlite")
    assert content(search.folder / "killed.sqlite") == content(search.folder / "whole.sqlite")


@pytest.mark.skipif(not shutil.which("mpirun"), reason="needs mpirun")
def test_search_with_mpi_gives_the_same_store(search):
    search("sweep", "s.toml", "-o", "threads.sqlite")
    command = ["mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "3",
               *search.command("sweep", "s.toml", "-o", "ranks.sqlite")]
    done = subprocess.run(command, cwd=search.folder, capture_output=True, text=True,
                          timeout=MOST_SECONDS)
    assert done.returncode == 0, done.stdout + done.stderr
    assert content(search.folder / "ranks.sqlite") == content(search.folder / "threads.sqlite")


def test_runs_of_a_search_are_shown_from_its_store(search):
    search("sweep", "s.toml", "--quiet")
    assert "restitution = 0.65" in search("sweep", "show", "s.sqlite", "--run", "7").stdout
    told = search.fail("sweep", "show", "s.toml", "--run", "0")
    assert told == ["s.toml: describes a search (its runs follow from results); give its store"]


def test_plan_of_a_search_tells_what_it_takes_at_most(search):
    plan = search("sweep", "s.toml", "--dry-run").stdout
    assert re.search(r"runs at each, at most +60\n", plan)
    assert re.search(r"runs +120 \(0 done", plan)
