"""The output file: the structure of docs/file-format.md, and that its snapshots are the system."""

import json
import re
import tomllib

import h5py
import numpy as np
import pytest

SPHERES = "particles/spheres"
SHEAR_RATE = 2.0  # of the small case
SIDE = (np.pi * 108 / (6 * 0.3)) ** (1 / 3)
COLUMNS = {"k": "<i8", "time": "<f8", "i": "<i4", "j": "<i4", "gap": "<f8",
           "normal_speed": "<f8", "flags": "|u1"}


@pytest.fixture
def file(sheared):
    with h5py.File(sheared[1]) as opened:
        yield opened


def snapshots(file):
    """Arrays of position, velocity, box edges and time, one row a snapshot."""
    spheres = file[SPHERES]
    return (spheres["position/value"][()], spheres["velocity/value"][()],
            spheres["box/edges/value"][()], spheres["position/time"][()])


def peculiar(position, velocity, shear_rate=SHEAR_RATE, side=SIDE):
    velocity = velocity.copy()
    velocity[:, 0] -= shear_rate * (position[:, 1] - side / 2)
    return velocity


def least_distance(position, edges):
    """Smallest distance of two centres, in the nearest image of the sliding periodic box."""
    side = edges[0, 0]
    i, j = np.triu_indices(len(position), 1)
    apart = position[j] - position[i]
    boxes = np.round(apart[:, 1] / side)
    apart[:, 1] -= boxes * side
    apart[:, 0] -= boxes * edges[1, 0]
    for axis in (0, 2):
        apart[:, axis] -= np.round(apart[:, axis] / side) * side
    return np.sqrt(np.min(np.sum(apart**2, axis=1)))


def test_h5md_part_says_what_it_is(file):
    assert file["h5md"].attrs["version"].tolist() == [1, 1]
    assert file["h5md/author"].attrs["name"] == "unknown"
    assert file["h5md/creator"].attrs["name"] == "zenosphere"
    assert file["h5md/creator"].attrs["version"] == file["zenosphere"].attrs["program_version"]
    box = file[f"{SPHERES}/box"].attrs
    assert box["dimension"] == 3 and box["dimension"].dtype == np.int64
    assert box["boundary"].tolist() == ["periodic"] * 3


def test_snapshots_have_the_documented_types_and_shapes(file):
    spheres = file[SPHERES]
    rows = len(spheres["position/step"])
    expected = {"position/value": ("<f8", (rows, 108, 3)),
                "velocity/value": ("<f8", (rows, 108, 3)), "box/edges/value": ("<f8", (rows, 3, 3)),
                "position/step": ("<i8", (rows,)), "position/time": ("<f8", (rows,))}
    found = {name: (spheres[name].dtype.str, spheres[name].shape) for name in expected}
    assert found == expected and rows > 20


def test_step_and_time_are_the_same_datasets_everywhere(file):
    for name in ("step", "time"):
        first = file[f"{SPHERES}/position/{name}"]
        assert file[f"{SPHERES}/velocity/{name}"] == first
        assert file[f"{SPHERES}/box/edges/{name}"] == first


def test_log_has_the_documented_types_and_every_collision(file, sheared):
    log = file["collisions"]
    assert {name: log[name].dtype.str for name in log} == COLUMNS
    assert np.array_equal(log["k"], np.arange(1, sheared[0]["collisions"] + 1))
    assert log.attrs["complete"] == 1 and log.attrs["complete"].dtype == np.uint8
    i, j = log["i"][()], log["j"][()]
    assert np.all((0 <= i) & (i < j) & (j < 108))


def names_in(file):
    """The names of all groups, datasets and attributes, parts of a path by themselves."""
    names = []
    file.visititems(lambda name, item: names.extend([*name.split("/"), *item.attrs]))
    return set(names)


def test_every_path_of_a_file_is_documented(file, collapsed, checkout):
    page = (checkout / "docs" / "file-format.md").read_text()
    words = set(re.findall(r"\w+", page))
    assert names_in(file) <= words
    with h5py.File(collapsed[1]) as other:
        assert {"anatomy", "hit", "arrest"} <= names_in(other) <= words


