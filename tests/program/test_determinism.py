"""The same case gives the same bits, whatever is recorded of it."""

import json

import h5py
import numpy as np
import pytest

OF_THE_MACHINE = {"wall_seconds", "collisions_per_second", "peak_memory_bytes"}
COLUMNS = ("k", "i", "j", "time", "gap", "normal_speed", "flags")
SHEARED = {"run.collisions": 4000}
COLLAPSING = {"system.restitution": 0.2, "drive.shear_rate": 1, "run.collisions": 200000}
DENSE = {"system.solids_volume_fraction": 0.6, "run.collisions": 4000}
RANDOM = {"start.arrangement": "random", "system.spheres": 77, "run.collisions": 2000}
COOLING = {"drive.kind": "none", "drive.shear_rate": 0, "run.collisions": 4000}
# So thin that some forty time units pass between two collisions.
THIN = {**COOLING, "system.solids_volume_fraction": 1e-4, "run.collisions": 60}
CASES = [SHEARED, COLLAPSING, DENSE, RANDOM, COOLING, THIN]
NAMES = ["sheared", "collapsing", "dense", "random", "cooling", "thin"]


def bits(value):
    """Something that is equal only for the same bits, NaN included."""
    array = np.asarray(value)
    return array.tobytes() if array.dtype != object else repr(array.tolist())


def checksums(text):
    """The lines of all but the summary and other costs, and that of all lines."""
    costs = (" zenosphere/summary", " of the lines above", *(f"@{name}" for name in OF_THE_MACHINE))
    return [line for line in text.decode().splitlines() if not line.endswith(costs)]


def contents(path):
    """Every attribute and dataset of a file but the summary and its checksums."""
    found = {}

    def collect(name, item):
        for key, value in item.attrs.items():
            if key not in OF_THE_MACHINE:
                found[name, key] = bits(value)
        if isinstance(item, h5py.Dataset) and name != "zenosphere/summary":
            value = item[()]
            found[name] = (item.dtype.str, item.shape, checksums(value)
                           if name == "zenosphere/checksums" else bits(value))

    with h5py.File(path) as file:
        collect("/", file)
        file.visititems(collect)
    return found


def stored_summary(path):
    with h5py.File(path) as file:
        summary = json.loads(file["zenosphere/summary"][()])
    return {key: value for key, value in summary.items() if key not in OF_THE_MACHINE}


def log(path):
    with h5py.File(path) as file:
        return {name: file["collisions"][name][()] for name in COLUMNS}


def assert_same_rows(rows, others):
    for name in COLUMNS:
        assert bits(rows[name]) == bits(others[name]), name


@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_same_case_twice_gives_the_same_file(program, case):
    _, first = program.keep({**case, "output.snapshot_interval": 0.61}, "first.h5")
    _, second = program.keep({**case, "output.snapshot_interval": 0.61}, "second.h5")
    assert contents(first) == contents(second)
    assert stored_summary(first) == stored_summary(second)


def test_other_seed_gives_other_collisions(program):
    _, first = program.keep({}, "first.h5")
    _, second = program.keep({"start.seed": 8}, "second.h5")
    assert bits(log(first)["time"]) != bits(log(second)["time"])


@pytest.mark.parametrize("interval", [0.137, 1.7])
@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_snapshots_change_no_collision(program, case, interval):
    _, plain = program.keep(case, "plain.h5")
    _, watched = program.keep({**case, "output.snapshot_interval": interval}, "watched.h5")
    assert_same_rows(log(plain), log(watched))


@pytest.mark.parametrize("setting", ["none", "window", "all"])
def test_collision_log_changes_no_collision(program, setting):
    plain = program.run(COLLAPSING)
    logged, _ = program.keep({**COLLAPSING, "output.collision_log": setting})
    assert plain["collisions"] == logged["collisions"]
    for key in set(plain) - OF_THE_MACHINE:
        assert plain[key] == logged[key], key


def test_window_of_the_log_is_that_part_of_the_whole_log(program):
    _, whole = program.keep({}, "whole.h5")
    window = {"output.collision_log": "window", "output.log_first": 123, "output.log_last": 456}
    _, part = program.keep(window, "part.h5")
    rows = log(whole)
    assert_same_rows({name: rows[name][122:456] for name in COLUMNS}, log(part))


def test_shorter_run_is_the_beginning_of_a_longer_one(program):
    _, shorter = program.keep({"run.collisions": 700}, "short.h5")
    _, longer = program.keep({"run.collisions": 1400}, "long.h5")
    rows, others = log(shorter), log(longer)
    assert np.isnan(rows["gap"][-1])  # known only one collision later
    assert_same_rows({name: rows[name][:-1] for name in COLUMNS},
                     {name: others[name][:699] for name in COLUMNS})
