"""What the scan scripts of examples/ compute, without running the program."""

import sys
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES))

import scan_random_acceleration as acceleration  # noqa: E402
import mixture_pressure  # noqa: E402
import scan_anatomy as anatomy  # noqa: E402
import scan_contact_duration as duration  # noqa: E402
import scan_friction_clock as friction_clock  # noqa: E402
import scan_rods as rods  # noqa: E402
import scan_shear as shear  # noqa: E402
import scan_three_balls as balls  # noqa: E402
import scan_triple as triple  # noqa: E402
import scanning  # noqa: E402
from zenosphere.drawing.pictures import STYLE  # noqa: E402


def test_overrides_are_written_as_toml():
    assert scanning.overrides({"run.time": 3, "start.positions": [[1, 2.5]], "a.b": True}) == [
        "--set", "run.time=3", "--set", "start.positions=[[1, 2.5]]", "--set", "a.b=true"]


def test_decimals_are_written_with_all_their_digits():
    place = Decimal("11.030009726984624")
    assert scanning.written([10, place]) == "[10, 11.030009726984624]"


def test_missing_program_is_said_with_what_to_do(monkeypatch):
    monkeypatch.setenv("ZENOSPHERE", "/nowhere/zenosphere")
    with pytest.raises(SystemExit, match="no such program.*ZENOSPHERE"):
        scanning.program()


def test_equations_of_state_of_mixtures_of_one_size_are_the_known_ones():
    """Carnahan-Starling (1 + f + f^2 - f^3)/(1 - f)^3 and Henderson (1 + f^2/8)/(1 - f)^2."""
    assert mixture_pressure.expected(3, 0.3, 1, 0.5) == pytest.approx(1.363 / 0.343)
    assert mixture_pressure.expected(2, 0.4, 1, 0.5) == pytest.approx(1.02 / 0.36)


def test_equations_of_spheres_of_one_size_are_the_known_ones():
    """Kolafa's over Carnahan & Starling's, 1.3666 / 1.363 at 0.3; that of Hansen-Goos & Roth is the
    latter for one size, and has the second virial coefficient of any mixture."""
    assert mixture_pressure.of_one_size(0.3) == pytest.approx(1.3666 / 1.363)
    white_bear = mixture_pressure.of_spheres_in_white_bear
    assert white_bear(0.4, 1, 0.5) == pytest.approx(mixture_pressure.expected(3, 0.4, 1, 0.5))
    assert white_bear(1e-6, 2, 0.2) - 1 == pytest.approx(
        mixture_pressure.expected(3, 1e-6, 2, 0.2) - 1, rel=1e-5)


def test_pressure_of_a_mixture_is_that_of_its_contact_values():
    """Z - 1 from the g_ij at contact, pair by pair, is the sum that the two equations give."""
    dimension, fraction, sizes, shares = 2, 0.5, (1, 2), (0.8, 0.2)
    mean, square = (sum(x * s**k for x, s in zip(shares, sizes)) for k in (1, 2))
    density = fraction / (np.pi / 4 * square)
    z = 1
    for x, s in zip(shares, sizes):
        for y, t in zip(shares, sizes):
            pair = (s + t) / 2
            contact = 1 / 0.5 + 9 / 16 * fraction * s * t * mean / (pair * square) / 0.25
            z += np.pi / 2 * density * x * y * pair**2 * contact
    assert mixture_pressure.expected(dimension, fraction, 2, 0.2) == pytest.approx(z)


def test_clock_is_read_eight_times_a_decade_and_at_the_end():
    numbers = friction_clock.limits(2e4)
    assert numbers[:2] == [1000, 1334] and numbers[8] == 10000 and numbers[-1] == 20000
    assert numbers == sorted(set(numbers))
    assert friction_clock.limits(1e4)[-2:] == [7499, 10000]


def test_thresholds_of_three_and_four_rods_are_the_known_ones():
    assert rods.threshold(3) == pytest.approx(7 - 4 * np.sqrt(3))
    assert rods.threshold(4) == pytest.approx(3 - 2 * np.sqrt(2))


