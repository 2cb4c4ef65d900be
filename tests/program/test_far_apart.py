"""Spheres that fly through very many boxes before they meet: soon computed, and told where they never will."""

import h5py
import numpy as np
import pytest

from test_ends import case, log_times, rods, summary_of


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
