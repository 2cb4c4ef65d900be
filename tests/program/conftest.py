"""The program as a user starts it, and a case small enough to run in some milliseconds."""

import contextlib
import json
import os
import subprocess
from pathlib import Path

import h5py
import pytest

from mixtures import MIXTURE
from processes import MOST_SECONDS, let_work, wait_for
from sweeps import SWEEP

CHECKOUT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("ZENOSPHERE", CHECKOUT / "build" / "zenosphere")).resolve()

CASE = """\
[system]
dimension = 3
spheres = 108
restitution = 0.9
solids_volume_fraction = 0.3

[start]
arrangement = "fcc"
granular_temperature = 0.1
seed = 7

[drive]
kind = "shear"
shear_rate = 2.0

[collapse]
window = 1000

[run]
collisions = 2000
"""


@contextlib.contextmanager
def forged(path):
    """An output open for changes that its checksums must not tell."""
    with h5py.File(path, "r+") as file:
        yield file
        file["zenosphere"].pop("checksums", None)


class Program:
    """Runs the program in a folder of its own; every call tells the exit code that it expects."""

    def __init__(self, folder):
        self.folder = folder
        self.case = folder / "case.toml"
        self.case.write_text(CASE)

    def __call__(self, *words, code=0, **options):
        done = subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, text=True,
                              errors="replace", timeout=MOST_SECONDS, **options)
        told = f"{words}: {done.returncode}\n{done.stdout}{done.stderr}"
        assert code in (None, done.returncode), told
        return done

    def redirected(self, target, *words):
        """Runs the program with its standard output going to `target`."""
        with open(target, "w") as output:
            return subprocess.run([PROGRAM, *words], cwd=self.folder, stdout=output, text=True,
                                  stderr=subprocess.PIPE, timeout=MOST_SECONDS)

    @staticmethod
    def command(*words):
        return [PROGRAM, *words]

    @staticmethod
    def words(changes):
        """`{"run.time": 3}` as the words `--set run.time=3`."""
        pairs = dict(changes).items()
        return [word for key, value in pairs for word in ("--set", f"{key}={value}")]

    def run(self, changes=(), *words, **options):
        """The summary of a run of the small case with some keys changed."""
        done = self("run", self.case.name, "--json", *self.words(changes), *words, **options)
        return json.loads(done.stdout.splitlines()[-1])

    def keep(self, changes=(), name="out.h5", **options):
        """The same, and the path of its output file."""
        return self.run(changes, "-o", name, **options), self.folder / name

    def fail(self, *words, code=2, **options):
        """The lines of standard error of a command that fails without printing anything else."""
        done = self(*words, code=code, **options)
        assert done.stdout == ""
        return done.stderr.splitlines()

    def start(self, changes=(), *words, stderr=subprocess.PIPE, **options):
        """A process that goes on until it is interrupted, once its output file is there and it has
        collisions: it has worked on."""
        settings = {"run.collisions": 10**12, "output.collision_log": "none", **dict(changes)}
        process = subprocess.Popen(
            [PROGRAM, "run", self.case.name, "-o", "out.h5", *self.words(settings), *words],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=stderr, text=True, **options)
        try:
            wait_for((self.folder / "out.h5").exists)
            let_work(process)
        except AssertionError:
            process.kill()
            raise
        return process

    def kill_with_journal(self, process, size=300_000):
        """Kills a process that writes out.h5 once its journal has so many bytes; the journal."""
        journal = self.folder / "out.h5.journal"
        wait_for(lambda: journal.exists() and journal.stat().st_size > size)
        process.kill()
        process.communicate()
        assert journal.stat().st_size > size
        return journal


@pytest.fixture
def program(tmp_path):
    return Program(tmp_path)


@pytest.fixture
def mixture(program):
    """The program in a folder with a mixture for its case."""
    program.case.write_text(MIXTURE)
    return program


@pytest.fixture
def sweep(program):
    """The program in a folder with a sweep of eight runs of the small case."""
    case = program.case.read_text().replace("collisions = 2000", "collisions = 1_000_000_000_000")
    program.case.write_text(case)
    (program.folder / "s.toml").write_text(SWEEP)
    return program


@pytest.fixture
def checkout():
    return CHECKOUT


@pytest.fixture(scope="session")
def sheared(tmp_path_factory):
    """Summary and file of a run over five strain units with snapshots at odd times."""
    program = Program(tmp_path_factory.mktemp("sheared"))
    return program.keep({"run.collisions": 10**6, "run.time": 2.53,
                         "output.snapshot_interval": 0.0917})


@pytest.fixture(scope="session")
def collapsed(tmp_path_factory):
    """Summary and file of a run that ends in a true collapse."""
    program = Program(tmp_path_factory.mktemp("collapsed"))
    return program.keep({"system.restitution": 0.2, "drive.shear_rate": 1,
                         "run.collisions": 200000})