@pytest.mark.parametrize("number", [3, 4, 5])
def test_starts_of_rods_approach_without_overlap(number):
    keys = rods.start(number)
    assert len(keys["start.positions"]) == len(keys["start.velocities"]) == number
    assert (np.diff(keys["start.positions"]) > 1).all()
    assert (np.diff(keys["start.velocities"]) < 0).all()


def test_neighbours_take_turns_or_not():
    assert rods.take_turns([0, 2, 1, 2, 0, 1], 4)
    assert not rods.take_turns([0, 2, 2, 1], 4)
    assert not rods.take_turns([0, 1, 2, 1], 4)  # 0 has not collided again before 1 does


def test_line_through_the_inverse_squares_is_zero_at_the_threshold():
    # 1/n^2 = (e - 0.2) / 4 at n = 10, 20 and 40
    collisions = np.array([10, 20, 40])
    assert rods.extrapolated_threshold(0.2 + 4 / collisions**2, collisions) == pytest.approx(0.2)


def test_growth_of_a_sideways_push_is_one_at_the_known_threshold():
    assert balls.growth(balls.STABLE) == pytest.approx(0, abs=1e-12)
    # e = 0.05: speeds x 0.4, gaps x 0.125, so that g = 0.125 / 0.16
    assert balls.growth(0.05) == pytest.approx(np.log(0.125 / 0.16))


def test_growth_is_read_from_the_counts():
    # n = ln(1 / d^2) / 0.5 collisions: d^2 grows by exp(0.5) in each
    counts = np.floor(-2 * np.log(balls.SIDEWAYS) / 0.5 + 1e-9)
    assert balls.measured_growth(counts) == pytest.approx(0.5, abs=0.05)


def test_zero_of_a_straight_line_is_found_by_line_and_parabola():
    rates = np.array([0.1, 0.2, 0.3, 0.4])
    assert balls.zero_of(0.05 + 0.02 * rates, rates) == pytest.approx((0.05, 0.05))


def test_sideways_speeds_of_three_balls_are_across_the_line():
    plane, space = balls.start(2, 0.01), balls.start(3, 0.01)
    assert plane["start.velocities"] == [[1, 0], [0, 0.01], [0.125, 0]]
    assert space["start.velocities"] == [[1, 0, 0], [0, 0.01, 0], [0.125, 0, 0.01]]
    assert space["start.positions"][2] == [13, 10, 10]


def test_triple_is_equilateral_without_momentum():
    keys = triple.triple(0.3)
    places = np.array(keys["start.positions"])
    sides = [np.linalg.norm(places[k] - places[k - 1]) for k in range(3)]
    assert sides == pytest.approx([1.5 * np.sqrt(3)] * 3)
    assert np.sum(keys["start.velocities"], axis=0) == pytest.approx([0, 0], abs=1e-15)


def test_return_from_the_other_wall_counts_as_infinitely_fast():
    launch, ratio = acceleration.excursions(np.array([1, 1, 2]), np.array([4.0, 3.0, 9.0]), 0.5)
    assert launch.tolist() == [2.0, 1.5]
    assert ratio.tolist() == [1.5, np.inf]


def test_mean_logarithm_takes_the_tail_from_its_power_law():
    mean, _ = acceleration.mean_logarithm(np.array([1.0, np.e, np.inf, 7.0]), cut=np.e)
    assert mean == pytest.approx((0 + 1 + 3 + 3) / 4)


def test_mean_logarithm_of_mckeans_density_is_the_known_one():
    """Quantiles of the density in place of a sample; the cut alone makes 0.005 of it."""
    ratio = np.geomspace(1e-4, 1e6, 4000)
    below = np.array([acceleration.cumulative(each) for each in ratio])
    sample = np.interp((np.arange(20000) + 0.5) / 20000, below, ratio)
    assert acceleration.mean_logarithm(sample)[0] == pytest.approx(np.pi / np.sqrt(3), abs=0.01)


