"""What the scan scripts of examples/ compute, without running the program."""

import sys
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES))

import averages as averages_of_runs  # noqa: E402
import scan_after_collapse as after  # noqa: E402
import contact_words  # noqa: E402
import scan_random_acceleration as acceleration  # noqa: E402
import scan_anatomy as anatomy  # noqa: E402
import scan_confined_acceleration as confined  # noqa: E402
import scan_contact_duration as duration  # noqa: E402
import scan_four_rods as four_rods  # noqa: E402
import scan_random_platform as platform  # noqa: E402
import scan_rods as rods  # noqa: E402
import scan_shear as shear  # noqa: E402
import scan_three_balls as balls  # noqa: E402
import scan_three_spheres as spheres  # noqa: E402
import scan_triple as triple  # noqa: E402
import scanning  # noqa: E402
from zenosphere.pictures import STYLE  # noqa: E402


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


def test_contact_turns_its_gap_and_closes_its_neighbours():
    # e = 0.2: gap b closes at 1, opens at 0.2, and a and c close by (1 + e) / 2 = 0.6 more
    after = contact_words.contact(1, [0.5, -1.0, 2.0], 0.2)
    assert after == pytest.approx([-0.1, 0.2, 1.4])
    assert contact_words.before_contact(1, after, 0.2) == pytest.approx([0.5, -1.0, 2.0])


def test_word_is_named_up_to_rotation_and_mirror_image():
    assert contact_words.canonical([1, 0, 1, 2, 1, 2]) == "ababcb"
    assert contact_words.canonical([2, 1, 2, 1, 0, 1]) == "ababcb"
    assert contact_words.name("abababcbcbcb") == "(ab)^3(cb)^3"
    assert contact_words.name("ab") == "ab" and contact_words.name("ababcb") == "ababcb"


def test_long_alternation_inside_a_round_is_not_taken_for_a_word():
    # Ends with the (ab)^8 of a round (ab)^8 (cb)^8: eight repetitions of ab are not enough.
    rounds = contact_words.places("ab" * 8 + "cb" * 8) * 8
    assert contact_words.eventual_word(rounds[:32 * 7 + 16]) == "ab" * 8 + "cb" * 8
    assert contact_words.eventual_word(rounds[:32 * 5 + 16]) is None


def test_windows_of_stable_words_end_at_the_known_restitutions():
    assert four_rods.window(2)[1] == pytest.approx(3 - 2 * np.sqrt(2), abs=1e-9)
    assert four_rods.window(3)[1] == pytest.approx(5 - 2 * np.sqrt(6), abs=1e-9)


@pytest.mark.parametrize("restitution, word", [(0.15, "ababcbcb"), (0.098, "abababcbcbcb"),
                                               (0.111, None), (0.05, "ab")])
def test_scaled_rods_come_to_the_stable_word_or_to_none(restitution, word):
    order = contact_words.scaled_contacts([0.3, 0.8, 0.5], [-0.7, -0.2, -0.9], restitution, 900)
    assert contact_words.eventual_word(order[:600 if word == "ab" else 900]) == word


def test_unstable_pattern_is_held_until_its_error_has_grown():
    growth = four_rods.eigenvalues("ababcb", 0.1)[1] / four_rods.eigenvalues("ababcb", 0.1)[2]
    with localcontext() as context:
        context.prec = 130
        gaps, rates = four_rods.pattern_start("ababcb", Decimal("0.1"))
        held = [contact_words.rounds_held(contact_words.exact_contacts(
                    [gaps[0] + Decimal(10) ** -power, *gaps[1:]], rates, Decimal("0.1"), 300),
                    "ababcb") for power in (20, 60)]
    assert held[0] > 10
    assert held[1] - held[0] == pytest.approx(40 / np.log10(growth), abs=1)


def test_errors_grow_where_no_word_repeats_and_shrink_where_one_does():
    rows = four_rods.sensitivity(Decimal("0.11"), np.random.default_rng(2))
    contacts = [length for _, length in rows]
    assert contacts == sorted(contacts) and contacts[-1] < four_rods.CONTACTS
    stable = four_rods.sensitivity(Decimal("0.15"), np.random.default_rng(2))
    assert [length for _, length in stable] == [four_rods.CONTACTS] * 4


