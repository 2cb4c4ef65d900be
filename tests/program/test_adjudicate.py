"""Physics or rounding: a state before the first hit, gone on with in more digits and by other rules."""

import json
import pathlib

import h5py
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
RODS = EXAMPLES / "bernu-mazighi-1990-three-rods.toml"
TRIPLE = EXAMPLES / "schorghofer-zhou-1996-triple.toml"
SHEAR = EXAMPLES / "shear-e02.toml"


def adjudicated(program, *words):
    done = program("adjudicate", *words, "--quiet", "--json")
    return json.loads(done.stdout.splitlines()[-1])


def trial(result, precision, overlap="rewind"):
    found = [t for t in result["trials"] if (t["precision"], t["overlap"]) == (precision, overlap)]
    assert len(found) == 1
    return found[0]


def test_three_rods_are_a_singularity_at_forty_elevenths(program):
    result = adjudicated(program, RODS)
    assert result["finding"] == "finite-time singularity"
    # 40/11 = 3.(63): sixty digits after the point
    assert trial(result, "digits100")["collapse_time"].startswith("3." + "63" * 30)
    assert trial(result, "double")["first_hit"] < trial(result, "digits100")["first_hit"]


def test_elastic_triple_is_a_chance_close_pair(program):
    result = adjudicated(program, TRIPLE)
    assert result["finding"] == "chance close pair"
    assert trial(result, "double")["hits"] > 0
    assert [trial(result, p)["hits"] for p in ("extended", "quad", "digits100")] == [0, 0, 0]


def test_collapse_under_shear_stays_with_more_digits(program):
    result = adjudicated(program, SHEAR, "--up-to", "quad", "--collisions", "200",
                         "--set", "system.spheres=500")
    assert result["finding"] == "finite-time singularity"
    assert len(result["trials"]) == 3 * 4  # precisions x rules
    # The first trial is the run itself, bit for bit.
    whole = json.loads(program("run", SHEAR, "--json", "--quiet", "--set", "system.spheres=500",
                               "--set", "run.collisions=20000").stdout.splitlines()[-1])
    assert result["first_hit"] == whole["separation"]["first_collision"]
    assert trial(result, "double")["first_hit"] == result["first_hit"]
    assert float(trial(result, "double")["first_hit_time"]) == whole["separation"]["first_time"]


def test_adjudication_is_kept_in_the_output_file(program):
    program("run", RODS, "-o", "rods.h5", "--quiet")
    result = adjudicated(program, "rods.h5")
    with h5py.File(program.folder / "rods.h5") as file:
        kept = json.loads(file["zenosphere/adjudication"].asstr()[()])
    assert kept == result
    assert adjudicated(program, "rods.h5") == result  # in place of the first


def test_run_without_a_hit_is_refused(program):
    done = program("adjudicate", SHEAR, "--set", "run.collisions=10", code=2)
    assert "no separation hit in 10 collisions" in done.stderr


def test_digits_are_never_taken_away(program):
    done = program("adjudicate", RODS, "--up-to", "double",
                   "--set", "collision.precision=quad", code=2)
    assert "digits cannot be taken away" in done.stderr
    program("run", RODS, "-o", "quad.h5", "--quiet", "--set", "collision.precision=quad")
    done = program("resume", "quad.h5", "--set", "collision.precision=double", code=2)
    assert "fewer digits" in done.stderr


@pytest.mark.parametrize("precision", ["extended", "quad", "digits100"])
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
