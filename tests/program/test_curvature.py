"""Three disks in a bent row: the curvature of their contacts decides above 9 - 4 sqrt(5).

Source of the threshold, 0.0557: Zhou & Kadanoff, Phys. Rev. E 54 (1996) 623.
"""

import json

import pytest

BENT_ROW = """
[system]
dimension = 2
spheres = 3
sides = [40, 40]
restitution = {restitution}
[start]
arrangement = "given"
positions = [[10, 20], [12, {middle}], [14.3, 20]]
velocities = [[1, 0], [0, 0], [-1, 0]]
[drive]
kind = "none"
[run]
time = 20
"""


def approach(program, restitution, *options, middle=20.001):
    program.case.write_text(BENT_ROW.format(restitution=restitution, middle=middle))
    result = json.loads(program("adjudicate", program.case, "--json", "--quiet", *options).stdout)
    return result["approaches"][0]


# A round multiplies closing speeds by x1 and gaps by x2, the roots of x^2 - (1 + e)/2 x + e = 0: the
# margin changes by 1 - 2 ln x1 / ln x2 for each decade of the gap.
@pytest.mark.parametrize("restitution, change", [(0.03, 0.40609), (0.05, 0.11871),
                                                 (0.065, -0.28665)])
def test_change_of_the_margin_is_that_of_theory(program, restitution, change):
    curvature = approach(program, restitution, "--up-to", "digits100")["curvature"]
    assert curvature["margin_per_decade"] == pytest.approx(change, abs=0.015)


@pytest.mark.parametrize("restitution, dies_out", [(0.05, True), (0.0555, True), (0.056, False),
                                                   (0.06, False)])
def test_curvature_dies_out_below_the_threshold_of_a_bent_row_only(program, restitution, dies_out):
    curvature = approach(program, restitution, "--up-to", "digits100")["curvature"]
    assert (curvature["margin_per_decade"] > 0) == dies_out
    assert (curvature["gives_way_at_decade"] is None) == dies_out


def test_depth_at_which_a_bent_row_opens_is_foretold_from_fewer_digits(program):
    opened = approach(program, 0.06)
    assert opened["finding"] == "near-collapse" and opened["decades"] == 47
    foretold = approach(program, 0.06, "--up-to", "digits40")["curvature"]["gives_way_at_decade"]
    assert 47 < foretold < 47 + 40 / 2  # twice the way it has seen would tell nothing


def test_sentence_of_a_fall_that_gives_way_names_the_digits_that_would_show_it(program):
    fallen = approach(program, 0.057, "--up-to", "digits100", middle=20.0000000001)
    assert fallen["finding"] == "singular", fallen["sentence"]
    assert "curvature of the contacts grows" in fallen["sentence"]
    assert "--up-to digits800 would show" in fallen["sentence"]


def test_fall_below_the_range_of_double_is_judged_like_any_other(program):
    fallen = approach(program, 0.03, "--up-to", "digits1000")
    assert fallen["finding"] == "singular" and fallen["decades"] > 990
    assert fallen["uncertainty"] > 0


def test_straight_row_along_a_diagonal_has_only_rounding_to_bend_it(program):
    program.case.write_text(
        BENT_ROW.format(restitution=0.05, middle=12)
        .replace("[10, 20]", "[10, 10]").replace("[14.3, 20]", "[14.5, 14.5]")
        .replace("[[1, 0], [0, 0], [-1, 0]]", "[[1, 1], [0, 0], [-1, -1]]"))
    result = json.loads(program("adjudicate", program.case, "--json", "--quiet").stdout)
    assert result["approaches"][0]["finding"] == "singular"
    assert [approach["curvature"] for approach in result["approaches"]] == [None, None]