def test_provenance_is_complete(file, program):
    own = file["zenosphere"]
    assert own.attrs["format_version"] == 1 and own.attrs["complete"] == 1
    assert own.attrs["format_version"].dtype == np.int64
    texts = ("program_version", "git_hash", "compiler", "compiler_flags")
    assert all(isinstance(own.attrs[name], str) and own.attrs[name] for name in texts)
    assert own["case"][()].decode() == program.case.read_text()


def test_resolved_case_holds_the_overrides(file):
    resolved = tomllib.loads(file["zenosphere/resolved"][()].decode())
    assert resolved["run"] == {"collisions": 10**6, "time": 2.53}
    assert resolved["output"]["snapshot_interval"] == 0.0917
    assert resolved["collapse"]["gap_threshold"] == 1e-16


def test_summary_is_the_object_that_the_run_printed(file, sheared):
    assert json.loads(file["zenosphere/summary"][()]) == sheared[0]


def test_first_snapshot_is_the_start(file):
    position, velocity, _, time = (values[0] for values in snapshots(file))
    assert time == 0 and file[f"{SPHERES}/position/step"][0] == 0
    own = peculiar(position, velocity)
    assert np.all(np.abs(own.mean(axis=0)) < 1e-15)  # some ulps of a speed near 6
    assert np.mean(own**2) == pytest.approx(0.1, rel=1e-12)


def test_fcc_start_is_a_lattice(file):
    position = snapshots(file)[0][0]
    constant = SIDE / 3  # 108 = 4 x 3^3
    edges = np.diag([SIDE] * 3)
    assert least_distance(position, edges) == pytest.approx(constant / np.sqrt(2), rel=1e-12)
    steps = (position - position[0]) / (constant / 2)
    assert np.allclose(steps, np.round(steps), atol=1e-12)


def test_snapshots_come_at_multiples_of_the_interval_and_at_the_end(file, sheared):
    time = snapshots(file)[3]
    assert time[:-1].tolist() == [0.0917 * k for k in range(len(time) - 1)]
    assert time[-1] == sheared[0]["time"] == 2.53
    step = file[f"{SPHERES}/position/step"]
    assert step[-1] == sheared[0]["collisions"]
    times = file["collisions/time"][()]
    assert step[()].tolist() == [np.count_nonzero(times <= each) for each in time]


def test_box_is_a_cube_whose_second_vector_leans_with_the_strain(file):
    _, _, edges, time = snapshots(file)
    strain = SHEAR_RATE * time
    assert strain[-1] > 5 and np.any(np.abs(strain % 1) > 0.1)
    offset = edges[:, 1, 0]
    expected = SIDE * (strain - np.floor(strain + 0.5))
    assert np.all((offset >= -SIDE / 2) & (offset < SIDE / 2))
    away = (offset - expected) / SIDE
    assert np.all(np.abs(away - np.round(away)) < 1e-13)  # ulps of a strain of five
    upright = edges.copy()
    upright[:, 1, 0] = 0
    assert np.allclose(upright, np.diag([SIDE] * 3), rtol=1e-15)


def test_offset_is_minus_half_a_side_at_half_a_strain_unit(program):
    _, path = program.keep({"run.collisions": 10**6, "run.time": 0.25})
    with h5py.File(path) as file:
        assert abs(abs(file[f"{SPHERES}/box/edges/value"][-1, 1, 0]) - SIDE / 2) < 1e-14


def test_positions_are_inside_the_box(file):
    position, _, edges, _ = snapshots(file)
    assert np.all(position >= 0) and np.all(position < edges[0, 0, 0])


@pytest.mark.parametrize("which", ["sheared", "collapsed"])
def test_no_two_spheres_of_a_snapshot_overlap(which, request):
    with h5py.File(request.getfixturevalue(which)[1]) as file:
        position, _, edges, _ = snapshots(file)
    assert all(least_distance(*each) > 1 - 1e-12 for each in zip(position, edges))


