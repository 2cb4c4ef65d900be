"""Physics or rounding: groups of hits, followed in more digits until they are spent or reopened."""

import json
import pathlib
import signal
import subprocess

import h5py
import pytest
from processes import MOST_SECONDS, has_worked, wait_for

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
RODS = EXAMPLES / "bernu-mazighi-1990-three-rods.toml"
TRIPLE = EXAMPLES / "schorghofer-zhou-1996-triple.toml"
SHEAR = EXAMPLES / "shear-e02.toml"
FALSE_POSITIVE = EXAMPLES / "shear-e06.toml"

GIVEN = """
[system]
dimension = {dimension}
spheres = {spheres}
restitution = {restitution}
sides = {sides}
[start]
arrangement = "given"
positions = {positions}
velocities = {velocities}
[drive]
kind = "none"
[collision]
overlap = "rewind"
[collapse]
window = 1000
[run]
time = 30
"""

FOUR_RODS = {"dimension": 1, "spheres": 4, "positions": [10, 11.2, 12.7, 14],
             "velocities": [1, 0, 0, -1]}

GAS = """
[system]
dimension = 3
spheres = 1000
restitution = 0.2
solids_volume_fraction = 0.2
[start]
arrangement = "random"
granular_temperature = 1.0
seed = 431455498415862
[drive]
kind = "shear"
shear_rate = 1.0
[collision]
overlap = "rewind"
[collapse]
window = 10000
[run]
collisions = 36500
"""


def adjudicated(program, *words, seconds=1e6):
    """What was found: whatever the machine, with more time than it takes."""
    done = program("adjudicate", *words, "--quiet", "--json", "--seconds", str(seconds))
    return json.loads(done.stdout.splitlines()[-1])


def trial(result, precision, overlap="rewind"):
    found = [t for t in result["trials"] if (t["precision"], t["overlap"]) == (precision, overlap)]
    assert len(found) == 1
    return found[0]


def given(program, name, **values):
    path = program.folder / name
    path.write_text(GIVEN.format(**values))
    return path


def test_three_rods_are_singular_at_forty_elevenths(program):
    result = adjudicated(program, RODS)
    assert result["finding"] in ("singular", "proven")
    approach = result["approaches"][0]
    # 40/11 = 3.(63): fifty digits after the point
    assert approach["collapse_time"].startswith("3." + "63" * 25)
    assert approach["uncertainty"] < 1e-50
    assert approach["word"] == "ab" and approach["word_is_periodic"]
    assert approach["round_ratio"]["ratio"] == pytest.approx(0.3125**2)
    assert approach["spheres"] == [0, 1, 2]
    assert approach["decades"] >= 99
    assert trial(result, "double")["first_hit"] < trial(result, "digits100")["first_hit"]
    # Each precision sees the same contacts until its digits are spent.
    lost = {loss["precision"]: loss["decade"] for loss in approach["lost_by"]}
    assert 14 <= lost["double"] <= 18 and 30 <= lost["quad"] <= 36


def test_ladder_goes_up_to_any_number_of_digits(program):
    result = adjudicated(program, RODS, "--up-to", "digits300")
    # 300 digits: 998 bits; the first hit after 301 / log10(8) = 333 collisions
    assert trial(result, "digits300")["first_hit"] == pytest.approx(334, abs=2)
    approach = result["approaches"][0]
    assert approach["precision"] == "digits300" and approach["decades"] >= 299
    assert approach["collapse_time"].startswith("3." + "63" * 70)
    done = program("adjudicate", RODS, "--up-to", "digits10001", code=2)
    assert "digits10001" in done.stderr and "20 to 10000" in done.stderr


def test_elastic_triple_is_a_chance_close_pair(program):
    result = adjudicated(program, TRIPLE)
    assert result["finding"] == "chance close pair"
    assert trial(result, "double")["hits"] > 0
    assert [trial(result, p)["hits"] for p in ("extended", "quad", "digits100")] == [0, 0, 0]


def test_paper_false_positive_at_e06_is_a_collapse_of_the_spheres(program):
    """The case that the paper calls a false positive: a hundred digits are spent by a row of spheres
    that collapses, after an approach that reopened at 1e-46. It must never be called false again."""
    result = adjudicated(program, FALSE_POSITIVE, "--set", "run.collisions=16000")
    assert result["finding"] == "singular"
    first = result["approaches"][0]
    assert first["finding"] == "near-collapse" and 35 <= first["decades"] <= 60
    singular = next(a for a in result["approaches"] if a["finding"] == "singular")
    assert singular["first_time"].startswith("0.7102181549433285969")
    assert singular["collapse_time"].startswith("0.7102181549433285969")
    assert singular["first_collision"] == 137252
    assert singular["steady_fall"]["decades"] > 40
    assert singular["decades"] >= 99


