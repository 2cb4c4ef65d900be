"""zenosphere sweep: one store however it comes about, and what a user sees when something is wrong."""

import json
import os
import pty
import re
import resource
import signal
import sqlite3
import subprocess

import pytest

from processes import MOST_SECONDS, has_worked, wait_for
from sweeps import ENDLESS, SWEEP, is_made, rows
from test_reliability import without_privilege


def start(program, *words, **options):
    return subprocess.Popen(program.command("sweep", *words), cwd=program.folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def test_store_holds_every_run_and_is_named_after_the_sweep_file(sweep):
    done = sweep("sweep", "s.toml", "--json")
    told = json.loads(done.stdout.splitlines()[-1])
    assert (told["store"], told["runs"], told["done"]) == ("s.sqlite", 8, 8)
    found = rows(sweep.folder / "s.sqlite")
    assert [row["run"] for row in found] == list(range(8))
    assert {row["status"] for row in found} == {"done"}
    assert [row["collision.overlap"] for row in found[:3]] == ["rewind", "guarded", "rewind"]
    assert len({row["seed"] for row in found}) == 8
    assert {row["collisions"] for row in found if row["system.restitution"] == 0.9} == {540}


def python_of_the_page(checkout, number):
    page = (checkout / "docs" / "sweep-file.md").read_text()
    return re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)[number]


def test_seeds_are_those_of_the_function_on_the_page(sweep, checkout):
    sweep("sweep", "s.toml")
    names = {}
    exec(python_of_the_page(checkout, 0), names)
    found = rows(sweep.folder / "s.sqlite")
    assert [row["seed"] for row in found] == [names["run_seed"](3, run) for run in range(8)]


def test_pandas_reads_the_store_as_the_page_says(sweep, checkout, monkeypatch, capsys):
    pytest.importorskip("pandas")
    sweep("sweep", "s.toml", "-o", "sweep.sqlite")
    monkeypatch.chdir(sweep.folder)
    exec(python_of_the_page(checkout, 1), {})
    assert "false_positive" in capsys.readouterr().out


def test_store_of_a_sweep_that_has_ended_is_one_plain_file(sweep):
    sweep("sweep", "s.toml")
    store = sqlite3.connect(sweep.folder / "s.sqlite")
    assert store.execute("PRAGMA journal_mode").fetchone() == ("delete",)  # the log is folded in
    store.close()
    assert sorted(path.name for path in sweep.folder.iterdir()) == ["case.toml", "s.sqlite", "s.toml"]


def test_case_that_show_prints_repeats_the_run(sweep):
    sweep("sweep", "s.toml")
    row = rows(sweep.folder / "s.sqlite")[5]
    for source in ("s.sqlite", "s.toml"):
        (sweep.folder / "again.toml").write_text(sweep("sweep", "show", source, "--run", "5").stdout)
        done = sweep("run", "again.toml", "--quiet", "--json")
        summary = json.loads(done.stdout)
        assert (summary["collisions"], summary["time"], summary["verdict"]) == \
            (row["collisions"], row["time"], row["verdict"])
        assert summary["averages"]["pressure_tensor"] == json.loads(row["pressure_tensor"])


def test_number_of_no_run_is_answered_with_those_there_are(sweep):
    sweep("sweep", "s.toml", "--quiet")
    for source in ("s.toml", "s.sqlite"):
        [line] = sweep.fail("sweep", "show", source, "--run", "99")
        assert line == f"--run 99: there is no such run in {source} (0 to 7)"


def test_extended_sweep_keeps_its_rows_and_adds_some(sweep):
    sweep("sweep", "s.toml")
    before = rows(sweep.folder / "s.sqlite")
    (sweep.folder / "s.toml").write_text(SWEEP.replace("[0.2, 0.9]", "[0.2, 0.5, 0.9]"))
    assert json.loads(sweep("sweep", "s.toml", "--json").stdout.splitlines()[-1])["ended_here"] == 4
    after = rows(sweep.folder / "s.sqlite")
    assert after[:8] == before and len(after) == 12
    assert {row["system.restitution"] for row in after[8:]} == {0.5}


def test_changed_sweep_is_refused_with_what_differs(sweep):
    sweep("sweep", "s.toml")
    (sweep.folder / "s.toml").write_text(SWEEP.replace("master_seed = 3", "master_seed = 4"))
    lines = sweep.fail("sweep", "s.toml")
    assert lines == ["s.sqlite: holds the runs of another sweep than s.toml (what differs is below); "
                     "choose another store with -o", "  sweep.master_seed is 4 (3 in the store)"]


