"""How runs end of which nothing more can be expected, and that they get there in reasonable time."""

import json

import h5py
import numpy as np
import pytest

def case(system, start, *tables):
    """A case file that cools freely unless a table says more."""
    return "\n".join(["[system]", system, "[start]", 'arrangement = "given"', start, "[drive]", 'kind = "none"', *tables, ""])


def rods(positions, velocities, *tables, restitution=1, side=7.5):
    count = len(positions)
    return case(f"dimension = 1\nspheres = {count}\nrestitution = {restitution}\nsides = [{side}]",
                f"positions = {positions}\nvelocities = {velocities}", *tables)


def summary_of(program, text, *words):
    program.case.write_text(text)
    done = program("run", program.case.name, "--json", "-o", "out.h5", "--overwrite", *words)
    return json.loads(done.stdout.splitlines()[-1])


def log_times(program):
    with h5py.File(program.folder / "out.h5") as file:
        return file["collisions/time"][()]


@pytest.mark.parametrize("precision", ["double", "quad"])
@pytest.mark.parametrize("speed", [1e-12, 1e-19, 1e-60, 1e-75])
def test_two_slow_rods_collide_when_fast_ones_would(program, precision, speed):
    # Centres at 2 and 5: a gap of 2, closed at twice the speed, then one of 7.5 - 2 = 5.5 around
    # the box less the other diameter: 1, and again 5.5/2, 5.5/2 later.
    text = rods([2, 5], [speed, -speed], f'[collision]\nprecision = "{precision}"',
                "[run]\ncollisions = 3")
    summary = summary_of(program, text)
    assert summary["ended_by"] == "collisions" and summary["collisions"] == 3
    np.testing.assert_allclose(log_times(program) * speed, [1, 3.75, 6.5], rtol=4e-15)


def test_clock_ends_where_the_squares_of_speeds_do(program):
    # 2^500 time units; what comes later is reported as that, not as a limit of the case.
    # Each collision leaves 1e-15 of the speed: at 1e-75 x 1e-15^6 the next is due at 1e165.
    text = rods([2, 5], [1e-75, -1e-75], "[run]\ncollisions = 30", restitution=1e-15)
    summary = summary_of(program, text)
    assert (summary["outcome"], summary["ended_by"]) == ("finished", "clock")
    assert 5 <= summary["collisions"] <= 7 and 1e134 < summary["time"] < 2.0**500
    program("verify", "out.h5")  # at 1e-150, of which the square is 1e-300
    program("info", "out.h5")
    lines = program.fail("resume", "out.h5")
    assert "has come to the end of its clock" in lines[-1]


def test_gas_that_cools_goes_on_to_the_collisions_it_was_given(program):
    text = case("dimension = 3\nspheres = 108\nrestitution = 0.8\nsolids_volume_fraction = 0.1",
                "granular_temperature = 1.0\nseed = 1", "[run]\ncollisions = 100000")
    summary = summary_of(program, text.replace('"given"', '"fcc"'))
    assert (summary["collisions"], summary["ended_by"]) == (100000, "collisions")
    assert summary["self_check"] is None and summary["time"] > 1e19


@pytest.mark.parametrize("restitution, velocities", [
    (0.5, [0.1, 0.1, 0.1]), (0, [-1, 0.3, 0.2])])
def test_rods_that_move_as_one_are_at_rest(program, restitution, velocities):
    # The last three stick, and drift with their mean velocity, -1/6.
    overlap = '[collision]\noverlap = "immediate"'
    text = rods([0, 2.87, 5.36], velocities, overlap, "[run]\ncollisions = 1000",
                restitution=restitution)
    summary = summary_of(program, text)
    assert (summary["outcome"], summary["ended_by"]) == ("finished", "at rest")
    with h5py.File(program.folder / "out.h5") as file:
        final = file["particles/spheres/velocity/value"][-1].ravel()
    np.testing.assert_allclose(final, np.mean(velocities), rtol=1e-14, atol=1e-16)
    assert "there is nothing to resume" in program.fail("resume", "out.h5")[-1]


def test_disks_that_pass_each_other_for_ever_are_at_rest(program):
    # Apart by 1.5 across the axis along which they move.
    text = case("dimension = 2\nspheres = 2\nrestitution = 1\nsides = [8, 8]",
                "positions = [[1, 1], [5, 2.5]]\nvelocities = [[1, 0], [-1, 0]]",
                "[run]\ncollisions = 10")
    summary = summary_of(program, text)
    assert (summary["collisions"], summary["ended_by"]) == (0, "at rest")


def test_summary_of_a_run_without_collisions_has_no_number_that_is_none(program):
    program.case.write_text(rods([0, 2.87, 5.36], [0.1, 0.1, 0.1], "[run]\ntime = 10"))
    table = program("run", program.case.name).stdout
    assert "nan" not in table and "none" in table
    assert summary_of(program, program.case.read_text())["averages"]["normal_speed"] is None


