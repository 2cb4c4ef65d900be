"""`zenosphere verify`: sound files pass, and each kind of damage is found and named."""

import json

import h5py
import numpy as np
import pytest

from conftest import CHECKOUT, forged

EVERYTHING = ["--set", "output.snapshot_interval=0.05"]


@pytest.fixture
def finished(program):
    """A sheared run of 108 spheres, 2000 collisions and some ten snapshots."""
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING)
    return program.folder / "out.h5"


def findings(program, *words, code=2):
    """The lines about contradictions."""
    told = program("verify", "out.h5", *words, code=code).stdout
    return [line for line in told.splitlines() if line.startswith("out.h5: ")]


def replayed(program, file="out.h5"):
    """How many collisions could be followed."""
    for line in program("verify", file).stdout.splitlines():
        if line.startswith("  replayed"):
            return int(line.split()[1])
    raise AssertionError("nothing is said about the replay")


def changed(file, dataset, index, change):
    with forged(file) as run:
        run[dataset][index] = change(run[dataset][index])


def with_summary(file, **changes):
    """Writes other values into the summary; a value that is a dict changes part of an object."""
    with forged(file) as run:
        summary = json.loads(run["zenosphere/summary"][()])
        for key, value in changes.items():
            summary[key] = summary[key] | value if isinstance(value, dict) else value
        del run["zenosphere/summary"]
        run["zenosphere/summary"] = json.dumps(summary)


def without_row(file, row, renumbered):
    """Takes a row out of the log, with its number or as if it had never been."""
    with forged(file) as run:
        for column in run["collisions"].values():
            values = np.delete(column[()], row)
            column.resize(values.shape)
            column[:] = values
        if renumbered:
            run["collisions/k"][:] = np.arange(1, len(run["collisions/k"]) + 1)


def test_every_collision_of_a_sound_file_is_replayed(program, finished):
    assert replayed(program) == 2000
    assert findings(program, code=0) == []


def test_one_gap(program, finished):
    changed(finished, "collisions/gap", 700, lambda gap: gap + 1e-9)
    assert [line.split(" (")[0].split(": gap")[0] for line in findings(program)] == [
        "out.h5: collision 701"]


def test_one_index(program, finished):
    with h5py.File(finished) as run:
        i, j = run["collisions/i"][700], run["collisions/j"][700]
    other = next(n for n in range(i + 1, 108) if n != j)
    changed(finished, "collisions/j", 700, lambda _: other)
    assert findings(program)[0].startswith("out.h5: collision 700: gap")  # of the pair that follows
    assert findings(program)[1].startswith(f"out.h5: collision 701 of spheres {i} and {other}")


def test_an_index_that_no_sphere_has(program, finished):
    changed(finished, "collisions/j", 700, lambda _: 5000)
    assert "collision 701: i = " in findings(program)[0]


def test_one_time(program, finished):
    changed(finished, "collisions/time", 700, lambda time: time * (1 + 1e-9))
    assert "collision 701" in "".join(findings(program))


def test_one_normal_speed(program, finished):
    changed(finished, "collisions/normal_speed", 700, lambda speed: speed * (1 + 1e-9))
    assert "collision 701" in findings(program)[0] and "normal_speed" in findings(program)[0]


def test_one_flag(program, finished):
    changed(finished, "collisions/flags", 700, lambda flags: flags ^ 1)
    assert "collision 701: gap" in findings(program)[0]


@pytest.mark.parametrize("dataset", ["position", "velocity"])
def test_one_component_in_a_snapshot(program, finished, dataset):
    changed(finished, f"particles/spheres/{dataset}/value", (3, 17, 1), lambda value: value + 1e-9)
    assert "sphere 17" in findings(program)[0]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_image_of_a_sphere_in_a_snapshot(program, finished, axis):
    changed(finished, "particles/spheres/image/value", (3, 17, axis), lambda value: value + 1)
    assert "sphere 17 has the image" in findings(program)[0]


def test_a_missing_row(program, finished):
    without_row(finished, 700, renumbered=False)
    assert findings(program)[0].startswith("out.h5: collision 702: follows 700 in the log")


def test_a_missing_row_behind_which_all_are_renumbered(program, finished):
    without_row(finished, 700, renumbered=True)
    assert findings(program)[0].startswith("out.h5: collision 700: gap")


@pytest.mark.parametrize("key, value", [("collisions", 1999), ("time", 0.1), ("verdict", "open"),
                                        ("absorbed", 3), ("receding", 1)])
