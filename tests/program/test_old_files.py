"""Files that zenosphere 0.1.0 has written (tests/program/files) are read, or refused in one line."""

import gzip
import json
import sqlite3

import pytest

from conftest import CHECKOUT, forged


def unpacked(program, name):
    packed = CHECKOUT / "tests" / "program" / "files" / f"{name}.gz"
    (program.folder / name).write_bytes(gzip.decompress(packed.read_bytes()))
    return program.folder / name


@pytest.fixture
def output(program):
    """200 collisions of 32 sheared spheres, eight snapshots, every collision logged."""
    return unpacked(program, "output-0.1.0.h5")


@pytest.fixture
def store(program):
    """Four runs at two restitutions, with what the adjudication found."""
    return unpacked(program, "store-0.1.0.sqlite")


def test_old_output_is_read_and_said_to_be_unchecked(program, output):
    told = json.loads(program("info", output.name, "--json").stdout)
    assert told["collisions"] == 200 and told["verdict"] == "none"
    assert told["file"]["program_version"] == "0.1.0" and told["file"]["checksums"] == "none"
    assert "not checked" in program("info", output.name).stdout


def test_old_output_is_verified_exported_and_shown(program, output):
    assert "replayed                200 " in program("verify", output.name).stdout
    program("export", output.name, "--format", "extxyz", "-o", "run.xyz")
    assert (program.folder / "run.xyz").read_text().count("Lattice=") == 8
    program("figures", output.name, "-o", "figures")
    assert (program.folder / "figures" / "output-0.1.0-separation.png").exists()


def test_old_output_goes_on_or_is_refused_in_one_line(program, output):
    done = program("resume", output.name, "--quiet", "--set", "run.collisions=300", code=None)
    if done.returncode == 0:
        assert json.loads(program("info", output.name, "--json").stdout)["collisions"] == 300
    else:
        [line] = done.stderr.splitlines()
        assert done.returncode == 2 and "zenosphere 0.1.0" in line


def test_old_store_is_read_and_goes_on(program, store):
    assert program("sweep", "csv", store.name, "-o", "-").stdout.count("\n") == 5
    with sqlite3.connect(store) as database:
        [[sweep_file]] = database.execute("SELECT sweep_file FROM sweep")
        [[case]] = database.execute("SELECT base_case FROM sweep")
    (program.folder / "case.toml").write_text(case)
    (program.folder / "s.toml").write_text(sweep_file.replace("seeds = 2", "seeds = 3"))
    told = program("sweep", "s.toml", "-o", store.name).stdout
    assert "6 of 6 runs done" in told


def test_output_of_a_format_to_come_is_refused_in_one_line(program, output):
    with forged(output) as file:
        file["zenosphere"].attrs["format_version"] = 2
        file["zenosphere"].attrs["program_version"] = "2.0.0"
    for command in ("info", "verify", "resume"):
        [line] = program.fail(command, output.name)
        assert line.startswith(f"{output.name}: has format version 2 (this program reads up to 1)")
        assert "2.0.0" in line


def test_store_of_a_format_to_come_is_refused_in_one_line(program, store):
    with sqlite3.connect(store) as database:
        database.execute("PRAGMA user_version = 99")
    [line] = program.fail("sweep", "csv", store.name, code=4)
    assert line.startswith(f"{store.name}: is a store of format 99 (this program reads 1 to ")
