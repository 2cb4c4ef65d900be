"""The programs that are compared: how each is started, and how its output is understood.

A program is one command with placeholders and one adapter. The adapter turns the output of the
command into collisions and the seconds of processor time that they took. A peer is known by the
format of its output alone: nothing here builds, fetches or contains one.
"""

import bz2
import contextlib
import json
import math
import os
import pathlib
import re
import shlex
import signal
import subprocess
import tempfile
from dataclasses import dataclass
from xml.etree import ElementTree


OURS = "Zenosphere"


class BenchError(Exception):
    """Something that the reader of the message can mend."""


@dataclass(frozen=True)
class State:
    """What is simulated: unit spheres in a periodic cube, granular temperature 1 at the start; or
    disks in a square."""

    spheres: int
    fraction: float
    restitution: float = 1.0
    shear_rate: float = 0.0
    start: str = "fcc"  # or "random"
    dimension: int = 3

    @staticmethod
    def parse(text):
        """The state that `N,phi[,e,shear rate][,random]` names."""
        words = text.split(",")
        start = words.pop() if words[-1] in ("fcc", "random") else "fcc"
        try:
            if len(words) not in (2, 3, 4):
                raise ValueError
            return State(int(words[0]), *map(float, words[1:]), start=start)
        except ValueError:
            raise BenchError(f"state {text!r} (must be N,phi[,e,shear rate][,fcc or random]); "
                             "for instance 4000,0.3,0.9,1") from None

    def __str__(self):
        flow = f"sheared, e {self.restitution:g}" if self.shear_rate else (
            "elastic" if self.restitution == 1 else f"cooling, e {self.restitution:g}")
        start = ", random start" if self.start == "random" else ""
        disks = "disks, " if self.dimension == 2 else ""
        return f"{disks}{flow}, phi {self.fraction:g}, N {self.spheres}{start}"

    def is_elastic(self):
        return self.restitution == 1 and self.shear_rate == 0

    def expected_time(self, collisions):
        """Time in which an elastic fluid at temperature 1 makes so many collisions.

        Source: Enskog's rate 4 n g sqrt(pi T) with Carnahan & Starling, J. Chem. Phys. 51 (1969)
        635. It sets the length of a run; nothing is computed with it.
        """
        phi = self.fraction
        contact_value = (1 - phi / 2) / (1 - phi) ** 3
        rate = 4 * (6 * phi / math.pi) * contact_value * math.sqrt(math.pi)
        return 2 * collisions / (self.spheres * rate)


@dataclass(frozen=True)
class Output:
    """What one run of a command left behind."""

    text: str  # of its standard output
    user_seconds: float  # processor time of it and its children, outside the kernel
    system_seconds: float  # likewise, in the kernel
    folder: pathlib.Path  # where it ran


@dataclass(frozen=True)
class Reading:
    """What an adapter understood."""

    collisions: int
    user_seconds: float


def last_json(text):
    """The JSON object on the last line that holds one."""
    for line in reversed(text.splitlines()):
        if line.startswith("{"):
            return json.loads(line)
    raise BenchError("no line of JSON in the output")


def read_bench(output):
    """bench_collisions, ours: counts and times the loop itself, after its own warm-up."""
    values = last_json(output.text)
    return Reading(values["collisions"], values["user_seconds"])


def read_zenosphere(output):
    """`zenosphere run --json`: collisions from the start; here writing to the disk counts too."""
    return Reading(last_json(output.text)["collisions"],
                   output.user_seconds + output.system_seconds)


def read_edmd(output):
    """EDMD: collisions so far, in the lines that it prints now and then, or in a total."""
    counts = re.findall(r"[Cc]ollisions: (\d+)", output.text)
    if not counts:
        raise BenchError("no 'Collisions: ' in the output of EDMD")
    return Reading(int(counts[-1]), output.user_seconds)


def read_dynamo(output):
    """DynamO: pair events in its output.xml.bz2; crossings of cells are events of another kind."""
    with bz2.open(output.folder / "output.xml.bz2") as file:
        duration = ElementTree.parse(file).getroot().find(".//Duration")
    return Reading(int(duration.get("TwoParticleEvents")), output.user_seconds)


READERS = {"bench": read_bench, "zenosphere": read_zenosphere, "edmd": read_edmd,
           "dynamo": read_dynamo}
ELASTIC_ONLY = {"edmd"}
SELF_TIMED = {"bench"}


def run_in(folder, words):
    """Runs a command in a folder of its own and returns its Output."""
    with open(folder / "stdout", "w") as stdout, open(folder / "stderr", "w") as stderr:
        try:
            process = subprocess.Popen(words, cwd=folder, stdout=stdout, stderr=stderr,
                                       stdin=subprocess.DEVNULL)
        except OSError as error:
            raise BenchError(f"{words[0]}: could not be started ({error.strerror})") from None
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        told = (folder / "stderr").read_text(errors="replace").strip().splitlines()
        raise BenchError(f"{shlex.join(map(str, words))}: exit code {process.returncode}"
                         + (f" ({told[-1]})" if told else ""))
    text = (folder / "stdout").read_text(errors="replace")
    return Output(text, usage.ru_utime, usage.ru_stime, folder)


