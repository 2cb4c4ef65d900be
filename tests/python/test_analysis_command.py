"""`zenosphere analyse` and `zenosphere.analyse` on files of runs."""

import json
import os
import re
import subprocess
import sys

import h5py
import numpy as np
import pytest
from matplotlib.figure import Figure
from module import CHECKOUT, ENDLESS, SHEARED, needed, program

import zenosphere
from zenosphere.__main__ import main
from zenosphere.analysis.figures import FIGURES
from zenosphere.analysis.tables import as_json

pytestmark = needed

KEYS = {  # that programs can rely on, of docs/measurements.md
    "radial_distribution": {"r", "g"}, "contact_value": {"value", "standard_error"},
    "structure_factor": {"k", "s"}, "sonine": {"a2", "a3", "a2_standard_error"},
    "profiles": {"y", "solids_volume_fraction", "velocity", "granular_temperature"},
    "diffusion": {"value", "standard_error"},
    "normal_stress_differences": {"n1", "n2", "n1_standard_error", "n2_standard_error"}}
WALLS = {"axis": "x", "restitution": 0.9}


def given(dimension, spheres, kind="none", **tables):
    """A case in which spheres of one kind begin at random places."""
    case = {"system": {"dimension": dimension, "spheres": spheres, "restitution": 0.9},
            "start": {"arrangement": "random", "granular_temperature": 1.0},
            "drive": {"kind": kind}, "run": {"time": 3.0},
            "output": {"snapshot_interval": 0.1}} | tables
    if not {"sides", "solids_volume_fraction"} & set(case["system"]):
        case["system"]["solids_volume_fraction"] = 0.2
    return case


CASES = {
    "rods": given(1, 30), "disks": given(2, 60), "spheres": given(3, 60),
    "sheared disks": given(2, 60, drive={"kind": "shear", "shear_rate": 1.0}),
    "sheared spheres": given(3, 60, drive={"kind": "shear", "shear_rate": 1.0}),
    "two disks": given(2, 2),
    "rods between walls": given(1, 10, walls=WALLS),
    "disks between walls": given(2, 60, walls=WALLS | {"axis": "y"}),
    "spheres between walls": given(3, 60, walls=WALLS | {"axis": "z"}),
    "one ball": given(1, 1, system={"dimension": 1, "spheres": 1, "restitution": 1,
                                    "sides": [5]},
                      start={"arrangement": "given", "positions": [[2.0]], "velocities": [[1.0]]},
                      walls=WALLS),
    "a jammed ball": given(1, 1, system={"dimension": 1, "spheres": 1, "restitution": 1,
                                         "sides": [1.001]},
                           start={"arrangement": "given", "positions": [[0.5005]],
                                  "velocities": [[0.001]]}, walls=WALLS),
    "start and end only": given(3, 60, output={}),
    "no log": given(3, 60, output={"snapshot_interval": 0.1, "collision_log": "none"}),
    "no collisions": given(3, 60, run={"collisions": 0}),
}


def recorded(folder, case):
    path = folder / "run.h5"
    with zenosphere.Run(case, output=path) as run:
        run.skip()
    return path


def strict(text):
    """JSON without NaN and Infinity, which are none."""
    def refuse(word):
        raise ValueError(word)
    return json.loads(text, parse_constant=refuse)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
@pytest.mark.filterwarnings("error")
def test_every_kind_of_run_is_analysed_and_drawn(tmp_path, case):
    """Figures are drawn, but not written, which takes long."""
    found = zenosphere.analyse(recorded(tmp_path, case))
    told = strict(as_json(found))
    for key, parts in KEYS.items():
        assert parts <= set(told[key]), key
    assert told["spheres"] == case["system"]["spheres"]
    is_sheared = case["drive"]["kind"] == "shear"
    assert (told["shear_viscosity"]["value"] is not None) == is_sheared
    assert (told["radial_distribution_by_direction"] is not None) == is_sheared
    drawn = [name for name, draw in FIGURES.items() if draw(Figure().add_subplot(), found)]
    assert len(drawn) >= (3 if case["system"]["spheres"] > 2 else 0)


