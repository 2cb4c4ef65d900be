"""Averages over the seeds of an ensemble, with both errors, and the curves of kinetic theory."""

import csv
import json
import sqlite3

import numpy as np
import pytest
from synthetic_store import write_store
from zenosphere.ensembles.figures import draw_ensemble
from zenosphere.ensembles.store import Ensemble

AXES = {"system.restitution": (0.8, 0.9), "system.solids_volume_fraction": (0.1, 0.3)}
PRESSURES = (1.0, 1.2, 1.4, 1.2)  # of four seeds: mean 1.2, standard deviation 0.163299
COLUMNS = {"granular_temperature": "REAL", "granular_temperature_standard_error": "REAL",
           "pressure": "REAL", "pressure_standard_error": "REAL", "pressure_tensor": "TEXT",
           "pressure_tensor_standard_error": "TEXT", "averages_steady": "INTEGER"}
CASE = '[system]\ndimension = 3\nspheres = 100\n[drive]\nkind = "shear"\nshear_rate = 1.0\n'


def write_averages(path, case=CASE, outcome=lambda keys, replica: (None, None), columns=COLUMNS):
    """A store of four seeds whose pressures are PRESSURES, each known to 0.1."""
    write_store(path, AXES, outcome, seeds=len(PRESSURES))
    with sqlite3.connect(path) as store:
        store.execute("UPDATE sweep SET base_case = ?", (case,))
        for name, kind in columns.items():
            store.execute(f"ALTER TABLE run ADD COLUMN {name} {kind}")
        for replica, pressure in enumerate(PRESSURES):
            values = {"granular_temperature": 0.5, "granular_temperature_standard_error": None,
                      "pressure": pressure, "pressure_standard_error": 0.1,
                      "pressure_tensor": json.dumps([[pressure, -0.3, 0], [-0.3, 1, 0], [0, 0, 1]]),
                      "pressure_tensor_standard_error": json.dumps([[0.1, 0.02, 0]] * 3),
                      "averages_steady": (1, 0, None, 1)[replica]}
            values = {name: value for name, value in values.items() if name in columns}
            changes = ", ".join(f"{name} = ?" for name in values)
            store.execute(f"UPDATE run SET {changes} WHERE replica = ?",
                          (*values.values(), replica))
    return path


def test_averages_have_the_spread_of_the_seeds_and_the_error_of_a_run(tmp_path):
    averages = Ensemble(write_averages(tmp_path / "s.sqlite")).averages()
    pressure = averages.means("pressure")
    np.testing.assert_allclose(pressure.value, 1.2)
    np.testing.assert_allclose(pressure.spread, np.sqrt(0.08 / 3))
    np.testing.assert_allclose(pressure.error, np.sqrt(0.08 / 3) / 2)
    np.testing.assert_allclose(pressure.run_error, 0.1)
    np.testing.assert_allclose(pressure.ratio, np.sqrt(0.08 / 3) / 0.1)
    stress = averages.means("shear_stress")
    np.testing.assert_allclose(stress.value, 0.3)
    np.testing.assert_allclose(stress.run_error, 0.02)
    assert np.isnan(averages.means("granular_temperature").run_error).all()


def test_a_point_is_steady_where_any_of_its_runs_is(tmp_path):
    store = write_averages(tmp_path / "s.sqlite")
    assert Ensemble(store).averages().any_steady.all()
    with sqlite3.connect(store) as database:
        database.execute('UPDATE run SET averages_steady = 0 WHERE "system.restitution" = 0.8')
    np.testing.assert_array_equal(Ensemble(store).averages().any_steady, [[False] * 2, [True] * 2])


def test_runs_that_arrested_have_no_averages(tmp_path):
    def arrested(_, replica):
        return (5, 9) if replica == 1 else (None, None)
    averages = Ensemble(write_averages(tmp_path / "s.sqlite", outcome=arrested)).averages()
    pressure = averages.means("pressure")
    assert (pressure.runs == 3).all()
    np.testing.assert_allclose(pressure.value, (1.0 + 1.4 + 1.2) / 3)


def test_a_single_run_has_the_error_that_it_tells(tmp_path):
    def pending(_, replica):
        return "pending" if replica else (None, None)
    pressure = Ensemble(write_averages(tmp_path / "s.sqlite", outcome=pending)
                        ).averages().means("pressure")
    np.testing.assert_allclose(pressure.value, 1.0)
    np.testing.assert_allclose(pressure.error, 0.1)
    assert np.isnan(pressure.spread).all()


def test_table_and_figure_of_averages_are_written(tmp_path):
    ensemble = Ensemble(write_averages(tmp_path / "s.sqlite"))
    names = {path.name for path in draw_ensemble(ensemble, tmp_path / "figures")}
    assert {"averages.csv", "averages.png"} <= names
    with open(tmp_path / "figures" / "averages.csv", encoding="utf-8") as file:
        row = next(csv.DictReader(file))
    assert (row["runs"], row["steady"], row["not_steady"]) == ("4", "2", "1")
    assert row["pressure"] == "1.2" and row["pressure_standard_error"] == "0.0816497"
    assert row["pressure_error_of_a_run"] == "0.1"
    assert row["pressure_spread_over_error"] == "1.63299"
    assert row["granular_temperature_error_of_a_run"] == "" and "sonine_a2" not in row


def test_store_without_errors_keeps_its_averages(tmp_path):
    columns = {name: kind for name, kind in COLUMNS.items()
               if not name.endswith("standard_error") and name != "averages_steady"}
    averages = Ensemble(write_averages(tmp_path / "s.sqlite", columns=columns)).averages()
    pressure = averages.means("pressure")
    np.testing.assert_allclose(pressure.value, 1.2)
    np.testing.assert_allclose(pressure.error, np.sqrt(0.08 / 3) / 2)
    assert np.isnan(pressure.ratio).all() and np.isnan(averages.steady).all()


@pytest.mark.parametrize("case, theory", [
    (CASE, True),
    (CASE + "[collision]\noverlap = 'rewind'\n", True),
    (CASE + "[collision]\ncontact_duration = 1e-3\n", False),
    (CASE.replace("dimension = 3", "dimension = 2"), False),
    (CASE + "[[species]]\nname = 'a'\n", False),
    ("[drive]\nkind = 'none'\n", None)])
def test_theory_is_drawn_for_smooth_spheres_of_one_kind_only(tmp_path, case, theory):
    flow = Ensemble(write_averages(tmp_path / "s.sqlite", case)).shear_flow
    assert (flow and flow["has_theory"]) == theory
