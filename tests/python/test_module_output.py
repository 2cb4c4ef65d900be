"""`zenosphere.open`: what a run has recorded, as arrays."""

import json
import pickle

import h5py
import h5py
import numpy as np
import pytest
from module import COLLAPSING, ENDLESS, SHEARED, needed, program, same_rows

import zenosphere

pytestmark = needed


@pytest.fixture
def kept(tmp_path):
    """A run of Python with its output, its chunks joined, and the states that it passed."""
    case = zenosphere.Case(SHEARED, overrides={"output.snapshot_interval": 0.2})
    with zenosphere.Run(case, output=tmp_path / "run.h5") as run:
        first = run.state()
        rows = run.advance()
        last = run.state()
    return tmp_path / "run.h5", case, rows, first, last


def test_opened_run_has_the_case_and_the_summary_of_the_run(kept):
    path, case, *_ = kept
    with zenosphere.open(path) as output:
        assert output.case == case and output.case.text == case.text
        told = json.loads(program("info", path, "--json").splitlines()[-1])
        assert told["file"]["checksums"] == "bytes unchanged"
        told["file"]["checksums"] = None  # opening does not look at them
        assert output.summary | {"file": output.file} == told
        assert output.summary["collisions"] == 2000 and output.verdict == "none"
        assert output.is_complete and output.file["program_version"] == zenosphere.__version__


def test_opened_run_has_every_collision_to_the_last_bit(kept):
    path, _, rows, *_ = kept
    with zenosphere.open(str(path)) as output:
        assert output.collisions.dtype == zenosphere.COLLISION_DTYPE
        assert same_rows(output.collisions, rows) and output.has_every_collision


def test_snapshots_are_the_states_that_the_run_passed(kept):
    path, _, _, first, last = kept
    with zenosphere.open(path) as output, h5py.File(path) as file:
        snapshots = output.snapshots
        spheres = file["particles/spheres"]
        assert len(snapshots) == len(spheres["position/time"]) > 3
        assert [state.time for state in snapshots] == list(spheres["position/time"])
        assert [state.collisions for state in snapshots] == list(spheres["position/step"])
        for n, state in enumerate(snapshots):
            assert np.array_equal(state.positions, spheres["position/value"][n])
            assert np.array_equal(state.velocities, spheres["velocity/value"][n])
            assert np.array_equal(state.box_edges, spheres["box/edges/value"][n])
            assert np.array_equal(state.images, spheres["image/value"][n])
        for state, known in ((snapshots[0], first), (snapshots[-1], last)):
            assert np.array_equal(state.positions, known.positions)
            # A profile of 2 x 2.9 is taken off again: ulps of 6.
            assert np.allclose(state.peculiar_velocities, known.peculiar_velocities, rtol=0, atol=4e-15)


def test_unwrapped_positions_move_with_the_velocities_of_the_flow(tmp_path):
    case = zenosphere.Case(SHEARED)
    with zenosphere.Run(case) as run:
        for _ in range(50):
            before = run.state()
            run.advance(20)
            after = run.state()
            moved = np.abs(after.unwrapped_positions - before.unwrapped_positions)[:, 1:]
            fastest = max(np.abs(state.velocities[:, 1:]).max() for state in (before, after))
            # A sphere whose speed has grown and fallen within 20 collisions may be somewhat faster.
            assert moved.max() <= 3 * fastest * (after.time - before.time)
    assert np.any(after.images)


def test_file_without_images_says_so(kept):
    path = kept[0]
    with h5py.File(path, "r+") as file:
        del file["particles/spheres/image"]
    state = zenosphere.open(path).snapshots[0]
    assert state.images is None
    with pytest.raises(zenosphere.InputError, match="no images of the spheres"):
        state.unwrapped_positions


def test_adjudication_that_the_file_holds_is_shown(tmp_path):
    path = tmp_path / "run.h5"
    with zenosphere.Run(zenosphere.Case(SHEARED, overrides=COLLAPSING), output=path) as run:
        run.advance()
    assert zenosphere.open(path).adjudication is None
    told = program("adjudicate", path, "--json", "--quiet", "--groups", "1", "--up-to", "quad")
    done = json.loads(told.splitlines()[-1])
    assert zenosphere.open(path).adjudication == done
    told = program("info", path)
    assert f"  adjudicated             {done['finding']}: " in told


def test_snapshots_are_a_sequence(kept):
    with zenosphere.open(kept[0]) as output:
        snapshots = output.snapshots
        assert snapshots[-1] == snapshots[len(snapshots) - 1] != snapshots[0]
        assert snapshots[::2] == list(snapshots)[::2]
        assert pickle.loads(pickle.dumps(snapshots[0])) == snapshots[0]
        with pytest.raises(IndexError, match="there are"):
            snapshots[len(snapshots)]


def test_open_run_is_read_with_its_journal_up_to_its_last_checkpoint(tmp_path):
    case = zenosphere.Case(SHEARED, overrides={**ENDLESS, "output.snapshot_interval": 0.2})
    path = tmp_path / "run.h5"
    with zenosphere.Run(case, output=path) as run:
        rows = [run.advance(3000)]
        run.save()
        with zenosphere.open(path) as output:
            assert not output.is_complete and not output.has_every_collision
            assert output.summary["outcome"] == "unfinished"
            assert output.summary["collisions"] == 3000
            found = output.collisions
            assert len(found) in (2999, 3000)
            assert same_rows(found[:2999], rows[0][:2999])
            assert output.snapshots[-1].time > 0.2
            run.advance(3000)
            run.save()
            assert output.collisions is found  # was read before
        with zenosphere.open(path) as output:
            assert output.summary["collisions"] == 6000 and len(output.collisions) > len(found)


def test_run_of_the_program_is_read_too(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(zenosphere.Case(SHEARED, overrides=COLLAPSING).resolved)
    program("run", file, "--quiet", "-o", tmp_path / "run.h5")
    with zenosphere.open(tmp_path / "run.h5") as output:
        assert output.verdict == "true" and output.summary["arrest"]["met"]
        assert output.collisions["k"][-1] == output.summary["collisions"]


def test_file_that_is_no_run_is_refused_with_the_text_of_the_program(tmp_path):
    (tmp_path / "run.h5").write_text("no run")
    for name in ("run.h5", "missing.h5"):
        with pytest.raises(zenosphere.InputError, match=name):
            zenosphere.open(tmp_path / name)


def test_damage_that_came_after_opening_is_an_error_and_no_crash(kept):
    output = zenosphere.open(kept[0])
    kept[0].write_bytes(kept[0].read_bytes()[:100_000])
    with pytest.raises(zenosphere.InputError, match="run.h5"):
        output.collisions
    with pytest.raises(zenosphere.InputError, match="run.h5"):
        output.snapshots[0]
