"""`zenosphere export`: the programs that the files are for read in them what the run recorded."""

import base64
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from recorded import Recorded, distances, sheared_cell
from viewers import collection, in_ase, in_mdanalysis, in_vtk, package

SHEAR_RATE = 2.0  # of the small case
SIDE = (np.pi * 108 / (6 * 0.3)) ** (1 / 3)
PLANE = {"system.dimension": 2, "start.arrangement": "random", "system.spheres": 40,
         "run.collisions": 400, "output.snapshot_interval": 0.1}
LINE = {"system.dimension": 1, "start.arrangement": "random", "system.spheres": 12,
        "drive.kind": "none", "drive.shear_rate": 0, "run.collisions": 60}
WALLED = {**PLANE, "drive.kind": "none", "drive.shear_rate": 0, "walls.axis": "y",
          "walls.restitution": 0.9}
SINGLE = 1e-6  # MDAnalysis keeps numbers of up to 6 diameters in 24 bits, of which it adds some


@pytest.fixture
def export(program):
    """Exports the file of a run in a format; the path of what was written."""

    def exported(run, file_format, *words, name=None):
        target = program.folder / (name or f"frames.{'pvd' if file_format == 'vtp' else 'txt'}")
        program("export", str(run), "--format", file_format, "-o", str(target), *words)
        return target

    return exported


def telling(run):
    """Snapshots after several strain units: the most and the least leaning ones, and the last."""
    late = np.flatnonzero(run.time * SHEAR_RATE > 3)
    leaning = np.abs(run.edges[late, 1, 0])
    return {late[np.argmax(leaning)], late[np.argmin(leaning)], late[-1]}


def true_distances(run, n):
    """From the positions in the output file and the strain alone."""
    return distances(run.position[n], sheared_cell(SIDE, SHEAR_RATE * run.time[n]))


def test_ase_reads_extended_xyz_to_the_last_bit(export, sheared):
    run = Recorded(sheared[1])
    frames = in_ase(export(sheared[1], "extxyz"), "extxyz")
    assert len(frames) == len(run.time)
    for n, frame in enumerate(frames):
        assert np.array_equal(frame.positions, run.position[n])
        assert np.array_equal(frame.arrays["velo"], run.velocity[n])
        assert np.array_equal(frame.get_velocities(), run.velocity[n])
        assert np.array_equal(frame.cell[:], run.cell(n)) and frame.pbc.all()
        assert np.array_equal(frame.arrays["id"], np.arange(108))
        assert np.array_equal(frame.arrays["collisions"], run.collisions(n))
        assert np.all(frame.arrays["radius"] == 0.5)
        info = frame.info
        assert (info["Time"], info["Step"], info["Snapshot"]) == (run.time[n], run.step[n], n)


def test_distances_in_ase_are_those_of_the_run(export, sheared):
    run = Recorded(sheared[1])
    frames = in_ase(export(sheared[1], "extxyz"), "extxyz")
    for n in telling(run):
        found = frames[n].get_all_distances(mic=True)[np.triu_indices(108, 1)]
        assert np.max(np.abs(found - true_distances(run, n))) < 1e-12  # ulps of five strain units


def test_ase_reads_lammps_dumps(export, sheared):
    run = Recorded(sheared[1])
    frames = in_ase(export(sheared[1], "lammps"), "lammps-dump-text", units="ASE")
    assert len(frames) == len(run.time)
    for n, frame in enumerate(frames):
        assert np.allclose(frame.cell[:], run.cell(n), rtol=0, atol=4e-15)  # bounds are sums
        shift = (frame.positions - run.position[n]) / SIDE
        assert np.max(np.abs(shift[:, 0] - np.round(shift[:, 0]))) < 1e-15
        assert np.all(shift[:, 1:] == 0)
        assert np.allclose(frame.get_velocities(), run.velocity[n], rtol=1e-15, atol=0)
        assert np.array_equal(frame.arrays["c_collisions"].ravel(), run.collisions(n))


