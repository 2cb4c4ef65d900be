"""What a run accumulates itself, beside what its snapshots and its collision log tell."""

import h5py
import numpy as np
import pytest
from module import needed, program

pytestmark = needed

SAMPLES = 10  # fewer than there may be rows
BASE = {
    "system": {"dimension": 3, "spheres": 108, "restitution": 0.9, "solids_volume_fraction": 0.3},
    "start": {"arrangement": "random", "granular_temperature": 1.0, "seed": 5},
    "drive": {"kind": "none"},
    "run": {"time": 3.0},
    "measure": {"after_time": 0.05},
}
SHEAR = {"drive": {"kind": "shear", "shear_rate": 1.0}}
PLANE = {"system": {**BASE["system"], "dimension": 2, "solids_volume_fraction": 0.5}}
TWO_KINDS = {"species": [{"name": "light", "diameter": 1.0, "mass": 1.0, "share": 0.5},
                         {"name": "heavy", "diameter": 1.4, "mass": 3.0, "share": 0.5}]}
WALLS = {"walls": {"axis": "y", "restitution": 0.9, "upper_speed": 1.0,
                   "tangential_restitution": 0.5}}
CASES = {
    "gas": {}, "sheared gas": SHEAR, "disks": PLANE, "sheared disks": PLANE | SHEAR,
    "rods": {"system": {"dimension": 1, "spheres": 60, "restitution": 1.0,
                        "solids_volume_fraction": 0.4}},
    "rods between walls": {"system": {"dimension": 1, "spheres": 10, "restitution": 1.0,
                                      "solids_volume_fraction": 0.4},
                           "walls": {"axis": "x", "restitution": 1.0}},
    "walls": WALLS, "disks between walls": PLANE | WALLS,
    "mixture": TWO_KINDS, "mixture between walls": TWO_KINDS | WALLS,
    "sheared mixture of disks": PLANE | TWO_KINDS | SHEAR,
    "extended": SHEAR | {"collision": {"precision": "extended"}},
    "two spheres": {"system": {"dimension": 3, "spheres": 2, "restitution": 1.0,
                               "sides": [3.0, 3.0, 3.0]}},
}


def ran(case, output, **more):
    """The output of a case that has been run to its end."""
    import zenosphere
    merged = {table: dict(keys) if isinstance(keys, dict) else keys
              for table, keys in (BASE | case).items()}
    for key, value in more.items():
        table, name = key.split("__")
        merged.setdefault(table, {})[name] = value
    with zenosphere.Run(merged, output=output) as run:
        run.skip()
    return output


def same(one, other, **tolerance):
    """Whether two results are equal but for rounding, wherever they are known."""
    if isinstance(other, dict):
        return all(same(one[key], other[key], **tolerance) for key in other)
    if isinstance(other, list):
        return len(one) == len(other) and all(
            same(a, b, **tolerance) for a, b in zip(one, other))
    if isinstance(other, str) or other is None:
        return one == other
    return np.allclose(np.asarray(one, dtype=float), np.asarray(other, dtype=float),
                       equal_nan=True, **tolerance)


@pytest.mark.parametrize("name", CASES)
def test_samples_tell_what_snapshots_of_the_same_moments_do(tmp_path, name):
    import zenosphere
    interval = BASE["run"]["time"] / SAMPLES
    kept = ran(CASES[name], tmp_path / "kept.h5", output__snapshot_interval=interval)
    summed = ran(CASES[name], tmp_path / "summed.h5", measure__sampling_interval=interval,
                 output__collision_log="none")
    snapshots, samples = zenosphere.analyse(kept), zenosphere.analyse(summed)
    assert snapshots["accumulated"] is None and snapshots["snapshots"] == SAMPLES
    told = samples["accumulated"]
    assert (told["samples"], told["rows"]) == (SAMPLES, SAMPLES)
    assert told["from_time"] == pytest.approx(0.05) and told["to_time"] == 3.0
    for key in ("radial_distribution", "radial_distribution_by_direction", "contact_value",
                "granular_temperature", "sonine", "velocity_distribution", "profiles", "species",
                "partial_radial_distributions"):
        assert (key in samples) == (key in snapshots)
        # Sums in another order; velocities that a file has together with the profile.
        assert same(samples.get(key), snapshots.get(key), rtol=1e-9, atol=1e-9), key
    waves, counted = samples["structure_factor"], snapshots["structure_factor"]
    assert same(waves["at_zero"]["value"], counted["at_zero"]["value"], rtol=1e-9, atol=1e-9)
    if "drive" not in CASES[name] and len(waves["k"]):  # of one snapshot, by a mesh
        here = np.searchsorted(counted["k"], waves["k"] - 1e-9)
        assert len(here) >= 3 and same(waves["k"], counted["k"][here], rtol=1e-9)
    if snapshots["collision_distributions"]:
        assert same(samples["collision_distributions"], counted_in_log(kept, 0.05, 3.0), rtol=1e-5,
                    atol=0)