def test_problems_of_the_sweep_file_come_with_their_places(sweep):
    (sweep.folder / "s.toml").write_text(SWEEP.replace("0.9", "1.9").replace("guarded", "garded"))
    assert sweep.fail("sweep", "s.toml") == [
        "s.toml:7:30: system.restitution = 1.9 (must be in [0, 1]; 1 is elastic)",
        "s.toml:8:34: collision.overlap = \"garded\" (must be \"rewind\", \"immediate\", \"guarded\" "
        "or \"stop\"); did you mean \"guarded\"?"]


def test_failed_runs_are_rows_and_exit_code_1(sweep):
    box = "2\nLattice=\"9 0 0 0 1 0 0 0 1\" Properties=pos:R:3:velo:R:3\n1 0 0 1 0 0\n{} 0 0 -1 0 0\n"
    for name, place in (("good", 5), ("bad", 1.5)):
        (sweep.folder / name).write_text(box.format(place))
    sweep.case.write_text("[system]\ndimension = 1\nspheres = 2\nrestitution = 0.9\nsides = [9]\n"
                          "[start]\narrangement = \"file\"\n[drive]\nkind = \"none\"\n"
                          "[run]\ncollisions = 9\n")
    (sweep.folder / "s.toml").write_text("[sweep]\ncase = \"case.toml\"\nseeds = 1\n[axes]\n"
                                         "\"start.file\" = [\"bad\", \"good\"]\n")
    assert "1 failed" in sweep("sweep", "s.toml", code=1).stdout
    found = rows(sweep.folder / "s.sqlite")
    assert [row["status"] for row in found] == ["failed", "done"]
    assert "spheres 0 and 1 overlap" in found[0]["error"]
    (sweep.folder / "bad").write_text(box.format(4))
    sweep("sweep", "s.toml", code=1)
    sweep("sweep", "s.toml", "--retry-failed")


LINE_OF_TWO = ('2\nLattice="9 0 0 0 1 0 0 0 1" Properties=pos:R:3:velo:R:3\n'
               "1 0 0 1 0 0\n{} 0 0 -1 0 0\n")
CASE_FROM_FILE = """\
[system]
dimension = 1
spheres = 2
restitution = 0.9
sides = [9]
[start]
arrangement = "file"
{}
[drive]
kind = "none"
[run]
collisions = 9
"""


@pytest.mark.parametrize("in_case, axis", [
    ('file = "start.xyz"', '"system.restitution" = [0.9]'), ("", '"start.file" = ["start.xyz"]'),
])
def test_start_file_that_has_changed_since_a_run_started_from_it_is_refused(sweep, in_case, axis):
    start = sweep.folder / "start.xyz"
    start.write_text(LINE_OF_TWO.format(5))
    sweep.case.write_text(CASE_FROM_FILE.format(in_case))
    (sweep.folder / "s.toml").write_text(f'[sweep]\ncase = "case.toml"\nseeds = 1\n[axes]\n{axis}\n')
    sweep("sweep", "s.toml")
    sweep("sweep", "s.toml")  # the same file: nothing to do
    start.write_text(LINE_OF_TWO.format(4))
    before = rows(sweep.folder / "s.sqlite")
    [line] = sweep.fail("sweep", "s.toml")
    assert line == (f"s.sqlite: {start} has changed since runs of this store started from it; put the"
                    " old file back, or begin another store with -o")
    assert rows(sweep.folder / "s.sqlite") == before
    start.write_text(LINE_OF_TWO.format(5))
    sweep("sweep", "s.toml")


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_sweep_ends_cleanly_and_goes_on_later(sweep, sent):
    (sweep.folder / "s.toml").write_text(ENDLESS)
    process = start(sweep, "s.toml")
    wait_for(lambda: is_made(sweep.folder / "s.sqlite"))
    wait_for(lambda: has_worked(process.pid))
    process.send_signal(sent)
    output, errors = process.communicate(timeout=MOST_SECONDS)
    assert process.returncode == 130 and errors == ""
    assert "0 of 8 runs done" in output and "the same command goes on" in output
    assert {row["status"] for row in rows(sweep.folder / "s.sqlite")} == {"pending"}