def test_extrapolation_of_a_line_with_equal_errors():
    value, error = acceleration.extrapolated([1.0, 2.0, 3.0], [3.0, 5.0, 7.0], [0.1, 0.1, 0.1])
    assert value == pytest.approx(1.0)
    assert error == pytest.approx(0.1 * np.sqrt(1 / 3 + 4 / 2))  # of the intercept, mean at 2


def test_shear_counts_runs_and_hits():
    runs = [{"separation": {"hits": 30}, "arrest": {"met": True}, "verdict": "true",
             "collisions": 1000},
            {"separation": {"hits": 0}, "arrest": {"met": False}, "verdict": "none",
             "collisions": 2000}]
    assert shear.counted(runs) == (1, 1, "1 none, 1 true")
    assert shear.hits_per_million(runs) == pytest.approx(10000)


def test_a_run_that_ended_before_its_averages_shows_dashes():
    run = {"averages": {"to_time": None}, "contact": {"made_elastic": 1}, "collisions": 2,
           "verdict": "true", "separation": {"hits": 3}}
    assert duration.row(0, [run, run]) == "| 0 | true, true | 3, 3 | 0.5 | – | – | – | – |"


def test_error_over_seeds_is_that_of_the_mean():
    mean, error = duration.mean_and_error([1, 2, 3, 4])
    # Variance 5/3 of one, so sqrt(5/12) of the mean of four.
    assert (mean, error) == (2.5, pytest.approx(np.sqrt(5 / 12)))


def test_least_chain_is_three_rods_below_the_threshold_of_three_rods():
    assert [anatomy.least_chain(e) for e in (0.05, 0.0717, 0.0719, 0.2, 0.6)] == [3, 3, 4, 5, 13]


def test_run_without_a_hit_has_a_row_of_dashes():
    assert anatomy.cells(0.9, 1, None) == ["0.9", "1", "no hit"] + ["–"] * 9


FAKE = """#!/bin/sh
echo "$@" >> {log}
case "$*" in *run.time=3*) echo '{{"outcome": "collapsed"}}';; *) echo '{{"outcome": "finished"}}';; esac
"""


def test_stages_resume_one_run_until_it_ends(tmp_path, monkeypatch):
    program, log = tmp_path / "zenosphere", tmp_path / "log"
    program.write_text(FAKE.format(log=log))
    program.chmod(0o755)
    monkeypatch.setenv("ZENOSPHERE", str(program))
    summaries = scanning.stages("shear-e06", {"start.seed": 2}, "run.time", [1, 2, 3, 4])
    assert [each["outcome"] for each in summaries] == ["finished", "finished", "collapsed"]
    calls = [line.split() for line in log.read_text().splitlines()]
    assert [words[0] for words in calls] == ["run", "resume", "resume"]
    assert "start.seed=2" in calls[0] and calls[1][-1] == "run.time=2"
    assert calls[1][1] == calls[2][1] == calls[0][calls[0].index("-o") + 1]


def test_results_are_kept_and_not_measured_again(tmp_path):
    calls = []

    def measured():
        calls.append(1)
        return {"times": (1.5, float("inf"))}
    path = tmp_path / "results.json"
    expected = {"times": [1.5, float("inf")]}
    assert scanning.kept(path, measured) == scanning.kept(path, measured) == expected
    assert len(calls) == 1
    assert scanning.kept(None, measured) == expected and len(calls) == 2


def test_scans_draw_in_the_typeface_of_the_other_figures(tmp_path):
    with scanning.drawn(tmp_path / "scan.svg") as axes:
        axes.set(xlabel="restitution $e$")
        assert axes.xaxis.label.get_fontname() == STYLE["font.family"]
    assert "<svg" in (tmp_path / "scan.svg").read_text(encoding="utf-8")
    for script in EXAMPLES.glob("scan_*.py"):
        assert "import Figure" not in script.read_text(encoding="utf-8")
