"""Going on from a snapshot of a run in another run: from any offset of its box, with other keys."""

import h5py
import numpy as np
import pytest

SIDE = (np.pi * 108 / (6 * 0.3)) ** (1 / 3)
CUT = 0.613  # a time at which the offset of the box is no whole number of anything
SINGLE_FLIGHTS = 60  # collisions that rounding of the state leaves alone: about one a sphere


def fields(path):
    """The snapshots and the log of an output file."""
    with h5py.File(path) as file:
        spheres = file["particles/spheres"]
        return {"position": spheres["position/value"][:], "velocity": spheres["velocity/value"][:],
                "edges": spheres["box/edges/value"][:], "time": spheres["position/time"][:],
                "image": spheres["image/value"][:],
                "log": {name: file[f"collisions/{name}"][:] for name in ("time", "i", "j")}}


@pytest.fixture
def cut(program):
    """A sheared run that ends at the cut, and the same run that goes on."""
    for name, time in (("cut", CUT), ("longer", 2 * CUT)):
        program.run({"run.collisions": 100000, "run.time": time}, "-o", f"{name}.h5")
    return fields(program.folder / "cut.h5"), fields(program.folder / "longer.h5")


def going_on(program, changes=(), start="cut.h5", name="on"):
    """A run from the file, of the case without its granular temperature."""
    case = program.case.read_text().replace('"fcc"', f'"file"\nfile = "{start}"')
    (program.folder / "on.toml").write_text(case.replace("granular_temperature = 0.1\n", ""))
    program("run", "on.toml", *program.words({"run.time": CUT, **dict(changes)}), "-o",
            f"{name}.h5")
    return fields(program.folder / f"{name}.h5")


def later_rows(run, time):
    """The rows of a log after a time, counted from it."""
    late = run["log"]["time"] > time
    return {name: column[late] - (time if name == "time" else 0)
            for name, column in run["log"].items()}


def test_a_run_from_the_end_of_a_sheared_one_goes_on_as_that_would_have(program, cut):
    before, longer = cut
    on = going_on(program)
    assert abs(before["edges"][-1][1, 0]) > 0.1
    assert np.array_equal(on["edges"][0], before["edges"][-1])
    assert np.array_equal(on["position"][0], before["position"][-1])
    # The engine has velocities in the frame of a layer: they are rounded as the flow there is.
    fastest_flow = 2.0 * SIDE / 2
    assert np.abs(on["velocity"][0] - before["velocity"][-1]).max() <= 4 * np.spacing(fastest_flow)
    expected = later_rows(longer, CUT)
    for name in ("i", "j"):
        assert np.array_equal(on["log"][name][:SINGLE_FLIGHTS], expected[name][:SINGLE_FLIGHTS])
    assert np.allclose(on["log"]["time"][:SINGLE_FLIGHTS], expected["time"][:SINGLE_FLIGHTS],
                       rtol=0, atol=1e-11)
    assert "contradicted" not in program("verify", "on.h5").stdout


@pytest.mark.parametrize("changes", [
    {"system.restitution": 0.5},
    {"drive.shear_rate": 0.3},
    {"drive.shear_rate": 0},
    {"collision.contact_duration": 1e-3},
    {"collision.precision": "quad", "run.collisions": 300},
    {"gravity.acceleration": "[0.1, 0, -0.2]"},
])
def test_it_goes_on_with_other_keys(program, cut, changes):
    before, longer = cut
    on = going_on(program, changes)
    assert np.array_equal(on["position"][0], before["position"][-1])
    assert np.array_equal(on["edges"][0], before["edges"][-1])
    if "system.restitution" in changes:  # what is to come is the same until a sphere comes again
        first = later_rows(longer, CUT)
        assert (on["log"]["i"][0], on["log"]["j"][0]) == (first["i"][0], first["j"][0])
        assert abs(on["log"]["time"][0] - first["time"][0]) < 1e-13
    program("verify", "on.h5")


def test_without_shear_the_offset_stays(program, cut):
    case = program.case
    case.write_text(case.read_text().replace('kind = "shear"\nshear_rate = 2.0', 'kind = "none"'))
    on = going_on(program)
    offset = cut[0]["edges"][-1][1, 0]
    assert np.all(on["edges"][:, 1, 0] == offset)
    assert len(on["log"]["time"]) > 500
    program("verify", "on.h5")


def test_the_snapshot_can_be_chosen(program):
    program.run({"run.collisions": 100000, "run.time": 1, "output.snapshot_interval": 0.1}, "-o",
                "cut.h5")
    whole = fields(program.folder / "cut.h5")
    on = going_on(program, {"start.snapshot": 4})
    assert np.array_equal(on["position"][0], whole["position"][4])
    expected = later_rows(whole, whole["time"][4])
    assert np.array_equal(on["log"]["i"][:SINGLE_FLIGHTS], expected["i"][:SINGLE_FLIGHTS])
    problem = program("check", "on.toml", "--set", "start.snapshot=11", code=2).stderr
    assert problem.endswith("cut.h5: has 11 snapshots (start.snapshot = 11, counted from 0); choose"
                            " one of them\n")


def test_an_exported_frame_is_the_same_start(program, cut):
    program("export", "cut.h5", "--format", "extxyz", "-o", "cut.xyz")
    one = going_on(program)
    other = going_on(program, start="cut.xyz", name="other")
    for name in ("position", "velocity", "edges"):
        assert np.array_equal(one[name], other[name])
    assert np.array_equal(one["log"]["time"], other["log"]["time"])


def test_resume_names_the_way_to_go_on_with_other_keys(program, cut):
    problem = program("resume", "cut.h5", "--set", "system.restitution=0.5", code=2).stderr
    for word in ('arrangement = "file"', 'file = "cut.h5"', "[start]"):
        assert word in problem
    assert problem.count("\n") == 1


def test_images_tell_where_spheres_have_come_to(program, cut):
    before, longer = cut
    unwrapped = [run["position"][-1] + run["image"][-1] @ run["edges"][-1] for run in cut]
    assert np.any(longer["image"][-1])
    # Along y and z spheres have speeds of at most 3 here, and are carried by nothing.
    moved = np.abs(unwrapped[1] - unwrapped[0])[:, 1:]
    assert moved.max() < 3 * CUT
    assert np.abs(unwrapped[0] - before["position"][0])[:, 1:].max() < 3 * CUT
