"""The commands themselves: help, version, usage errors, and what `check` and `info` print."""

import json
import re
import tomllib

import pytest

from conftest import CHECKOUT


def commands_in(help_text):
    """The first word of each line below `Subcommands:`."""
    return re.findall(r"^  (\w+)", help_text.split("Subcommands:")[1], re.MULTILINE)


def test_help_lists_the_commands_that_exist_and_no_other(program):
    done = program("--help")
    assert set(commands_in(done.stdout)) == {
        "run", "resume", "check", "info", "adjudicate", "verify", "sweep", "export", "report",
        "new", "examples", "figures", "report", "cooling", "movie", "ensemble", "analyse",
        "completion", "manual"}
    assert done.stderr == ""


@pytest.mark.parametrize("command", ["run", "resume", "check", "info", "adjudicate", "export"])
def test_every_command_has_help(program, command):
    assert f"zenosphere {command}" in program(command, "--help").stdout


def test_help_of_run_names_every_option_of_the_interface(program):
    text = program("run", "--help").stdout
    options = ["-o", "--set", "--json", "--quiet", "--overwrite", "--fail-on-collapse"]
    assert all(option in text for option in options)


def test_citation_names_version_and_year(program):
    citation = (CHECKOUT / "CITATION.cff").read_text()
    version = re.search("^version: (.*)$", citation, re.M)[1]
    year = re.search("^date-released: (....)", citation, re.M)[1]
    text = program("--cite").stdout
    assert f"The Zenosphere authors ({year}). Zenosphere: " in text and f"Version {version}," in text
    entry = program("--cite", "bibtex").stdout
    assert entry.startswith("@software{zenosphere,") and entry.endswith("}\n}\n")
    assert f"version = {{{version}}}," in entry and f"year    = {{{year}}}," in entry


def test_citation_in_an_unknown_format_is_one_line(program):
    assert program.fail("--cite", "ris") == ["--cite ris: is no format (must be bibtex, or nothing)"]


def test_version_is_a_line_with_three_numbers(program):
    assert re.fullmatch(r"zenosphere \d+\.\d+\.\d+ .*\n", program("--version").stdout)
    assert program("-V").stdout == program("--version").stdout


def test_help_is_a_command_too(program):
    assert program("help").stdout == program("--help").stdout


@pytest.mark.parametrize("words", [
    ["simulate"], ["run"], ["check"], ["info"], ["run", "case.toml", "--nonsense"],
    ["run", "case.toml", "other.toml"], ["run", "case.toml", "-o"], ["run", "case.toml", "--set"],
    ["resume"], ["resume", "out.h5", "-o", "other.h5"], ["--nonsense"],
])
def test_wrong_command_line_is_exit_code_2_and_points_at_the_help(program, words):
    lines = program.fail(*words)
    assert any("--help" in line or "Usage" in line for line in lines)


@pytest.mark.parametrize("words", [["simulate"], ["run", "case.toml", "--nonsense"]])
def test_word_that_is_not_understood_is_repeated(program, words):
    assert words[-1] in "".join(program.fail(*words))


@pytest.mark.parametrize("words, told", [
    ("rum case.toml",
     "zenosphere: unknown command rum; did you mean run? See zenosphere --help"),
    ("run", "zenosphere run: CASE.toml missing; see zenosphere run --help"),
    ("export", "zenosphere export: OUT.h5 and --format FORMAT and --output FILE missing; "
     "see zenosphere export --help"),
    ("sweep show s.toml",
     "zenosphere sweep show: --run N missing; see zenosphere sweep show --help"),
    ("run case.toml --overwite", "zenosphere run: unknown option --overwite; "
     "did you mean --overwrite? See zenosphere run --help"),
    ("run --seed=3", "zenosphere run: unknown option --seed; see zenosphere run --help"),
    ("run case.toml other.toml", "zenosphere run: other.toml is one word too many "
     "(a name with blanks stands in quotes); see zenosphere run --help"),
    ("run case.toml -o",
     "zenosphere run: --output needs OUT.h5 behind it; see zenosphere run --help"),
    ("run case.toml -o a.h5 -o b.h5",
     "zenosphere run: --output is given 2 times; see zenosphere run --help"),
    ("run case.toml --overwrite=no",
     "zenosphere run: --overwrite takes no value; see zenosphere run --help"),
    ("adjudicate case.toml --up-to 128", "--up-to = 128 (must be double, extended, quad or digitsN "
     "with N from 20 to 10000); write digits128"),
    ("adjudicate case.toml --seconds 0", "--seconds = 0 (must be a number > 0)"),
    ("adjudicate case.toml --seconds soon", "--seconds = soon (must be a number > 0)"),
    ("adjudicate case.toml --collisions 1e6",
     "--collisions = 1e6 (must be a whole number in [1, 9007199254740992])"),
    ("export out.h5 --format xyz -o x", "--format = xyz (must be csv-collisions, csv-observables, "
     "csv-series, extxyz, lammps or vtp)"),
    ("export out.h5 --format extxy -o x", "--format = extxy (must be csv-collisions, "
     "csv-observables, csv-series, extxyz, lammps or vtp); did you mean extxyz?"),
    ("export out.h5 --format vtp -o x --every 0",
     "--every = 0 (must be a whole number in [1, 9007199254740992])"),
    ("export out.h5 --format vtp -o x --from 1.5",
     "--from = 1.5 (must be a whole number in [-9007199254740992, 9007199254740992])"),
    ("sweep s.toml --threads many", "--threads = many (must be a whole number in [1, 1024])"),
    ("sweep show s.toml --run -1",
     "--run = -1 (must be a whole number in [0, 9007199254740992])"),
    ("sweep s.toml --set run.time=3", "--set run.time=3: is not for sweeps (a store holds the runs "
     "of one sweep file); write it into the base case, or under [case...] or [axes] of the sweep "
     "file"),
])
def test_wrong_command_line_is_told_in_one_line_of_our_grammar(program, words, told):
    assert program.fail(*words.split()) == [told]


