"""A case from a dict, a text or a file, and what is wrong with it."""

import copy
import multiprocessing
import pickle
import tomllib
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
from module import SHEARED, failure, needed, program

import zenosphere
from zenosphere import InputError
from zenosphere.errors import in_python_words

pytestmark = needed


def broken(**changes):
    """The small case with some keys of [system] changed; None removes one."""
    tables = copy.deepcopy(SHEARED)
    tables["system"].update(changes)
    tables["system"] = {key: value for key, value in tables["system"].items() if value is not None}
    return tables


def complaint(make, *arguments, **options):
    with pytest.raises(InputError) as caught:
        make(*arguments, **options)
    return str(caught.value)


def test_dict_text_and_file_make_the_same_case(tmp_path):
    case = zenosphere.Case(SHEARED)
    file = tmp_path / "case.toml"
    file.write_text(case.text)
    assert tomllib.loads(case.text) == SHEARED
    assert zenosphere.Case.parse(case.text).resolved == case.resolved
    assert zenosphere.Case.read(file).resolved == zenosphere.Case.read(str(file)).resolved
    assert zenosphere.Case.read(file).resolved == case.resolved


def test_resolved_case_holds_defaults_and_overrides():
    case = zenosphere.Case(SHEARED, overrides={"system.restitution": 0.25, "run.time": 3})
    assert case.tables["system"]["restitution"] == 0.25 and case.tables["run"]["time"] == 3
    assert case.tables["collapse"]["gap_threshold"] == 1e-16
    assert "restitution = 0.9" in case.text
    assert zenosphere.Case.parse(case.resolved).resolved == case.resolved