def test_second_sweep_on_a_store_is_refused(sweep):
    (sweep.folder / "s.toml").write_text(ENDLESS)
    process = start(sweep, "s.toml")
    try:
        wait_for(lambda: is_made(sweep.folder / "s.sqlite"))
        wait_for(lambda: has_worked(process.pid))
        lines = sweep.fail("sweep", "s.toml", code=4)
        assert lines[0].startswith("s.sqlite: another sweep is writing to it")
        assert sweep("sweep", "csv", "s.sqlite").stdout.count("pending") == 8  # readers may look
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=MOST_SECONDS)


@pytest.mark.parametrize("content, told", [
    ("a text that is long enough to be no empty database", "is not the store of a sweep"),
    (None, "is a database of another program")])
def test_file_of_another_program_is_refused_and_left_alone(sweep, content, told):
    path = sweep.folder / "s.sqlite"
    if content:
        path.write_text(content)
    else:
        with sqlite3.connect(path) as store:
            store.execute("CREATE TABLE mine (x)")
        store.close()
    before = path.read_bytes()
    assert told in sweep.fail("sweep", "s.toml")[0]
    assert told in sweep.fail("sweep", "csv", "s.sqlite")[0]
    assert path.read_bytes() == before


def test_full_disk_is_exit_code_4(sweep):
    def little_room():
        resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

    (sweep.folder / "s.toml").write_text(SWEEP.replace("seeds = 2", "seeds = 200"))
    done = sweep("sweep", "s.toml", code=4, preexec_fn=little_room)
    assert done.stderr.startswith("s.sqlite: could not be written")
    sweep("sweep", "s.toml", "--quiet")
    assert {row["status"] for row in rows(sweep.folder / "s.sqlite")} == {"done"}


def test_store_in_a_read_only_folder_can_be_read_but_not_written(sweep):
    sweep("sweep", "s.toml", "--quiet")
    sweep.folder.chmod(0o500)
    try:
        options = {"preexec_fn": without_privilege}
        table = sweep("sweep", "csv", "s.sqlite", **options).stdout
        assert table.count("\n") == 1 + len(rows(sweep.folder / "s.sqlite"))
        for name in ("s.sqlite", "new.sqlite"):
            done = sweep("sweep", "s.toml", "-o", name, code=4, **options)
            assert done.stderr == (f"{name}: cannot be written beside ({name}-lock: Permission denied); "
                                   "choose another place\n")
    finally:
        sweep.folder.chmod(0o700)


def test_terminal_shows_one_progress_line(sweep):
    (sweep.folder / "s.toml").write_text(ENDLESS)
    ours, theirs = pty.openpty()
    process = subprocess.Popen(sweep.command("sweep", "s.toml", "--threads", "2"), stderr=theirs,
                               cwd=sweep.folder, stdout=subprocess.PIPE, text=True)
    os.close(theirs)
    shown = os.read(ours, 4096).decode()
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=MOST_SECONDS)
    os.close(ours)
    assert "0 of 8 runs done  2 running  0 failed" in shown


def test_script_finds_killed_sweeps_equal_to_undisturbed_ones(sweep, checkout):
    done = subprocess.run(
        [checkout / "scripts" / "reliability" / "kill-a-sweep", "1"], text=True, capture_output=True,
        timeout=MOST_SECONDS, env={**os.environ, "ZENOSPHERE": str(sweep.command()[0])})
    assert done.stdout.startswith("1 of 1 ") and done.returncode == 0, done.stdout + done.stderr


def test_csv_is_never_written_over_its_store(sweep):
    sweep("sweep", "s.toml", "--quiet")
    before = (sweep.folder / "s.sqlite").read_bytes()
    (sweep.folder / "link.csv").symlink_to("s.sqlite")
    for name in ("s.sqlite", "link.csv"):
        done = sweep("sweep", "csv", "s.sqlite", "-o", name, code=4)
        assert done.stderr == f"{name}: is the store itself; choose another name\n"
    assert (sweep.folder / "s.sqlite").read_bytes() == before


@pytest.mark.parametrize("name", [":memory:", "file:s.sqlite?mode=memory"])
def test_store_is_a_file_whatever_its_name(sweep, name):
    sweep("sweep", "s.toml", "-o", name, "--quiet")
    assert len(rows(sweep.folder / name)) == 8


def test_store_without_a_name_is_refused(sweep):
    done = sweep("sweep", "s.toml", "-o", "", code=2)
    assert done.stderr.startswith("-o: the file name is empty")
