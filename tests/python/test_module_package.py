"""The package as a whole: types, documentation, and what works without the compiled part."""

import ast
import inspect
import os
import re
import shutil
import subprocess
import sys

import pytest
from module import CHECKOUT, PROGRAM, needed
from processes import MOST_SECONDS

import zenosphere

PACKAGE = CHECKOUT / "python" / "zenosphere"
PAGE = CHECKOUT / "docs" / "python.md"
BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
EXAMPLES = sorted((CHECKOUT / "examples" / "python").glob("*.py"))
ENVIRONMENT = {**{key: value for key, value in os.environ.items() if key != "DISPLAY"},
               "PYTHONPATH": os.path.dirname(os.path.dirname(zenosphere.__file__))}


def public(owner):
    return {name for name in vars(owner) if not name.startswith("_")}


@needed
def test_stub_names_all_that_the_compiled_part_has():
    from zenosphere import _core

    body = ast.parse((PACKAGE / "_core.pyi").read_text()).body
    classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
    constants = {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
    assert set(classes) | constants == public(_core)
    for name, node in classes.items():
        functions = {each.name: each for each in node.body}
        assert set(functions) == public(getattr(_core, name))
        for each, function in functions.items():
            told = inspect.getdoc(getattr(getattr(_core, name), each)) or ""
            for argument in function.args.args:
                assert argument.arg == "self" or f"{argument.arg}: " in told, (name, each)


@needed
def test_everything_public_is_documented():
    for name in zenosphere.__all__:
        owner = getattr(zenosphere, name)
        assert inspect.isclass(owner) is False or owner.__doc__
        for each in public(owner) if inspect.isclass(owner) else ():
            member = inspect.getattr_static(owner, each)
            if callable(member) or isinstance(member, (property, classmethod)):
                assert inspect.getdoc(member), (name, each)


@pytest.fixture
def copy_of_the_sources(tmp_path):
    """A folder with the package, without its compiled part."""
    shutil.copytree(PACKAGE, tmp_path / "zenosphere")
    return tmp_path


def test_errors_and_figures_need_no_compiled_part(copy_of_the_sources):
    script = ("import zenosphere, zenosphere.figures\n"
              "zenosphere.InputError, zenosphere.OutputError\n"
              "try: zenosphere.Run\n"
              "except ImportError as error: print(error)\n")
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": str(copy_of_the_sources)})
    assert "zenosphere.Run: needs the compiled part" in done.stdout
    assert "PYTHONPATH=build/python" in done.stdout


@needed
def test_names_of_the_package_are_seen_before_they_are_used():
    script = "import zenosphere; print(*dir(zenosphere)); help(zenosphere)"
    shown = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True,
                           text=True, env=ENVIRONMENT).stdout
    names, text = shown.split("\n", 1)
    assert set(zenosphere.__all__) | {"__version__"} <= set(names.split())
    for heading in ("class Case(", "class Output(", "class Run(", "class State(", "open("):
        assert heading in text
    assert "VERSION\n    0.1.0" in text.replace(zenosphere.__version__, "0.1.0")


def test_version_is_that_of_the_program():
    told = subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, text=True).stdout
    assert told.split()[:2] == ["zenosphere", zenosphere.__version__]
    assert f"version: {zenosphere.__version__}" in (CHECKOUT / "CITATION.cff").read_text()


def test_dir_without_the_compiled_part_names_what_works(copy_of_the_sources):
    script = "import zenosphere; print(*dir(zenosphere)); help(zenosphere)"
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": str(copy_of_the_sources)})
    names = done.stdout.splitlines()[0].split()
    assert "InputError" in names and "Run" not in names


def test_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'Rum'"):
        zenosphere.Rum


@needed
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_example_runs(tmp_path, example):
    """Each takes the number of collisions as its argument."""
    done = subprocess.run([sys.executable, example, "3000"], cwd=tmp_path, check=True,
                          capture_output=True, text=True, env=ENVIRONMENT, timeout=MOST_SECONDS)
    assert "3000" in done.stdout and done.stderr == ""


@needed
def test_python_of_the_page_runs_from_its_first_line_to_its_last(tmp_path):
    """All blocks together, in a folder from which examples/ can be seen."""
    (tmp_path / "examples").symlink_to(CHECKOUT / "examples")
    script = "\n".join(BLOCK.findall(PAGE.read_text()))
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, check=True,
                          capture_output=True, text=True, env=ENVIRONMENT, timeout=MOST_SECONDS)
    assert done.stdout and done.stderr == ""
    assert "nan" not in done.stdout


def test_console_command_says_what_to_do_without_the_program(tmp_path, monkeypatch, capfd):
    from zenosphere import console
    monkeypatch.setattr(sys, "argv", ["zenosphere", "run", "case.toml"])
    monkeypatch.setattr(console, "PROGRAM", tmp_path / "zenosphere")
    assert console.main() == 2
    assert "pip install" in capfd.readouterr().err


@needed
def test_installed_package_has_the_program_as_its_command(tmp_path):
    pytest.importorskip("wheel", reason="python3-wheel is not installed; scripts/test does that")
    pytest.importorskip("pip", reason="python3-pip is not installed; scripts/test does that")
    build = PROGRAM.parent
    subprocess.run([sys.executable, "-m", "pip", "wheel", "--quiet", "--no-build-isolation",
                    "--no-deps", "--wheel-dir", tmp_path, CHECKOUT], check=True,
                   timeout=MOST_SECONDS, env={**os.environ, "ZENOSPHERE_BUILD": str(build)})
    [wheel] = tmp_path.glob("zenosphere-*.whl")
    subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target",
                    tmp_path / "there", wheel], check=True, timeout=MOST_SECONDS)
    command = [tmp_path / "there" / "bin" / "zenosphere"]
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "there")}
    for words, told in ((["--version"], f"zenosphere {zenosphere.__version__} "),
                        (["--help"], "ensemble"), (["figures", "--help"], "--true-collapse")):
        done = subprocess.run([*command, *words], check=True, capture_output=True, text=True,
                              env=environment)
        assert told in done.stdout
    done = subprocess.run([*command, "run"], capture_output=True, text=True, env=environment)
    assert done.returncode == 2 and "CASE.toml missing" in done.stderr
