"""Runs of spheres of different kinds, and of rough ones: resumed, verified, in every precision."""

import json

import h5py
import numpy as np
import pytest

from conftest import forged
from identity import differences
from test_resume import extended
from test_verify import findings, replayed

MIXTURE = """\
[system]
dimension = {dimension}
spheres = 120
restitution = 0.9
solids_volume_fraction = 0.3

[[species]]
name = "large"
diameter = 1.4
mass = 2.7
share = 0.5

[[species]]
name = "small"
diameter = 1
mass = 1
share = 0.5
{species}
[collision]
precision = "{precision}"
{collision}
[start]
arrangement = "random"
granular_temperature = 0.5
seed = 7

[drive]
{drive}

[run]
collisions = {collisions}

[output]
snapshot_interval = 0.13
"""
ROUGH = "tangential_restitution = 0.4\nfriction = 0.3"
VISCOELASTIC = 'restitution_law = "viscoelastic"\nviscoelastic_constant = 0.2'
FIXED_LOSS = 'restitution_law = "fixed-loss"\nenergy_loss = 0.1'
TWO_VALUED = ('restitution_law = "two-valued"\nslow_restitution = 0.95\nfast_restitution = 0.7\n'
              'threshold_speed = 0.8')
SHEAR = 'kind = "shear"\nshear_rate = 1'
KICKS = 'kind = "random"\nnoise_strength = 0.1\nkick_interval = 0.07'
WALLS = 'kind = "none"\n\n[walls]\naxis = "z"\nrestitution = 0.9\ntangential_restitution = 0.3\nupper_speed = 0.5'
FLAT_WALLS = WALLS.replace('"z"', '"y"')
PULL = "[gravity]\nacceleration = [0.2, 0, -1]"
FALLING = 'kind = "none"\n\n[walls]\naxis = "z"\nrestitution = 0.9\n\n' + PULL
FLAT_FALLING = FALLING.replace('"z"', '"y"').replace("[0.2, 0, -1]", "[0.2, -1]")
OBSTACLES = '[[species]]\nname = "peg"\ndiameter = 1.1\nspheres = 20\nimmobile = true\n'


def case(dimension=3, precision="double", collision=ROUGH, drive=SHEAR, species="", collisions=2000):
    text = MIXTURE.format(dimension=dimension, precision=precision, collision=collision, drive=drive,
                          species=species, collisions=collisions)
    if species == OBSTACLES:
        text = text.replace("share = 0.5", "spheres = 50")
    has_law = "restitution_law" in collision
    return text.replace("restitution = 0.9\nsolids", "solids") if has_law else text


def pair(restitution):
    """The large ones with a restitution of their own."""
    return f'[[contact]]\nbetween = ["large", "large"]\nrestitution = {restitution}'


SYSTEMS = {
    "rough": case(),
    "smooth": case(collision=""),
    "perfectly rough": case(collision='tangential_restitution = 1\nfriction = "unbounded"'),
    "shells": case(collision=ROUGH + "\nreduced_moment_of_inertia = 0.6666666666666667"),
    "rings": case(dimension=2, collision=ROUGH + "\nreduced_moment_of_inertia = 1"),
    "disks": case(dimension=2),
    "rods": case(dimension=1, collision="", drive='kind = "none"', collisions=400),
    "kicked": case(drive=KICKS),
    "between rough walls": case(drive=WALLS),
    "smooth between walls": case(drive=WALLS, collision=""),
    "disks between walls": case(dimension=2, drive=FLAT_WALLS),
    "constants of pairs": case(
        species='[[contact]]\nbetween = ["large", "small"]\nrestitution = 0.7\nfriction = 0'),
    "viscoelastic": case(collision=VISCOELASTIC),
    "rough and viscoelastic": case(collision=f"{VISCOELASTIC}\n{ROUGH}"),
    "viscoelastic disks": case(dimension=2, collision=VISCOELASTIC, species=pair(0.6)),
    "fixed loss": case(collision=FIXED_LOSS, species=pair(0.6)),
    "rough with a fixed loss": case(collision=f"{FIXED_LOSS}\n{ROUGH}"),
    "fixed loss in contacts that last": case(collision=f"{FIXED_LOSS}\ncontact_duration = 0.02"),
    "rods with a fixed loss": case(dimension=1, collision=FIXED_LOSS, drive='kind = "none"',
                                   collisions=400),
    "two values": case(collision=f"{TWO_VALUED}\ncontact_duration = 0.02", drive=WALLS),
    "viscoelastic in quad": case(precision="quad", collision=VISCOELASTIC, collisions=600),
    "fixed loss in quad": case(precision="quad", collision=FIXED_LOSS, collisions=600),
    "falling on obstacles": case(drive=FALLING, species=OBSTACLES),
    "falling on obstacles, smooth": case(drive=FALLING, species=OBSTACLES, collision=""),
    "disks falling on obstacles": case(dimension=2, drive=FLAT_FALLING, species=OBSTACLES),
    "falling past obstacles for ever": case(drive=FALLING.split("[walls]")[0] + PULL,
                                            species=OBSTACLES),
    "falling on obstacles in quad": case(precision="quad", drive=FALLING, species=OBSTACLES,
                                         collisions=400),
    "quad": case(precision="quad", collisions=600),
    "digits40": case(precision="digits40", collisions=300),
}


