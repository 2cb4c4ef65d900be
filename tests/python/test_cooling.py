"""Haff's law: its formulas, and the sub-command that draws it."""

import json

import h5py
import numpy as np
import pytest

from zenosphere.__main__ import main
from zenosphere.cooling import law as cooling
from zenosphere.run_file import RunFile

SPHERES = 400


def write_cooling(path, temperatures, interval=0.5, kind="none", dimension=3, log=None,
                  collision=""):
    """A run whose snapshots have the given granular temperatures, and its path.

    log: (time, normal_speed) of its collisions;  collision: lines of the table [collision]
    """
    random = np.random.default_rng(seed=1)
    pattern = random.standard_normal((SPHERES, dimension))
    pattern -= pattern.mean(axis=0)
    pattern /= np.sqrt(np.mean(pattern**2))
    roots = np.sqrt(np.asarray(temperatures, dtype=float))
    rate = "shear_rate = 2.0\n" if kind == "shear" else ""
    with h5py.File(path, "w") as file:
        spheres = file.create_group("particles/spheres")
        places = random.random((len(roots), SPHERES, dimension)) * 8
        velocities = roots[:, None, None] * pattern + 3.0  # a common drift does not count
        if rate:
            velocities[:, :, 0] += 2.0 * (places[:, :, 1] - 4)
        spheres["position/value"], spheres["velocity/value"] = places, velocities
        spheres["position/time"] = interval * np.arange(len(roots))
        spheres["box/edges/value"] = np.tile(8.0 * np.eye(dimension), (len(roots), 1, 1))
        group = file.create_group("zenosphere")
        group.attrs.update({"format_version": 1, "complete": 1})
        group["summary"] = json.dumps({"verdict": "none"})
        group["resolved"] = (f"[system]\ndimension = {dimension}\nspheres = {SPHERES}\n"
                             "restitution = 0.9\nsolids_volume_fraction = 0.3\n"
                             f'[drive]\nkind = "{kind}"\n{rate}[collision]\n{collision}')
        if log:
            collisions = file.create_group("collisions")
            collisions.attrs["complete"] = 1
            empty = np.zeros(len(log[0]))
            for name in ("i", "j", "gap", "flags"):
                collisions[name] = empty
            collisions["k"] = np.arange(1, len(log[0]) + 1)
            collisions["time"], collisions["normal_speed"] = log
    return path


def haff(time, tau):
    return (1 + np.asarray(time) / tau) ** -2


def test_tau_is_that_of_the_reference_case():
    """phi = 0.3, T0 = 1, e = 0.9: tau = 3.146, from an independent computation."""
    assert cooling.haff_time(3, 0.3, 0.9, 1.0) == pytest.approx(3.146, abs=5e-4)


def test_collision_rate_is_that_of_the_reference_case():
    """3-D, phi = 0.3, T = 1: 10.105(9) from kinetic Monte Carlo; Carnahan-Starling is 0.4 % low."""
    assert cooling.collision_rate(3, 0.3, 1.0) == pytest.approx(10.10, rel=5e-3)


def test_rods_collide_at_twice_the_density_times_the_mean_relative_speed():
    """n / (1 - n) = 1 at n = 1/2, and the mean of |v1 - v2| is 2 / sqrt(pi) at T = 1."""
    assert cooling.collision_rate(1, 0.5, 1.0) == pytest.approx(2 / np.sqrt(np.pi))


def test_cumulant_vanishes_for_elastic_spheres_and_at_the_root_of_one_half():
    for dimension in (2, 3):
        assert cooling.fourth_cumulant(dimension, 1.0) == 0
        assert cooling.fourth_cumulant(dimension, np.sqrt(0.5)) == pytest.approx(0, abs=1e-15)
    # 16 x 0.1 x (1 - 1.62) / (81 - 15.3 + 2.43), the formula of three dimensions
    assert cooling.fourth_cumulant(3, 0.9) == pytest.approx(-0.992 / 68.13)


def test_tau_is_infinite_where_nothing_is_lost():
    assert cooling.haff_time(3, 0.3, 1.0, 1.0) == np.inf


def test_fit_finds_the_tau_of_an_exact_decay():
    time = np.linspace(0, 10, 21)
    assert cooling.fitted_time(time, 4.0 * haff(time, 2.5)) == pytest.approx(2.5)


def test_drift_and_imposed_profile_are_not_temperature(tmp_path):
    path = write_cooling(tmp_path / "sheared.h5", [4.0, 1.0], kind="shear")
    with RunFile(path) as run:
        time, temperature = cooling.temperature_of_snapshots(run)
    assert time.tolist() == [0, 0.5]
    assert temperature == pytest.approx([4.0, 1.0])