@pytest.mark.parametrize("case", [
    {}, SHEAR | {"system": {**BASE["system"], "solids_volume_fraction": 0.45}}, PLANE, WALLS,
    TWO_KINDS, {"system": {"dimension": 1, "spheres": 60, "restitution": 1.0,
                           "solids_volume_fraction": 0.4}},
], ids=["gas", "sheared gas", "disks", "walls", "mixture", "rods"])
def test_displacements_of_samples_are_those_of_snapshots_of_the_same_moments(tmp_path, case,
                                                                             monkeypatch):
    """Without a least time analyse cuts the snapshots into stretches of ten as well."""
    import zenosphere
    from zenosphere.analysis import displacements
    monkeypatch.setattr(displacements, "FREE_TIMES", 0)
    interval = 0.25
    times = {"run__time": 41 * interval, "measure__after_time": 0.05}
    kept = ran(case, tmp_path / "kept.h5", output__snapshot_interval=interval, **times)
    summed = ran(case, tmp_path / "summed.h5", measure__sampling_interval=interval, **times)
    snapshots, samples = zenosphere.analyse(kept), zenosphere.analyse(summed)
    for key in ("mean_square_displacement", "velocity_autocorrelation"):
        first = {name: column[:11] for name, column in samples[key].items() if name != "by_axis"}
        assert len(samples[key]["time"]) == 11 + 5  # to ten intervals, and to twice ten
        assert len(snapshots[key]["time"]) == 11
        assert same(first["time"], snapshots[key]["time"], rtol=1e-9)
        assert same(first["value"], snapshots[key]["value"], rtol=1e-9, atol=1e-9), key
    by_axis = snapshots["mean_square_displacement"]["by_axis"]
    assert np.isfinite(by_axis["x"]).all()
    for axis, column in by_axis.items():
        assert same(samples["mean_square_displacement"]["by_axis"][axis][:11], column, rtol=1e-9,
                    atol=1e-12)


def test_diffusion_of_samples_is_that_of_snapshots(tmp_path):
    """Both of the same run of an elastic gas, over stretches of 40 mean free times."""
    import zenosphere
    case = {"system": {**BASE["system"], "restitution": 1.0, "spheres": 256}}
    path = ran(case, tmp_path / "run.h5", measure__sampling_interval=0.4, run__time=160.0,
               output__snapshot_interval=0.4, output__collision_log="none")
    summed = zenosphere.analyse(path)["diffusion"]
    frames = tmp_path / "kept.h5"
    with h5py.File(path) as old, h5py.File(frames, "w") as new:
        for name in old:
            old.copy(name, new)
        for name, value in old.attrs.items():
            new.attrs[name] = value
        del new["zenosphere/samples"]
    kept = zenosphere.analyse(frames)["diffusion"]
    assert summed["standard_error"] < 0.02 and kept["standard_error"] < 0.02
    assert summed["value"] == pytest.approx(kept["value"], rel=1e-3)


def counted_in_log(path, from_time, to_time):
    """flight_time and normal_speed, without those bins that a rounded value may leave."""
    from zenosphere.analysis.collision_log import collision_distributions
    found = collision_distributions(path, from_time, to_time)
    return {name: {key: found[name][key] for key in ("mean", "number", "below_smallest_bin")}
            for name in ("flight_time", "normal_speed")}


@pytest.mark.parametrize("case", [{}, SHEAR, TWO_KINDS], ids=["gas", "sheared", "mixture"])
def test_stress_and_dissipation_of_the_layers_add_up_to_the_averages_of_the_run(tmp_path, case):
    """Collisional parts are the same sums; kinetic ones are seen in samples, not integrals."""
    import zenosphere
    path = ran(case, tmp_path / "run.h5", measure__sampling_interval=0.01, run__time=4.0)
    averages, found = zenosphere.open(path).summary["averages"], zenosphere.analyse(path)
    layers = found["profiles"]
    tensor = layers["pressure_tensor"].mean(axis=0)
    # 64 samples a row or fewer, so that all count but the last few of 400; the mean motion that
    # each layer of ten spheres has by chance is not its temperature: 1/10 less.
    assert tensor == pytest.approx(np.array(averages["pressure_tensor"]), rel=0.1,
                                   abs=0.05 * averages["pressure"])
    assert layers["dissipation"].mean() == pytest.approx(averages["dissipation"], rel=0.02)
    rates = found["accumulated"]["dissipation_by_kinds"]
    if rates:
        assert sum(each["dissipation"]["value"] for each in rates) == pytest.approx(
            layers["dissipation"].mean())


