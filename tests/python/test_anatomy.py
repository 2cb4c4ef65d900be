"""The anatomy of a collapse: reading it from a file, and its three panels."""

import h5py
import numpy as np
import pytest
from matplotlib.figure import Figure

from synthetic import write_run
from zenosphere.__main__ import main
from zenosphere.anatomy import panels as anatomy_panels
from zenosphere.anatomy.dissection import plane_of
from zenosphere.run_file import RunFile

PANELS = ("decay", "cluster", "pairs")


def write_anatomy(path, which, steps=20, chain=(4, 1, 7), wall=False, measured=True):
    """Adds a dissection of a chain whose pairs take turns; gaps shrink by 0.125, speeds by 0.4."""
    chain = np.array(chain, dtype=np.int32)
    pairs = np.sort(np.stack((chain[:-1], chain[1:]), axis=1), axis=1)
    if wall:
        pairs = np.array([[chain[0], 4000]], dtype=np.int32)
    turn = np.arange(steps) % len(pairs)
    flight = 2.5 * 0.3125 ** np.arange(steps)
    with h5py.File(path, "a") as file:
        group = file.create_group(f"zenosphere/anatomy/{which}")
        group.attrs.update({"collision": np.int64(steps), "time": 3.5, "cycle": 2.0,
                            "resolution": 2.2e-11, "collapse_time": 3.6})
        for name, ratio in (("gap", 0.125), ("speed", 0.4), ("flight", 0.3125)):
            group.attrs[f"{name}_ratio"] = ratio if measured else np.nan
            group.attrs[f"exact_{name}_ratio"] = ratio if measured else np.nan
        group["chain"], group["straightness"] = chain, np.ones(1)
        group["spheres/sphere"], group["spheres/cluster"] = np.sort(chain), np.zeros(len(chain), int)
        places = np.zeros((len(chain), 3))
        places[np.argsort(chain), 1] = np.arange(len(chain)) - (len(chain) - 1) / 2
        group["spheres/position"] = places
        group["contacts/i"], group["contacts/j"] = pairs.T
        group["contacts/cluster"] = np.zeros(len(pairs), int)
        group["contacts/collisions"] = np.full(len(pairs), 9)
        group["collisions/k"] = np.arange(1, steps + 1)
        group["collisions/i"], group["collisions/j"] = pairs[turn].T
        group["collisions/gap"] = np.append(np.nan, 0.125 ** np.arange(steps - 1))
        group["collisions/normal_speed"] = 0.4 ** np.arange(steps)
        group["collisions/flight"] = np.append(np.nan, flight[1:])
        group["collisions/time"] = np.cumsum(flight) - np.sum(flight)


@pytest.fixture
def run_path(tmp_path):
    return write_run(tmp_path / "run.h5", gap=[0.1, 0.01, 0])


def test_run_without_a_hit_has_no_anatomy(run_path):
    with RunFile(run_path) as run:
        assert run.dissection("hit") is None


def test_dissection_is_what_the_file_says(run_path):
    write_anatomy(run_path, "hit")
    with RunFile(run_path) as run:
        found = run.dissection("hit")
        assert run.dissection("arrest") is None
    assert (found.collision, found.time) == (20, 3.5)
    assert found.chain.tolist() == [4, 1, 7]
    assert found.ratio("normal_speed") == 0.4 and found.exact_ratio("gap") == 0.125


def drawn_panels(run_path, folder, which):
    """Names of the panels of one dissection that the figure command has drawn."""
    assert main(["figures", "--run", str(run_path), "-o", str(folder)]) == 0
    return {path.name for path in folder.glob(f"run-{which}-*.png")}


def test_panels_of_hit_and_arrest_are_drawn(run_path, tmp_path):
    write_anatomy(run_path, "hit")
    write_anatomy(run_path, "arrest", chain=tuple(range(60)), steps=200)
    for which in ("hit", "arrest"):
        names = {f"run-{which}-{panel}.png" for panel in PANELS}
        assert drawn_panels(run_path, tmp_path / "figures", which) == names


@pytest.mark.parametrize("panel", [anatomy_panels.decay, anatomy_panels.cluster,
                                   anatomy_panels.raster])
@pytest.mark.parametrize("content", [
    {"wall": True, "chain": (3,)}, {"measured": False}, {"steps": 1}],
    ids=["wall", "unmeasured", "one collision"])
def test_panels_are_drawn_where_little_is_known(run_path, panel, content):
    write_anatomy(run_path, "arrest", **content)
    with RunFile(run_path) as run:
        axes = Figure().subplots(3)
        panel(axes if panel is anatomy_panels.decay else axes[-1], run, "arrest")
        assert axes[-1].get_xlabel() and axes[-1].texts


def decay_of(path):
    """Axes of the decay of an arrest, each with what is said in it."""
    with RunFile(path) as run:
        axes = Figure().subplots(3)
        anatomy_panels.decay(axes, run, "arrest")
        return [(each, each.texts[0].get_text()) for each in axes]


def test_line_is_drawn_where_the_decay_is_geometric(run_path):
    write_anatomy(run_path, "arrest")
    for (axes, said), factor in zip(decay_of(run_path), ("0.125", "0.4", "0.3125")):
        assert len(axes.lines) == 2  # the marks and the line
        assert said.startswith(rf"$\times\,{factor}$ per collision")


def test_sawtooth_gets_no_line_but_a_remark(run_path):
    write_anatomy(run_path, "arrest", steps=60)
    with h5py.File(run_path, "a") as file:  # strokes of ten collisions, renewed each time
        speeds = file["zenosphere/anatomy/arrest/collisions/normal_speed"]
        speeds[...] = 0.4 ** (np.arange(60) % 10)
        file["zenosphere/anatomy/arrest"].attrs["speed_ratio"] = 0.97
    axes, said = decay_of(run_path)[1]
    assert len(axes.lines) == 1
    assert said.startswith("no steady factor")


def test_decay_holds_within_a_fifth_of_its_fall():
    place, pairs = np.arange(20), np.arange(20) % 2
    fall = 19 * np.log(2)  # of the whole line
    bent = np.where(place % 4 < 2, 1, -1)
    for miss, holds in ((0.19, True), (0.21, False)):
        values = 0.5**place * np.exp(miss * fall * bent)
        assert anatomy_panels.decay_holds(place, values, pairs, 0.5) == holds


def test_decay_of_pairs_that_are_not_alike_holds():
    place, pairs = np.arange(20), np.arange(20) % 2
    values = 0.5**place * np.where(pairs, 1e6, 1)
    assert anatomy_panels.decay_holds(place, values, pairs, 0.5)


@pytest.mark.parametrize("count, ratio", [(5, 0.5), (20, np.nan), (20, 1.0), (0, 0.5)])
def test_decay_of_too_few_values_or_no_factor_does_not_hold(count, ratio):
    place = np.arange(count)
    assert not anatomy_panels.decay_holds(place, 0.5**place, place % 2, ratio)


def test_plane_shows_a_chain_in_space_at_its_full_length():
    along = np.array([1.0, 2.0, 2.0]) / 3
    places = plane_of(np.outer(np.arange(4.0), along))
    assert np.abs(np.diff(places[:, 0])) == pytest.approx(1)
    assert places[:, 1] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_plane_of_a_sphere_alone_is_a_point(dimension):
    assert plane_of(np.zeros((1, dimension))).tolist() == [[0, 0]]