@pytest.fixture(params=SYSTEMS)
def system(request, program):
    program.case.write_text(SYSTEMS[request.param])
    return program


def test_sound_file_passes_with_its_sizes_masses_and_spins(system):
    summary, _ = system.keep()
    assert summary["ledger_error"] < 1e-10
    assert findings(system, code=0) == []
    assert replayed(system) > 0.9 * summary["collisions"]


def test_extended_run_holds_the_bits_of_one_that_ran_through(system):
    whole, path = system.keep((), "whole.h5")
    end = whole["collisions"]
    assert differences(extended(system, {}, [0, end // 3, end]), path) == []


def test_wrong_spin_is_found(program):
    program.case.write_text(SYSTEMS["rough"])
    _, path = program.keep()
    with forged(path) as run:
        spins = run["particles/spheres/angular_velocity/value"]
        spins[2, 17, 1] += 1e-6
    assert any("angular velocity of sphere 17" in line for line in findings(program))


def test_wrong_mass_is_found(program):
    program.case.write_text(SYSTEMS["smooth"])
    _, path = program.keep()
    with forged(path) as run:
        run["particles/spheres/mass"][5] *= 1.001
    assert findings(program) != []


def test_wrong_flag_of_sliding_is_found(program):
    program.case.write_text(SYSTEMS["rough"])
    _, path = program.keep()
    with forged(path) as run:
        flags = run["collisions/flags"]
        sliding = np.flatnonzero(flags[()] & 64)
        assert 0 < len(sliding) < len(flags)
        flags[sliding[10]] -= 64
    assert any("flag 64" in line for line in findings(program))


def test_log_tells_which_contacts_slide(program):
    program.case.write_text(SYSTEMS["perfectly rough"])
    _, path = program.keep()
    with h5py.File(path) as run:
        assert not np.any(run["collisions/flags"][()] & 64)


def test_temperatures_of_spins_and_kinds_are_told(program):
    program.case.write_text(SYSTEMS["rough"])
    summary = program.run()
    averages = summary["averages"]
    large, small = summary["species"]
    assert [large["name"], small["name"]] == ["large", "small"]
    assert large["spheres"] == small["spheres"] == 60
    mean = (large["granular_temperature"] + small["granular_temperature"]) / 2
    assert averages["granular_temperature"] == pytest.approx(mean, rel=1e-12)
    assert averages["rotational_temperature"] > 0


RODS = """\
[system]
dimension = 1
spheres = 3
restitution = 0.2
sides = [100]

[[species]]
name = "heavy"
diameter = 1
mass = 3
spheres = 2

[[species]]
name = "light"
diameter = 0.5
mass = 1
spheres = 1

[start]
arrangement = "given"
positions = [10, 12.02, 10.9]
velocities = [1, -0.2, 0]

[drive]
kind = "none"

[run]
time = 1
"""


@pytest.mark.parametrize("restitution, finding", [(0.203, "proven"), (0.2045, "near-collapse")])
def test_collapse_of_rods_of_two_kinds_is_proven(program, restitution, finding):
    """A rod between two of three times its mass: ((1 - sqrt(1 - b^2)) / b)^2 = 0.20378, b = 3/4."""
    program.case.write_text(RODS)
    done = program("adjudicate", "case.toml", "--json", "--set", f"system.restitution={restitution}")
    result = json.loads(done.stdout.splitlines()[-1])
    assert result["finding"] == finding
    assert "in exact fractions" in result["sentence"]


def test_collapse_of_disks_of_two_kinds_is_enclosed(program):
    """The same three, bent, as disks in the plane: singular, and followed with balls."""
    disks = RODS.replace("dimension = 1", "dimension = 2").replace("sides = [100]", "sides = [60, 60]")
    disks = disks.replace("[10, 12.02, 10.9]", "[[10, 10], [12.02, 10.003], [10.9, 10]]")
    disks = disks.replace("[1, -0.2, 0]", "[[1, 0], [-0.2, 0], [0, 0]]")
    program.case.write_text(disks)
    done = program("adjudicate", "case.toml", "--json", "--set", "system.restitution=0.15")
    result = json.loads(done.stdout.splitlines()[-1])
    assert result["finding"] == "singular"
    assert result["approaches"][0]["enclosed_to"] >= 50
    assert "ball arithmetic" in result["sentence"]