def test_case_prints_what_the_program_checks(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(zenosphere.Case(SHEARED).text)
    shown = zenosphere.Case.read(file)
    commented = "".join(f"# {line}\n" for line in shown.derived.splitlines())
    assert program("check", file) == f"{shown.resolved}\n{commented}"


def test_numbers_of_numpy_are_numbers():
    given = {"arrangement": "given", "positions": np.array([[1.0, 1, 1], [1, 3, 1.25]]),
             "velocities": np.array([[0, 0.5, 0], [0, -0.1, 0]])}
    tables = {"system": {"dimension": np.int64(3), "spheres": np.int32(2),
                         "restitution": np.float32(0.5), "sides": np.full(3, 5.0)},
              "start": given, "drive": {"kind": "none"}, "run": {"collisions": np.uint8(1)}}
    start = zenosphere.Case(tables).tables["start"]
    assert start["positions"] == given["positions"].tolist()
    assert start["velocities"] == given["velocities"].tolist()


def test_real_numbers_arrive_bit_for_bit():
    for number in (0.1, 1 / 3, 1.2345678901234567e-20, 1e16, 0.30000000000000004):
        case = zenosphere.Case(SHEARED, overrides={"start.granular_temperature": number})
        assert case.tables["start"]["granular_temperature"] == number


def test_error_in_a_dict_names_the_key():
    assert complaint(zenosphere.Case, broken(restitution=1.2)) == (
        "case: system.restitution = 1.2 (must be in [0, 1]; 1 is elastic)")
    assert complaint(zenosphere.Case, broken(restituton=0.2), name="mine") == (
        "mine: unknown key system.restituton; did you mean restitution?")


def test_all_errors_in_a_dict_are_told_at_once():
    told = complaint(zenosphere.Case, broken(restitution=-1, spheres=0, dimension=None))
    assert [line.split(" ")[1] for line in told.splitlines()] == [
        "system.spheres", "system.restitution", "missing"]


@pytest.mark.parametrize("tables, told", [
    ({"system": 3}, "case: system = 3 (found no dict, needs one with the keys of a table)"),
    ({"a": 1}, "case: a = 1 (found no dict, needs one with the keys of a table); give {'system'"),
    (broken(restitution=1j), "case: system.restitution = 1j (a complex, which TOML has not)"),
    (broken(restitution=[object]), "case: system.restitution = <class 'object'> (a type,"),
    (broken(restitution="high"), 'case: system.restitution = "high" (found text, needs'),
    (broken(restitution=float("nan")), "case: system.restitution = nan (must be"),
    ({**SHEARED, "sistem": {}}, "case: unknown table [sistem]; did you mean [system]?"),
    ({**SHEARED, 'a "b"\n': {}}, "case: unknown table"),
    ({**SHEARED, 7: {}}, "case: key 7 (a int, keys are text)"),
    ([SHEARED], "case: is a list (a case is nested dicts)"),
    (broken(spheres=10**30), "case: system.spheres = 1000000000000000000000000000000 (TOML's"),
    (broken(restitution="\ud800"), "case: system.restitution = '\\ud800' (half of a pair"),
], ids=["no table", "key outside", "complex", "nested", "text", "nan", "unknown table", "odd name",
        "number", "list", "huge", "surrogate"])
def test_dict_that_is_no_case_is_refused(tables, told):
    assert complaint(zenosphere.Case, tables).startswith(told)


def test_errors_in_a_file_have_the_texts_of_the_program(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(zenosphere.Case(SHEARED).text.replace("0.9", "1.9").replace("seed", "sead"))
    code, printed = failure("check", file)
    assert code == 2 and len(printed.splitlines()) == 2
    assert complaint(zenosphere.Case.read, file) == printed
    assert complaint(zenosphere.Run, file) == printed


def test_error_in_an_override_names_it_as_python_does(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(zenosphere.Case(SHEARED).text)
    assert complaint(zenosphere.Case.read, file, overrides={"system.restitution": 1.5}) == (
        'overrides["system.restitution"]: system.restitution = 1.5 (must be in [0, 1]; 1 is elastic)')
    assert complaint(zenosphere.Case.read, file, overrides={"system.restitution": None}).startswith(
        'overrides["system.restitution"] = None (a NoneType')


@pytest.mark.parametrize("told, meant", [
    ("out.h5: exists already; choose another name or pass --overwrite",
     "out.h5: exists already; choose another name or pass overwrite=True"),
    ("out.h5: is at time 3 (run.time = 3 is reached); raise it: --set run.time=4",
     'out.h5: is at time 3 (run.time = 3 is reached); raise it: overrides={"run.time": 4}'),
    ("has collapsed; go on with --set collapse.stop_when_collapsed=false",
     'has collapsed; go on with overrides={"collapse.stop_when_collapsed": False}'),
    ("--set system.spheres: cannot be changed in a run that has begun",
     'overrides["system.spheres"]: cannot be changed in a run that has begun'),
    ('--set "a=1": problem (why)\n--set run.time=-1: run.time = -1 (must be > 0)',
     'overrides "a=1": problem (why)\noverrides["run.time"]: run.time = -1 (must be > 0)'),
])
def test_options_of_the_program_are_arguments_in_python(told, meant):
    assert in_python_words(told) == meant


def test_cases_are_equal_if_they_describe_the_same_run(tmp_path):
    case = zenosphere.Case(SHEARED)
    other = zenosphere.Case.parse("# mine\n" + case.resolved)
    assert case == other and hash(case) == hash(other) and case.text != other.text
    assert case != zenosphere.Case(SHEARED, overrides={"start.seed": 8})
    assert case != "a case" and len({case, other}) == 1


def test_case_is_pickled_with_all_it_has():
    case = zenosphere.Case(SHEARED, overrides={"system.restitution": 0.25})
    again = pickle.loads(pickle.dumps(case))
    assert again == case and (again.text, again.derived) == (case.text, case.derived)
    assert copy.deepcopy(case) == case


def end_of(case):
    with zenosphere.Run(case) as run:
        run.skip()
    return run.time


def test_cases_go_to_other_processes():
    cases = [zenosphere.Case(SHEARED, overrides={"start.seed": seed, "run.collisions": 200})
             for seed in (1, 2)]
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, mp_context=spawn) as pool:  # says so if a process ends early
        assert list(pool.map(end_of, cases)) == [end_of(case) for case in cases]


def test_text_that_is_not_toml_is_refused_with_its_line():
    assert complaint(zenosphere.Case.parse, "[system\n", name="text").startswith("text:1:8: ")


def test_errors_are_python_errors_too():
    assert issubclass(zenosphere.InputError, ValueError)
    assert issubclass(zenosphere.OutputError, OSError)
