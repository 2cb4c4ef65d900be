"""Mixtures in the Python module: cases from dicts, grains and spins as arrays."""

import numpy as np
import pytest

import zenosphere

CASE = {
    "system": {"dimension": 2, "spheres": 40, "restitution": 0.9, "solids_volume_fraction": 0.5},
    "species": [{"name": "disk", "diameter": 1, "spheres": 30},
                {"name": "post", "diameter": 2.0, "spheres": 10, "immobile": True}],
    "contact": [{"between": ["disk", "post"], "restitution": 0.5}],
    "collision": {"tangential_restitution": 0.5, "friction": "unbounded"},
    "start": {"arrangement": "random", "granular_temperature": 1, "seed": 2},
    "drive": {"kind": "none"},
    "run": {"collisions": 300},
}


def test_a_case_from_dicts_has_species_as_lists():
    case = zenosphere.Case(CASE)
    assert case.tables["species"][1]["name"] == "post"
    assert zenosphere.Case.parse(case.resolved) == case
    assert "species post" in case.derived
    grains = case.grains
    assert list(grains.diameter[[0, 29, 30]]) == [1, 1, 2] and grains.mass[30] == 4
    assert grains.kind.dtype == np.int32 and list(grains.immobile[[29, 30]]) == [False, True]


def test_errors_in_species_name_the_key():
    species = [{**CASE["species"][0], "mass": 0}, CASE["species"][1]]
    with pytest.raises(zenosphere.InputError,
                       match=r"^case: species\.disk\.mass = 0 \(must be in \[1e-30, 1e\+30\]\)$"):
        zenosphere.Case({**CASE, "species": species})


def test_states_have_spins_and_temperatures_by_mass(tmp_path):
    with zenosphere.Run(CASE, output=tmp_path / "out.h5") as run:
        run.advance(300)
        state = run.state()
    assert state.angular_velocities.shape == (40, 1)
    assert state.angular_velocities[:30].any() and not state.angular_velocities[30:].any()
    assert state.granular_temperature == pytest.approx(
        (state.velocities[:30]**2).mean(), rel=1e-12)  # posts do not count, disks have the mass 1
    output = zenosphere.open(tmp_path / "out.h5")
    assert np.array_equal(output.grains.kind, [0] * 30 + [1] * 10)
    last = output.snapshots[-1]
    assert np.array_equal(last.angular_velocities, state.angular_velocities)
    assert last == state
    kinds = zenosphere.analyse(tmp_path / "out.h5")["species"]
    assert kinds[0]["granular_temperature"]["value"] > 0
    assert kinds[1]["granular_temperature"]["value"] is None  # posts have none


def test_unit_spheres_have_unit_grains_and_no_spins():
    tables = {key: value for key, value in CASE.items()
              if key not in ("species", "contact", "collision")}
    run = zenosphere.Run(tables)
    assert set(run.case.grains.diameter) == {1.0} and run.state().angular_velocities is None
    assert run.state().grains is None
