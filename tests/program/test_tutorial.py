"""The tutorial as a newcomer follows it: every block is run, and prints what the page says."""

import os
import re
import subprocess

import pytest
from processes import MOST_SECONDS

PARTS = re.compile(r"(<!-- not run by the tests: .*? -->\n)?^```(\w+)\n(.*?)^```",
                   re.MULTILINE | re.DOTALL)
SHELLS = {"sh": ["bash", "-euo", "pipefail", "-c"], "python": ["/usr/bin/python3", "-c"]}


@pytest.fixture
def clone(tmp_path, program, checkout):
    """A folder that looks like a clone in which the program has been built."""
    folder = tmp_path / "clone"
    folder.mkdir()
    (folder / "build").mkdir()
    (folder / "build" / "zenosphere").symlink_to(program.command()[0])
    (folder / "python").symlink_to(checkout / "python")
    return folder


def output_of(folder, language, block):
    done = subprocess.run([*SHELLS[language], block], cwd=folder, capture_output=True, text=True,
                          timeout=MOST_SECONDS, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert done.returncode == 0, f"{block}\n{done.stdout}{done.stderr}"
    return done.stdout


@pytest.mark.skipif(os.environ.get("ZENOSPHERE_HAS_PAGE") == "OFF",
                    reason="built without the report page, which needs npm")
def test_every_block_of_the_tutorial_prints_what_the_page_says(clone, checkout):
    page = (checkout / "docs" / "tutorial.md").read_text()
    printed, ran, compared = "", 0, 0
    for excluded, language, block in PARTS.findall(page):
        if language == "text":
            lines = block.rstrip().splitlines()
            assert [line for line in lines if line not in printed.splitlines()] == []
            compared += len(lines)
        elif not excluded:
            printed = output_of(clone, language, block)
            ran += 1
    assert ran == 10 and compared > 15


def test_only_the_first_block_is_not_run(checkout):
    page = (checkout / "docs" / "tutorial.md").read_text()
    assert [bool(excluded) for excluded, *_ in PARTS.findall(page)].index(False) == 1
    assert page.count("<!--") == 1