@contextlib.contextmanager
def companions(count, words):
    """Copies of a command, each over and over again, that keep other cores busy meanwhile."""
    loop = f"while :; do {shlex.join(map(str, words))} > /dev/null 2>&1; done"
    with contextlib.ExitStack() as folders:
        loops = []
        try:
            for _ in range(count):
                folder = folders.enter_context(tempfile.TemporaryDirectory())
                loops.append(subprocess.Popen(["sh", "-c", loop], cwd=folder,
                                              stdin=subprocess.DEVNULL, start_new_session=True))
            yield
        finally:
            for one in loops:
                os.killpg(one.pid, signal.SIGKILL)
                one.wait()


@dataclass(frozen=True)
class Program:
    """A program under measurement."""

    name: str
    adapter: str
    command: str
    most_spheres: float = math.inf  # larger states are left out
    copies: int = 1  # that run at once, of which one is measured

    @staticmethod
    def parse(text):
        """The program that `NAME[<=N]=ADAPTER:COMMAND` describes."""
        match = re.fullmatch(r"\s*([^=<]+?)\s*(?:<=\s*([\d.e+]+))?\s*=(\w+):(.+)", text)
        if not match or match[3] not in READERS:
            raise BenchError(f"program {text!r} (must be NAME=ADAPTER:COMMAND); adapters are "
                             + ", ".join(READERS))
        return Program(match[1], match[3], match[4], float(match[2] or math.inf))

    def can_run(self, state):
        if state.spheres > self.most_spheres:
            return False
        if state.dimension != 3 and not re.search(r"\{(dimension|case)\}", self.command):
            return False
        if state.start == "random" and not re.search(r"\{(start|start_file|case)\}", self.command):
            return False
        return self.adapter not in ELASTIC_ONLY or state.is_elastic()

    def words(self, state, warm_up, collisions, files):
        """The command for a run of so many collisions after so many others."""
        total = collisions if self.adapter in SELF_TIMED else warm_up + collisions
        values = dict(vars(state), warm_up=warm_up, collisions=total,
                      time=f"{state.expected_time(warm_up + collisions):.6g}", **files)
        try:
            words = [word.format(**values) for word in shlex.split(self.command)]
        except KeyError as error:
            raise BenchError(f"{self.name}: unknown placeholder {error}; there are "
                             + ", ".join(f"{{{key}}}" for key in values)) from None
        return [word for word in words if word]

    def run(self, state, warm_up, collisions, files):
        """One run of the command, understood."""
        words = self.words(state, warm_up, collisions, files)
        with tempfile.TemporaryDirectory() as folder:
            with companions(self.copies - 1, words):
                output = run_in(pathlib.Path(folder), words)
            try:
                return READERS[self.adapter](output)
            except (OSError, EOFError, LookupError, ValueError, AttributeError,
                    ElementTree.ParseError) as error:
                raise BenchError(f"{self.name}: its output is not what the adapter "
                                 f"{self.adapter} expects ({error})") from None

    def collisions_per_second(self, state, warm_up, collisions, files):
        """Collisions per second of user time in the state that the warm-up leads to.

        A program that does not time its own loop runs twice, once for the warm-up alone; what the
        longer run has more of both is what counts. Start-up and melting drop out of it.
        """
        run = self.run(state, warm_up, collisions, files)
        short = Reading(0, 0.0) if self.adapter in SELF_TIMED else (
            self.run(state, warm_up, 0, files))
        seconds = run.user_seconds - short.user_seconds
        if not (seconds > 0 and run.collisions > short.collisions):
            raise BenchError(f"{self.name}: the longer run took no longer ({run.user_seconds:.3f} s"
                             f" against {short.user_seconds:.3f} s); raise --collisions")
        return (run.collisions - short.collisions) / seconds


def bare_loop(build):
    """Zenosphere without anything that observes the collisions."""
    return Program(OURS, "bench", shlex.quote(str(build.resolve() / "bench_collisions"))
                   + " --dimension {dimension} --spheres {spheres} --fraction {fraction}"
                   " --restitution {restitution} --shear-rate {shear_rate} --start {start}"
                   " --warm-up {warm_up} --collisions {collisions}")


def recorded_run(build):
    """Zenosphere with both criteria, all averages, and every collision written to a file."""
    return Program(OURS + ", recorded", "zenosphere",
                   shlex.quote(str(build.resolve() / "zenosphere"))
                   + " run {case} -o out.h5 --quiet --json --set run.collisions={collisions}")