def test_spheres_of_a_lammps_dump_are_numbered_from_1(export, sheared):
    lines = export(sheared[1], "lammps", "--from", "-1").read_text().splitlines()
    columns = lines[8].removeprefix("ITEM: ATOMS ").split()
    assert columns[:2] == ["id", "type"]
    assert [int(line.split()[0]) for line in lines[9:]] == list(range(1, 109))


def test_images_of_a_lammps_dump_lead_to_where_the_spheres_have_come(export, sheared):
    run = Recorded(sheared[1])
    lines = iter(export(sheared[1], "lammps").read_text().splitlines())
    for n in range(len(run.time)):
        head = [next(lines) for _ in range(9)]
        columns = head[8].removeprefix("ITEM: ATOMS ").split()
        table = np.array([next(lines).split() for _ in range(108)], dtype=float)
        place, flags = (table[:, [columns.index(name) for name in names.split()]]
                        for names in ("x y z", "ix iy iz"))
        tilt = float(head[5].split()[2])
        cell = np.array([[SIDE, 0, 0], [tilt, SIDE, 0], [0, 0, SIDE]])
        expected = run.position[n] + run.image[n] @ run.cell(n)
        assert np.allclose(place + flags @ cell, expected, rtol=1e-14, atol=1e-13)
    assert np.abs(run.image[-1]).max(axis=0).min() > 0


def test_lammps_box_leans_by_at_most_half_a_side_and_holds_every_sphere(export, sheared):
    frames = in_ase(export(sheared[1], "lammps"), "lammps-dump-text", units="ASE")
    leaning = [frame.cell[1, 0] / SIDE for frame in frames]
    assert np.max(leaning) > 0.4 and np.min(leaning) < -0.4
    assert np.all(np.abs(leaning) <= 0.5)
    for frame in frames:
        fractions = frame.positions @ np.linalg.inv(frame.cell[:])
        assert np.all((fractions > -1e-14) & (fractions < 1 + 1e-14))


def test_mdanalysis_reads_lammps_dumps(export, sheared):
    run = Recorded(sheared[1])
    universe = in_mdanalysis(export(sheared[1], "lammps"), "LAMMPSDUMP", 108)
    from MDAnalysis.lib.distances import self_distance_array
    assert len(universe.trajectory) == len(run.time)
    for n, frame in enumerate(universe.trajectory):
        assert frame.data["step"] == run.step[n]
        assert np.allclose(frame.triclinic_dimensions, run.cell(n), rtol=0, atol=2 * SINGLE)
        shift = (frame.positions - run.position[n]) / SIDE
        assert np.max(np.abs(shift - np.round(shift))) < SINGLE
        assert np.allclose(frame.velocities, run.velocity[n], rtol=SINGLE, atol=0)
        if n in telling(run):
            found = self_distance_array(frame.positions, box=frame.dimensions)
            assert np.max(np.abs(found - true_distances(run, n))) < 4 * SINGLE


def test_mdanalysis_reads_the_output_file_itself(sheared):
    run = Recorded(sheared[1])
    universe = in_mdanalysis(sheared[1], "H5MD", 108, convert_units=False)
    from MDAnalysis.lib.distances import self_distance_array
    assert len(universe.trajectory) == len(run.time)
    for n, frame in enumerate(universe.trajectory):
        assert frame.time == run.time[n] and frame.data["step"] == run.step[n]
        assert np.allclose(frame.positions, run.position[n], rtol=SINGLE, atol=0)
        assert np.allclose(frame.velocities, run.velocity[n], rtol=SINGLE, atol=0)
        assert np.allclose(frame.triclinic_dimensions, run.cell(n), rtol=0, atol=2 * SINGLE)
        if n in telling(run):
            found = self_distance_array(frame.positions, box=frame.dimensions)
            assert np.max(np.abs(found - true_distances(run, n))) < 4 * SINGLE


