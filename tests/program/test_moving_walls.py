"""Runs with walls that oscillate or are thermal: resumed, verified, recorded, refused."""

import h5py
import numpy as np
import pytest
from conftest import forged
from identity import differences
from test_resume import extended
from test_verify import findings, replayed

CASE = """\
[system]
dimension = {dimension}
spheres = {spheres}
restitution = 0.9
sides = {sides}

[collision]
precision = "{precision}"
{collision}

[start]
arrangement = "random"
granular_temperature = 0.5
seed = 7

[drive]
kind = "none"

[gravity]
acceleration = {gravity}

[walls]
axis = "{axis}"
restitution = 0.8
{walls}

[run]
collisions = {collisions}

[output]
snapshot_interval = 0.7
"""
SINE = 'motion = "sinusoidal"\namplitude = 0.4\nfrequency = 0.5'
PARABOLAS = SINE.replace("sinusoidal", "parabolic")
HOT = "lower_temperature = 2\nupper_temperature = 1"
HOT_ABOVE = SINE + "\nupper_temperature = 1\ntangential_restitution = 0.3\nlower_speed = 0.2"
ROUGH = "tangential_restitution = 0.4\nfriction = 0.3"
SIDES = {1: ("[30]", 8, "[-1]", "x"), 2: ("[6, 20]", 30, "[0, -1]", "y"),
         3: ("[4, 4, 15]", 30, "[0, 0, -1]", "z")}


def case(dimension=2, walls=SINE, precision="double", collision="", collisions=3000):
    sides, spheres, gravity, axis = SIDES[dimension]
    return CASE.format(dimension=dimension, walls=walls, precision=precision, collision=collision,
                       collisions=collisions, sides=sides, spheres=spheres, gravity=gravity,
                       axis=axis)


SYSTEMS = {
    "sine on a line": case(1), "sine in a plane": case(2), "sine in space": case(3),
    "parabolas": case(2, PARABOLAS), "thermal": case(3, HOT), "thermal on a line": case(1, HOT),
    "hot above": case(2, HOT_ABOVE), "rough": case(3, SINE, collision=ROUGH),
    "extended": case(2, SINE, "extended"), "quad": case(2, SINE, "quad", collisions=600),
    "thermal in quad": case(2, HOT, "quad", collisions=600),
    "digits50": case(1, SINE, "digits50", collisions=200),
}
SETTLED = """\
[system]
dimension = 1
spheres = 1
restitution = 1
sides = [10]
[start]
arrangement = "given"
positions = [0.6]
velocities = [0]
[drive]
kind = "none"
[gravity]
acceleration = [-1]
[walls]
axis = "x"
restitution = 0.5
motion = "sinusoidal"
amplitude = 0.3
frequency = 0.2
resting_flight = 1e-3
[run]
time = 12
[output]
snapshot_interval = 0.7
"""


@pytest.mark.parametrize("name", SYSTEMS)
def test_run_is_verified(program, name):
    program.case.write_text(SYSTEMS[name])
    summary = program.run((), "-o", "out.h5")
    assert replayed(program) == summary["collisions"]
    assert summary["ledger_error"] < 1e-11
    told = program("verify", "out.h5").stdout
    assert "beyond predictability   0\n" in told


