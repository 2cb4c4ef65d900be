"""Runs that are cut off and resumed, or made longer: the same bits as a run that went through."""

import json
import os
import resource
import signal
import subprocess

import pytest
from conftest import forged
from identity import differences
from processes import MOST_SECONDS, has_worked, wait_for

LINE = {"system.dimension": 1, "system.spheres": 20, "start.arrangement": "random",
        "system.solids_volume_fraction": 0.5, "drive.kind": "none", "drive.shear_rate": 0,
        "run.collisions": 150}
KICKED = {"drive.kind": "random", "drive.shear_rate": 0, "drive.noise_strength": 0.1,
          "drive.kick_interval": 0.07}
FALLING = {"drive.kind": "none", "drive.shear_rate": 0, "walls.axis": "z", "walls.restitution": 0.9,
           "walls.upper_speed": 0.5, "gravity.acceleration": "[0.0, 0.1, -0.2]",
           "start.arrangement": "random", "system.solids_volume_fraction": 0.2}
COOLING = {"drive.kind": "none", "drive.shear_rate": 0, "system.restitution": 0.7}
COLLAPSING = {"system.restitution": 0.2, "drive.shear_rate": 1}
DISCS = {"system.dimension": 2, "start.arrangement": "random",
         "system.solids_volume_fraction": 0.4}
WINDOWED = {"output.collision_log": "window", "output.log_first": 700, "output.log_last": 1500}
LIMITS = {"run.collisions": 2000, "output.snapshot_interval": 0.13}

SYSTEMS = {
    "sheared": {}, "line": LINE, "kicked": KICKED, "falling": FALLING, "cooling": COOLING,
    "discs": DISCS, "windowed": WINDOWED, "unlogged": {"output.collision_log": "none"},
    "late averages": {"measure.after_time": 1.1},
    "immediate": {**COLLAPSING, "collision.overlap": "immediate"},
    "guarded": {**COLLAPSING, "collision.overlap": "guarded"},
    "rewind": {**COLLAPSING, "collision.overlap": "rewind"},
    "extended": {"collision.precision": "extended", **KICKED},
    "quad": {"collision.precision": "quad", "run.collisions": 700},
    "digits100": {"collision.precision": "digits100", "run.collisions": 200,
                  "system.spheres": 32, **COOLING},
    "digits20": {"collision.precision": "digits20", "run.collisions": 200, "system.spheres": 32},
    "digits250": {"collision.precision": "digits250", "run.collisions": 200,
                  "system.spheres": 32},
}


def extended(program, changes, stops, name="parts.h5"):
    """A run in pieces: made longer from one number of collisions to the next."""
    program.keep({**changes, "run.collisions": stops[0]}, name)
    for stop in stops[1:]:
        program("resume", name, "--quiet", "--set", f"run.collisions={stop}")
    return program.folder / name