def test_losses_of_collisions_lower_the_temperature(tmp_path):
    """(1 - 0.81) / 4 x 2^2 = 0.19 is lost; T = 2 E / (3 x 400) falls by 0.38 / 1200."""
    path = write_cooling(tmp_path / "run.h5", [1.0, 1.0], log=([0.1, 0.2], [2.0, 2.0]))
    with RunFile(path) as run:
        time, temperature = cooling.temperature_of_collisions(run, 1.0)
    assert time.tolist() == [0.1, 0.2]
    assert temperature == pytest.approx([1 - 0.38 / 1200, 1 - 0.76 / 1200], abs=1e-15)


@pytest.mark.parametrize("kind, how", [("none", "tau = 3.146 (by formula)"),
                                       ("random", "tau = 2 (fitted to the snapshots")])
def test_command_draws_a_figure_and_says_which_tau(tmp_path, capsys, kind, how):
    path = write_cooling(tmp_path / "run.h5", haff(0.5 * np.arange(40), 2.0), kind=kind)
    figure = tmp_path / "haff.png"
    assert main(["cooling", str(path), "-o", str(figure)]) == 0
    assert how in capsys.readouterr().out
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_run_without_snapshots_between_start_and_end_is_refused(tmp_path, capsys):
    path = write_cooling(tmp_path / "run.h5", [1.0, 0.5])
    assert main(["cooling", str(path), "-o", str(tmp_path / "haff.png")]) == 2
    assert "output.snapshot_interval" in capsys.readouterr().err


def test_folder_that_is_not_there_is_exit_code_4(tmp_path, capsys):
    path = write_cooling(tmp_path / "run.h5", haff(np.arange(9), 2.0))
    assert main(["cooling", str(path), "-o", str(tmp_path / "no" / "haff.png")]) == 4
    assert "haff.png: cannot be written" in capsys.readouterr().err


def test_viscoelastic_run_is_fitted_with_the_power_five_thirds(tmp_path):
    time = 0.5 * np.arange(20)
    path = write_cooling(tmp_path / "run.h5", (1 + time / 4.0) ** (-5 / 3),
                         collision='restitution_law = "viscoelastic"\nviscoelastic_constant = 0.1\n')
    with RunFile(path) as run:
        law = cooling.haff_of(run, *cooling.temperature_of_snapshots(run))
    assert (law.tau, law.power, law.is_fitted) == (pytest.approx(4.0, rel=1e-6), 5 / 3, True)
    assert main(["cooling", str(path), "-o", str(tmp_path / "cooling.png")]) == 0


FIXED_LOSS = 'restitution_law = "fixed-loss"\nenergy_loss = 0.1\n'


def test_run_with_a_fixed_loss_is_fitted_and_named(tmp_path):
    path = write_cooling(tmp_path / "run.h5", haff(0.5 * np.arange(40), 2.0), collision=FIXED_LOSS)
    with RunFile(path) as run:
        law = cooling.haff_of(run, *cooling.temperature_of_snapshots(run))
    assert (law.power, law.is_fitted) == (2, True)
    assert main(["cooling", str(path), "-o", str(tmp_path / "cooling.png")]) == 0


ROUGH = "tangential_restitution = 0.5\nfriction = 0.3\n"


@pytest.mark.parametrize("collision", ["contact_duration = 1e-3\n", FIXED_LOSS, ROUGH])
def test_losses_are_not_counted_where_some_collisions_are_elastic(tmp_path, collision):
    path = write_cooling(tmp_path / "run.h5", [1, 0.9], log=([0.1], [1.0]), collision=collision)
    with RunFile(path) as run:
        assert cooling.temperature_of_collisions(run, 1.0)[0].size == 0


def test_a_mixture_is_refused_since_its_spheres_have_masses_of_their_own(tmp_path, capsys):
    path = write_cooling(tmp_path / "run.h5", haff(np.arange(9), 2.0),
                         collision="[[species]]\nname = 'a'\nmass = 2.0\nshare = 1.0\n")
    assert main(["cooling", str(path), "-o", str(tmp_path / "haff.png")]) == 2
    assert "spheres that differ" in capsys.readouterr().err


def test_figure_of_cooling_has_the_formats_asked_for(tmp_path):
    path = write_cooling(tmp_path / "run.h5", haff(np.arange(9), 2.0))
    assert main(["cooling", str(path), "-o", str(tmp_path / "haff.png"), "--format",
                 "pdf,svg"]) == 0
    assert {each.name for each in tmp_path.glob("haff.*")} == {"haff.pdf", "haff.svg"}


def test_figure_of_cooling_refuses_a_suffix_that_is_no_format(tmp_path, capsys):
    path = write_cooling(tmp_path / "run.h5", haff(np.arange(9), 2.0))
    assert main(["cooling", str(path), "-o", str(tmp_path / "haff.jpg")]) == 2
    assert ".jpg names no format" in capsys.readouterr().err
