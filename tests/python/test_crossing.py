"""Where a probability crosses one half, against exact and brute-force answers."""

import numpy as np
import pytest

from zenosphere.ensembles.crossing import DROP_95, crossing, log_likelihood

E = np.arange(1, 8) / 10


def test_two_values_are_met_exactly_by_a_logistic_curve():
    # logit 0.9 = 2.1972 at 0, logit 0.2 = -1.3863 at 1: zero at 2.1972 / 3.5835 = 0.61315
    found = crossing([0, 1], [9, 2], [10, 10])
    assert found.how == "fit"
    assert found.place == pytest.approx(0.61315, abs=1e-3)


def test_crossing_of_mirrored_counts_is_in_the_middle_whichever_way_p_goes():
    for hits in ([10, 9, 6, 4, 1, 0], [0, 1, 4, 6, 9, 10]):
        found = crossing([1, 2, 3, 4, 5, 6], hits, [10] * 6)
        assert found.place == pytest.approx(3.5, abs=2e-3)
        assert found.low + found.high == pytest.approx(7, abs=4e-3)


def test_ends_of_the_interval_are_where_the_best_likelihood_has_dropped():
    hits, runs = np.array([10, 9, 6, 2, 1, 0, 0]), np.full(7, 10)
    found = crossing(E, hits, runs)

    def best(place):  # by brute force over slopes
        slopes = np.linspace(-200, 0, 20001)[:, None]
        return log_likelihood(slopes * (E - place), hits, runs).max()

    highest = best(found.place)
    for end in (found.low, found.high):
        assert highest - best(end) == pytest.approx(DROP_95, abs=0.02)


def test_separated_counts_give_the_neighbouring_values_and_say_so():
    found = crossing(E, [10, 10, 10, 0, 0, 0, 0], [10] * 7)
    assert (found.how, found.place) == ("separated", pytest.approx(0.35))
    assert (found.low, found.high) == (pytest.approx(0.3), pytest.approx(0.4))


def test_one_value_in_doubt_is_between_its_neighbours():
    found = crossing(E, [10, 10, 10, 3, 0, 0, 0], [10] * 7)
    assert found.how == "fit"
    assert 0.3 < found.low < found.place <= 0.4 < found.high < 0.5


def test_single_runs_do_not_pretend_to_know_the_neighbours():
    found = crossing([1, 2, 3, 4], [1, 1, 0, 0], [1] * 4)
    assert (found.how, found.place) == ("separated", 2.5)
    assert found.low < 2 and found.high > 3  # ln 2 < 1.92: a single run excludes nothing


@pytest.mark.parametrize("hits, how", [([0] * 7, "below"), ([10] * 7, "above"),
                                       ([3, 0, 0, 0, 0, 0, 0], "below"),
                                       ([10, 10, 10, 9, 9, 8, 7], "above"),
                                       ([5, 4, 6, 5, 5, 4, 6], "unclear")])
def test_no_crossing_in_the_range_is_said(hits, how):
    found = crossing(E, hits, [10] * 7)
    assert (found.place, found.how) == (None, how)


def test_a_few_single_runs_do_not_settle_the_side():
    assert crossing([1, 2], [0, 0], [1, 1]).how == "unclear"
    assert crossing([1, 2], [0, 0], [3, 3]).how == "below"


def test_crossing_near_the_end_has_an_open_interval():
    found = crossing(E, [6, 1, 0, 0, 0, 0, 0], [10] * 7)
    assert found.low is None and 0.1 < found.place < found.high


def test_values_without_runs_are_left_out():
    assert crossing([1, 2, 3], [5, 0, 1], [10, 0, 0]).how == "nothing"
    with_gap = crossing([1, 2, 3, 4], [10, 0, 8, 0], [10, 0, 10, 10])
    assert with_gap == crossing([1, 3, 4], [10, 8, 0], [10, 10, 10])


def test_interval_covers_the_true_crossing_about_as_often_as_it_says():
    random = np.random.default_rng(2)
    p = 1 / (1 + np.exp((E - 0.37) / 0.05))
    covered = 0
    for _ in range(200):
        found = crossing(E, random.binomial(10, p), np.full(7, 10))
        covered += (found.low or 0) <= 0.37 <= (found.high or 1)
    assert covered >= 180  # 95 % of 200, less 3 standard errors of 3.1