def test_arrays_of_python_are_the_lists_of_the_program(tmp_path, capsys):
    path = recorded(tmp_path, CASES["sheared spheres"])
    found = zenosphere.analyse(path, from_time=1.0, to_time=2.0)
    assert isinstance(found["radial_distribution"]["g"], np.ndarray)
    assert found["snapshots"] == 11 and found["to_time"] == pytest.approx(2.0)
    target = tmp_path / "found.json"
    assert main(["analyse", str(path), "--from-time", "1", "--to-time", "2", "-o",
                 str(target)]) == 0
    told = strict(target.read_text())
    assert told["radial_distribution"]["g"] == found["radial_distribution"]["g"].tolist()
    text = capsys.readouterr().out
    assert "11 snapshots of 60 spheres" in text and "N1 / p" in text and str(target) in text


def test_program_prints_what_python_returns(tmp_path):
    path = recorded(tmp_path, CASES["disks"])
    told = strict(program("analyse", path, "--json").splitlines()[-1])
    found = zenosphere.analyse(path)
    assert told["structure_factor"]["s"] == found["structure_factor"]["s"].tolist()
    assert told["contact_value"] == found["contact_value"]


def keys_of(results):
    """All keys, of dicts in dicts too; the axes of a curve are no keys."""
    for key, value in results.items():
        yield key
        if isinstance(value, dict) and key != "by_axis":
            yield from keys_of(value)


def test_every_key_is_explained(tmp_path):
    text = (CHECKOUT / "docs" / "measurements.md").read_text()
    found = zenosphere.analyse(recorded(tmp_path, CASES["sheared disks"]))
    unknown = {key for key in keys_of(found) if not re.search(rf"[`.]{key}[`.]", text)}
    assert unknown == set()


def test_tables_are_written_one_for_each_curve(tmp_path, capsys):
    path = recorded(tmp_path, CASES["sheared disks"])
    assert main(["analyse", str(path), "-o", str(tmp_path / "all.csv")]) == 0
    names = {file.name for file in tmp_path.glob("all*.csv")}
    assert names == {"all.csv"} | {f"all-{curve}.csv" for curve in (
        "radial-distribution", "radial-distribution-by-direction", "structure-factor", "profiles",
        "component-distribution", "speed-distribution", "mean-square-displacement",
        "velocity-autocorrelation", "touching", "gap", "flight-time", "normal-speed")}
    table = np.genfromtxt(tmp_path / "all-radial-distribution.csv", delimiter=",", names=True)
    assert table["r"] == pytest.approx(zenosphere.analyse(path)["radial_distribution"]["r"])
    assert (tmp_path / "all.csv").read_text().startswith("quantity,value,standard_error\ngranular")


def test_figures_are_one_for_each_result(tmp_path, capsys):
    path = recorded(tmp_path, CASES["sheared spheres"])
    folder = tmp_path / "figures"
    assert main(["analyse", str(path), "--figures", str(folder), "--format", "png,svg"]) == 0
    drawn = {file.stem for file in folder.iterdir()}
    assert drawn == {f"run-{name}" for name in (
        "radial-distribution", "radial-distribution-by-direction", "structure-factor",
        "velocity-distribution", "profiles", "mean-square-displacement",
        "velocity-autocorrelation", "touching", "gap", "flight-time", "normal-speed")}
    assert len(list(folder.iterdir())) == 2 * len(drawn)


def test_open_run_is_analysed_as_far_as_it_has_got(tmp_path):
    case = zenosphere.Case(SHEARED, overrides=ENDLESS | {"output.snapshot_interval": 0.05})
    with zenosphere.Run(case, output=tmp_path / "run.h5") as run:
        run.skip(3000)
        run.save()
        found = zenosphere.analyse(tmp_path / "run.h5")
        assert found["snapshots"] > 2 and found["collision_distributions"] is None
        assert found["contact_value"]["value"] > 0


def test_averages_begin_where_those_of_the_run_do(tmp_path):
    case = CASES["spheres"] | {"measure": {"after_time": 1.95}}
    assert zenosphere.analyse(recorded(tmp_path, case))["from_time"] == pytest.approx(2.0)


def test_places_of_24_bits_give_the_same(tmp_path):
    path = recorded(tmp_path, CASES["sheared spheres"])
    exact = zenosphere.analyse(path)
    with h5py.File(path, "r+") as file:
        for name in ("position", "velocity"):
            values = file[f"particles/spheres/{name}/value"]
            values[...] = values[...].astype(np.float32)
    rounded = zenosphere.analyse(path)
    assert rounded["radial_distribution"]["g"] == pytest.approx(
        exact["radial_distribution"]["g"], rel=0.05)
    assert rounded["diffusion"]["value"] == pytest.approx(exact["diffusion"]["value"], rel=1e-4)


