"""Displacements whose mean squares are known, and the flights of a collision log."""

import numpy as np
import pytest
from placements import Given, result_of

from zenosphere.analysis import displacements
from zenosphere.analysis.collision_log import LogarithmicHistogram, flights_of
from zenosphere.analysis.displacements import Displacements


def ballistic(snapshots, spheres, sides, interval, speed=1.0, shear_rate=0.0):
    """Spheres that never meet; places in the upright box, as a file has them.

    Under shear their laboratory velocities are constant and the peculiar ones are not.
    """
    random = np.random.default_rng(1)
    start = random.random((spheres, len(sides))) * sides
    peculiar = random.standard_normal((spheres, len(sides))) * speed
    peculiar -= peculiar.mean(axis=0)
    carried = np.zeros_like(peculiar)
    carried[:, 0] = shear_rate * (start[:, 1] - sides[1] / 2) if shear_rate else 0
    positions, velocities, edges = [], [], []
    for time in interval * np.arange(snapshots):
        places = start + (peculiar + carried) * time
        now = peculiar.copy()
        edge = np.diag(sides).astype(float)
        if shear_rate:
            now[:, 0] -= shear_rate * peculiar[:, 1] * time
            slide = shear_rate * sides[1] * time
            edge[1, 0] = slide - sides[0] * np.round(slide / sides[0])
            turns = np.floor(places[:, 1] / sides[1])
            places -= turns[:, None] * np.array([slide, sides[1], 0])[:len(sides)]
        positions.append(places % sides)
        velocities.append(now)
        edges.append(edge)
    frames = Given(positions, np.array(edges), velocities, interval, shear_rate)
    return frames, peculiar, start


@pytest.mark.parametrize("sides", [(5.0,), (5.0, 6.0), (5.0, 6.0, 4.0)])
def test_ballistic_spheres_move_with_the_square_of_time_across_every_face(sides):
    frames, velocity, _ = ballistic(11, 50, np.array(sides), interval=0.4)
    found = result_of(Displacements, frames)
    curve = found["mean_square_displacement"]
    assert curve["value"] == pytest.approx(np.mean(np.sum(velocity**2, axis=1)) * curve["time"]**2)
    assert list(curve["by_axis"]) == list("xyz")[:len(sides)]
    assert found["velocity_autocorrelation"]["value"] == pytest.approx(1)
    assert found["diffusion"]["value"] is None  # it is not linear in time


@pytest.mark.parametrize("shear_rate", [0.7, -0.7])
def test_displacement_under_shear_is_relative_to_the_flow_across_the_sliding_face(shear_rate):
    """Free flight: v_x t - shear_rate v_y t^2 / 2 along x, v_y t across."""
    frames, velocity, _ = ballistic(11, 50, np.array([7.0, 6.0]), 0.4, shear_rate=shear_rate)
    curve = result_of(Displacements, frames)["mean_square_displacement"]
    time = curve["time"][:, None]
    along = velocity[:, 0] * time - shear_rate * velocity[:, 1] * time**2 / 2
    assert curve["by_axis"]["x"] == pytest.approx(np.mean(along**2, axis=1))
    assert curve["by_axis"]["y"] == pytest.approx(np.mean(velocity[:, 1] ** 2) * curve["time"] ** 2)


def test_displacement_is_unknown_where_a_sphere_could_come_half_a_side():
    frames, _, _ = ballistic(11, 50, np.array([5.0, 60.0]), interval=1.5)
    found = result_of(Displacements, frames)
    curve = found["mean_square_displacement"]
    assert np.isnan(curve["value"]).all() and np.isnan(curve["by_axis"]["x"]).all()
    assert np.isfinite(curve["by_axis"]["y"]).all()
    assert found["velocity_autocorrelation"]["value"] == pytest.approx(1)


def test_displacement_along_the_flow_needs_snapshots_close_in_strain():
    frames, _, _ = ballistic(11, 50, np.array([70.0, 60.0]), interval=1.0, shear_rate=0.5)
    curve = result_of(Displacements, frames)["mean_square_displacement"]
    assert np.isnan(curve["by_axis"]["x"]).all() and np.isfinite(curve["by_axis"]["y"]).all()