@pytest.mark.parametrize("system", SYSTEMS)
def test_extended_run_holds_the_bits_of_one_that_ran_through(program, system):
    changes = {**LIMITS, **SYSTEMS[system]}
    end = changes["run.collisions"]
    _, whole = program.keep(changes, "whole.h5")
    parts = extended(program, changes, [0, end // 3, end // 3 + 1, end // 2, end])
    assert differences(parts, whole) == []
    assert sorted(os.listdir(program.folder)) == ["case.toml", "parts.h5", "whole.h5"]


# Four slow spheres: between two events the clock leaps over whole units, and over limits.
SLOW = {"system.spheres": 4, "system.solids_volume_fraction": 0.02, "output.snapshot_interval": 3.3,
        "start.granular_temperature": 0.02, "system.restitution": 0.999, "run.collisions": 10**9}


@pytest.mark.parametrize("system, times", [
    ({**COOLING, **SLOW}, [0, 3.3, 10.01, 57.7, 58.2, 300]), (KICKED, [0.05, 0.07, 0.69, 1]),
    ({}, [0.31, 1, 1.0000001, 2]), (FALLING, [0.3, 1.7, 2]), (LINE, [2, 40.5, 1000]),
])
def test_run_made_longer_in_time_holds_the_bits_of_one_that_ran_through(program, system, times):
    changes = {"output.snapshot_interval": 0.5, **system, "run.collisions": 10**9}
    _, whole = program.keep({**changes, "run.time": times[-1]}, "whole.h5")
    program.keep({**changes, "run.time": times[0]}, "parts.h5")
    for time in times[1:]:
        program("resume", "parts.h5", "--quiet", "--set", f"run.time={time}")
    assert differences(program.folder / "parts.h5", whole) == []


def test_bouncing_ball_that_leaps_goes_on_bit_for_bit(program, checkout):
    case = checkout / "examples" / "kadanoff-1999-bouncing-ball.toml"
    changes = ["--set", "output.snapshot_interval=0.17", "--set", "collapse.stop_when_collapsed=false"]
    program("run", case, "-o", "whole.h5", "--set", "run.time=2.7", *changes)
    program("run", case, "-o", "parts.h5", "--set", "run.time=0.63", *changes)
    program("resume", "parts.h5", "--set", "run.time=2.7")
    assert differences(program.folder / "parts.h5", program.folder / "whole.h5") == []


def file_size_limit(size):
    """What a child process does before it starts: no file of it grows beyond `size` bytes."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


@pytest.mark.parametrize("system", ["sheared", "kicked", "falling", "rewind", "windowed"])
def test_run_cut_off_again_and_again_ends_with_the_same_bits(program, system):
    changes = {**LIMITS, **SYSTEMS[system], "output.checkpoint_collisions": 7}
    _, whole = program.keep(changes, "whole.h5")
    words = ["run", "case.toml", "-o", "parts.h5", *program.words(changes)]
    size, cuts = 1_000_000, 0
    while program(*words, "--quiet", code=None, preexec_fn=file_size_limit(size)).returncode:
        told = json.loads(program("info", "parts.h5", "--json").stdout)["file"]
        assert not told["complete"]
        assert told["last_collision"] % 7 == 0 or told["last_collision"] == LIMITS["run.collisions"]
        words, size, cuts = ["resume", "parts.h5"], size + 500_000, cuts + 1
    assert cuts >= 3
    assert differences(program.folder / "parts.h5", whole) == []


def test_killed_run_goes_on_from_its_last_checkpoint(program):
    changes = {"run.collisions": 400000, "output.checkpoint_collisions": 500}
    _, whole = program.keep(changes, "whole.h5")
    program.kill_with_journal(program.start(changes | {"output.collision_log": "all"}))
    told = json.loads(program("info", "out.h5", "--json").stdout)["file"]
    assert not told["complete"] and told["last_collision"] % 500 == 0 < told["last_collision"]
    program("resume", "out.h5")
    assert differences(program.folder / "out.h5", whole) == []


def test_interrupted_run_goes_on_without_being_told_where_to(program):
    changes = {"run.collisions": 800000, "output.collision_log": "all"}
    _, whole = program.keep(changes, "whole.h5")
    process = program.start(changes)
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == 130
    program("resume", "out.h5")
    assert differences(program.folder / "out.h5", whole) == []


def test_resume_is_interrupted_as_a_run_is(program):
    program.keep({"run.collisions": 100})
    process = subprocess.Popen(
        program.command("resume", "out.h5", "--json", "--set", f"run.collisions={10**12}"),
        cwd=program.folder, stdout=subprocess.PIPE, text=True)
    wait_for(lambda: has_worked(process.pid, 0.5))  # it has begun long ago
    process.send_signal(signal.SIGTERM)
    summary = json.loads(process.communicate()[0])
    assert process.returncode == 130 and summary["outcome"] == "interrupted"
    program("resume", "out.h5", "--set", f"run.collisions={summary['collisions'] + 50}")
    _, whole = program.keep({"run.collisions": summary["collisions"] + 50}, "whole.h5")
    assert differences(program.folder / "out.h5", whole) == []


def test_collapsed_run_goes_on_where_it_may(program):
    changes = {**COLLAPSING, "run.collisions": 200000}
    summary, _ = program.keep(changes)
    assert summary["ended_by"] == "arrest"
    end = summary["collisions"] + 3000
    further = {"collapse.stop_when_collapsed": "false", "run.collisions": end}
    done = program("resume", "out.h5", "--json", "--fail-on-collapse", *program.words(further), code=3)
    assert json.loads(done.stdout)["collisions"] == end
    _, whole = program.keep({**changes, **further}, "whole.h5")
    assert differences(program.folder / "out.h5", whole) == []


def test_summary_counts_the_whole_run(program):
    program.keep({"run.collisions": 1000})
    done = program("resume", "out.h5", "--json", "--set", "run.collisions=2000")
    summary, whole = json.loads(done.stdout), program.run()
    costs = {"wall_seconds", "collisions_per_second", "peak_memory_bytes"}
    assert {k: v for k, v in summary.items() if k not in costs} == \
        {k: v for k, v in whole.items() if k not in costs}


def test_resume_of_a_start_from_a_file_needs_the_file_no_more(program):
    program.keep({"run.collisions": 10, "drive.shear_rate": 0}, "start.h5")
    changes = {"start.arrangement": "file", "start.file": "start.h5", "drive.shear_rate": 0}
    _, whole = program.keep(changes, "whole.h5")
    program.keep({**changes, "run.collisions": 700}, "out.h5")
    (program.folder / "start.h5").unlink()
    program("resume", "out.h5", "--set", "run.collisions=2000")
    assert differences(program.folder / "out.h5", whole) == []


@pytest.mark.parametrize("changes, words, part", [
    ({}, [], "run.collisions = 2000 is reached"),
    ({}, ["--set", "run.collisions=2000"], "raise it"),
    ({}, ["--set", "run.collisions=3000", "--set", "run.time=0.5"], "run.time = 0.5 is reached"),
    ({"run.time": 0.5}, [], "run.time = 0.5 is reached"),
    ({}, ["--set", "system.restitution=0.5"], "--set system.restitution=0.5: cannot be changed"),
    ({}, ["--set", "run.colisions=3000"], "--set run.colisions=3000: "),
    ({}, ["--set", "run.collisions=many"], "--set run.collisions=many: "),
    ({**COLLAPSING, "run.collisions": 200000}, [], "stop_when_collapsed=false"),
    ({**COLLAPSING, "collision.overlap": "stop", "run.collisions": 200000}, [], "overlap"),
])
def test_run_that_cannot_go_on_says_why(program, changes, words, part):
    program.keep(changes)
    before = (program.folder / "out.h5").read_bytes()
    (line,) = program.fail("resume", "out.h5", *words)
    assert part in line
    assert (program.folder / "out.h5").read_bytes() == before
    assert sorted(os.listdir(program.folder)) == ["case.toml", "out.h5"]


def test_output_without_a_checkpoint_says_so(program):
    program.keep()
    with forged(program.folder / "out.h5") as file:
        del file["zenosphere/checkpoint"]
    (line,) = program.fail("resume", "out.h5", "--set", "run.collisions=3000")
    assert line.startswith("out.h5: holds no checkpoint")


@pytest.mark.parametrize("change, part", [
    (lambda state: state[:-1], "damaged"), (lambda state: b"", "damaged"),
    (lambda state: b"\x63" + state[1:], "damaged"),  # the checksum is another one
])
def test_damaged_checkpoint_is_one_line(program, change, part):
    program.keep()
    with forged(program.folder / "out.h5") as file:
        state = file["zenosphere/checkpoint/state"][()].tobytes()
        file["zenosphere/checkpoint/state"].resize((len(change(state)),))
        file["zenosphere/checkpoint/state"][()] = list(change(state))
    (line,) = program.fail("resume", "out.h5", "--set", "run.collisions=3000")
    assert line.startswith("out.h5: ") and part in line


@pytest.mark.parametrize("name", ["nowhere", "case.toml", "folder"])
def test_resume_of_what_is_no_output_is_one_line_and_leaves_nothing(program, name):
    (program.folder / "folder").mkdir()
    (line,) = program.fail("resume", name)
    assert line.startswith(f"{name}: ")
    assert sorted(os.listdir(program.folder)) == ["case.toml", "folder"]


def test_output_that_a_run_writes_is_not_resumed_or_overwritten(program):
    process = program.start()
    for words in (["resume", "out.h5"], ["run", "case.toml", "--quiet", "-o", "out.h5", "--overwrite"]):
        (line,) = program.fail(*words, code=4)
        assert "another run writes this output" in line
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode == 130


def test_output_that_is_moved_away_ends_the_run_at_once(program):
    process = program.start()
    (program.folder / "out.h5").rename(program.folder / "moved.h5")
    _, errors = process.communicate(timeout=MOST_SECONDS)
    assert process.returncode == 4 and "no longer there" in errors
    assert program("info", "moved.h5").returncode == 0


def test_info_tells_the_state_of_a_killed_run_at_its_last_checkpoint(program):
    program.kill_with_journal(program.start({"output.checkpoint_collisions": 1000}))
    before = {path.name: path.read_bytes() for path in program.folder.iterdir()}
    told = json.loads(program("info", "out.h5", "--json").stdout)
    assert told["collisions"] == told["file"]["last_collision"] > 0
    assert told["outcome"] == "unfinished" and told["file"]["complete"] is False
    text = program("info", "out.h5").stdout
    assert text.startswith("Unfinished: ") and f"zenosphere resume out.h5" in text
    assert {path.name: path.read_bytes() for path in program.folder.iterdir()} == before


def test_run_that_a_self_check_ended_is_not_resumed(program):
    program.keep()
    with forged(program.folder / "out.h5") as file:
        summary = json.loads(file["zenosphere/summary"][()])
        summary["self_check"] = "after collision 7: the energy ledger is open"
        del file["zenosphere/summary"]
        file["zenosphere/summary"] = json.dumps(summary)
    (line,) = program.fail("resume", "out.h5", "--set", "run.collisions=3000")
    assert line.startswith("out.h5: was ended by a self-check, after collision 7: the energy")


def test_run_made_longer_and_killed_before_its_first_checkpoint_is_resumed(program):
    program.keep()
    process = subprocess.Popen(
        program.command("resume", "out.h5", "--set", f"run.collisions={10**12}"),
        cwd=program.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    program.kill_with_journal(process, size=0)
    program("resume", "out.h5", "--set", "run.collisions=3000")
    assert json.loads(program("info", "out.h5", "--json").stdout)["collisions"] == 3000