@pytest.mark.parametrize("name", SYSTEMS)
def test_run_made_longer_has_the_same_bits(program, name):
    program.case.write_text(SYSTEMS[name])
    _, whole = program.keep()
    with h5py.File(whole) as run:
        collisions = len(run["collisions/k"])
    parts = extended(program, {}, [collisions // 3, collisions // 2 + 1, collisions])
    assert differences(whole, parts) == []


def test_run_that_is_stopped_between_collisions_goes_on_with_the_same_bits(program):
    program.case.write_text(SETTLED)
    _, whole = program.keep()
    program.keep({"run.time": 5.3}, "parts.h5")
    program("resume", "parts.h5", "--quiet", "--set", "run.time=12")
    assert differences(whole, program.folder / "parts.h5") == []


def test_a_ball_that_has_settled_is_marked_and_follows_the_plate(program):
    program.case.write_text(SETTLED)
    summary = program.run((), "-o", "out.h5")
    assert (summary["verdict"], summary["separation"]["hits"]) == ("none", 0)
    with h5py.File(program.folder / "out.h5") as run:
        rests = run["collisions/flags"][()] & 128 != 0
        times = run["particles/spheres/position/time"][()]
        places = run["particles/spheres/position/value"][:, 0, 0]
    assert rests.sum() > 1000
    plate = 0.3 * (1 - np.cos(2 * np.pi * 0.2 * times))
    assert np.abs(places - 0.5 - plate)[times > 6].max() < 1e-5
    assert findings(program, code=0) == []


@pytest.mark.parametrize("old, new", [
    ("amplitude = 0.4 ", "amplitude = 0.4000001 "), ("frequency = 0.5 ", "frequency = 0.5000001 "),
    ('motion = "sinusoidal" ', 'motion = "parabolic" ')])
def test_motion_of_another_wall_is_found(program, old, new):
    program.case.write_text(SYSTEMS["sine in a plane"])
    program.keep()
    with forged(program.folder / "out.h5") as run:
        text = run["zenosphere/resolved"][()].decode()
        assert old in text
        del run["zenosphere/resolved"]
        run["zenosphere/resolved"] = text.replace(old, new)
    assert findings(program) != []


def test_velocities_of_another_thermal_wall_are_found(program):
    program.case.write_text(SYSTEMS["thermal"])
    program.keep()
    with forged(program.folder / "out.h5") as run:
        text = run["zenosphere/resolved"][()].decode()
        assert "lower_temperature = 2.0 " in text
        del run["zenosphere/resolved"]
        run["zenosphere/resolved"] = text.replace("lower_temperature = 2.0 ",
                                                  "lower_temperature = 2.000001 ")
    assert findings(program) != []


@pytest.mark.parametrize("system", ["sine in a plane", "thermal"])
def test_output_is_exported_and_told(program, system):
    program.case.write_text(SYSTEMS[system])
    summary = program.run((), "-o", "out.h5")
    assert len(summary["averages"]["wall_work"]) == 2
    program("export", "out.h5", "--format", "csv-series", "-o", "series.csv")
    assert "wall_work_1" in (program.folder / "series.csv").read_text().splitlines()[0]
    assert "work of walls" in program("info", "out.h5").stdout


@pytest.mark.parametrize("old, new, words", [
    ("frequency = 0.5", "", ["missing", "walls.frequency"]),
    ("amplitude = 0.4", "", ["missing", "walls.amplitude"]),
    ('motion = "sinusoidal"\n', "", ["walls.amplitude", "only for a walls.motion"]),
    ('"sinusoidal"', '"sine"', ["walls.motion", '"sine"', '"sinusoidal"']),
    ("amplitude = 0.4", "amplitude = 9.6", ["walls.amplitude = 9.6", "use less than 9.5"]),
    ("amplitude = 0.4", "amplitude = 0", ["walls.amplitude = 0", "[1e-09"]),
    ("frequency = 0.5", "frequency = 0", ["walls.frequency = 0", "> 0"]),
    ("frequency = 0.5", "frequency = 1e9", ["walls.frequency", "clock", "unit of time"]),
    ("frequency = 0.5", "frequency = 0.5\nresting_flight = 0.1", ["resting_flight", "[0, 0.001]"]),
    ("frequency = 0.5", "frequency = 0.5\nresting_flight = 1e-9",
     ["walls.amplitude = 0.4", "gap_threshold", "walls.resting_flight to at least", "or 0"]),
    ("amplitude = 0.4", "amplitude = 1e-9",  # too small for the default
     ["walls.amplitude = 1e-09", "gap_threshold", "set walls.resting_flight to 0"]),
    ("frequency = 0.5", "frequency = 0.5\nlower_temperature = 1",
     ["walls.lower_temperature", "either oscillates or is thermal"]),
    ("frequency = 0.5", "frequency = 0.5\nupper_temperature = -1",
     ["walls.upper_temperature", "> 0"]),
])
def test_wrong_walls_are_told_in_one_line(program, old, new, words):
    text = SYSTEMS["sine in a plane"]
    assert old in text
    program.case.write_text(text.replace(old, new))
    lines = program.fail("check", "case.toml")
    assert all(word in lines[0] for word in words), lines


def test_thermal_walls_of_rough_spheres_are_refused(program):
    program.case.write_text(case(3, HOT, collision=ROUGH))
    lines = program.fail("check", "case.toml")
    assert len(lines) == 2 and "smooth spheres" in lines[0], lines


def test_a_plate_and_fixed_spheres_are_refused(program):
    text = SYSTEMS["sine in a plane"].replace("[gravity]\nacceleration = [0, -1]\n", "")
    species = '[[species]]\nname = "fixed"\ndiameter = 1\nshare = 1\nimmobile = true\n\n[start]'
    program.case.write_text(text.replace("[start]", species, 1))
    assert any("walls.motion" in line and "immobile" in line
               for line in program.fail("check", "case.toml"))