def test_collapse_under_shear_stays_with_more_digits(program):
    case = [SHEAR, "--set", "system.spheres=500", "--set", "run.collisions=20000"]
    result = adjudicated(program, *case, "--up-to", "quad")
    assert result["finding"] == "singular"
    assert [t["precision"] for t in result["trials"][:3]] == ["double", "extended", "quad"]
    assert {t["overlap"] for t in result["trials"]} == {"rewind", "immediate", "guarded", "stop"}
    # The first trial is the run itself, bit for bit.
    whole = json.loads(program("run", *case, "--json", "--quiet").stdout.splitlines()[-1])
    assert result["first_hit"] == whole["separation"]["first_collision"]
    assert trial(result, "double")["first_hit"] == result["first_hit"]
    assert float(trial(result, "double")["first_hit_time"]) == whole["separation"]["first_time"]


@pytest.mark.parametrize("name, values", [
    ("three elastic rods that meet symmetrically",
     dict(dimension=1, spheres=3, restitution=1, sides=[30], positions=[1, 10, 19],
          velocities=[1, 0, -1])),
    ("Newton's cradle",
     dict(dimension=1, spheres=6, restitution=1, sides=[40], positions=[5, 10, 11, 12, 13, 14],
          velocities=[1, 0, 0, 0, 0, 0])),
])
def test_symmetric_contacts_are_exact_and_no_singularity(program, name, values):
    result = adjudicated(program, given(program, "symmetric.toml", **values))
    assert {(a["finding"], a["decades"]) for a in result["approaches"]} == {("exact contact", 0)}, name


@pytest.mark.parametrize("restitution, finding", [(0.0717957, "proven"),
                                                  (0.0717977, "near-collapse")])
def test_three_rods_are_told_from_each_other_within_a_millionth_of_the_threshold(
        program, restitution, finding):
    """7 - 4 sqrt(3) = 0.0717968. Above it the gaps fall to 1e-532 before they grow again."""
    result = adjudicated(program, RODS, "--set", f"system.restitution={restitution}")
    assert [a["finding"] for a in result["approaches"]] == [finding]
    if finding == "near-collapse":
        assert "in exact fractions there are" in result["sentence"]
        assert result["approaches"][0]["collapse_time"] is None


@pytest.mark.parametrize("restitution, finding", [(0.1714729, "proven"),
                                                  (0.1716729, "near-collapse")])
def test_four_rods_are_told_from_each_other_within_a_ten_thousandth_of_the_threshold(
        program, restitution, finding):
    """3 - 2 sqrt(2) = 0.1715729."""
    case = given(program, "four.toml", restitution=restitution, sides=[100], **FOUR_RODS)
    result = adjudicated(program, case)
    assert result["finding"] == finding
    assert "in exact fractions" in result["sentence"]


def test_hits_after_a_rounded_collapse_are_no_exact_contact(program):
    """Random starts have no symmetry. The group from collision 12680 on is mostly of spheres that
    collapsed 160 collisions before, where the run's rounding had closed their gaps."""
    program.case.write_text(GAS)
    result = adjudicated(program, program.case, "--up-to", "quad")
    findings = {(a["run_hit"], a["finding"]) for a in result["approaches"]}
    assert "exact contact" not in {finding for _, finding in findings}
    assert (12680, "singular") in findings
    first = {a["run_hit"]: a for a in reversed(result["approaches"])}
    assert len(set(first[12520]["spheres"]) & set(first[12680]["spheres"])) == 5
    assert 12580 < first[12680]["followed_from"] < 12680


def test_singular_approach_in_three_dimensions_is_enclosed_to_the_end_of_the_digits(program):
    program.case.write_text(GAS)
    result = adjudicated(program, program.case, "--set", "system.spheres=500",
                         "--set", "system.restitution=0.1", "--set", "start.seed=1",
                         "--set", "system.solids_volume_fraction=0.1",
                         "--set", "run.collisions=1500")
    first, *others = [a for a in result["approaches"] if a["finding"] == "singular"]
    assert first["enclosed_to"] >= 99
    assert f"enclosed to 1e-{first['enclosed_to']}" in first["sentence"]
    assert all(a["enclosed_to"] is None for a in others)


def test_interrupt_before_the_first_hit_says_so(program):
    endless = program.command("adjudicate", program.case, "--set", "run.collisions=1000000000000")
    process = subprocess.Popen(endless, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: has_worked(process.pid, 0.5))  # elastic enough that it never has a hit
    process.send_signal(signal.SIGINT)
    output, error = process.communicate(timeout=MOST_SECONDS)
    assert process.returncode == 130, error
    assert "interrupted at collision" in output and "before a separation hit" in output