def test_vtk_reads_frames_to_the_last_bit(export, sheared):
    run = Recorded(sheared[1])
    entries = collection(export(sheared[1], "vtp"))
    assert [time for time, _ in entries] == run.time.tolist()
    for n, (time, path) in enumerate(entries):
        points, arrays, field = in_vtk(path)
        assert np.array_equal(points, run.position[n])
        assert np.array_equal(arrays["velocity"], run.velocity[n])
        assert np.array_equal(arrays["id"], np.arange(108)) and np.all(arrays["radius"] == 0.5)
        assert np.array_equal(arrays["collisions"], run.collisions(n))
        assert np.array_equal(field["cell"].reshape(3, 3), run.cell(n))
        assert (field["TimeValue"][0], field["step"][0]) == (time, run.step[n])


def whole_numbers(array):
    """Of a DataArray of integers: behind how many bytes they are."""
    return np.frombuffer(base64.b64decode(array.text), "<i8")[1:]


def test_frames_are_built_as_ovito_needs_them(export, sheared):
    """OVITO looks for the piece as the first of the first, and for a vertex for each point."""
    for _, path in collection(export(sheared[1], "vtp", "--every", "10")):
        assert path.read_text().startswith('<?xml version="1.0"?>\n<VTKFile type="PolyData"')
        piece = ElementTree.parse(path).getroot()[0][0]
        assert piece.tag == "Piece" and piece.get("NumberOfVerts") == piece.get("NumberOfPoints")
        assert {array.get("format") for array in piece.iter("DataArray")} == {"binary"}
        vertices = np.arange(int(piece.get("NumberOfVerts")))
        assert np.array_equal(whole_numbers(piece.find(".//*[@Name='connectivity']")), vertices)
        assert np.array_equal(whole_numbers(piece.find(".//*[@Name='offsets']")), vertices + 1)


def test_distances_in_vtk_are_those_of_the_run(export, sheared):
    run = Recorded(sheared[1])
    entries = collection(export(sheared[1], "vtp"))
    for n in telling(run):
        points, _, field = in_vtk(entries[n][1])
        found = distances(points, field["cell"].reshape(3, 3))
        assert np.max(np.abs(found - true_distances(run, n))) < 1e-12


def test_pandas_reads_every_collision_to_the_last_bit(export, sheared):
    pandas = package("pandas")
    run = Recorded(sheared[1])
    table = pandas.read_csv(export(sheared[1], "csv-collisions"), float_precision="round_trip")
    names = ["k", "time", "i", "j", "gap", "normal_speed", "flags"]
    assert list(table.columns) == names
    for name in names:
        assert np.array_equal(table[name], run.log[name], equal_nan=name == "gap")


def test_pandas_reads_observables_that_follow_from_the_snapshots(export, sheared):
    pandas = package("pandas")
    run = Recorded(sheared[1])
    table = pandas.read_csv(export(sheared[1], "csv-observables"), float_precision="round_trip")
    own = run.velocity.copy()
    own[:, :, 0] -= SHEAR_RATE * (run.position[:, :, 1] - SIDE / 2)
    expected = {"snapshot": np.arange(len(run.time)), "collisions": run.step, "time": run.time,
                "collisions_per_sphere": run.step / 54, "strain": SHEAR_RATE * run.time,
                "offset": run.edges[:, 1, 0], "granular_temperature": np.mean(own**2, axis=(1, 2)),
                "temperature_xy": np.mean(own[:, :, 0] * own[:, :, 1], axis=1),
                "fastest": np.sqrt(np.max(np.sum(own**2, axis=2), axis=1))}
    for axis, name in enumerate("xyz"):
        expected[f"temperature_{name}"] = np.mean(own[:, :, axis]**2, axis=1)
    assert set(table.columns) == set(expected)
    for name, values in expected.items():
        assert np.allclose(table[name], values, rtol=1e-13, atol=1e-14), name  # 108 terms a sum


@pytest.mark.parametrize("changes, periodic", [(PLANE, "TTF"), (LINE, "TFF"), (WALLED, "TFF")],
                         ids=["plane", "line", "walled plane"])
