"""Where `zenosphere report` writes its page, and what it refuses."""

import sqlite3

import h5py
import pytest

from test_report import pytestmark, small_files  # noqa: F401 (pytest reads the mark)


def test_database_that_is_no_sweep_is_refused(program):
    with sqlite3.connect(program.folder / "other.sqlite") as store:
        store.execute("CREATE TABLE run (x)")
    store.close()
    [line] = program.fail("report", "other.sqlite", "-o", "page.html")
    assert line.startswith("other.sqlite: is a database of another program")
    assert not (program.folder / "page.html").exists()


def test_page_is_not_overwritten_unless_asked(program):
    program.keep()
    (program.folder / "page.html").write_text("mine")
    [line] = program.fail("report", "out.h5", "-o", "page.html", code=4)
    assert line == "page.html: exists already; choose another name or pass --overwrite"
    assert (program.folder / "page.html").read_text() == "mine"
    program("report", "out.h5", "-o", "page.html", "--overwrite")
    assert (program.folder / "page.html").stat().st_size > 100_000


def test_run_is_never_overwritten_by_its_page(program):
    program.keep()
    before = (program.folder / "out.h5").read_bytes()
    [line] = program.fail("report", "out.h5", "-o", "out.h5", "--overwrite", code=4)
    assert line == "out.h5: is what it is to show; choose another name"
    assert (program.folder / "out.h5").read_bytes() == before


def test_journal_is_never_overwritten_by_a_page(program):
    program.keep()
    journal = program.folder / "out.h5.journal"
    journal.write_bytes(b"the end of the run")
    [line] = program.fail("report", "out.h5", "-o", journal.name, "--overwrite", code=4)
    assert line == "out.h5.journal: is what it is to show; choose another name"
    assert journal.read_bytes() == b"the end of the run"


def test_file_of_another_name_is_not_touched_by_a_page(program):
    program.keep()
    (program.folder / "page.html.part").write_text("mine")
    program("report", "out.h5", "-o", "page.html")
    assert (program.folder / "page.html.part").read_text() == "mine"


def test_page_without_a_name_of_its_own_lies_beside_the_run(program):
    (program.folder / "data").mkdir()
    program.keep(name="data/out.h5")
    assert program("report", "data/out.h5").stdout.startswith("data/out.html: report page")
    assert (program.folder / "data" / "out.html").exists()


@pytest.mark.parametrize("target, reason", [
    ("missing/page.html", "there is no folder missing"), (".", "is a folder"),
    ("/dev/full", "is not a regular file")])
def test_page_that_cannot_be_written_is_an_error_of_the_output(program, target, reason):
    program.keep()
    [line] = program.fail("report", "out.h5", "-o", target, code=4)
    assert reason in line


def test_failed_page_leaves_nothing(program):
    program.keep()
    [line] = program.fail("report", "out.h5", "-o", "page.html", code=4, preexec_fn=small_files)
    assert line.startswith("page.html: could not be written (File too large)")
    assert not list(program.folder.glob("page.html*"))


@pytest.mark.parametrize("content", [b"", b"not HDF5", b"\x89HDF\r\n\x1a\n" + bytes(100)])
def test_file_that_is_no_run_is_wrong_input(program, content):
    (program.folder / "bad.h5").write_bytes(content)
    [line] = program.fail("report", "bad.h5", "-o", "page.html")
    assert line.startswith("bad.h5: ")
    assert not (program.folder / "page.html").exists()


def test_damaged_anatomy_is_told(program, collapsed):
    _, output = collapsed
    (program.folder / "out.h5").write_bytes(output.read_bytes())
    with h5py.File(program.folder / "out.h5", "r+") as run:
        run["zenosphere/anatomy/hit/spheres/sphere"][0] = 10**9
    [line] = program.fail("report", "out.h5", "-o", "page.html")
    assert "the anatomy names a sphere that is not there" in line
