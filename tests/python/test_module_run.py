"""A run that Python drives: the bits of the program, arrays, criteria, ends."""

import h5py
import numpy as np
import pytest
from identity import differences
from module import (COLLAPSING, ENDLESS, SHEARED, joined, needed, ran_by_program, same_rows,
                    without_costs)

import zenosphere

pytestmark = needed

DISCS = {"system.dimension": 2, "start.arrangement": "random",
         "system.solids_volume_fraction": 0.4}
KICKED = {"drive.kind": "random", "drive.shear_rate": 0, "drive.noise_strength": 0.1,
          "drive.kick_interval": 0.07}
FALLING = {"drive.kind": "none", "drive.shear_rate": 0, "walls.axis": "z", "walls.restitution": 0.9,
           "walls.upper_speed": 0.5, "gravity.acceleration": [0.0, 0.1, -0.2],
           "start.arrangement": "random", "system.solids_volume_fraction": 0.2}
# Four slow spheres: between two events the clock leaps over whole units, and over ends of chunks. A
# leap in two steps would round twice; snapshots make such steps, so that there are few.
SLOW = {"drive.kind": "none", "drive.shear_rate": 0, "system.spheres": 4,
        "system.solids_volume_fraction": 0.02, "start.granular_temperature": 2e-4,
        "system.restitution": 0.999, "run.collisions": 500, "run.time": 1e6,
        "output.snapshot_interval": 1e5}
SYSTEMS = {
    "sheared": {}, "discs": DISCS, "kicked": KICKED, "falling": FALLING, "slow": SLOW,
    "collapsing": COLLAPSING, "by time": {"run.collisions": 10**9, "run.time": 0.61},
    "stop": {**COLLAPSING, "collision.overlap": "stop"},
    "extended": {"collision.precision": "extended", "run.collisions": 400},
    "quad": {"collision.precision": "quad", "run.collisions": 200},
    "digits150": {"collision.precision": "digits150", "run.collisions": 100,
                  "system.spheres": 32},
}


def case(system="sheared", **more):
    return zenosphere.Case(SHEARED, overrides={**SYSTEMS[system], **more})


def in_pieces(run):
    """The collisions of a run that is driven in every way there is."""
    rows = [run.advance(0), run.advance(1), run.advance(until=0.11), run.advance(until=0.05)]
    run.state(), run.summary()
    rows += [run.advance(157, until=0.4), run.advance(until=11.3), run.advance(1)]
    rows += [run.advance(until=1.01 * run.time + 0.9) for _ in range(900)]
    return joined([*rows, *run.chunks(333)])


@pytest.mark.parametrize("system", SYSTEMS)
def test_run_in_pieces_gives_the_bits_of_the_program(tmp_path, system):
    chosen = case(system, **{"output.snapshot_interval": 0.23, **SYSTEMS[system]})
    whole, pieces = tmp_path / "whole.h5", tmp_path / "pieces.h5"
    by_program = ran_by_program(chosen, whole)
    run = zenosphere.Run(zenosphere.Case.parse(chosen.resolved), output=pieces)
    in_pieces(run)
    assert without_costs(run.finish()) == without_costs(by_program)
    assert differences(pieces, whole) == []


@pytest.mark.parametrize("system", SYSTEMS)
def test_chunks_together_are_the_log_of_the_file(tmp_path, system):
    run = zenosphere.Run(case(system), output=tmp_path / "out.h5")
    rows = in_pieces(run)
    run.finish()
    assert zenosphere.Run(case()).advance(3).dtype == zenosphere.COLLISION_DTYPE
    with h5py.File(tmp_path / "out.h5") as file:
        assert set(rows.dtype.names) == set(file["collisions"])
        for name in rows.dtype.names:
            assert rows[name].dtype == file["collisions"][name].dtype
            assert rows[name].tobytes() == file["collisions"][name][()].tobytes(), name


def test_run_without_output_has_the_same_summary_and_collisions(tmp_path):
    kept, bare = zenosphere.Run(case(), output=tmp_path / "out.h5"), zenosphere.Run(case())
    assert same_rows(kept.advance(), bare.advance())
    assert without_costs(kept.finish()) == without_costs(bare.finish())


def test_last_collision_of_a_chunk_waits_for_the_gap_of_the_next_pair():
    run = zenosphere.Run(case())
    assert run.advance(10)["k"].tolist() == list(range(1, 10)) and run.collisions == 10
    assert run.advance(2)["k"].tolist() == [10, 11]
    last = joined(run.chunks(700))
    assert last["k"][-1] == 2000 and np.isnan(last["gap"][-1])
    assert not np.isnan(last["gap"][:-1]).any()


