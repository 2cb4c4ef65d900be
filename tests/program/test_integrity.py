"""Checksums of finished outputs: what has changed since it was written is found and named."""

import json
import os
import subprocess

import h5py
import pytest

from conftest import forged
from processes import MOST_SECONDS

SOUND = "match: every byte is as it was written"


def checksums(program):
    """What `info` says of them, for people and as JSON."""
    line = next(line for line in program("info", "out.h5").stdout.splitlines()
                if line.startswith("  checksums"))
    told = json.loads(program("info", "out.h5", "--json").stdout)
    return line.removeprefix("  checksums").strip(), told["file"]["checksums"]


def change_gap(file):
    with h5py.File(file, "r+") as run:
        run["collisions/gap"][700] += 1e-9


def test_info_and_verify_say_that_a_file_is_as_it_was_written(program):
    program.keep()
    assert checksums(program) == (SOUND, "bytes unchanged")
    assert f"checksums {SOUND}" in program("verify", "out.h5").stdout


@pytest.mark.parametrize("words", [["info"], ["info", "--json"], ["verify"], ["adjudicate"],
                                   ["resume", "--set", "run.collisions=3000"]])
def test_damaged_dataset_is_one_line(program, words):
    _, file = program.keep()
    change_gap(file)
    before = file.read_bytes()
    [line] = program.fail(words[0], "out.h5", *words[1:])
    assert line == ("out.h5: is damaged (/collisions/gap is not what was written); take another copy"
                    " of it, or run its case again")
    assert file.read_bytes() == before


def test_damaged_attribute_is_one_line(program):
    _, file = program.keep()
    with h5py.File(file, "r+") as run:
        run["zenosphere/checkpoint"].attrs["wall_seconds"] = 1.5
    [line] = program.fail("info", "out.h5")
    assert "the attribute wall_seconds of /zenosphere/checkpoint is not what was written" in line


def test_what_another_program_adds_is_no_damage(program):
    _, file = program.keep()
    with h5py.File(file, "r+") as run:
        run["mine"] = [1, 2, 3]
        run["collisions"].attrs["note"] = "of its reader"
    assert checksums(program) == ("match: every dataset and attribute is as it was written",
                                  "values unchanged")


def test_file_without_checksums_is_said_to_be_unchecked(program):
    _, file = program.keep()
    with forged(file) as run:
        run["collisions/gap"][700] += 1e-9
    text, word = checksums(program)
    assert text.startswith("none, ") and text.endswith("not checked") and word == "none"
    assert "checksums none" in program("verify", "out.h5", code=2).stdout


def test_longer_run_has_checksums_of_its_own(program):
    _, file = program.keep()
    with forged(file):
        pass  # as zenosphere 0.1 has written it
    program("resume", "out.h5", "--quiet", "--set", "run.collisions=3000")
    assert checksums(program) == (SOUND, "bytes unchanged")
    change_gap(file)
    assert "/collisions/gap" in program.fail("info", "out.h5")[0]


def test_list_of_checksums_can_be_read_by_people(program):
    """Checksum, type, extents, name: a line a value, the last one about those before it."""
    _, file = program.keep()
    with h5py.File(file) as run:
        lines = run["zenosphere/checksums"][()].decode().splitlines()
    assert any(line.endswith(" float64 2000 collisions/gap") for line in lines)
    assert any(line.endswith(" string scalar zenosphere/case") for line in lines)
    assert any(line.endswith(" int64 2 h5md@version") for line in lines)
    assert lines[-1].endswith(" of the lines above")


def test_flipped_bits_are_found(program, checkout):
    done = subprocess.run(
        [checkout / "scripts" / "reliability" / "flip-bits", "24", "--system", "quad"], text=True,
        capture_output=True, timeout=MOST_SECONDS,
        env={**os.environ, "ZENOSPHERE": str(program.command()[0])})
    assert done.returncode == 0, done.stdout + done.stderr
