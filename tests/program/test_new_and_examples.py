"""Cases that the program carries: `zenosphere new`, `zenosphere examples`, and standard input."""

from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
QUESTIONS = sorted(path.stem for path in (EXAMPLES / "new").glob("*.toml"))


def test_program_alone_shows_what_there_is_to_do(program):
    text = program().stdout
    assert "zenosphere new" in text and "zenosphere --help" in text


def test_new_lists_its_questions(program):
    assert all(f"\n  {name} " in program("new").stdout for name in QUESTIONS)


@pytest.mark.parametrize("name", QUESTIONS)
def test_new_case_is_valid_and_has_a_question_for_title(program, tmp_path, name):
    case = tmp_path / f"{name}.toml"
    first = program("new", name, "-o", case).stdout.splitlines()[0]
    assert first.startswith(f"{case}: ") and first.endswith("?")
    assert case.read_text() == (EXAMPLES / "new" / f"{name}.toml").read_text()
    program("check", case)


def test_examples_can_be_copied_all_and_one(program, tmp_path):
    program("examples", "--all", tmp_path / "all")
    names = {path.relative_to(EXAMPLES) for path in EXAMPLES.rglob("*.toml")}
    assert {path.relative_to(tmp_path / "all") for path in (tmp_path / "all").rglob("*.toml")} == names
    one = tmp_path / "one.toml"
    program("examples", "shear-e06", "-o", one)
    assert one.read_text() == (EXAMPLES / "shear-e06.toml").read_text()


def test_nothing_is_replaced_unasked(program, tmp_path):
    case = tmp_path / "rods.toml"
    case.write_text("mine")
    assert "exists already; choose another name or pass --overwrite" in "".join(program.fail("new", "rods", "-o", case, code=4))
    assert case.read_text() == "mine"
    program("new", "rods", "-o", case, "--overwrite")
    assert case.read_text() != "mine"


def test_unknown_name_is_refused_with_where_the_list_is(program):
    assert "run zenosphere new for the list" in "".join(program.fail("new", "nonsense"))


@pytest.mark.parametrize("command, typed, meant", [
    ("new", "sheered", "sheared"), ("examples", "shear-e6", "shear-e06"),
])
def test_name_that_is_nearly_right_is_guessed(program, command, typed, meant):
    assert f"; did you mean {meant}? " in "".join(program.fail(command, typed))


def test_examples_are_listed_by_subject_and_none_is_left_over(program):
    text = program("examples").stdout
    assert "More cases" not in text
    names = [line.split()[0] for line in text.splitlines() if line.startswith("  ")]
    assert names[:2] == ["shear-e02", "shear-e06"]
    shipped = {str(path.relative_to(EXAMPLES).with_suffix("")) for path in EXAMPLES.rglob("*.toml")}
    assert sorted(names) == sorted(name for name in shipped if not name.startswith("new/"))


def test_title_of_an_example_is_not_cut_at_an_abbreviation(program):
    titles = [line.strip() for line in program("examples").stdout.splitlines()
              if line.startswith("  ")]
    assert titles and not any(title.endswith((" Phys", " Rev", " J")) for title in titles)


def test_case_is_read_from_standard_input(program, tmp_path):
    text = (EXAMPLES / "new" / "rods.toml").read_text()
    done = program("run", "-", "--json", "--quiet", input=text)
    assert '"verdict"' in done.stdout
    assert "standard input:" in "".join(program.fail("run", "-", input="[system]\nspheers = 3\n"))
