"""zenosphere sweep under mpirun: the same store, and no rank that waits for ever."""

import os
import shutil
import signal
import subprocess

import pytest

from processes import MOST_SECONDS, has_worked, wait_for
from sweeps import ENDLESS, is_made, rows


def has_mpi(program):
    libraries = subprocess.run(["ldd", program.command()[0]], capture_output=True, text=True).stdout
    return "libmpi" in libraries and shutil.which("mpirun")


def mpirun(program, ranks, *words):
    return subprocess.run(
        ["mpirun", "--oversubscribe", "--allow-run-as-root", "-n", str(ranks),
         *program.command("sweep", *words)],
        cwd=program.folder, capture_output=True, text=True, timeout=MOST_SECONDS)


def test_ranks_of_mpi_make_the_rows_that_threads_make(sweep):
    if not has_mpi(sweep):
        pytest.skip("built without MPI")
    sweep("sweep", "s.toml", "-o", "threads.sqlite")
    for ranks in (3, 1):
        done = mpirun(sweep, ranks, "s.toml", "-o", f"{ranks}.sqlite")
        assert done.returncode == 0, done.stderr
        assert rows(sweep.folder / f"{ranks}.sqlite") == rows(sweep.folder / "threads.sqlite")


def test_error_of_rank_0_ends_all_ranks(sweep):
    if not has_mpi(sweep):
        pytest.skip("built without MPI")
    done = mpirun(sweep, 3, "missing.toml")
    assert done.returncode == 2
    assert done.stderr.startswith("missing.toml: cannot be opened (No such file or directory)")


def test_death_of_a_rank_ends_the_sweep_which_goes_on_later(sweep):
    if not has_mpi(sweep):
        pytest.skip("built without MPI")
    (sweep.folder / "s.toml").write_text(ENDLESS)
    process = subprocess.Popen(
        ["mpirun", "--oversubscribe", "--allow-run-as-root", "-n", "3",
         *sweep.command("sweep", "s.toml")],
        cwd=sweep.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: is_made(sweep.folder / "s.sqlite"))
    children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True)
    rank = int(children.stdout.split()[-1])
    wait_for(lambda: has_worked(rank))
    os.kill(rank, signal.SIGKILL)
    process.communicate(timeout=MOST_SECONDS)
    assert process.returncode != 0
    assert {row["status"] for row in rows(sweep.folder / "s.sqlite")} == {"pending"}