def test_missing_axes_are_one_diameter_thick_and_closed(program, export, changes, periodic):
    _, path = program.keep(changes)
    run = Recorded(path)
    closed = [letter == "T" for letter in periodic]
    [*_, xyz] = in_ase(export(path, "extxyz", name="x"), "extxyz")
    [*_, dump] = in_ase(export(path, "lammps", name="l"), "lammps-dump-text", units="ASE")
    points, arrays, field = in_vtk(collection(export(path, "vtp"))[-1][1])
    assert np.array_equal(xyz.positions, run.position[-1]) and xyz.pbc.tolist() == closed
    assert np.array_equal(points, run.position[-1]) and dump.pbc.tolist() == closed
    assert np.array_equal(arrays["velocity"], run.velocity[-1])
    assert np.array_equal(arrays["collisions"], run.collisions(-1))
    for cell in (xyz.cell[:], dump.cell[:], field["cell"].reshape(3, 3)):
        assert np.allclose(cell, run.cell(-1), rtol=0, atol=4e-15)
    origin = [0 if axis < run.dimension else -0.5 for axis in range(3)]
    assert xyz.info["Origin"].tolist() == field["origin"].ravel().tolist() == origin
    assert dump.get_celldisp().ravel().tolist() == origin
    found = distances(dump.positions, dump.cell[:], closed)
    assert np.allclose(found, distances(run.position[-1], run.cell(-1), closed), rtol=0, atol=1e-13)


def test_mdanalysis_puts_the_corner_of_a_plane_at_its_origin(program, export):
    _, path = program.keep(PLANE)
    run = Recorded(path)
    frame = in_mdanalysis(export(path, "lammps"), "LAMMPSDUMP", 40).trajectory[-1]
    assert np.all(frame.positions[:, 2] == 0.5)
    found = distances(frame.positions.astype(float), run.cell(-1), (True, True, False))
    expected = distances(run.position[-1], run.cell(-1), (True, True, False))
    assert np.max(np.abs(found - expected)) < 8 * SINGLE  # the box is some 10 diameters wide


def test_python_of_the_page_runs(program, checkout, monkeypatch):
    package("ase")
    package("pandas")
    page = (checkout / "docs" / "export.md").read_text()
    [script] = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    program.keep({"output.snapshot_interval": 0.1})
    for words in (["extxyz", "-o", "last.xyz", "--from", "-1"],
                  ["csv-observables", "-o", "observables.csv"]):
        program("export", "out.h5", "--format", *words)
    monkeypatch.chdir(program.folder)
    exec(compile(script, "export.md", "exec"), {})


def test_python_of_the_page_reads_four_thousand_spheres_in_little_memory(program, checkout):
    package("ase")
    package("pandas")
    page = (checkout / "docs" / "export.md").read_text()
    [script] = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    program.keep({"system.spheres": 4000, "run.collisions": 10})
    for words in (["extxyz", "-o", "last.xyz"], ["csv-observables", "-o", "observables.csv"]):
        program("export", "out.h5", "--format", *words)
    # 2 GiB of addresses, libraries included; all distances of ASE would take 8.
    script = f"import resource\nresource.setrlimit(resource.RLIMIT_AS, (2**31, 2**31))\n{script}"
    done = subprocess.run([sys.executable, "-c", script], cwd=program.folder, text=True,
                          capture_output=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    assert done.returncode == 0, done.stderr


def test_exported_end_of_an_upright_run_is_a_start(program, export):
    _, path = program.keep({"drive.kind": "none", "drive.shear_rate": 0})
    export(path, "extxyz", "--from", "-1", name="end.xyz")
    case = program.case.read_text().replace("granular_temperature = 0.1", 'file = "end.xyz"')
    program.case.write_text(case.replace('"fcc"', '"file"').replace("seed = 7\n", ""))
    _, again = program.keep({"drive.kind": "none", "drive.shear_rate": 0}, "again.h5")
    before, after = Recorded(path), Recorded(again)
    assert np.array_equal(after.position[0], before.position[-1])
    assert np.array_equal(after.velocity[0], before.velocity[-1])
