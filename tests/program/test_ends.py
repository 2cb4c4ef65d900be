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


# Each makes the speed along x the mean of that and of its own, (1 - 0.5).
FAST_ROUGH_WALLS = """[walls]
axis = "y"
restitution = 1
tangential_restitution = -0.5
lower_speed = -1e6
upper_speed = 1e6"""


def test_disk_between_fast_rough_walls_crosses_its_box_a_million_times(program):
    text = case("dimension = 2\nspheres = 1\nrestitution = 1\nsides = [10, 10]",
                "positions = [[5, 5]]\nvelocities = [[0.3, 1]]",
                FAST_ROUGH_WALLS, "[run]\ncollisions = 30")
    summary = summary_of(program, text)
    assert summary["collisions"] == 30 and summary["self_check"] is None
    # From the middle to the wall 4.5, then 9 each: 4.5 + 29 x 9.
    assert summary["time"] == pytest.approx(265.5, rel=1e-12)
    assert summary["ledger_error"] < 1e-12


def test_far_apart_spheres_meet_in_seconds(program):
    # 2 x 325/32 flights of a mean free path of 1.2e5 diameters.
    text = case("dimension = 3\nspheres = 32\nrestitution = 1\nsolids_volume_fraction = 1e-6",
                "granular_temperature = 1.0\nseed = 1", "[run]\ncollisions = 325")
    summary = summary_of(program, text.replace('"given"', '"random"'))
    assert summary["collisions"] == 325
    # 4 n sqrt(pi T) per sphere and time, n = 6 phi/pi; 2 x 325 flights scatter by 4 % (1/sqrt(650)).
    expected = 4 * 6e-6 / np.pi * np.sqrt(np.pi)
    assert summary["averages"]["collision_rate"] == pytest.approx(expected, rel=5 * 325**-0.5)


@pytest.mark.parametrize("precision", ["double", "quad"])
def test_random_rods_in_a_box_of_nearly_a_billion_diameters_collide(program, precision):
    text = ("[system]\ndimension = 1\nspheres = 8\nrestitution = 0.1\nsolids_volume_fraction = 1e-8\n"
            '[start]\narrangement = "random"\nseed = 1\ngranular_temperature = 1\n'
            f'[drive]\nkind = "none"\n[collision]\nprecision = "{precision}"\n[run]\ncollisions = 2\n')
    summary = summary_of(program, text)
    assert summary["collisions"] == 2 and summary["ended_by"] == "collisions"


def test_ball_that_bounces_low_for_long_keeps_its_ledger(program):
    text = case("dimension = 1\nspheres = 1\nrestitution = 1\nsides = [8]",
                "positions = [0.5]\nvelocities = [1e-4]", '[walls]\naxis = "x"\nrestitution = 1',
                "[gravity]\nacceleration = [-1]", "[run]\ncollisions = 100000")
    assert summary_of(program, text)["ledger_error"] < 1e-10


@pytest.mark.parametrize("precision", ["double", "quad", "digits30"])
def test_kicks_take_no_momentum_away_in_any_precision(program, precision):
    text = rods([1, 3, 5], [1, 0.5, -0.2], f'[collision]\nprecision = "{precision}"',
                "[run]\ntime = 20", restitution=0.8, side=8).replace(
                    'kind = "none"', 'kind = "random"\nnoise_strength = 1\nkick_interval = 0.1')
    assert summary_of(program, text)["ended_by"] == "time"  # and no self-check


def test_disks_of_a_slanting_flight_cross_ten_million_boxes_in_one_step(program):
    # They come 4 nearer across, to a diameter, at 1e-7: at 4e7, and then along the box within 10.
    text = case("dimension = 2\nspheres = 2\nrestitution = 1\nsides = [10, 10]",
                "positions = [[2, 2], [7, 7]]\nvelocities = [[1, 1e-7], [0, 0]]",
                "[run]\ncollisions = 1")
    summary = summary_of(program, text)
    # The time of the exact quadratic equation, within four ulps of it.
    assert summary["collisions"] == 1 and abs(summary["time"] - 40000004.9990001) < 3e-8
    program("verify", "out.h5")  # the frame drifts, and rounds the sphere that rests too


def test_two_disks_between_fast_rough_walls_collide_with_them_and_each_other(program):
    text = case("dimension = 2\nspheres = 2\nrestitution = 1\nsides = [10, 10]",
                "positions = [[2, 5], [7, 3]]\nvelocities = [[0.3, 1], [0.1, -0.7]]",
                FAST_ROUGH_WALLS, "[run]\ncollisions = 1000")
    summary = summary_of(program, text)
    assert summary["collisions"] == 1000 and summary["self_check"] is None
    assert summary["ledger_error"] < 1e-10
    program("verify", "out.h5")


def test_fast_disks_of_a_long_box_pass_its_length_in_few_steps(program):
    # 1e8 diameters in the time 1, in a box ten wide, which they cross some times meanwhile.
    text = case("dimension = 2\nspheres = 3\nrestitution = 0.9\nsides = [10, 3.5e8]",
                "positions = [[7, 2.5e8], [8, 1.1e8], [3, 1.8e8]]\n"
                "velocities = [[-2, -7.8e7], [-2.8, 6.4e7], [2.3, -4.9e6]]", "[run]\ntime = 1")
    summary = summary_of(program, text)
    assert (summary["ended_by"], summary["self_check"]) == ("time", None)
    program("verify", "out.h5")