def walking(snapshots, spheres, side, variance, dimension=2):
    """Independent Gaussian steps of this variance along each axis, at intervals of 1."""
    random = np.random.default_rng(3)
    steps = random.standard_normal((snapshots, spheres, dimension)) * np.sqrt(variance)
    places = np.cumsum(steps, axis=0) % side
    return Given(list(places), side * np.eye(dimension), list(0.1 * steps), collision_rate=4.0)


def test_random_walk_diffuses_with_half_the_variance_of_a_step():
    frames = walking(601, 200, 20.0, 0.5)
    found = result_of(Displacements, frames)
    diffusion = found["diffusion"]
    assert abs(diffusion["value"] - 0.25) < 5 * diffusion["standard_error"]
    assert 1e-4 < diffusion["standard_error"] < 0.02
    curve = found["mean_square_displacement"]
    assert len(curve["time"]) == displacements.FREE_TIMES / 4 + 1
    assert curve["value"][-1] == pytest.approx(10 * 2 * 0.5, rel=0.05)


def test_snapshot_at_the_end_of_a_run_out_of_step_is_left_out():
    frames, velocity, _ = ballistic(6, 20, np.array([5.0, 6.0]), interval=0.4)
    frames.times[-1] -= 0.1
    curve = result_of(Displacements, frames)["mean_square_displacement"]
    assert curve["time"] == pytest.approx(0.4 * np.arange(5))
    assert curve["value"] == pytest.approx(np.mean(np.sum(velocity**2, axis=1)) * curve["time"]**2)


def test_two_snapshots_make_one_step_and_one_makes_none():
    frames, velocity, _ = ballistic(2, 20, np.array([5.0]), interval=0.4)
    curve = result_of(Displacements, frames)["mean_square_displacement"]
    assert curve["value"] == pytest.approx([0, np.mean(velocity**2) * 0.16])
    assert result_of(Displacements, frames)["velocity_autocorrelation"] is None
    alone = result_of(Displacements, ballistic(1, 20, np.array([5.0]), interval=0.4)[0])
    assert alone["mean_square_displacement"] is None and alone["diffusion"]["value"] is None


def test_one_sphere_between_walls_moves_by_its_own_velocity():
    places = [np.array([[1.0 + 0.5 * step]]) for step in range(4)]
    frames = Given(places, [[9.0]], [np.array([[0.5]])] * 4, walls=0)
    found = result_of(Displacements, frames)
    assert found["mean_square_displacement"]["value"] == pytest.approx([0, 0.25, 1, 2.25])
    assert found["diffusion"]["value"] is None


def test_flight_of_a_sphere_lasts_from_its_collision_before():
    """Spheres 0-1 at 1, 1-2 at 3, 0-wall at 4 (N = 3), 0-1 at 6; sphere 2 had one at 0.5."""
    last = np.array([np.nan, np.nan, 0.5])
    time = np.array([1.0, 3, 4, 6])
    flights, ends = flights_of(time, np.array([0, 1, 0, 0]), np.array([1, 2, 3, 1]), last)
    known = np.isfinite(flights)
    found = sorted(zip(ends[known], flights[known]))
    assert found == [(3, 2), (3, 2.5), (4, 3), (6, 2), (6, 3)]
    assert last.tolist() == [6, 6, 3]


def test_flights_of_a_log_in_parts_are_those_of_the_whole():
    random = np.random.default_rng(1)
    i, steps = random.integers(0, 9, 500), random.integers(1, 9, 500)
    j, time = (i + steps) % 10, np.cumsum(random.random(500))
    whole, _ = flights_of(time, i, j, np.full(10, np.nan))
    last = np.full(10, np.nan)
    parts = [flights_of(time[at:at + 60], i[at:at + 60], j[at:at + 60], last)[0]
             for at in range(0, 500, 60)]
    assert np.sort(np.concatenate(parts)) == pytest.approx(np.sort(whole), nan_ok=True)


def test_histogram_in_the_logarithm_is_a_density():
    histogram = LogarithmicHistogram((-3, 1))
    histogram.add(np.linspace(1e-6, 2, 200_001))
    histogram.add(np.array([np.nan]))
    found = histogram.result()
    assert found["mean"] == pytest.approx(1) and found["number"] == 200_001
    assert found["density"][5:-1] == pytest.approx(0.5, rel=0.02)
    assert found["below_smallest_bin"] == 100
