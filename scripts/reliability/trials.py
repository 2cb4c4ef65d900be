"""What the scripts of this folder share: systems to run, and how a trial is judged."""

import argparse
import json
import os
import pathlib
import random
import subprocess
import sys

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("ZENOSPHERE", CHECKOUT / "build" / "zenosphere")).resolve()
sys.path.insert(0, str(CHECKOUT / "tests" / "program"))
from identity import differences  # noqa: E402

CASE = """\
[system]
dimension = {dimension}
spheres = {spheres}
restitution = {restitution}
solids_volume_fraction = 0.3
[start]
arrangement = "{arrangement}"
granular_temperature = 0.1
seed = {seed}
[drive]
kind = "{kind}"
{drive}
[collision]
overlap = "{overlap}"
precision = "{precision}"
[collapse]
window = 1000
stop_when_collapsed = false
[run]
collisions = {collisions}
[output]
snapshot_interval = 0.2
checkpoint_collisions = {cadence}
{extra}
"""
SHEARED = {"dimension": 3, "spheres": 500, "restitution": 0.8, "arrangement": "fcc", "kind": "shear",
           "drive": "shear_rate = 1.0", "overlap": "rewind", "precision": "double",
           "collisions": 40000, "cadence": 400, "extra": ""}
# Its checkpoints are so large and so many that the journal is folded several times.
FOLDING = {**SHEARED, "spheres": 4000, "collisions": 60000, "cadence": 150}
COLLAPSING = {**SHEARED, "spheres": 108, "restitution": 0.2, "cadence": 200}  # arrested in the end
KICKED = {**SHEARED, "dimension": 2, "spheres": 300, "arrangement": "random", "kind": "random",
          "drive": "noise_strength = 0.1\nkick_interval = 0.05", "overlap": "guarded"}
FALLING = {**SHEARED, "spheres": 200, "arrangement": "random", "kind": "none", "drive": "",
           "overlap": "immediate", "collisions": 20000,
           "extra": '[walls]\naxis = "z"\nrestitution = 0.95\n[gravity]\n'
                    "acceleration = [0.0, 0.0, -0.1]"}
QUAD = {**SHEARED, "spheres": 32, "precision": "quad", "collisions": 3000, "cadence": 40}
SYSTEMS = {"sheared": SHEARED, "folding": FOLDING, "collapsing": COLLAPSING, "kicked": KICKED,
           "falling": FALLING, "quad": QUAD}


def arguments(text, default_trials):
    """The command line of a script: how many trials, which random numbers, where."""
    parser = argparse.ArgumentParser(description=text)
    parser.add_argument("trials", type=int, nargs="?", default=default_trials)
    parser.add_argument("--seed", type=int, default=1, help="of the random moments")
    parser.add_argument("--system", choices=SYSTEMS, help="this one only")
    return parser.parse_args()


def run(*words, folder, **options):
    """A finished process of the program, whatever its exit code."""
    return subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True, **options)


def start(*words, folder, **options):
    """A process of the program that goes on beside us."""
    return subprocess.Popen([PROGRAM, *words], cwd=folder, stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL, **options)


class Reference:
    """A system's case, and the output of its run that was not disturbed."""

    def __init__(self, name, folder):
        self.name = name
        self.case = folder / f"{name}.toml"
        self.output = folder / f"{name}.h5"
        self.case.write_text(CASE.format(seed=7, **SYSTEMS[name]))
        done = run("run", self.case, "-o", self.output, "--json", folder=folder)
        if done.returncode != 0:
            raise SystemExit(f"{name}: {done.stderr}")
        self.seconds = json.loads(done.stdout)["wall_seconds"]


def references(options, folder):
    """The undisturbed runs of the systems asked for, by turns and for ever."""
    names = [options.system] if options.system else list(SYSTEMS)
    made = [Reference(name, folder) for name in names]
    number = 0
    while True:
        yield made[number % len(made)]
        number += 1


def problem_of(output, reference):
    """What is wrong with a resumed output, or None if it holds the same bits."""
    unlike = differences(output, reference.output)
    left = [path.name for path in output.parent.iterdir() if path.name.startswith(output.name + ".")]
    if unlike:
        return f"differs in {', '.join(unlike)}"
    return f"left {', '.join(left)} behind" if left else None


def info(output):
    """What `zenosphere info` knows of an output, or None where it cannot be read."""
    done = run("info", output, "--json", folder=output.parent)
    return json.loads(done.stdout)["file"] if done.returncode == 0 else None


def dice(options):
    return random.Random(options.seed)
