"""Trials: programs take turns, so that a noisy machine is noisy for all of them alike."""

import datetime
import os
import pathlib
import statistics
import subprocess
import tempfile
from dataclasses import dataclass

from starts import files_for

ROOT = pathlib.Path(__file__).resolve().parent.parent


@dataclass(frozen=True)
class Trial:
    """One measurement of one program."""

    state: object
    round: int
    program: str
    rate: float  # collisions per second


@dataclass(frozen=True)
class Length:
    """How long a trial is, in collisions per sphere; short runs of few spheres are no measurement.

    Ten collisions per sphere melt the lattice at phi <= 0.45; five and a half are one unit of
    strain at e = 0.9 and phi = 0.3, so that the work done once in each such unit is in the count.
    """

    warm_up: float = 10
    measured: float = 11
    least: int = 400_000  # measured collisions, about half a second
    most: int = 6_000_000
    most_warm_up: int = 20_000_000  # 4 for each of ten million spheres, which takes minutes

    def collisions(self, spheres):
        """Collisions of the warm-up and of the measurement."""
        wanted = max(self.least, min(self.most, self.measured * spheres / 2))
        return int(min(self.most_warm_up, self.warm_up * spheres / 2)), int(wanted)


def alternate(programs, states, rounds, length, zenosphere, done=()):
    """Yields trials: in every round each state once, and in each state every program that can.

    `done` holds (state, round, name of program) of trials to leave out.
    """
    numbers = range(1, rounds + 1)
    able = {state: [program for program in programs if program.can_run(state)
                    and any((state, number, program.name) not in done for number in numbers)]
            for state in states}
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        for place, state in enumerate(states):
            home = pathlib.Path(folder) / str(place)
            home.mkdir()
            files[state] = files_for(state, home, able[state], zenosphere)
        for number in numbers:
            for state in states:
                warm_up, measured = length.collisions(state.spheres)
                for program in able[state]:
                    if (state, number, program.name) not in done:
                        rate = program.collisions_per_second(state, warm_up, measured, files[state])
                        yield Trial(state, number, program.name, rate)


@dataclass(frozen=True)
class Spread:
    """Median, least and most of some numbers."""

    median: float
    least: float
    most: float

    @staticmethod
    def of(numbers):
        return Spread(statistics.median(numbers), min(numbers), max(numbers))

    def __str__(self):
        return f"{self.median:#.3g} ({self.least:#.3g}-{self.most:#.3g})"


def rates(trials, state, program):
    """Collisions per second of a program in a state, by round."""
    return {trial.round: trial.rate for trial in trials
            if trial.state == state and trial.program == program}


def ratio(above, below):
    """Spread of the ratios of two programs, each within one round."""
    return Spread.of([above[number] / below[number] for number in above if number in below])


def machine():
    """The class of this machine, in words that say nothing else about it."""
    facts = dict.fromkeys(("vendor_id", "cpu family", "model"), "unknown")
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        key, _, value = line.partition(":")
        if key.strip() in facts:
            facts[key.strip()] = value.strip()
    return (f"{facts['vendor_id']} family {facts['cpu family']} model {facts['model']}"
            f" {os.cpu_count()} cores")


def commit():
    """The commit of this checkout, with a + where files differ from it."""
    def git(*words):
        done = subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True)
        return done.stdout.strip() if done.returncode == 0 else ""
    changed = git("status", "--porcelain", "--untracked-files=no", "--", "src", "bench",
                  ":!bench/*.csv", "CMakeLists.txt")
    return (git("rev-parse", "--short=9", "HEAD") or "unknown") + ("+" if changed else "")


def compiler(build):
    """The compiler that a build folder was configured with."""
    for path in sorted(pathlib.Path(build).glob("CMakeFiles/*/CMakeCXXCompiler.cmake")):
        facts = dict(line[4:].rstrip(")").split(" ", 1) for line in path.read_text().splitlines()
                     if line.startswith("set(CMAKE_CXX_COMPILER_") and " " in line)
        name = facts.get("CMAKE_CXX_COMPILER_ID", '"unknown"').strip('"')
        return name + " " + facts.get("CMAKE_CXX_COMPILER_VERSION", '""').strip('"')
    return "unknown"


def today():
    return datetime.date.today().isoformat()
