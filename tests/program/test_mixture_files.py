"""Spheres that differ and turn, in what other programs read and in what a run starts from."""

import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np
import pytest

from mixtures import MIXTURE, ROUGH, SNAPSHOTS


def exported(program, file_format, target):
    program("export", "out.h5", "--format", file_format, "-o", target)
    return program.folder / target


def test_exports_have_radius_mass_kind_and_angular_velocity(mixture):
    _, path = mixture.keep({**ROUGH, **SNAPSHOTS, "collision.reduced_moment_of_inertia": 0.6})
    with h5py.File(path) as file:
        group = file["particles/spheres"]
        diameter, mass, kind = (group[name][:] for name in ("diameter", "mass", "species"))
        spin, velocity = (group[f"{name}/value"][-1] for name in ("angular_velocity", "velocity"))
    lines = exported(mixture, "extxyz", "run.xyz").read_text().splitlines()[-91:]
    assert (":radius:R:1:masses:R:1:kind:I:1:angular_velocity:R:3:collisions:I:1 " in lines[0]
            and 'Kinds="small large"' in lines[0])
    table = np.array([line.split()[1:] for line in lines[1:]], float)
    assert np.array_equal(table[:, 7:10], mass[:, None] * velocity)
    assert np.array_equal(table[:, 10:12], np.stack([diameter / 2, mass], axis=1))
    assert np.array_equal(table[:, 12], kind)
    assert np.array_equal(table[:, 13:16], spin)

    text = exported(mixture, "lammps", "run.dump").read_text()
    names = text.rsplit("ITEM: ATOMS ", 1)[1].splitlines()[0].split()
    rows = np.array([line.split() for line in
                     text.rsplit("ITEM: ATOMS ", 1)[1].splitlines()[1:]], float)
    column = {name: rows[:, number] for number, name in enumerate(names)}
    assert np.array_equal(column["type"], kind + 1)
    assert np.array_equal(column["radius"], diameter / 2)
    assert np.array_equal(column["mass"], mass)
    assert np.array_equal(np.stack([column[f"omega{axis}"] for axis in "xyz"], axis=1), spin)

    exported(mixture, "vtp", "run.pvd")
    frame = sorted((mixture.folder / "run-frames").iterdir())[-1]
    arrays = {array.get("Name") for array in ElementTree.parse(frame).iter("DataArray")}
    assert {"radius", "mass", "kind", "angular_velocity"} <= arrays

    header, *_, last = exported(mixture, "csv-observables", "o.csv").read_text().splitlines()
    row = dict(zip(header.split(","), map(float, last.split(","))))
    inertia = 0.15 * mass * diameter**2  # 0.6 m s^2 / 4
    assert row["rotational_temperature"] == pytest.approx(
        (inertia * (spin**2).sum(axis=1)).mean() / 3, rel=1e-12)


def test_observables_are_those_of_the_spheres_that_move(mixture):
    _, path = mixture.keep({"drive.kind": "none", "species.large.immobile": "true"})
    with h5py.File(path) as file:
        velocity = file["particles/spheres/velocity/value"][-1, :60]  # small ones, of mass 1
    header, *_, last = exported(mixture, "csv-observables", "o.csv").read_text().splitlines()
    row = dict(zip(header.split(","), map(float, last.split(","))))
    assert row["temperature_xy"] == pytest.approx((velocity[:, 0] * velocity[:, 1]).mean(),
                                                  rel=1e-12)
    assert row["temperature_z"] == pytest.approx((velocity[:, 2]**2).mean(), rel=1e-12)
    assert row["fastest"] == pytest.approx(np.sqrt((velocity**2).sum(axis=1).max()), rel=1e-12)


def test_disks_turn_about_one_axis(mixture):
    _, path = mixture.keep({**ROUGH, "system.dimension": 2, "run.collisions": 300})
    with h5py.File(path) as file:
        group = file["particles/spheres"]
        inertia = 0.125 * group["mass"][:] * group["diameter"][:]**2  # of solid disks, m s^2 / 8
        spin = group["angular_velocity/value"][-1].ravel()
    header, *_, last = exported(mixture, "csv-observables", "o.csv").read_text().splitlines()
    row = dict(zip(header.split(","), map(float, last.split(","))))
    assert row["rotational_temperature"] == pytest.approx((inertia * spin**2).mean(), rel=1e-12)


def test_an_exported_frame_is_a_start(mixture):
    mixture.keep({**ROUGH, "drive.kind": "none"}, name="out.h5")
    exported(mixture, "extxyz", "last.xyz")
    mixture.case.write_text(mixture.case.read_text().replace("granular_temperature = 1\n", ""))
    summary = mixture.run({"drive.kind": "none", "start.arrangement": "file",
                           "start.file": "last.xyz", "run.collisions": 10})
    assert summary["collisions"] == 10