@pytest.mark.parametrize("walls", ["", '[walls]\naxis = "y"\nrestitution = 1\n'])
def test_spheres_that_fall_together_do_with_each_other_what_they_do_at_rest(program, walls):
    # Galileo: the same collisions at the same times, and all velocities larger by g t.
    text = case("dimension = 2\nspheres = 32\nrestitution = 0.9\nsolids_volume_fraction = 0.1",
                "granular_temperature = 1.0\nseed = 1", walls, "[run]\ntime = 8")
    text = text.replace('"given"', '"random"')
    finals = []
    for gravity in ("", "[gravity]\nacceleration = [-0.5, 0]\n"):
        summary = summary_of(program, text + gravity)
        with h5py.File(program.folder / "out.h5") as file:
            finals.append((summary["collisions"], log_times(program),
                           file["particles/spheres/velocity/value"][-1]))
        program("verify", "out.h5")
    assert finals[0][0] == finals[1][0] > 50
    np.testing.assert_array_equal(finals[0][1], finals[1][1])
    np.testing.assert_allclose(finals[1][2] - finals[0][2], [[-4, 0]] * 32, atol=1e-14)


def test_snapshots_of_a_clock_that_leaps_ahead_are_spaced(program):
    # Rods that part at 1e-9 of their speed: the second collision is due near 5.5e9, the third
    # beyond 1e18. A thousand snapshots one apart, a thousand two apart, ...: log2(1e18/1000) = 50.
    text = rods([2, 5], [1, -1], "[run]\ncollisions = 3", "[output]\nsnapshot_interval = 1",
                restitution=1e-9)
    summary = summary_of(program, text)
    assert summary["collisions"] == 3 and summary["time"] > 1e18
    with h5py.File(program.folder / "out.h5") as file:
        times = file["particles/spheres/position/time"][()]
    np.testing.assert_array_equal(times[:1001], np.arange(1001))
    np.testing.assert_array_equal(times[1001:2001], 1000 + 2.0 * np.arange(1, 1001))
    assert 40000 < len(times) < 51000
    program("verify", "out.h5")


def test_run_that_gets_an_end_takes_every_snapshot_from_there(program):
    # The second collision is due at 1 + 5.5/(2 x 1.1e-3) = 2501.
    text = rods([2, 5], [1, -1], "[run]\ncollisions = 2", "[output]\nsnapshot_interval = 1",
                restitution=1.1e-3)
    summary_of(program, text)
    program("resume", "out.h5", "--set", "run.time=2600", "--set", "run.collisions=5")
    with h5py.File(program.folder / "out.h5") as file:
        times = file["particles/spheres/position/time"][()]
    assert {2498, 2500, 2502, 2503, 2599, 2600} <= set(times) and not {2499, 2501} & set(times)


def test_cold_and_slow_in_the_largest_box_is_told_by_what_its_averages_can_hold(program):
    # The slowest start there is, and each collision leaves 1e-15 of the speed: 1e-105, whose powers
    # over a volume and a time are below 1e-308.
    for dimension, last in [(1, 3), (3, 1)]:
        zeros = [0] * (dimension - 1)
        places = [[1e8, *zeros], [2e8, *zeros]]
        velocities = [[1e-75, *zeros], [-1e-75, *zeros]]
        text = case(f"dimension = {dimension}\nspheres = 2\nrestitution = 1e-15\nsides = {[1e9] * dimension}",
                    f"positions = {places}\nvelocities = {velocities}", f"[run]\ncollisions = {last}",
                    "[measure]\nafter_time = 1e90")
        summary_of(program, text)
        program("info", "out.h5")
        program("verify", "out.h5")
        program("resume", "out.h5", "--set", f"run.collisions={last + 1}")
        program("verify", "out.h5")


@pytest.mark.parametrize("unit", [1, 2.0**-30])
def test_anatomy_tells_a_collapse_at_a_late_time_within_its_error(program, unit):
    # A rod at the speed 1 comes from 9e8 away, or in a unit of time in which that is 2^-30, to two that
    # rest; the three collapse within some diameters. The clock stands at 9e8 and 9e17 then.
    text = rods([1, 9e8, 9e8 + 3], [unit, 0, 0], "[run]\ncollisions = 1000", restitution=0.02, side=1e9)
    summary = summary_of(program, text)
    anatomy = summary["anatomy"]["hit"]
    # The larger root of x^2 - (1 + e) cos(pi/3) x + e = 0 is what a round leaves of speeds.
    half = 1.02 / 4
    speed = half + np.sqrt(half**2 - 0.02)
    assert anatomy["speed_ratio"] == pytest.approx(speed, rel=1e-3)
    # At 9e8 - 2 the first two meet; speeds are (1 - e)/2 = 0.49 and 0.51, and the second closes its gap
    # of 2 at 2/0.51 later.
    assert 0 < anatomy["collapse_time"] * unit - (9e8 - 2) - 2 / 0.51 < 10
    error = anatomy["collapse_time_error"]
    assert 2.0**-52 < error / anatomy["collapse_time"] < 1e-12  # places are known to 1e-7


def test_last_snapshot_has_the_kick_that_is_due_at_the_end(program):
    # A kick and a snapshot at the end of the run: the averages count the work of both.
    text = rods([1, 3, 5], [0.7, 0.7, 0.7], '[walls]\naxis = "x"\nrestitution = 0.5', "[run]\ntime = 5",
                "[output]\nsnapshot_interval = 1", restitution=0.5, side=10).replace(
                    'kind = "none"', 'kind = "random"\nnoise_strength = 1\nkick_interval = 0.5')
    assert summary_of(program, text)["ended_by"] == "time"
    program("verify", "out.h5")
