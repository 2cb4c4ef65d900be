"""The package as a whole: types, documentation, and what works without the compiled part."""

import ast
import inspect
import os
import re
import subprocess
import sys

import pytest
from module import CHECKOUT, needed

import zenosphere

PACKAGE = CHECKOUT / "python" / "zenosphere"
DOCUMENTS = [CHECKOUT / "README.md", CHECKOUT / "docs" / "python.md"]  # what needs no files
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


def test_errors_and_figures_need_no_compiled_part(tmp_path):
    script = ("import zenosphere, zenosphere.figures\n"
              "zenosphere.InputError, zenosphere.OutputError\n"
              "try: zenosphere.Run\n"
              "except ImportError as error: print(error)\n")
    copy = tmp_path / "zenosphere"
    copy.mkdir()
    for file in PACKAGE.glob("*.py"):
        (copy / file.name).symlink_to(file)
    done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert "zenosphere.Run: needs the compiled part" in done.stdout
    assert "PYTHONPATH=build/python" in done.stdout


def test_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'Rum'"):
        zenosphere.Rum


@needed
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_example_runs(tmp_path, example):
    """Each takes the number of collisions as its argument."""
    done = subprocess.run([sys.executable, example, "3000"], cwd=tmp_path, check=True,
                          capture_output=True, text=True, env=ENVIRONMENT, timeout=60)
    assert "3000" in done.stdout and done.stderr == ""


@needed
@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_python_in_a_document_runs_from_its_first_line_to_its_last(tmp_path, document):
    """All blocks of a document together, in a folder from which examples/ can be seen."""
    (tmp_path / "examples").symlink_to(CHECKOUT / "examples")
    script = "\n".join(BLOCK.findall(document.read_text()))
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, check=True,
                          capture_output=True, text=True, env=ENVIRONMENT, timeout=60)
    assert done.stdout and done.stderr == ""
