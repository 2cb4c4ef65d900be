"""What the scans of four rods, three spheres and single particles compute, without the program."""

import sys
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES))

import contact_words  # noqa: E402
import scan_confined_acceleration as confined  # noqa: E402
import scan_four_rods as four_rods  # noqa: E402
import scan_random_platform as platform  # noqa: E402
import scan_three_spheres as spheres  # noqa: E402
import scanning  # noqa: E402


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
