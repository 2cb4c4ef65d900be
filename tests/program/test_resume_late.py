"""A run that is resumed late has the bits of an uninterrupted one: strides, frames and leaps too."""

import h5py
import numpy as np
import pytest

COOLING = """\
[system]
dimension = 3
spheres = 108
restitution = 0.8
solids_volume_fraction = 0.1
[start]
arrangement = "fcc"
granular_temperature = 1.0
seed = 1
[drive]
kind = "none"
[run]
"""
FALLING = """\
[system]
dimension = 2
spheres = 32
restitution = 0.9
solids_volume_fraction = 0.1
[start]
arrangement = "random"
granular_temperature = 1.0
seed = 1
[drive]
kind = "none"
[gravity]
acceleration = [-0.5, 0]
[run]
"""
PASSING = """\
[system]
dimension = 2
spheres = 2
restitution = 1
sides = [10, 10]
[start]
arrangement = "given"
positions = [[2, 2], [7, 7]]
velocities = [[1, 1e-7], [0.5, 0]]
[drive]
kind = "none"
[run]
"""


def bits(path):
    with h5py.File(path) as file:
        log = {name: file["collisions"][name][()] for name in ("time", "i", "j", "gap")}
        frames = file["particles/spheres"]
        return log, {name: frames[name]["value"][-1] for name in ("position", "velocity")}


@pytest.mark.parametrize("case, key, stops", [
    (COOLING, "run.collisions", (12000, 20000)),  # strides from 1 to millions of units
    (FALLING, "run.time", (3, 8)),  # a frame that falls
    (PASSING, "run.time", (2e7, 9e7)),  # in the middle of a leap, in a frame that drifts
])
def test_resumed_run_has_the_bits_of_an_uninterrupted_one(program, case, key, stops):
    program.case.write_text(case + f"{key.split('.')[1]} = {stops[1]}\n")
    program("run", program.case.name, "-o", "whole.h5")
    program("run", program.case.name, "-o", "parts.h5", "--set", f"{key}={stops[0]}")
    program("resume", "parts.h5", "--set", f"{key}={stops[1]}")
    whole, parts = (bits(program.folder / name) for name in ("whole.h5", "parts.h5"))
    for one, other in zip(whole, parts):
        for name in one:
            np.testing.assert_array_equal(one[name], other[name], err_msg=name)
    assert len(whole[0]["time"]) > 0