def test_four_rods_below_their_threshold_are_singular(program):
    """e = 0.17 < 3 - 2 sqrt(2); the word of contacts repeats, and its ratio settles."""
    case = given(program, "four.toml", restitution=0.17, sides=[100], **FOUR_RODS)
    result = adjudicated(program, case)
    assert result["finding"] in ("singular", "proven")
    strongest = next(a for a in result["approaches"] if a["finding"] == result["finding"])
    assert strongest["spheres"] == [0, 1, 2, 3]
    assert strongest["word_is_periodic"]


def test_budget_leaves_what_it_found(program):
    result = adjudicated(program, FALSE_POSITIVE, "--set", "run.collisions=16000", seconds=0.5)
    assert result["finding"] == "undecided" or result["approaches"]


def test_adjudication_is_kept_in_the_output_file(program):
    program("run", RODS, "-o", "rods.h5", "--quiet")
    result = adjudicated(program, "rods.h5")
    with h5py.File(program.folder / "rods.h5") as file:
        kept = json.loads(file["zenosphere/adjudication"].asstr()[()])
    assert kept == result
    assert adjudicated(program, "rods.h5") == result  # in place of the first
    other = adjudicated(program, "rods.h5", "--set", "system.restitution=0.06")
    with h5py.File(program.folder / "rods.h5") as file:
        assert json.loads(file["zenosphere/adjudication"].asstr()[()]) == result != other


def test_run_without_a_hit_is_an_answer(program):
    result = adjudicated(program, SHEAR, "--set", "run.collisions=10")
    assert result["approaches"] == [] and result["finding"] is None
    assert result["hits"] == 0 and result["first_hit"] is None
    assert program("adjudicate", SHEAR, "--set", "run.collisions=10").stdout == (
        "Nothing to adjudicate: no two spheres have met the separation criterion in 10"
        " collisions.\n")


def test_digits_are_never_taken_away(program):
    done = program("adjudicate", RODS, "--up-to", "double",
                   "--set", "collision.precision=quad", code=2)
    assert "digits cannot be taken away" in done.stderr
    program("run", RODS, "-o", "quad.h5", "--quiet", "--set", "collision.precision=quad")
    done = program("resume", "quad.h5", "--set", "collision.precision=double", code=2)
    assert "fewer digits" in done.stderr


@pytest.mark.parametrize("precision", ["extended", "digits25", "quad", "digits100",
                                       "digits250"])
def test_promoted_checkpoint_goes_on_as_the_same_state(program, precision):
    """Stopped before the hit and resumed in more digits, the rods keep their factor 0.3125."""
    program("run", RODS, "-o", "rods.h5", "--quiet", "--set", "run.collisions=8")
    done = program("resume", "rods.h5", "--json", "--quiet", "--set", "run.collisions=18",
                   "--set", f"collision.precision={precision}")
    summary = json.loads(done.stdout.splitlines()[-1])
    assert summary["collisions"] == 18
    assert summary["separation"]["hits"] == 0  # the threshold has gone down with the precision
    with h5py.File(program.folder / "rods.h5") as file:
        time = file["collisions/time"][:]
        assert f'precision = "{precision}"' in file["zenosphere/resolved"].asstr()[()]
    flights = time[2:17] - time[1:16]
    assert flights[10:13] / flights[9:12] == pytest.approx(0.3125, rel=1e-3)


def test_trial_under_stop_goes_through_a_contact_at_the_start(program):
    """The first two rods touch, and come on: a collision at the time 0, and no overlap by rounding."""
    case = given(program, "touch.toml", dimension=1, spheres=3, restitution=0.05, sides="[30]",
                 positions="[[10], [11], [13.5]]", velocities="[[1], [0], [-1]]")
    lines = program("adjudicate", case).stdout.splitlines()
    [stopped] = [line.split() for line in lines if line.startswith("double     stop")]
    assert int(stopped[2]) > 1 and stopped[-1] == "overlap", stopped


def test_gaps_that_fell_before_the_spheres_flew_apart_are_a_near_collapse(program, checkout):
    # Seven of 500 spheres at e = 0.3: 1e-15 at collision 34890, then a flight of hundreds of collisions.
    sweep = checkout / "examples" / "sweeps" / "shear-3d.toml"
    case = program("sweep", "show", sweep, "--run", "48").stdout
    found = json.loads(program("adjudicate", "-", "--groups", "1", "--up-to", "quad", "--json",
                               "--quiet", "--seconds", "1e6", input=case).stdout)
    assert found["trials"][0]["ended_by"] == "apart"
    assert [one["finding"] for one in found["approaches"]] == ["near-collapse"]


def test_rods_above_their_threshold_whose_clock_goes_on_are_not_singular(program):
    # 3 - 2 sqrt(2) = 0.17157288: these fly apart after 6580 contacts, at 1.870452.
    case = given(program, "four.toml", restitution=0.171573, sides=[40], **FOUR_RODS)
    found = adjudicated(program, case, "--up-to", "digits100")
    assert found["finding"] not in ("singular", "proven")