def test_skipped_collisions_are_not_in_the_next_chunk():
    run = zenosphere.Run(case())
    run.advance(10)
    run.skip(90)
    assert run.collisions == 100 and run.advance(6)["k"].tolist() == list(range(101, 106))


def test_advance_ends_at_the_time_and_the_state_is_that_of_a_snapshot(tmp_path):
    for system in ("sheared", "slow", "falling", "kicked"):
        times = {"output.snapshot_interval": 0.37, "run.time": 3}
        ran_by_program(case(system, **times), tmp_path / f"{system}.h5")
        run = zenosphere.Run(case(system))
        with h5py.File(tmp_path / f"{system}.h5") as file:
            spheres = file["particles/spheres"]
            run.advance(until=2 * 0.37)
            state = run.state()
            assert run.time == state.time == 2 * 0.37 == spheres["position/time"][2]
            assert state.collisions == run.collisions == spheres["position/step"][2]
            assert np.array_equal(state.positions, spheres["position/value"][2])
            assert np.array_equal(state.velocities, spheres["velocity/value"][2])
            assert np.array_equal(state.box_edges, spheres["box/edges/value"][2])


def test_peculiar_velocity_is_the_velocity_without_the_shear_profile():
    run = zenosphere.Run(case())
    run.skip(1000)
    state = run.state()
    height = state.positions[:, 1] - state.box_edges[1, 1] / 2
    profile = state.velocities - state.peculiar_velocities
    assert np.allclose(profile[:, 0], 2.0 * height, rtol=0, atol=1e-12)  # sums of numbers below 10
    assert not profile[:, 1:].any()
    assert state.granular_temperature == pytest.approx((state.peculiar_velocities**2).mean())


def test_arrays_stay_as_they_are_while_the_run_goes_on():
    run = zenosphere.Run(case())
    rows, state = run.advance(500), run.state()
    kept = rows.copy(), state.positions.copy()
    run.advance()
    del run
    assert same_rows(rows, kept[0]) and np.array_equal(state.positions, kept[1])
    assert state.positions.shape == state.velocities.shape == (108, 3)
    assert rows.flags.c_contiguous and rows.flags.writeable


def test_criteria_are_told_while_the_run_goes_on():
    run = zenosphere.Run(case("collapsing"))
    run.skip(100)
    assert (run.verdict, run.separation["hits"], run.arrest["met"]) == ("none", 0, False)
    assert run.summary()["outcome"] == "unfinished" and not run.is_over
    run.skip()
    assert run.is_over and run.verdict == "true"
    assert run.arrest["collision"] == run.collisions and run.separation["hits"] > 0
    assert run.finish()["outcome"] == "collapsed"


def test_case_of_a_run_is_the_one_it_was_given(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(case().text)
    run = zenosphere.Run(file, overrides={"run.collisions": 77})
    assert run.case.tables["run"]["collisions"] == 77
    assert zenosphere.Run(SHEARED, overrides={"run.collisions": 77}).case.resolved == (
        run.case.resolved)
    with pytest.raises(TypeError, match="give them to the Case"):
        zenosphere.Run(case(), overrides={"run.collisions": 77})


def test_finished_run_cannot_go_on_but_can_be_asked():
    run = zenosphere.Run(case())
    first = run.finish()
    assert (first["outcome"], first["collisions"]) == ("interrupted", 0)
    assert run.finish() == first == run.summary() and run.is_over
    for use in (run.advance, run.skip, run.save):
        with pytest.raises(RuntimeError, match="is finished; .* resume its file"):
            use()


@pytest.mark.parametrize("wrong, told", [
    ({"collisions": -1}, r"collisions = -1 \(must be >= 0\)"),
    ({"collisions": 2**63}, r"collisions = 9223372036854775808 \(needs 64 bits\)"),
    ({"until": -0.5}, r"until = -0.5 \(must be a time >= 0\)"),
    ({"until": float("nan")}, r"until = nan \(must be a time >= 0\)"),
])
def test_wrong_chunk_is_refused(wrong, told):
    run = zenosphere.Run(case(**ENDLESS))
    with pytest.raises(zenosphere.InputError, match=told):
        run.advance(**wrong)
    assert len(run.advance(5)) == 4
    with pytest.raises(TypeError):
        run.advance(1.5)
    with pytest.raises(zenosphere.InputError, match="chunks: collisions = 0"):
        next(run.chunks(0))
