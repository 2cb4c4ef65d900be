"""The four overlap rules, and that the log, its flags and the summary tell the same."""

import h5py
import numpy as np
import pytest

RULES = ["rewind", "immediate", "guarded", "stop"]
COLLAPSING = {"system.restitution": 0.2, "drive.shear_rate": 1, "run.collisions": 50000,
              "start.granular_temperature": 6e-3}
HIT, OVERLAP, ABSORBED, RECEDING, CLOCK_STOOD = 1, 2, 4, 8, 16


def read_log(path):
    with h5py.File(path) as file:
        return {name: file["collisions"][name][()] for name in file["collisions"]}


def has(log, flag):
    return (log["flags"] & flag) != 0


def rule(name, **more):
    return {**COLLAPSING, "collision.overlap": name, **more}


@pytest.mark.parametrize("name", RULES)
def test_every_rule_runs_and_sees_the_hits(program, name):
    summary, path = program.keep(rule(name, **{"system.spheres": 256}))
    assert summary["outcome"] == ("finished" if name == "stop" else "collapsed")
    assert summary["separation"]["hits"] > 0
    assert len(read_log(path)["k"]) == summary["collisions"] > 100


@pytest.mark.parametrize("name", RULES)
def test_flags_agree_with_the_counts_of_the_summary(program, name):
    summary, path = program.keep(rule(name))
    log = read_log(path)
    assert np.count_nonzero(has(log, HIT)) == summary["separation"]["hits"]
    assert np.count_nonzero(has(log, OVERLAP)) == summary["overlap_collisions"]
    assert np.count_nonzero(has(log, ABSORBED)) == summary["absorbed"]
    assert np.count_nonzero(has(log, RECEDING)) == summary["receding"]
    assert not np.any(log["flags"] & ~31)


@pytest.mark.parametrize("name", RULES)
def test_flags_agree_with_the_rows(program, name):
    _, path = program.keep(rule(name))
    log = read_log(path)
    assert np.array_equal(has(log, HIT), log["gap"] <= 1e-16)  # NaN is not
    assert np.array_equal(has(log, RECEDING), ~(log["normal_speed"] > 0))
    assert np.all(has(log, ABSORBED)[has(log, RECEDING)])  # no impulse changes nothing
    assert not np.any(np.isnan(log["gap"][:-1]))


@pytest.mark.parametrize("name", RULES)
def test_last_gap_is_known_only_where_the_run_stopped_at_the_pair(program, name):
    _, path = program.keep(rule(name))
    gap = read_log(path)["gap"][-1]
    assert gap <= 1e-16 if name == "stop" else np.isnan(gap)


@pytest.mark.parametrize("name", RULES)
def test_clock_goes_forward_where_no_flag_says_otherwise(program, name):
    _, path = program.keep(rule(name))
    log = read_log(path)
    steps = np.diff(log["time"])
    stood = has(log, CLOCK_STOOD)[1:]
    assert np.all(steps[~stood] >= 0)
    assert np.all(steps[stood] <= 0)
    assert not has(log, CLOCK_STOOD)[0]


def test_only_rewind_sets_the_clock_back(program):
    backwards = {}
    for name in RULES:
        _, path = program.keep(rule(name), f"{name}.h5")
        backwards[name] = np.any(np.diff(read_log(path)["time"]) < 0)
    assert backwards == {"rewind": True, "immediate": False, "guarded": False, "stop": False}


def test_hits_of_the_summary_are_rows_of_the_log(collapsed):
    summary, path = collapsed
    log = read_log(path)
    hits = log["k"][has(log, HIT)]
    separation = summary["separation"]
    assert hits[0] == separation["first_collision"] and hits[-1] == separation["last_collision"]
    assert log["time"][hits[0] - 1] == separation["first_time"]


def test_arrested_pairs_are_those_that_end_the_log(collapsed):
    summary, path = collapsed
    log = read_log(path)
    pairs = np.unique(np.stack([log["i"], log["j"]], axis=1)[-500:], axis=0)  # half a window
    assert pairs.tolist() == summary["arrest"]["pairs"]


def test_stop_ends_at_the_first_overlap_with_the_state_saved(program):
    summary, path = program.keep(rule("stop"))
    assert (summary["outcome"], summary["ended_by"]) == ("finished", "overlap")
    assert summary["overlap_collisions"] == 0
    with h5py.File(path) as file:
        assert file["zenosphere"].attrs["complete"] == 1
        position = file["particles/spheres/position"]
        assert position["step"][-1] == summary["collisions"]
        assert position["time"][-1] == summary["time"]


@pytest.mark.parametrize("name", RULES)
def test_spheres_that_touch_at_the_start_collide_whatever_the_rule(program, name):
    # The first two touch: they collide at 0, speeds (1 - e)/2 = 1/4 and (1 + e)/2 = 3/4; the second
    # meets the third, a gap of 2 away, at 2/(3/4 + 1).
    program.case.write_text(
        "[system]\ndimension = 1\nspheres = 3\nrestitution = 0.5\nsides = [10]\n"
        '[start]\narrangement = "given"\npositions = [2, 3, 6]\nvelocities = [1, 0, -1]\n'
        f'[drive]\nkind = "none"\n[collision]\noverlap = "{name}"\n[run]\ncollisions = 2\n')
    summary, path = program.keep()
    assert summary["ended_by"] == "collisions"
    np.testing.assert_allclose(read_log(path)["time"], [0, 2 / 1.75], rtol=4e-16)
    program("verify", path)


def test_run_stopped_by_an_overlap_does_not_deny_that_spheres_came_close(program):
    summary = program.run(rule("stop"))
    assert summary["ended_by"] == "overlap"
    assert summary["verdict"] != "none"


def test_rules_agree_up_to_the_first_overlap(program):
    logs = {}
    for name in RULES:
        _, path = program.keep(rule(name), f"{name}.h5")
        logs[name] = read_log(path)
    common = len(logs["stop"]["k"])
    for column in logs["stop"]:
        parts = {logs[name][column][:common].tobytes() for name in RULES}
        assert len(parts) == 1, column


def test_guard_of_zero_lets_nothing_pass(program):
    assert program.run(rule("guarded", **{"collision.guard": 0}))["overlaps_ignored"] == 0
    assert program.run(rule("guarded"))["overlaps_ignored"] > 0