def test_a_number_of_the_summary(program, finished, key, value):
    with_summary(finished, **{key: value})
    assert key in "".join(findings(program))


@pytest.mark.parametrize("key, changes", [
    ("arrest.pairs", {"pairs": [[0, 1]]}),
    ("arrest.collision", {"collision": 1500}),
    ("arrest.met", {"met": False, "collision": None}),
    ("separation.hits", {"hits": 7}),
    ("separation.first_collision", {"first_collision": 7}),
    ("separation.last_time", {"last_time": 1.25}),
    ("separation.longest_pause", {"longest_pause": 0.5}),
])
def test_criteria_of_a_collapse_are_counted_again(program, key, changes):
    case = CHECKOUT / "examples" / "kadanoff-1999-bouncing-column.toml"
    program("run", case, "--quiet", "-o", "out.h5")
    assert findings(program, code=0) == []
    with_summary(program.folder / "out.h5", **{key.split(".")[0]: changes})
    assert key in "".join(findings(program))


def test_a_file_that_names_no_criteria_is_counted_by_those_of_older_versions(program):
    # Between two bounces the gap of an older file is 0, that of the floor.
    case = CHECKOUT / "examples" / "kadanoff-1999-bouncing-ball.toml"
    program("run", case, "--quiet", "-o", "out.h5")
    assert findings(program, code=0) == []
    with forged(program.folder / "out.h5") as run:
        assert run["zenosphere"].attrs["criteria_version"] == 2
        del run["zenosphere"].attrs["criteria_version"]
    assert "gap = 0.28125" in findings(program)[0]  # 0.75^2 / 2, the apex


@pytest.mark.parametrize("name", ["shear-e02", "van-noije-1999-2d-random-driving",
                                  "luding-mcnamara-1998-tc-shear",
                                  "brilliantov-poeschel-2000-viscoelastic-cooling",
                                  "rough-walls-2d-shear", "mcnamara-young-1992-1d-cooling",
                                  "kadanoff-1999-bouncing-ball", "haff-1983-cooling"])
def test_drives_walls_gravity_and_dimensions(program, name):
    program("run", CHECKOUT / "examples" / f"{name}.toml", "--quiet", "-o", "out.h5",
            "--set", "run.collisions=3000", "--set", "output.collision_log=all")
    with h5py.File(program.folder / "out.h5") as run:
        assert replayed(program) == len(run["collisions/k"])


HEXAGON_THAT_MEETS_AT_A_KICK = """
[system]
dimension = 2
spheres = 6
sides = [40, 40]
restitution = 1e-9
[start]
arrangement = "given"
positions = [[23.0, 20.0], [21.5, 22.598076211353316], [18.5, 22.598076211353316], [17.0, 20.0],
             [18.5, 17.401923788646684], [21.5, 17.401923788646684]]
velocities = [[-1, 0], [-0.5000000000000001, -0.8660254037844386],
              [0.4999999999999998, -0.8660254037844387], [1, 0],
              [0.5000000000000004, 0.8660254037844384], [-0.5000000000000001, 0.8660254037844386]]
[drive]
kind = "random"
noise_strength = 1e-20
kick_interval = 0.1
[run]
collisions = 3000
"""


# Collision 23 is an overlap that a kick at time 2 has made, and is set back to 4.7e-11 before it.
# From the first overlap on, collision 4, a kick so weak may have been behind any of them.
def test_collision_that_is_set_back_behind_a_kick_has_had_it(program):
    program.case.write_text(HEXAGON_THAT_MEETS_AT_A_KICK)
    program("run", "case.toml", "--quiet", "-o", "out.h5")
    with h5py.File(program.folder / "out.h5") as run:
        assert run["collisions/flags"][22] & 2 and 1.9999999999 < run["collisions/time"][22] < 2
    assert replayed(program) == 3


def test_clock_that_ends_before_a_logged_collision_has_been_set_back(program):
    run = ["run", "case.toml", "--quiet", "--set", "system.restitution=0.1"]
    program(*run, "-o", "long.h5", "--set", "run.collisions=3000")
    with h5py.File(program.folder / "long.h5") as file:
        back = np.flatnonzero(np.diff(file["collisions/time"][()]) < 0)[0] + 2  # collisions
    program(*run, "-o", "out.h5", "--set", f"run.collisions={back}")
    with h5py.File(program.folder / "out.h5") as file:
        assert file["collisions/time"][()].max() > file["collisions/time"][-1]
    program("verify", "out.h5")