def test_elastic_spheres_have_the_numbers_of_kinetic_theory(tmp_path):
    """Normal speed sqrt(pi T); flights as long as there are spheres / (2 collisions), less ends;
    g at contact (Z - 1) / (4 phi); the mean speed sqrt(8 T / pi) over the collision rate."""
    case = given(3, 500, run={"time": 10.0}, system={
        "dimension": 3, "spheres": 500, "restitution": 1, "solids_volume_fraction": 0.3})
    path = recorded(tmp_path, case)
    found, summary = zenosphere.analyse(path), zenosphere.open(path).summary
    log, collisions = found["collision_distributions"], summary["collisions"]
    assert log["normal_speed"]["mean"] == pytest.approx(np.sqrt(np.pi), rel=0.01)
    assert log["normal_speed"]["number"] == collisions
    assert log["flight_time"]["mean"] == pytest.approx(500 * 10 / (2 * collisions), rel=0.02)
    contact = found["contact_value"]
    expected = (summary["averages"]["compressibility_factor"] - 1) / (4 * 0.3)
    assert contact["value"] == pytest.approx(expected, abs=5 * contact["standard_error"])
    assert contact["standard_error"] < 0.06
    assert found["mean_free_path"]["value"] == pytest.approx(
        np.sqrt(8 / np.pi) / summary["averages"]["collision_rate"], rel=0.01)


@pytest.mark.parametrize("words, told", [
    (["missing.h5"], "missing.h5"), (["run.h5", "-o", "found.txt"], ".txt names no format of"),
    (["run.h5", "--from-time", "99"], "no snapshot in the time from 99"),
    (["run.h5", "--from-time", "2", "--to-time", "1"], "no snapshot in the time from 2 to 1")])
def test_wrong_words_are_one_line_and_exit_code_2(tmp_path, capsys, monkeypatch, words, told):
    recorded(tmp_path, CASES["two disks"])
    monkeypatch.chdir(tmp_path)
    capsys.readouterr()
    assert main(["analyse", *words]) == 2
    [line] = capsys.readouterr().err.splitlines()
    assert told in line


@pytest.mark.parametrize("name", ["position", "velocity"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_place_or_velocity_that_is_no_number_is_damage(tmp_path, capsys, name, value):
    path = recorded(tmp_path, CASES["two disks"])
    with h5py.File(path, "r+") as file:
        file[f"particles/spheres/{name}/value"][-1, 0, 0] = value
    capsys.readouterr()
    assert main(["analyse", str(path)]) == 2
    [line] = capsys.readouterr().err.splitlines()
    assert "in the snapshot at time" in line and "damaged" in line


def test_file_that_cannot_be_written_is_exit_code_4(tmp_path, capsys):
    path = recorded(tmp_path, CASES["two disks"])
    capsys.readouterr()
    for words in (["-o", "no/found.json"], ["-o", "no/found.csv"], ["--figures", "run.h5"]):
        assert main(["analyse", str(path), words[0], str(tmp_path / words[1])]) == 4
        assert len(capsys.readouterr().err.splitlines()) == 1


def test_reader_that_has_left_is_no_error(tmp_path):
    path = recorded(tmp_path, CASES["two disks"])
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run([sys.executable, "-m", "zenosphere", "analyse", path, "--json"],
                          stdout=writing, stderr=subprocess.PIPE, text=True)
    os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")


def test_missing_scipy_is_said_in_one_line(tmp_path):
    script = ("import sys; sys.modules['scipy'] = None\n"
              "from zenosphere.__main__ import main\n"
              "sys.exit(main(['analyse', 'run.h5']))\n")
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 2
    [line] = done.stderr.splitlines()
    assert "python3-scipy" in line


def test_run_that_ended_before_its_averages_began_says_which_time_to_choose(tmp_path, capsys):
    path = recorded(tmp_path, CASES["spheres"] | {"measure": {"after_time": 20.0}})
    assert main(["analyse", str(path)]) == 2
    [line] = capsys.readouterr().err.splitlines()
    assert "no snapshot in the time from 20 " in line and "--from-time" in line
    assert zenosphere.analyse(path, from_time=0)["snapshots"] == 31
