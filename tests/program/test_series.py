"""The time series of a run: what is in the file, in tables, in other programs' readers."""

import csv
import json

import h5py
import numpy as np
import pytest

from viewers import package

LONG = {"run.collisions": 20000, "output.snapshot_interval": 0.02}


def series(path):
    with h5py.File(path) as file:
        group = file["zenosphere/series"]
        found = {"step": group["step"][:], "time": group["time"][:]}
        for name, element in group.items():
            if isinstance(element, h5py.Group):
                assert element["step"] == group["step"] and element["time"] == group["time"]
                found[name] = element["value"][:]
    return found


def test_the_mean_of_the_series_is_the_average_of_the_run(program):
    summary, path = program.keep(LONG)
    found, averages = series(path), summary["averages"]
    rows, interval = len(found["time"]), found["time"][0]
    assert rows >= 16
    assert np.allclose(found["time"], interval * np.arange(1, rows + 1), rtol=1e-14)
    assert np.all(np.diff(found["step"]) >= 0)
    # What comes after the last interval is less than one of them.
    late = averages["to_time"] - found["time"][-1]
    assert 0 <= late < interval
    for name in ("granular_temperature", "pressure", "pressure_tensor", "collision_rate"):
        inside = found[name].mean(axis=0) * found["time"][-1]
        whole = np.array(averages[name]) * averages["to_time"]
        scale = np.abs(found[name]).max() * interval
        assert np.all(np.abs(whole - inside) <= 3 * scale), name
    assert np.allclose(np.trace(found["pressure_tensor"], axis1=1, axis2=2) / 3, found["pressure"])


def test_averages_carry_errors_of_their_shape(program):
    averages = program.run({**LONG, "run.collisions": 100000, "measure.after_time": 2})["averages"]
    errors = averages["standard_error"]
    assert np.shape(errors["pressure_tensor"]) == (3, 3)
    assert np.shape(errors["temperature_diagonal"]) == (3,)
    assert 0 < errors["pressure"] < averages["pressure"]
    assert averages["blocks"] >= 1
    assert averages["steady"] in (True, False, None) and averages["steady_reason"]
    assert averages["streak_amplitude"] > 0


def test_a_short_run_has_no_errors(program):
    averages = program.run({"run.collisions": 50})["averages"]
    assert averages["standard_error"]["pressure"] is None
    assert averages["steady"] is None and "too short" in averages["steady_reason"]


def test_the_interval_of_the_case_is_kept(program):
    _, path = program.keep({**LONG, "measure.interval": 0.3})
    assert series(path)["time"][0] == pytest.approx(0.3, rel=1e-12)


def test_averages_start_where_the_steady_state_is_found(program):
    # From a temperature of 100, far above that of the shear.
    hot = {**LONG, "start.granular_temperature": 100, "measure.after_time": "auto"}
    averages = program.run(hot)["averages"]
    late = program.run({**hot, "measure.after_time": averages["from_time"]})["averages"]
    assert averages["from_time"] > 0
    for name in ("granular_temperature", "pressure", "normal_speed", "compressibility_factor"):
        assert averages[name] == pytest.approx(late[name], rel=1e-9), name


def test_the_table_is_the_series(program):
    _, path = program.keep(LONG)
    table = program.folder / "series.csv"
    program("export", str(path), "--format", "csv-series", "-o", str(table))
    found = series(path)
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["step"]) for row in rows] == list(found["step"])
    assert [float(row["pressure_tensor_xy"]) for row in rows] == list(
        found["pressure_tensor"][:, 0, 1])
    assert [float(row["temperature_diagonal_y"]) for row in rows] == list(
        found["temperature_diagonal"][:, 1])


def test_a_run_without_intervals_has_no_table(program):
    _, path = program.keep({"run.collisions": 50})
    target = str(program.folder / "series.csv")
    said = program.fail("export", str(path), "--format", "csv-series", "-o", target)
    assert len(said) == 1 and "holds no time series" in said[0]


def test_observables_are_those_of_the_snapshots_for_readers_that_go_by_frames(program):
    _, path = program.keep(LONG)
    found = series(path)
    with h5py.File(path) as file:
        times = file["particles/spheres/position/time"][:]
        element = file["observables/granular_temperature"]
        assert np.array_equal(element["time"][:], times)
        values = element["value"][:]
    row = np.minimum(np.searchsorted(found["time"], times, side="right"), len(found["time"]) - 1)
    assert np.array_equal(values, found["granular_temperature"][row])
    analysis = package("MDAnalysis")
    universe = analysis.Universe.empty(108)
    universe.load_new(str(path), format="H5MD", convert_units=False)
    read = [frame.data["granular_temperature"] for frame in universe.trajectory]
    assert np.array_equal(read, values)


def test_a_run_that_goes_on_has_the_series_of_one_that_was_never_interrupted(program):
    _, whole = program.keep(LONG, name="whole.h5")
    _, half = program.keep({**LONG, "run.collisions": 9000}, name="half.h5")
    program("resume", str(half), "--set", "run.collisions=20000")
    first, second = series(whole), series(half)
    assert list(first) == list(second)
    assert all(np.array_equal(first[name], second[name], equal_nan=True) for name in first)


def test_the_series_of_a_killed_run_is_that_of_its_last_checkpoint(program):
    program.kill_with_journal(program.start({"output.checkpoint_collisions": 2000}))
    table = program.folder / "table.csv"
    program("export", "out.h5", "--format", "csv-series", "-o", str(table))
    steps = [int(line.split(",")[0]) for line in table.read_text().splitlines()[1:]]
    reached = json.loads(program("info", "out.h5", "--json").stdout)["collisions"]
    assert 0.9 * reached < steps[-1] <= reached


def test_logarithmic_snapshots_are_ten_in_a_decade(program):
    _, path = program.keep({**LONG, "output.snapshot_interval": 0.01,
                            "output.snapshot_spacing": "log"})
    with h5py.File(path) as file:
        times = file["particles/spheres/position/time"][1:-1]
    assert np.allclose(np.diff(np.log10(times)), 0.1, atol=1e-9)
    assert times[0] == pytest.approx(0.01, rel=1e-9)
