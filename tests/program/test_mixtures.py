"""Spheres that differ and turn, as a run has them."""

import json

import h5py
import numpy as np
import pytest

from mixtures import ROUGH, SNAPSHOTS


def apart(file):
    """Smallest surface distance of two spheres in the last snapshot, nearest images."""
    group = file["particles/spheres"]
    places, edges = group["position/value"][-1], group["box/edges/value"][-1]
    between = places[:, None] - places[None]
    layers = np.round(between[..., 1] / edges[1, 1])
    between -= layers[..., None] * edges[1]
    for axis in (0, 2):
        side = edges[axis, axis]
        between[..., axis] -= side * np.round(between[..., axis] / side)
    radius = group["diameter"][:] / 2
    gaps = np.linalg.norm(between, axis=2) - (radius[:, None] + radius[None])
    return gaps[np.triu_indices(len(places), 1)].min()


def test_a_sheared_mixture_runs_and_its_file_says_what_its_spheres_are(mixture):
    summary, path = mixture.keep(SNAPSHOTS)
    assert summary["collisions"] == 1000 and abs(summary["ledger_error"]) < 1e-10
    kinds = summary["species"]
    assert [(kind["name"], kind["spheres"]) for kind in kinds] == [("small", 60), ("large", 30)]
    temperature = sum(kind["spheres"] * kind["granular_temperature"] for kind in kinds) / 90
    assert temperature == pytest.approx(summary["averages"]["granular_temperature"], rel=1e-12)
    assert "rotational_temperature" not in summary["averages"]
    with h5py.File(path) as file:
        group = file["particles/spheres"]
        assert set(group["diameter"][:60]) == {1.0} and set(group["diameter"][60:]) == {1.4}
        assert group["mass"][60] == pytest.approx(1.4**3, rel=1e-15)
        assert list(group["species"][[0, 59, 60]]) == [0, 0, 1]
        assert list(group["species"].attrs["names"]) == ["small", "large"]
        assert "angular_velocity" not in group
        assert apart(file) > -1e-12
        edges = group["box/edges/value"][0]
        volume = np.pi / 6 * (group["diameter"][:]**3).sum()
        assert volume / np.linalg.det(edges) == pytest.approx(0.3, rel=1e-12)


def test_rough_spheres_turn_and_their_ledger_closes(mixture):
    summary, path = mixture.keep({**SNAPSHOTS, **ROUGH})
    assert summary["averages"]["rotational_temperature"] > 0
    assert all(kind["rotational_temperature"] > 0 for kind in summary["species"])
    assert abs(summary["ledger_error"]) < 1e-10
    with h5py.File(path) as file:
        group = file["particles/spheres/angular_velocity"]
        spins = group["value"]
        assert spins.shape == (len(group["time"]), 90, 3)
        assert not spins[0].any() and spins[-1].any()


def test_frictionless_spheres_are_smooth_ones_to_the_last_bit(mixture):
    smooth = mixture.run()
    for changes in ({"collision.tangential_restitution": -1, "collision.friction": 0.4},
                    {"collision.tangential_restitution": 0.5, "collision.friction": 0}):
        other = mixture.run(changes)
        assert other["time"] == smooth["time"]
        assert other["averages"]["pressure"] == smooth["averages"]["pressure"]


@pytest.mark.parametrize("precision", ["extended", "quad"])
def test_other_precisions_begin_from_the_same_spheres(mixture, precision):
    short = {"run.collisions": 20, **ROUGH}
    double = mixture.run(short)
    other = mixture.run({**short, "collision.precision": precision})
    assert other["time"] == pytest.approx(double["time"], rel=1e-12)


def test_a_run_in_two_pieces_ends_with_the_same_bits(mixture):
    whole, _ = mixture.keep({**ROUGH, **SNAPSHOTS}, name="whole.h5")
    mixture.keep({**ROUGH, **SNAPSHOTS, "run.collisions": 400})
    done = mixture("resume", "out.h5", "--json", "--set", "run.collisions=1000")
    resumed = json.loads(done.stdout.splitlines()[-1])
    for key in ("time", "averages", "species", "separation"):
        assert resumed[key] == whole[key]


def test_a_run_goes_on_from_the_file_of_another_with_its_spins(mixture):
    _, path = mixture.keep(ROUGH, name="first.h5")
    start = {"start.arrangement": "file", "start.file": "first.h5"}
    text = mixture.case.read_text().replace("granular_temperature = 1\n", "")
    mixture.case.write_text(text)
    mixture.keep({**ROUGH, **start, "run.collisions": 0})
    with h5py.File(path) as first, h5py.File(mixture.folder / "out.h5") as second:
        for element in ("position", "angular_velocity"):
            name = f"particles/spheres/{element}/value"
            assert np.array_equal(first[name][-1], second[name][0]), element
    errors = mixture.fail("run", "case.toml", *mixture.words(
        {**start, "species.large.diameter": 1.3, "system.sides": "[1]"}))
    assert len(errors) == 1


@pytest.mark.parametrize("dimension, fraction", [(2, 0.8), (1, 0.7)])
def test_disks_and_rods_of_two_sizes_run(mixture, dimension, fraction):
    summary, path = mixture.keep({"system.dimension": dimension, "drive.kind": "none",
                                  "system.solids_volume_fraction": fraction})
    assert summary["collisions"] == 1000
    with h5py.File(path) as file:
        assert file["particles/spheres/mass"][60] == pytest.approx(1.4**dimension, rel=1e-15)


def test_a_start_that_jams_says_how_far_it_came(mixture):
    *_, error = mixture.fail("run", "case.toml", "--set", "system.solids_volume_fraction=0.8")
    assert error.startswith("start: the growing spheres jammed at a solids volume fraction of 0.6")


def test_polydisperse_spheres_fill_the_fraction_of_the_case(program):
    summary, path = program.keep({"start.arrangement": "random", "drive.kind": "none",
                                  "polydispersity.distribution": "lognormal",
                                  "polydispersity.spread": 0.3})
    assert summary["collisions"] == 2000
    with h5py.File(path) as file:
        group = file["particles/spheres"]
        diameters = group["diameter"][:]
        assert len(set(diameters)) == 108 and "species" not in group
        assert np.array_equal(group["mass"][:], diameters * diameters * diameters)
        side = group["box/edges/value"][0, 0, 0]
        assert np.pi / 6 * (diameters**3).sum() / side**3 == pytest.approx(0.3, rel=1e-12)


def test_immobile_spheres_stay_where_they_are(mixture):
    summary, path = mixture.keep({"drive.kind": "none", "species.large.immobile": "true"})
    assert summary["species"][1]["granular_temperature"] is None
    with h5py.File(path) as file:
        places = file["particles/spheres/position/value"]
        assert np.array_equal(places[0, 60:], places[-1, 60:])
        assert not np.array_equal(places[0, :60], places[-1, :60])
    [error] = mixture.fail("run", "case.toml", "--set", "species.large.immobile=true")
    assert "drive.kind" in error and "immobile" in error


def test_check_tells_the_species(mixture):
    text = mixture("check", "case.toml").stdout
    assert "species large" in text and "30 spheres, diameter 1.4, mass 2.744" in text
    assert "smallest and largest" in text