def test_case_of_four_rods_is_the_pattern_to_17_digits():
    gaps, rates = four_rods.pattern_start("ababcb", four_rods.PATTERN_AT)
    text = (EXAMPLES / f"{four_rods.CASE}.toml").read_text()
    for key, values in four_rods.keys_of(gaps, rates, decimals=16).items():
        assert f"{key.removeprefix('start.')} = {scanning.written(values)}\n" in text


def test_largest_bend_is_zero_at_the_threshold_of_three_balls_and_none_above():
    assert spheres.largest_bend(spheres.STABLE) == pytest.approx(0, abs=1e-6)
    assert np.isnan(spheres.largest_bend(0.056))
    # e = 0.001: cos t = 2 (0.1 + 0.01) / 1.001
    assert np.cos(spheres.largest_bend(0.001)) == pytest.approx(0.22 / 1.001)


def test_orders_of_three_spheres_are_told_apart():
    first, second, third = 1, 2, 3  # i + j of the pairs 0-1, 0-2 and 1-2
    assert spheres.eventual_order([third] + [first, second] * 12) == "nearly linear"
    assert spheres.eventual_order([first, second, third] * 8) == "triangular"
    assert spheres.eventual_order([first, second] * 11 + [third, first]) == "other"
    assert spheres.longest_triangular([first, second, first, third, second, second]) == 4


def test_bend_of_a_row_follows_from_the_distance_of_its_ends():
    assert np.degrees(spheres.bend(1)) == 0 and np.degrees(spheres.bend(0.5)) == pytest.approx(120)


def test_starts_of_three_spheres_do_not_overlap():
    random = np.random.default_rng(1)
    for _ in range(50):
        places = np.array(spheres.random_start(random, 3)["start.positions"])
        assert min(np.linalg.norm(places[k] - places[k - 1]) for k in range(3)) > 1.04


def test_rate_of_a_tail_counts_the_runs_that_did_not_end():
    # Beyond 1: collapses at 2 and 4, one run cut off at LONGEST.
    times = np.array([0.5, 2, 4, np.inf])
    spent = 1 + 3 + platform.LONGEST - 1
    assert platform.tail_rate(times, 1) == pytest.approx((2 / spent, 2 / spent / np.sqrt(2)))


def test_computed_ball_without_kicks_comes_to_rest_at_the_known_time():
    class Still:
        def normal(self):
            return 0.0
    # It lands at t = 1 with the speed 1, and ends at 1 + 2 e / (1 - e).
    assert platform.computed_time(0.5, Still()) == pytest.approx(3)
    assert platform.computed_time(0.8, Still()) == pytest.approx(9)


def test_uniform_places_have_their_share_at_the_walls():
    places = (np.arange(100000) + 0.5) / 100000
    np.random.default_rng(1).shuffle(places)
    assert confined.at_wall(places)[0] == pytest.approx(2 * confined.EDGE, abs=1e-3)
    assert confined.folded(places)[1] == pytest.approx(np.ones(25), abs=1e-3)


def averages_until(to_time, value):
    """Averages of a summary from strain 20 on, every number being the same."""
    return {"from_time": 20, "to_time": to_time, "granular_temperature": value, "pressure": value,
            "temperature_diagonal": [value] * 3, "pressure_tensor": [[value] * 3] * 3,
            "collision_rate": value}


def test_blocks_are_what_longer_averages_add():
    # 1 over 40, 2 over 80: the second 40 have 3; 2 over 120: the third have 2.
    stages = [averages_until(60, 1), averages_until(100, 2), averages_until(140, 2)]
    assert after.block_means(stages)["T"] == pytest.approx([1, 3, 2])
    assert after.block_means(stages)["-P_xy"] == pytest.approx([-1, -3, -2])


def test_blocks_have_equal_strain():
    assert after.ends_of(420)[:2] == [20, 60] and after.ends_of(420)[-1] == 420


def test_viscoelastic_law_of_the_scan_is_that_of_the_page():
    # docs/contact-models.md, A v^(1/5) = 0.5
    assert after.viscoelastic_restitution(32.0, 0.25) == pytest.approx(0.59703, abs=1e-5)


