"""What `run` prints: the JSON object, the text, nothing; and what ends a run."""

import json
import math

import pytest

WHOLE = {"collisions", "absorbed", "peak_memory_bytes"}
REAL = {"collisions_per_sphere", "time", "strain", "ledger_error", "wall_seconds",
        "collisions_per_second"}
AVERAGES = {"granular_temperature": (), "temperature_diagonal": (3,), "pressure": (),
            "pressure_tensor": (3, 3), "collision_rate": (), "dissipation": (),
            "compressibility_factor": (), "from_time": (), "to_time": ()}
COLLAPSING = {"system.restitution": 0.2, "drive.shear_rate": 1, "run.collisions": 200000}


def is_whole(value):
    return type(value) is int


def is_real(value):
    return type(value) in (int, float) and math.isfinite(value)


def has_shape(value, shape):
    if not shape:
        return is_real(value)
    return len(value) == shape[0] and all(has_shape(part, shape[1:]) for part in value)


def assert_promised_keys(summary):
    """Every key of the interface is there, with its type."""
    assert all(is_whole(summary[key]) for key in WHOLE)
    assert all(is_real(summary[key]) for key in REAL)
    assert summary["outcome"] in ("finished", "collapsed", "interrupted")
    assert summary["verdict"] in ("none", "temporary", "open", "true")
    assert {"hits", "first_collision", "first_time", "last_collision"} <= set(summary["separation"])
    assert {"met", "collision", "time", "window", "pairs"} <= set(summary["arrest"])
    assert is_whole(summary["separation"]["hits"]) and is_whole(summary["arrest"]["window"])
    assert type(summary["arrest"]["met"]) is bool
    assert set(AVERAGES) <= set(summary["averages"])


def test_json_is_one_object_on_the_only_line_of_stdout(program):
    done = program("run", "case.toml", "--json")
    assert done.stdout.count("\n") == 1 and done.stdout.endswith("}\n")
    assert_promised_keys(json.loads(done.stdout))


def test_json_has_no_number_that_json_does_not_know(program):
    done = program("run", "case.toml", "--json", "--set", "measure.after_time=1e6")
    assert_promised_keys(json.loads(done.stdout, parse_constant=pytest.fail))


def test_run_without_hits_has_nulls_where_nothing_was_met(program):
    summary = program.run()
    assert summary["verdict"] == "none" and summary["outcome"] == "finished"
    assert summary["separation"] == {"hits": 0, "first_collision": None, "first_time": None,
                                     "last_collision": None, "last_time": None,
                                     "longest_pause": 0.0}
    assert summary["arrest"] == {"met": False, "collision": None, "time": None, "window": 1000,
                                 "pairs": [], "extrapolated_time": None, "flight_ratio": None,
                                 "others_moving": None}


def test_collapsed_run_tells_when_and_which_pairs(collapsed):
    summary, _ = collapsed
    assert_promised_keys(summary)
    separation, arrest = summary["separation"], summary["arrest"]
    assert (summary["outcome"], summary["verdict"]) == ("collapsed", "true")
    assert 1 <= separation["first_collision"] <= separation["last_collision"]
    assert separation["last_collision"] < summary["collisions"] == arrest["collision"]
    assert 0 < separation["first_time"] <= arrest["time"] == summary["time"]
    assert arrest["met"] is True and arrest["pairs"]
    assert all(0 <= i < j < 108 for i, j in arrest["pairs"])


def test_averages_have_the_promised_shapes(program):
    averages = program.run({"measure.after_time": 0.1})["averages"]
    assert all(has_shape(averages[key], shape) for key, shape in AVERAGES.items())
    assert averages["from_time"] == 0.1


def test_averages_are_null_where_nothing_was_measured(program):
    averages = program.run({"measure.after_time": 1e6})["averages"]
    assert all(averages[key] is None for key in AVERAGES)


def test_numbers_of_the_summary_agree_with_each_other(program):
    summary = program.run()
    assert summary["collisions_per_sphere"] == pytest.approx(2 * 2000 / 108, rel=1e-15)
    assert summary["strain"] == 2 * summary["time"]  # exact: the shear rate is 2
    averages = summary["averages"]
    assert averages["to_time"] == summary["time"]
    assert averages["pressure"] == pytest.approx(
        sum(averages["pressure_tensor"][axis][axis] for axis in range(3)) / 3, rel=1e-12)
    assert averages["granular_temperature"] == pytest.approx(
        sum(averages["temperature_diagonal"]) / 3, rel=1e-12)
    assert summary["ledger_error"] < 1e-10  # physics.md, section 4