def test_no_two_spheres_overlap_in_other_boxes(program):
    changes = [{"system.spheres": 32, "system.solids_volume_fraction": 0.7},
               {"system.spheres": 33, "start.arrangement": "random"},
               {"drive.shear_rate": 0.01}, {"drive.kind": "none", "drive.shear_rate": 0},
               {"system.spheres": 500, "system.solids_volume_fraction": 0.01}]
    for k, change in enumerate(changes):
        case = {"run.collisions": 3000, "output.snapshot_interval": 0.37, **change}
        with h5py.File(program.keep(case, f"{k}.h5")[1]) as file:
            position, _, edges, _ = snapshots(file)
        assert len(position) > 1
        assert all(least_distance(*each) > 1 - 1e-12 for each in zip(position, edges)), change


def test_peculiar_momentum_stays_zero(file):
    for position, velocity, _, _ in zip(*snapshots(file)):
        assert np.all(np.abs(peculiar(position, velocity).mean(axis=0)) < 1e-12)


def test_no_snapshots_but_start_and_end_unless_asked(program):
    _, path = program.keep()
    with h5py.File(path) as file:
        assert file[f"{SPHERES}/position/step"][()].tolist() == [0, 2000]


def test_log_none_has_no_rows(program):
    _, path = program.keep({"output.collision_log": "none"})
    with h5py.File(path) as file:
        assert {len(file["collisions"][name]) for name in COLUMNS} == {0}
        assert file["collisions"].attrs["complete"] == 0


@pytest.mark.parametrize("first, last, rows", [
    (1, 1, (1, 1)), (500, 1500, (500, 1500)), (1999, 5000, (1999, 2000)),
    (2000, 2000, (2000, 2000)),
])
def test_windowed_log_holds_exactly_the_window(program, first, last, rows):
    _, path = program.keep({"output.collision_log": "window", "output.log_first": first,
                            "output.log_last": last})
    with h5py.File(path) as file:
        assert file["collisions/k"][()].tolist() == list(range(rows[0], rows[1] + 1))
        assert file["collisions"].attrs["complete"] == 0


def test_window_beyond_the_end_is_empty(program):
    _, path = program.keep({"output.collision_log": "window", "output.log_first": 3000})
    with h5py.File(path) as file:
        assert len(file["collisions/k"]) == 0


def test_run_of_no_length_has_one_snapshot(program):
    _, path = program.keep({"run.collisions": 0})
    with h5py.File(path) as file:
        assert file[f"{SPHERES}/position/step"][()].tolist() == [0]
        assert len(file["collisions/k"]) == 0 and file["collisions"].attrs["complete"] == 1


def test_anatomy_of_a_collapse_has_the_documented_types_and_shapes(collapsed):
    expected = {"pairs": "<i4", "chain": "<i4", "bends": "<f8", "straightness": "<f8",
                "spheres/sphere": "<i4", "spheres/cluster": "<i4", "spheres/position": "<f8",
                "contacts/i": "<i4", "contacts/j": "<i4", "contacts/cluster": "<i4",
                "contacts/collisions": "<i8", "collisions/k": "<i8", "collisions/time": "<f8",
                "collisions/i": "<i4", "collisions/j": "<i4", "collisions/gap": "<f8",
                "collisions/normal_speed": "<f8", "collisions/flight": "<f8"}
    with h5py.File(collapsed[1]) as file:
        for which in ("hit", "arrest"):
            group = file[f"zenosphere/anatomy/{which}"]
            assert {name: group[name].dtype.str for name in expected} == expected
            assert group["spheres/position"].shape == (len(group["spheres/sphere"]), 3)
            assert len(group["bends"]) == max(len(group["chain"]) - 2, 0)


def test_anatomy_agrees_with_summary_and_log(collapsed):
    summary, path = collapsed
    with h5py.File(path) as file:
        log = file["collisions"]
        for which in ("hit", "arrest"):
            group, short = file[f"zenosphere/anatomy/{which}"], summary["anatomy"][which]
            assert group.attrs["collision"] == short["collision"]
            assert group["chain"][()].tolist() == short["chain"]
            row = group["collisions/k"][()] - 1
            for name in ("i", "j", "normal_speed"):
                assert np.array_equal(group[f"collisions/{name}"], log[name][()][row])
        assert summary["anatomy"]["hit"]["collision"] == summary["separation"]["first_collision"]
        assert summary["anatomy"]["arrest"]["collision"] == summary["arrest"]["collision"]