def test_viscoelastic_spheres_are_matched_by_the_share_that_they_lose():
    def law(speed):
        return after.viscoelastic_restitution(speed, after.viscoelastic_constant())
    assert after.share_lost(law, after.MEAN_SPEED) == pytest.approx(0.64, abs=1e-3)
    assert after.share_lost(lambda v: 0.6 + 0 * v, after.MEAN_SPEED) == pytest.approx(0.64)


def test_a_fixed_loss_takes_at_most_one_over_e_of_the_energy():
    def share(loss):  # at T = 1, where the mean speed is sqrt(pi): x exp(-x)
        def law(speed):
            return np.sqrt(np.where(speed**2 > 4 * loss, 1 - 4 * loss / speed**2, 1))
        return after.share_lost(law, np.sqrt(np.pi))
    assert share(1) == pytest.approx(np.exp(-1), abs=2e-3)
    assert share(0.5) == pytest.approx(0.5 * np.exp(-0.5), abs=2e-3)
    assert share(1) > max(share(0.8), share(1.25))


def test_chance_of_one_mean_is_small_only_for_means_far_apart():
    random = np.random.default_rng(3)
    groups = [random.standard_normal(8) for _ in range(5)]
    assert averages_of_runs.chance_of_one_mean(groups) > 0.05
    groups[2] = groups[2] + 3
    assert averages_of_runs.chance_of_one_mean(groups) < 1e-3


def stored_run(way, seed, value):
    return {"way": way, "spheres": 500, "seed": seed, "until": 420, "verdict": "none", "hits": 0,
            "blocks": {name: [value, value + 2] for name in after.QUANTITIES}}


def test_flow_is_shown_with_its_difference_from_the_control_in_errors():
    way = next(way for way in after.WAYS if way.name == "rewind")
    by_way = {"hot start": [stored_run("hot start", seed, seed) for seed in (1, 2, 3)],
              "rewind": [stored_run("rewind", seed, seed + 1) for seed in (1, 2, 3)]}
    # Means 4 and 3, each with the error 1/sqrt(3), and a variance of 1: 1/16 and 1/9 of their
    # squares, pooled (1/16 + 1/9)/2. The difference is 1/3 of the control.
    spread = averages_of_runs.spread_of_a_run([np.array([2.0, 3, 4]), np.array([3.0, 4, 5])])
    assert spread == pytest.approx(np.sqrt(1 / 18 + 1 / 32))
    line = after.flow(way, by_way, slice(None), dict.fromkeys(after.QUANTITIES, spread))
    expected = (1 / 3) / (spread * np.sqrt(2 / 3))
    assert line.startswith(f"| rewind | 4.0000(5774) {expected:+.1f} |")


def test_errors_from_blocks_are_those_of_independent_blocks():
    runs = [stored_run("rewind", seed, 1.0) for seed in (1, 2, 3, 4)]
    assert after.block_error(runs, "T") == pytest.approx(np.sqrt(2 / 8))  # variance 2, 8 blocks


def test_a_run_that_the_store_has_is_not_done_again(tmp_path, monkeypatch):
    done = []

    def measured(way, spheres, seed, until):
        done.append((way.name, seed))
        return {"way": way.name, "spheres": spheres, "seed": seed, "until": until}
    monkeypatch.setattr(after, "measured", measured)
    store = tmp_path / "runs.jsonl"
    first = list(after.runs_of(after.WAYS[:2], {500: 420.0}, 1, store))
    again = list(after.runs_of(after.WAYS[:2], {500: 420.0}, 2, store))
    assert done == [("hot start", 1), ("rewind", 1), ("hot start", 2), ("rewind", 2)]
    assert again[:2] == first


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


def test_scans_draw_in_the_typeface_of_the_other_figures(tmp_path):
    with scanning.drawn(tmp_path / "scan.svg") as axes:
        axes.set(xlabel="restitution $e$")
        assert axes.xaxis.label.get_fontname() == STYLE["font.family"]
    assert "<svg" in (tmp_path / "scan.svg").read_text(encoding="utf-8")
    for script in EXAMPLES.glob("scan_*.py"):
        assert "import Figure" not in script.read_text(encoding="utf-8")