def test_impact_angles_of_an_elastic_gas_are_those_of_chaos(tmp_path):
    """Density sin 2x: 1/4 below 30 degrees, mean pi/4. Errors of independent collisions."""
    import zenosphere
    case = {"system": {**BASE["system"], "restitution": 1.0}}
    path = ran(case, tmp_path / "run.h5", measure__sampling_interval=0.5, run__time=20.0)
    angles = zenosphere.analyse(path)["collision_distributions"]["impact_angle"]
    number = angles["number"]
    assert number > 5000
    below = angles["density"][:15].sum() * np.pi / 90
    assert abs(below - 0.25) < 5 * np.sqrt(0.25 * 0.75 / number)
    assert abs(angles["mean"] - np.pi / 4) < 5 * 0.342 / np.sqrt(number)  # sqrt((pi^2 - 8)/16)


def test_contact_value_of_samples_is_that_of_the_pressure(tmp_path):
    """g = (Z - 1) / (4 phi) of the same elastic run, within 5 errors of both."""
    import zenosphere
    case = {"system": {**BASE["system"], "restitution": 1.0, "spheres": 500}}
    path = ran(case, tmp_path / "run.h5", measure__sampling_interval=0.25, run__time=40.0,
               measure__after_time=2.0, output__collision_log="none")
    averages = zenosphere.open(path).summary["averages"]
    contact = zenosphere.analyse(path)["contact_value"]
    expected = (averages["compressibility_factor"] - 1) / 1.2
    error = np.hypot(contact["standard_error"],
                     averages["standard_error"]["compressibility_factor"] / 1.2)
    assert abs(contact["value"] - expected) < 5 * error and error < 0.02 * expected


@pytest.mark.parametrize("case", [SHEAR, TWO_KINDS | WALLS], ids=["sheared", "walls"])
def test_resumed_run_accumulates_the_same_bits(tmp_path, case):
    whole = ran(case, tmp_path / "whole.h5", measure__sampling_interval=0.02, run__time=2.5)
    parts = ran(case, tmp_path / "parts.h5", measure__sampling_interval=0.02, run__time=1.17)
    program("resume", parts, "--set", "run.time=2.5")
    with h5py.File(whole) as one, h5py.File(parts) as other:
        first, second = one["zenosphere/samples"], other["zenosphere/samples"]
        names = []
        first.visit(names.append)
        assert "pair_counts/value" in names and len(first["time"]) > 16
        for name in names:
            if isinstance(first[name], h5py.Dataset):
                assert first[name][()].tobytes() == second[name][()].tobytes(), name
        assert (one["zenosphere/checkpoint/state"][()].tobytes()
                == other["zenosphere/checkpoint/state"][()].tobytes())


def test_many_samples_are_put_together_and_a_span_of_them_can_be_chosen(tmp_path):
    import zenosphere
    path = ran({}, tmp_path / "run.h5", measure__sampling_interval=0.01,
               output__snapshot_interval=1.5)
    samples = zenosphere.open(path).samples
    assert len(samples["time"]) <= 63 and set(samples["samples"]) == {8}  # 300 in rows of 8
    assert zenosphere.analyse(path, from_time=1.0, to_time=2.0)["accumulated"]["samples"] in range(
        80, 105)


def test_span_without_a_snapshot_is_told_from_its_samples(tmp_path, capsys):
    import zenosphere
    from zenosphere.__main__ import main
    path = ran({}, tmp_path / "run.h5", measure__sampling_interval=0.05,
               output__snapshot_interval=1.5, output__collision_log="none")
    found = zenosphere.analyse(path, from_time=1.6, to_time=2.9)
    assert (found["snapshots"], found["from_time"], found["to_time"]) == (0, None, None)
    assert found["accumulated"]["samples"] in range(20, 27)
    assert found["radial_distribution"]["g"][0] > 1 and found["touching"]["coordination"] is None
    assert found["structure_factor"]["k"].size >= 3
    assert main(["analyse", str(path), "--from-time", "1.6", "--to-time", "2.9", "-o",
                 str(tmp_path / "found.csv"), "--figures", str(tmp_path)]) == 0
    assert "0 snapshots of 108 spheres\n" in capsys.readouterr().out
    assert (tmp_path / "run-radial-distribution.png").exists()


def test_without_the_key_nothing_is_accumulated_and_the_bits_are_the_same(tmp_path):
    import zenosphere
    plain, summed = ran({}, tmp_path / "a.h5"), ran({}, tmp_path / "b.h5",
                                                    measure__sampling_interval=0.1)
    assert zenosphere.open(plain).samples == {}
    with h5py.File(plain) as one, h5py.File(summed) as other:
        assert "samples" not in one["zenosphere"]
        for name in ("collisions/gap", "collisions/time", "particles/spheres/velocity/value"):
            assert np.array_equal(one[name], other[name], equal_nan=True), name