@pytest.mark.parametrize("overlap", ["rewind", "immediate", "guarded", "stop"])
@pytest.mark.parametrize("precision", ["double", "extended", "quad", "digits30", "digits100"])
def test_overlap_rules_and_precisions(program, overlap, precision):
    program("run", "case.toml", "--quiet", "-o", "out.h5", "--set", "run.collisions=400",
            "--set", "system.restitution=0.1", "--set", f"collision.overlap={overlap}",
            "--set", f"collision.precision={precision}")
    with h5py.File(program.folder / "out.h5") as run:
        assert replayed(program) == len(run["collisions/k"]) > 0


LASTING = ["--set", "collision.contact_duration=0.02"]
WALLED = ["--set", "drive.kind=none", "--set", "drive.shear_rate=0", "--set", "walls.axis=z",
          "--set", "walls.restitution=0.8", "--set", "start.arrangement=random"]
VISCOELASTIC = ["--set", "collision.restitution_law=viscoelastic", "--set",
                "collision.viscoelastic_constant=0.3"]
TWO_VALUED = ["--set", "collision.restitution_law=two-valued", "--set",
              "collision.slow_restitution=0.7", "--set", "collision.fast_restitution=0.95", "--set",
              "collision.threshold_speed=1"]
FIXED_LOSS = ["--set", "collision.restitution_law=fixed-loss", "--set", "collision.energy_loss=0.1"]


@pytest.mark.parametrize("words", [LASTING, VISCOELASTIC, [*LASTING, *VISCOELASTIC],
                                   [*LASTING, *VISCOELASTIC, *WALLED], FIXED_LOSS,
                                   [*LASTING, *FIXED_LOSS, *WALLED],
                                   [*LASTING, *TWO_VALUED]])
def test_contact_models_are_replayed_and_counted(program, words):
    if any("restitution_law" in word for word in words):
        program.case.write_text(program.case.read_text().replace("restitution = 0.9\n", ""))
    summary = program.run((), *EVERYTHING, *words, "-o", "out.h5")
    assert replayed(program) == 2000
    assert (summary["contact"]["made_elastic"] > 0) == (LASTING[1] in words)
    with h5py.File(program.folder / "out.h5") as run:
        elastic = run["collisions/flags"][()] & 32 != 0
        row = int(np.flatnonzero(elastic)[-1]) if elastic.any() else 1000
    changed(program.folder / "out.h5", "collisions/flags", row, lambda flags: flags ^ 32)
    assert "contact.made_elastic" in "".join(findings(program))


def test_viscoelastic_constant_of_another_run(program):
    program.case.write_text(program.case.read_text().replace("restitution = 0.9\n", ""))
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING, *VISCOELASTIC)
    with forged(program.folder / "out.h5") as run:
        case = run["zenosphere/resolved"][()].decode()
        assert "viscoelastic_constant = 0.3 " in case
        del run["zenosphere/resolved"]
        run["zenosphere/resolved"] = case.replace("_constant = 0.3 ", "_constant = 0.3000001 ")
    assert findings(program) != []


def test_fixed_loss_of_another_run(program):
    program.case.write_text(program.case.read_text().replace("restitution = 0.9\n", ""))
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING, *FIXED_LOSS)
    with forged(program.folder / "out.h5") as run:
        case = run["zenosphere/resolved"][()].decode()
        assert "energy_loss = 0.1 " in case
        del run["zenosphere/resolved"]
        run["zenosphere/resolved"] = case.replace("energy_loss = 0.1 ", "energy_loss = 0.1000001 ")
    told = "".join(findings(program))
    assert "from where the log leads it" in told


def test_after_a_random_rotation_nothing_is_claimed_of_a_sphere(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING, "--set",
            "collision.rotation_angle=0.5")
    assert 0 < replayed(program) < 2000
    told = program("verify", "out.h5").stdout
    assert "random rotation (collision.rotation_angle): the angles are not in the file" in told
    assert "beyond predictability   0\n" in told


def test_a_windowed_log_is_replayed_from_the_snapshot_before_it(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING, "--set",
            "output.collision_log=window", "--set", "output.log_first=500", "--set",
            "output.log_last=1500")
    assert 0 < replayed(program) < 1001
    assert "the log does not hold every collision" in program("verify", "out.h5").stdout


def test_what_is_no_output_file_is_wrong_input(program):
    assert "is a case file" in program("verify", "case.toml", code=2).stderr