@pytest.mark.parametrize("changes, verdict, sentence", [
    ({}, "none", "No collapse: no two spheres"),
    ({"collapse.gap_threshold": 1e-5, "collapse.window": 100}, "temporary",
     "No arrest: "),
    ({**COLLAPSING, "collapse.window": 10**8, "run.collisions": 3000}, "open", "Undecided: "),
    (COLLAPSING, "true", "Collapse: "),
])
def test_text_begins_with_the_verdict_in_a_sentence(program, changes, verdict, sentence):
    assert program.run(changes)["verdict"] == verdict
    lines = program("run", "case.toml", *program.words(changes)).stdout.splitlines()
    assert lines[0].startswith(sentence)
    assert any("outcome" in line for line in lines)


def test_quiet_prints_nothing(program):
    done = program("run", "case.toml", "--quiet", "-o", "out.h5")
    assert (done.stdout, done.stderr) == ("", "")
    assert (program.folder / "out.h5").exists()


def test_quiet_with_json_prints_only_the_object(program):
    done = program("run", "case.toml", "--quiet", "--json")
    assert_promised_keys(json.loads(done.stdout))
    assert done.stderr == ""


def test_no_progress_line_without_a_terminal(program):
    assert "\r" not in program("run", "case.toml", "-o", "out.h5").stderr


def test_set_overrides_a_key_and_the_last_one_wins(program):
    assert program.run({"run.collisions": 17})["collisions"] == 17
    words = ["--set", "run.collisions=17", "--set", "run.collisions=18"]
    assert program.run((), *words)["collisions"] == 18


def test_set_takes_words_without_quotes(program):
    summary = program.run({"drive.kind": "none", "drive.shear_rate": 0, "start.seed": 8})
    assert summary["strain"] == 0 and summary["time"] > 0


def test_strain_is_told_of_a_sheared_run_only(program):
    assert "(strain " in program("run", "case.toml").stdout
    words = ["--set", "drive.kind=none", "--set", "drive.shear_rate=0"]
    assert "(strain " not in program("run", "case.toml", *words).stdout


def test_time_limit_ends_the_run_at_that_time(program):
    summary = program.run({"run.collisions": 10**9, "run.time": 0.75})
    assert summary["time"] == 0.75 and summary["strain"] == 1.5
    assert summary["ended_by"] == "time" and summary["outcome"] == "finished"


def test_collision_limit_ends_the_run_where_it_comes_first(program):
    summary = program.run({"run.collisions": 50, "run.time": 1e6})
    assert summary["collisions"] == 50 and summary["ended_by"] == "collisions"
    assert summary["time"] < 1e6


@pytest.mark.parametrize("limit", ["run.collisions", "run.time"])
def test_run_of_no_length_ends_at_its_start(program, limit):
    summary = program.run({limit: 0})
    assert (summary["collisions"], summary["time"], summary["outcome"]) == (0, 0, "finished")
    assert summary["averages"]["pressure"] is None
    assert_promised_keys(summary)


def test_one_limit_is_enough(program):
    program.case.write_text(program.case.read_text().replace("collisions = 2000", "time = 0.5"))
    assert program.run()["time"] == 0.5


def test_collapse_is_exit_code_3_only_if_asked_for(program):
    assert program.run(COLLAPSING)["verdict"] == "true"
    assert program.run(COLLAPSING, "--fail-on-collapse", code=3)["verdict"] == "true"
    assert program.run({}, "--fail-on-collapse")["verdict"] == "none"
    undecided = {**COLLAPSING, "collapse.window": 10**8, "run.collisions": 3000}
    assert program.run(undecided, "--fail-on-collapse")["verdict"] == "open"


def test_run_goes_on_after_the_arrest_if_asked_to(program):
    summary = program.run({**COLLAPSING, "run.collisions": 20000,
                           "collapse.stop_when_collapsed": "false"})
    assert (summary["collisions"], summary["outcome"]) == (20000, "finished")
    assert summary["verdict"] == "true" and summary["arrest"]["collision"] < 20000