def test_rods_that_fly_ten_million_diameters_between_collisions_are_not_called_wrong(program):
    # Places are rounded by 2e-9 at each image; an overlap of 1.2e-7 has been seen here.
    text = rods([2477057.6, 4763929.9, 4763931, 5423442.8], [-1.1e-10, -1.5e-10, -2e-10, 4.6e-10],
                '[collision]\noverlap = "immediate"', "[run]\ncollisions = 20", side=14445591)
    summary = summary_of(program, text)
    assert (summary["collisions"], summary["self_check"]) == (20, None)
    program("verify", "out.h5")


def test_state_at_a_time_within_a_leap_is_that_of_the_flight(program):
    # 2 + t and 2 + 1e-7 t, modulo 10; and what comes later is what comes without the stop.
    text = case("dimension = 2\nspheres = 2\nrestitution = 1\nsides = [10, 10]",
                "positions = [[2, 2], [7, 7]]\nvelocities = [[1, 1e-7], [0, 0]]",
                "[run]\ntime = 2e7")
    assert summary_of(program, text)["ended_by"] == "time"
    with h5py.File(program.folder / "out.h5") as file:
        place = file["particles/spheres/position/value"][-1]
    np.testing.assert_allclose(place, [[2, 4], [7, 7]], atol=1e-7)
    program("resume", "out.h5", "--set", "run.time=5e7")
    resumed = log_times(program)
    summary_of(program, text.replace("2e7", "5e7"))
    np.testing.assert_array_equal(log_times(program), resumed)


def test_two_spheres_in_a_box_too_large_to_meet_in_are_idle(program):
    # A mean free path of 1e26 diameters: in 1/epsilon = 4.5e15 their places have no digit left.
    text = case("dimension = 3\nspheres = 2\nrestitution = 0.9\nsides = [1e9, 1e9, 1e9]",
                "positions = [[1e8, 2e8, 3e8], [7e8, 1e8, 5e8]]\n"
                "velocities = [[1, 0.7, 0.3], [-0.6, 0.2, -0.5]]", "[run]\ncollisions = 1")
    summary = summary_of(program, text)
    assert (summary["collisions"], summary["outcome"], summary["ended_by"]) == (0, "finished", "idle")
    assert 1e15 < summary["time"] < 1e16


@pytest.mark.parametrize("heights", [(2, 7), (5, 5)])
def test_spheres_that_shear_carries_past_each_other_for_ever_are_at_rest(program, heights):
    # Apart across, or at rest relative to each other at one height.
    text = case("dimension = 2\nspheres = 2\nrestitution = 0.9\nsides = [10, 10]",
                f"positions = [[2, {heights[0]}], [7, {heights[1]}]]\nvelocities = [[0, 0], [0, 0]]",
                "[run]\ncollisions = 1")
    text = text.replace('kind = "none"', 'kind = "shear"\nshear_rate = 1')
    text = text.replace("velocities = [[0, 0], [0, 0]]",
                        f"velocities = [[{heights[0] - 5}, 0], [{heights[1] - 5}, 0]]")
    summary = summary_of(program, text)
    assert (summary["collisions"], summary["ended_by"]) == (0, "at rest")


def test_hundreds_of_spheres_far_apart_meet_as_fast_as_few(program):
    text = case("dimension = 3\nspheres = 500\nrestitution = 1\nsolids_volume_fraction = 1e-6",
                "granular_temperature = 1.0\nseed = 1", "[run]\ncollisions = 100")
    summary = summary_of(program, text.replace('"given"', '"random"'))
    assert summary["collisions"] == 100 and summary["self_check"] is None
    program("verify", "out.h5")


def sheared(places, velocities, *tables, sides=(10, 10)):
    """Disks or spheres in a flow of rate 1, whose velocities are told relative to it."""
    flowing = [[v[0] + p[1] - sides[1] / 2, *v[1:]] for p, v in zip(places, velocities)]
    text = case(f"dimension = {len(sides)}\nspheres = {len(places)}\nrestitution = 0.9\nsides = {list(sides)}",
                f"positions = {places}\nvelocities = {flowing}", *tables)
    return text.replace('kind = "none"', 'kind = "shear"\nshear_rate = 1')


@pytest.mark.parametrize("precision", ["double", "digits25"])
@pytest.mark.parametrize("velocity", [[0, 1e-9], [0.25, -1e-9]])
def test_disks_that_shear_carries_past_each_other_for_too_long_are_idle_soon(program, precision, velocity):
    # As high as each other in 4e9 at the earliest: the events for which a run waits are 2^28, some
    # three a time unit.
    text = sheared([[2, 2], [7, 7]], [[0, 0], velocity], f'[collision]\nprecision = "{precision}"',
                   "[run]\ncollisions = 1")
    summary = summary_of(program, text)
    assert (summary["collisions"], summary["ended_by"]) == (0, "idle")
    assert summary["time"] < 1e5


def test_disks_that_meet_one_day_under_shear_are_waited_for(program):
    # Across by 5 less a diameter at 1e-3, or sooner: at most 4000 later.
    text = sheared([[2, 2], [7, 7]], [[0, 0], [0, -1e-3]], "[run]\ncollisions = 1")
    summary = summary_of(program, text)
    assert summary["collisions"] == 1 and 1000 < summary["time"] < 6000


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
