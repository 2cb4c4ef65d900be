"""Every example works: the cases of examples/, and the commands and cases in the documents."""

import json
import os
import re
import shlex
import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
EXAMPLES = sorted((CHECKOUT / "examples").glob("*.toml"))
DOCUMENTS = sorted([*CHECKOUT.glob("*.md"), *(CHECKOUT / "docs").rglob("*.md")])
HAS_PAGE = os.environ.get("ZENOSPHERE_HAS_PAGE") != "OFF"  # a build without npm makes none
SHORT = ["--set", "run.collisions=2000"]
FENCE = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
PLACEHOLDERS = re.compile(r"CASE\.toml|OUT\.h5|KEY=VALUE|\[|\.\.\.")


def blocks(document, *languages):
    return [body for language, body in FENCE.findall(document.read_text())
            if language in languages]


def commands_of(document):
    """The words of each command of this program in the shell examples of a document."""
    lines = [line.strip().removeprefix("$ ") for block in blocks(document, "sh", "bash", "console")
             for line in block.replace("\\\n", " ").splitlines()]
    ours = [line for line in lines if re.match(r"(\./)?(build/)?zenosphere ", line)]
    return [shlex.split(line, comments=True)[1:] for line in ours
            if not PLACEHOLDERS.search(line)]


def name_of(path):
    return path.relative_to(CHECKOUT).as_posix()


RUN_ELSEWHERE = ["tutorial.md", "export.md", "ensembles.md"]  # with what stands between them
WITH_COMMANDS = [document for document in DOCUMENTS if commands_of(document)
                 and document.name not in RUN_ELSEWHERE]
CASES = [(document, number) for document in DOCUMENTS
         for number in range(len(blocks(document, "toml")))]


def settings_in(text):
    """A TOML text as overrides; its values are scalars, which JSON writes as TOML does."""
    tables = tomllib.loads(text)
    return {f"{table}.{key}": json.dumps(value) for table, values in tables.items()
            for key, value in values.items()}


@pytest.mark.parametrize("example", EXAMPLES, ids=name_of)
def test_example_is_a_right_case(program, example):
    text = program("check", str(example)).stdout
    assert "[system]" in text and "box side" in text


@pytest.mark.parametrize("example", EXAMPLES, ids=name_of)
def test_example_runs(program, example):
    done = program("run", str(example), "--json", "-o", "out.h5", *SHORT)
    summary = json.loads(done.stdout)
    assert 0 < summary["collisions"] <= 2000 and summary["ledger_error"] < 1e-10
    assert program("info", "out.h5").stdout


@pytest.mark.parametrize("example", sorted((CHECKOUT / "examples" / "sweeps").glob("*.toml")),
                         ids=name_of)
def test_example_of_a_sweep_is_right(program, example):
    assert "points" in program("sweep", str(example), "--dry-run").stdout


def test_there_are_the_two_cases_of_the_paper():
    restitution = {tomllib.loads(each.read_text())["system"].get("restitution")
                   for each in EXAMPLES}
    assert {0.2, 0.6} <= restitution


def follow(program, document):
    """Runs the commands of a document one after another in a folder with the examples."""
    shutil.copytree(CHECKOUT / "examples", program.folder / "examples")
    for words in commands_of(document):
        if words[0] == "report" and not HAS_PAGE:
            continue
        program(*words, *(SHORT if words[0] in ("run", "check") else []))


@pytest.mark.parametrize("document", WITH_COMMANDS, ids=name_of)
def test_commands_of_a_document_run(program, document):
    follow(program, document)


@pytest.mark.parametrize("page", ["export.md", "ensembles.md"])
def test_python_of_a_document_reads_what_its_commands_have_made(program, page):
    document = CHECKOUT / "docs" / page
    follow(program, document)
    script = "\n".join(blocks(document, "python"))
    done = subprocess.run(["/usr/bin/python3", "-c", script], cwd=program.folder, text=True,
                          capture_output=True)
    assert done.returncode == 0 and done.stdout, done.stderr


@pytest.mark.parametrize("document, number", CASES,
                         ids=[f"{name_of(document)}:{number}" for document, number in CASES])
def test_toml_of_a_document_is_right(program, document, number):
    text = blocks(document, "toml")[number]
    if "sweep" in tomllib.loads(text):
        program.case.rename(program.folder / "shear.toml")
        program.case.write_text(text)
        program("sweep", "case.toml", "--quiet")
    elif {"system", "start", "drive", "run"} <= set(tomllib.loads(text)):
        program.case.write_text(text)
        program("run", "case.toml", "--quiet", *SHORT)
    else:
        program.run({**settings_in(text), "run.collisions": 2000})


def test_every_command_is_on_the_page_of_the_command_line(program):
    page = (CHECKOUT / "docs" / "commands.md").read_text()
    commands = re.findall(r"^  ([\w-]+)  ", program("--help").stdout.split("Subcommands:")[1],
                          re.MULTILINE)
    assert len(commands) > 15
    assert set(re.findall(r"^\| `([\w-]+)` \|", page, re.MULTILINE)) == set(commands)


def test_every_key_that_check_prints_is_on_the_page_of_the_case_file(program):
    page = (CHECKOUT / "docs" / "case-file.md").read_text()
    keys = re.findall(r"^(\w+) = ", program("check", str(EXAMPLES[0])).stdout, re.MULTILINE)
    assert len(keys) > 15
    assert [key for key in keys if f"| `{key}` |" not in page] == []


def test_every_key_of_the_summary_is_on_its_page(program):
    page = (CHECKOUT / "docs" / "summary.md").read_text()
    names = [name for key, value in program.run().items()
             for name in ([f"{key}.{inner}" for inner in value] if isinstance(value, dict)
                          and key != "averages" else [key])]
    missing = [name for name in names
               if f"`{name}`" not in page and f"`.{name.split('.')[-1]}`" not in page]
    assert missing == []


def test_no_room_includes_what_it_may_not():
    done = subprocess.run([CHECKOUT / "scripts" / "check-includes"], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