@pytest.mark.parametrize("command", ["figures", "report-md", "cooling", "movie", "ensemble"])
def test_manual_of_a_command_in_python_has_the_options_that_it_takes(program, command):
    manual = program("manual", command).stdout.replace("\\-", "-").split(".SH DESCRIPTION")[0]
    taken = program(command, "--help").stdout.split("options:")[1]
    options = set(re.findall(r"^  (?:-o \S+, )?(--[\w-]+)", taken, re.MULTILINE))
    assert set(re.findall(r"--[\w-]+", manual)) | {"--output"} == options | {"--output"}
    assert ("[-o " in manual) == ("--output" in options)


def test_exit_codes_are_told_where_they_can_be(program):
    def codes(*command):
        text = program(*command, "--help").stdout.split("Exit codes:")[1]
        return re.findall(r"^\s*(\d+) ", text, re.MULTILINE)  # each of them once
    assert codes("run") == codes("resume") == ["0", "1", "2", "3", "4", "130"]
    assert codes("sweep") == ["0", "1", "2", "4", "130"]
    assert codes("info") == codes("verify") == codes("sweep", "show") == ["0", "1", "2"]
    assert codes("export") == ["0", "1", "2", "4"]
    assert "2 wrong input, or the file contradicts itself\n" in program("verify", "--help").stdout


def test_help_of_a_command_is_a_command_too(program):
    assert program("help", "run").stdout == program("run", "--help").stdout


@pytest.mark.parametrize("words", ["run case.toml", "sweep s.toml", "report out.h5"])
@pytest.mark.parametrize("output", ["-", "/dev/stdout"])
def test_what_cannot_go_to_standard_output_is_refused(program, words, output):
    [line] = program.fail(*words.split(), "-o", output)
    assert line.startswith(f"-o {output}: cannot go to standard output (")
    assert not (program.folder / "-").exists()


def test_run_of_which_nothing_is_left_says_so_before_it_begins(program):
    [line] = program("run", "case.toml", "--quiet").stderr.splitlines()
    assert line.startswith("case.toml: nothing is kept or printed (--quiet without -o); -o OUT.h5")
    for words in (["--json"], ["--fail-on-collapse"], ["-o", "out.h5"]):
        assert program("run", "case.toml", "--quiet", *words).stderr == ""


def resolved_part(text):
    """The TOML in what `check` prints: its paragraphs that begin with a table."""
    return "\n\n".join(part for part in text.split("\n\n") if part.startswith("["))


def test_check_prints_a_case_that_gives_the_same_when_fed_back(program):
    first = program("check", "case.toml").stdout
    again = program.folder / "again.toml"
    again.write_text(resolved_part(first))
    assert program("check", "again.toml").stdout == first


def test_checked_case_runs_the_same_collisions(program):
    (program.folder / "again.toml").write_text(resolved_part(program("check", "case.toml").stdout))
    time = json.loads(program("run", "again.toml", "--json").stdout)["time"]
    assert time == program.run()["time"]


def test_check_tells_every_value_used(program):
    text = program("check", "case.toml", "--set", "system.restitution=0.5").stdout
    values = tomllib.loads(resolved_part(text))
    assert values["system"] == {"dimension": 3, "spheres": 108, "restitution": 0.5,
                                "solids_volume_fraction": 0.3, "aspect_ratio": 1}
    assert values["collision"]["overlap"] == "rewind"
    assert values["collision"]["precision"] == "double"
    assert values["collapse"] == {"gap_threshold": 1e-16, "window": 1000,
                                  "stop_when_collapsed": True}
    assert values["run"] == {"collisions": 2000}


def test_check_tells_what_follows_from_the_case(program):
    text = program("check", "case.toml").stdout
    # (pi 108 / (6 x 0.3))^(1/3) = 5.7336835; 2 x 2000 / 108 = 37.037037; 1 / 2 = 0.5
    assert re.search(r"box side\s+5\.733683", text)
    assert re.search(r"collisions per sphere\s+37\.037", text)
    assert re.search(r"strain unit\s+0\.5 ", text)


def test_check_runs_nothing(program):
    program("check", "case.toml", "--set", "run.collisions=1000000000000")
    assert [path.name for path in program.folder.iterdir()] == ["case.toml"]


def test_info_gives_the_object_that_the_run_printed(program):
    summary, _ = program.keep()
    told = json.loads(program("info", "out.h5", "--json").stdout.splitlines()[-1])
    assert {key: told[key] for key in summary} == summary


def test_info_without_json_tells_the_verdict_in_a_sentence(program):
    program.keep()
    assert program("info", "out.h5").stdout.startswith("No collapse: ")