UNTOLD = MIXTURE[:MIXTURE.index("[[species]]")] + MIXTURE[MIXTURE.index("[start]"):] \
    .replace('"random"\ngranular_temperature = 1', '"file"\nfile = "first"')


def first_collisions(path):
    with h5py.File(path) as file:
        return [file[f"collisions/{name}"][:50] for name in ("i", "j", "time")]


@pytest.mark.parametrize("from_text", [True, False])
def test_a_start_file_tells_the_species_that_the_case_does_not(mixture, from_text):
    """The first snapshot is the start; pairs of large spheres would lose 0.7 there, here 0.9."""
    mixture.case.write_text(MIXTURE.replace("restitution = 0.7", "restitution = 0.9"))
    _, path = mixture.keep({"drive.kind": "none", "run.collisions": 100})
    start = exported(mixture, "extxyz", "first").rename(mixture.folder / "first") if from_text \
        else path
    frames = start.read_text().split("\n90\n") if from_text else []
    if from_text:
        start.write_text(frames[0] + "\n")  # the first frame alone
    mixture.case.write_text(UNTOLD)
    told = {"start.file": start.name, "drive.kind": "none", "run.collisions": 100,
            **({} if from_text else {"start.snapshot": 0})}
    summary, again = mixture.keep(told, name="again.h5")
    assert [(kind["name"], kind["spheres"]) for kind in summary["species"]] == [
        ("small", 60), ("large", 30)]
    with h5py.File(path) as one, h5py.File(again) as other:
        for name in ("diameter", "mass"):
            name = f"particles/spheres/{name}"
            assert np.allclose(one[name][:], other[name][:], rtol=1e-15, atol=0)
    for one, other in zip(first_collisions(path), first_collisions(again)):
        assert np.allclose(one, other, rtol=1e-12, atol=0)
    start.unlink()  # the output has the species: it does not need the file
    assert "large" in mixture("info", "again.h5").stdout
    mixture("verify", "again.h5")


def two_disks_and_a_third(words):
    """A frame of three disks 2 apart, with a kind and a radius each."""
    rows = [f"{word} {1 + 2 * n} 1 0 {1 - n} 0 0 {radius}" for n, (word, radius) in enumerate(words)]
    return "\n".join(["3", 'Lattice="9 0 0 0 9 0 0 0 1" Properties=species:S:1:pos:R:3:velo:R:3:'
                      "radius:R:1", *rows, ""])


THREE = """\
[system]
dimension = 2
spheres = 3
restitution = 0.9
sides = [9, 9]
[start]
arrangement = "file"
file = "three.xyz"
[drive]
kind = "none"
[run]
collisions = 1
"""


def test_disks_of_a_file_have_the_density_of_a_unit_disk_and_names(program):
    program.case.write_text(THREE)
    frame = two_disks_and_a_third([("A", 0.5), ("A", 0.5), ("B-2", 0.7)])
    (program.folder / "three.xyz").write_text(frame)
    text = program("check", "case.toml").stdout
    assert 'name = "B-2"\ndiameter = 1.4' in text and "spheres = 2" in text
    assert "mass = 1.96" not in text  # it follows from the diameter
    (program.folder / "three.xyz").write_text(frame.replace("B-2", "A"))
    assert 'name = "kind2"' in program("check", "case.toml").stdout


def test_kinds_of_a_file_that_a_case_cannot_have_are_refused(program):
    program.case.write_text(THREE)
    (program.folder / "three.xyz").write_text(
        two_disks_and_a_third([("A", 0.5), ("B", 0.7), ("A", 0.5)]))
    assert program.fail("run", "case.toml")[0].endswith(
        "three.xyz: sphere 2 is like sphere 0, and others are between them (spheres of a kind "
        "follow one another); sort the file by kind")
    kinds = "".join(f'[[species]]\nname = "{name}"\ndiameter = {diameter}\nspheres = {number}\n'
                    for name, diameter, number in (("B", 1.4, 1), ("A", 1.0, 2)))
    program.case.write_text(THREE + kinds)
    (program.folder / "three.xyz").write_text(
        two_disks_and_a_third([("A", 0.7), ("A", 0.5), ("B", 0.5)]))
    assert program.fail("run", "case.toml")[-1].endswith(
        "three.xyz: sphere 0 is of the kind A (in the case it is B); list the spheres in the order "
        "of the species")
