"""What the tests of the compiled module share: a small case, and the program beside it."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
from processes import MOST_SECONDS  # tests/program

CHECKOUT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("ZENOSPHERE", CHECKOUT / "build" / "zenosphere")).resolve()
COSTS = {"wall_seconds", "collisions_per_second", "peak_memory_bytes"}

needed = pytest.mark.skipif(os.environ.get("ZENOSPHERE_MODULE", "1") == "0",
                            reason="built without pybind11: there is no compiled module")

SHEARED = {
    "system": {"dimension": 3, "spheres": 108, "restitution": 0.9, "solids_volume_fraction": 0.3},
    "start": {"arrangement": "fcc", "granular_temperature": 0.1, "seed": 7},
    "drive": {"kind": "shear", "shear_rate": 2.0},
    "collapse": {"window": 1000},
    "run": {"collisions": 2000},
}
COLLAPSING = {"system.restitution": 0.2, "drive.shear_rate": 1.0, "run.collisions": 200_000}
ENDLESS = {"run.collisions": 10**12}


def program(*words):
    """What the program prints; its exit code has to be 0."""
    return subprocess.run([PROGRAM, *words], check=True, capture_output=True, text=True,
                          timeout=MOST_SECONDS).stdout


def failure(*words):
    """Exit code and standard error of the program."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=MOST_SECONDS)
    return done.returncode, done.stderr.rstrip("\n")


def ran_by_program(case, output):
    """The summary of a case that the program has run in one go."""
    file = output.with_suffix(".toml")
    file.write_text(case.resolved)
    return json.loads(program("run", file, "--json", "-o", output).splitlines()[-1])


def without_costs(summary):
    return {key: value for key, value in summary.items() if key not in COSTS}


def joined(chunks):
    """All rows of the chunks; NumPy leaves out the padding between them."""
    return np.concatenate(list(chunks))


def same_rows(rows, others):
    """Whether two structured arrays hold the same bits, NaN included, whatever pads them."""
    return rows.dtype.names == others.dtype.names and all(
        rows[name].tobytes() == others[name].tobytes() for name in rows.dtype.names)
