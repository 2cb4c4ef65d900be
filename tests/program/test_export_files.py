"""`zenosphere export`: which snapshots, what it never overwrites, what a broken world costs."""

import json
import os
import resource
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np
import pytest

from recorded import Recorded

SNAPSHOTS = ["--set", "output.snapshot_interval=0.05"]
ONE_FILE = ["extxyz", "lammps", "csv-observables", "csv-collisions"]
FORMATS = [*ONE_FILE, "vtp"]


@pytest.fixture
def finished(program):
    """A sheared run of 108 spheres and 2000 collisions."""
    program("run", "case.toml", "--quiet", "-o", "out.h5", *SNAPSHOTS)
    return program.folder / "out.h5"


def target_of(file_format):
    return "new.pvd" if file_format == "vtp" else "new.txt"


def export(program, file_format, *words, target=None, code=0):
    """Exports out.h5; the lines that it prints, on standard error where it fails."""
    done = program("export", "out.h5", "--format", file_format, "-o",
                   target or target_of(file_format), *words, code=code)
    return (done.stdout if code == 0 else done.stderr).splitlines()


def left(program):
    """What is in the folder besides the case and the run."""
    return sorted({path.name for path in program.folder.iterdir()} - {"case.toml", "out.h5"})


def shown(program, *words):
    """The numbers of the snapshots that an export holds."""
    export(program, "csv-observables", "--overwrite", *words)
    lines = (program.folder / "new.txt").read_text().splitlines()[1:]
    return [int(line.split(",")[0]) for line in lines]


def changed(path, dataset, index, value):
    with h5py.File(path, "r+") as file:
        file[dataset][index] = value


def test_snapshots_are_chosen_by_number_from_both_ends(program, finished):
    everything = shown(program)
    assert everything == list(range(len(Recorded(finished).time))) and len(everything) > 8
    last = everything[-1]
    assert shown(program, "--from", "2", "--to", "4") == [2, 3, 4]
    assert shown(program, "--every", "3") == everything[::3]
    assert shown(program, "--from", "-1") == [last]
    assert shown(program, "--from", "-3", "--to", "-2") == [last - 2, last - 1]
    assert shown(program, "--from", "1", "--to", "100000", "--every", "2") == everything[1::2]


def test_collisions_are_chosen_by_their_number(program, finished):
    export(program, "csv-collisions", "--from", "500", "--to", "520", "--every", "10")
    lines = (program.folder / "new.txt").read_text().splitlines()
    assert [line.split(",")[0] for line in lines] == ["k", "500", "510", "520"]


@pytest.mark.parametrize("file_format, words", [
    ("extxyz", ["--from", "1000"]), ("lammps", ["--from", "5", "--to", "4"]),
    ("vtp", ["--to", "-1000"]), ("csv-observables", ["--from", "-1000"]),
    ("csv-collisions", ["--from", "2001"]), ("csv-collisions", ["--from", "-1"]),
])
def test_selection_of_nothing_is_wrong_input_and_leaves_nothing(program, finished, file_format,
                                                                words):
    [line] = export(program, file_format, *words, code=2)
    assert line.startswith("out.h5: ") and left(program) == []


@pytest.mark.parametrize("words", [
    [], ["out.h5"], ["out.h5", "-o", "x"], ["out.h5", "--format", "extxyz"],
    ["out.h5", "--format", "pdb", "-o", "x"],
    ["out.h5", "--format", "extxyz", "-o", "x", "--every", "0"],
    ["out.h5", "--format", "extxyz", "-o", ""], ["out.h5", "--format", "vtp", "-o", "x.vtp"],
])
def test_wrong_command_line_is_exit_code_2_and_writes_nothing(program, finished, words):
    program.fail("export", *words)
    assert left(program) == []


@pytest.mark.parametrize("file_format", FORMATS)
def test_what_is_there_is_not_overwritten_unless_asked(program, finished, file_format):
    target = program.folder / target_of(file_format)
    target.write_text("years of work")
    [line] = export(program, file_format, code=4)
    assert "--overwrite" in line and target.read_text() == "years of work"
    export(program, file_format, "--overwrite")
    assert target.read_text() != "years of work"
    assert left(program) == (["new-frames", "new.pvd"] if file_format == "vtp" else ["new.txt"])


def test_overwritten_collection_has_the_new_frames_only(program, finished):
    export(program, "vtp")
    export(program, "vtp", "--overwrite", "--every", "4")
    listed = [entry.get("file") for entry in
              ElementTree.parse(program.folder / "new.pvd").getroot().iter("DataSet")]
    frames = sorted((program.folder / "new-frames").iterdir())
    assert listed == [f"new-frames/{path.name}" for path in frames]
    assert listed[:2] == ["new-frames/frame-000000.vtp", "new-frames/frame-000004.vtp"]


def test_folder_with_other_files_is_never_replaced(program, finished):
    (program.folder / "new-frames").mkdir()
    (program.folder / "new-frames" / "thesis.tex").write_text("years of work")
    [line] = export(program, "vtp", "--overwrite", code=4)
    assert line.startswith("new-frames: ") and left(program) == ["new-frames"]
    assert (program.folder / "new-frames" / "thesis.tex").read_text() == "years of work"


@pytest.mark.parametrize("target", ["out.h5", "./out.h5", "folder", "nowhere/x", "case.toml/x",
                                    "/dev/null", "/proc/x"])
def test_target_that_cannot_be_is_exit_code_4(program, finished, target):
    (program.folder / "folder").mkdir()
    before = finished.read_bytes()
    [line] = export(program, "extxyz", "--overwrite", target=target, code=4)
    assert line.startswith(f"{target}: ")
    assert finished.read_bytes() == before and left(program) == ["folder"]


def test_symbolic_link_leads_to_the_file_that_is_written(program, finished):
    (program.folder / "new.txt").touch()
    (program.folder / "link").symlink_to("new.txt")
    export(program, "extxyz", "--overwrite", target="link")
    assert (program.folder / "link").is_symlink() and left(program) == ["link", "new.txt"]
    assert (program.folder / "new.txt").read_text().startswith("108\n")


@pytest.mark.parametrize("file_format", FORMATS)
def test_full_disk_is_exit_code_4_and_leaves_nothing(program, finished, file_format):
    """No file may grow beyond 1000 bytes, as on a disk that is full."""
    done = program("export", "out.h5", "--format", file_format, "-o", target_of(file_format),
                   code=4, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                                 (1000, 1000)))
    assert done.stdout == "" and done.stderr.startswith("new") and done.stderr.count("\n") == 1
    assert left(program) == []


def test_full_disk_leaves_what_was_there(program, finished):
    target = program.folder / "new.txt"
    target.write_text("years of work")
    program("export", "out.h5", "--format", "extxyz", "-o", "new.txt", "--overwrite", code=4,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
    assert target.read_text() == "years of work" and left(program) == ["new.txt"]


def test_new_files_have_the_permissions_of_the_user(program, finished):
    program("export", "out.h5", "--format", "extxyz", "-o", "new.txt",
            preexec_fn=lambda: os.umask(0o027))
    assert (program.folder / "new.txt").stat().st_mode & 0o777 == 0o640


@pytest.fixture
def killed(program):
    """A run whose snapshots and rows are in its journal, but for the first."""
    process = program.start({"output.checkpoint_collisions": 1000, "output.collision_log": "all",
                             "output.snapshot_interval": 0.5})
    return program.kill_with_journal(process)


def text_of(program, file_format, name, *words):
    export(program, file_format, *words, target=name)
    return (program.folder / name).read_text()


def test_run_that_was_killed_gives_what_its_journal_holds(program, killed):
    """The same run, ended at its last checkpoint, has one more snapshot and row: its end."""
    stored = Recorded(program.folder / "out.h5")
    formats = ("csv-observables", "csv-collisions", "extxyz")
    before = {each: text_of(program, each, f"before-{each}") for each in formats}
    told = json.loads(program("info", "out.h5", "--json").stdout.splitlines()[-1])["file"]
    program("resume", "out.h5", "--quiet", "--set", f"run.collisions={told['last_collision']}")
    for each in formats:
        assert text_of(program, each, f"after-{each}").startswith(before[each])
    assert before["csv-observables"].count("\n") == 1 + told["snapshots"] > 1 + len(stored.time)
    rows = before["csv-collisions"].count("\n") - 1
    assert rows == told["logged_collisions"] == told["last_collision"] - 1 > len(stored.log["k"])


def test_export_of_a_killed_run_says_that_it_has_not_ended(program, killed):
    assert "has not ended" in export(program, "extxyz")[1]


def test_journal_that_does_not_belong_to_the_file_is_left_alone(program, killed):
    rows = len(Recorded(program.folder / "out.h5").log["k"])
    program("run", "case.toml", "--quiet", "-o", "other.h5", *SNAPSHOTS)
    killed.rename(program.folder / "other.h5.journal")
    done = program("export", "other.h5", "--format", "csv-collisions", "-o", "other.csv")
    assert done.stdout == "other.csv: 2000 collisions of 108 spheres\n"
    assert export(program, "csv-collisions")[0] == f"new.txt: {rows} collisions of 108 spheres"


def test_damaged_journal_is_one_line_or_left_out(program, killed):
    content = bytearray(killed.read_bytes())
    for place in range(0, len(content), len(content) // 20):
        bad = content.copy()
        bad[place] ^= 0x5A
        killed.write_bytes(bad)
        done = program("export", "out.h5", "--format", "csv-collisions", "-o", "new.txt",
                       "--overwrite", code=None)
        assert done.returncode in (0, 2) and done.stderr.count("\n") == (done.returncode == 2)


@pytest.mark.parametrize("part", [0.001, 0.1, 0.5, 0.999])
@pytest.mark.parametrize("file_format", ["extxyz", "csv-collisions"])
def test_truncated_file_is_one_line(program, finished, part, file_format):
    content = finished.read_bytes()
    finished.write_bytes(content[:int(part * len(content))])
    [line] = export(program, file_format, code=2)
    assert line.startswith("out.h5: ") and left(program) == []


@pytest.mark.parametrize("dataset, index, value, word", [
    ("particles/spheres/position/value", (3, 5, 1), np.nan, "sphere 5"),
    ("particles/spheres/velocity/value", (3, 7, 0), np.inf, "sphere 7"),
    ("particles/spheres/box/edges/value", (3, 0, 0), 0, "edge xx"),
    ("particles/spheres/box/edges/value", (3, 1, 0), np.nan, "edge yx"),
    ("particles/spheres/box/edges/value", (3, 2, 0), 1, "edge zx"),
    ("collisions/k", 700, 699, "collision 699"), ("collisions/i", 700, -1, "collision 701"),
    ("collisions/j", 700, 110, "collision 701"),
    ("particles/spheres/position/step", 9, 1, "collision 1 comes after"),
])
def test_what_no_run_writes_is_named_and_not_shown(program, finished, dataset, index, value, word):
    changed(finished, dataset, index, value)
    for file_format in ("extxyz", "lammps", "vtp"):
        [line] = export(program, file_format, code=2)
        assert line.startswith("out.h5: ") and word in line and left(program) == []


def test_what_is_no_run_is_wrong_input(program):
    assert "is a case file" in program(
        "export", "case.toml", "--format", "extxyz", "-o", "x", code=2).stderr
    assert "does not exist" in program(
        "export", "nowhere", "--format", "extxyz", "-o", "x", code=2).stderr


@pytest.mark.parametrize("log", [{"output.collision_log": "none"},
                                 {"output.collision_log": "window", "output.log_first": 2},
                                 {"output.collision_log": "window", "output.log_last": 1999}])
def test_collisions_of_each_sphere_are_left_out_where_the_log_lacks_some(program, log):
    program.keep({**log, "output.snapshot_interval": 0.05})
    line, note = export(program, "extxyz")
    assert "without the collisions of each sphere" in note
    assert "collisions:I" not in (program.folder / "new.txt").read_text()
    assert len(export(program, "extxyz", "--to", "0", "--overwrite")) == 1  # none are needed


def test_log_without_rows_is_told(program):
    program.keep({"output.collision_log": "none"})
    [line] = export(program, "csv-collisions", code=2)
    assert "output.collision_log" in line and left(program) == []


@pytest.mark.parametrize("target", ["-", "/dev/stdout"])
@pytest.mark.parametrize("file_format", ONE_FILE)
def test_export_to_standard_output_has_the_bytes_of_the_file(program, finished, file_format, target):
    export(program, file_format)
    done = program("export", "out.h5", "--format", file_format, "-o", target)
    assert done.stdout == (program.folder / "new.txt").read_text()
    assert done.stderr.startswith(f"{target}: ") and not (program.folder / "-").exists()
    again = program("export", "out.h5", "--format", file_format, "-o", target, "--quiet")
    assert (again.stdout, again.stderr) == (done.stdout, "")


def test_full_standard_output_is_exit_code_4(program, finished):
    done = program.redirected("/dev/full", "export", "out.h5", "--format", "extxyz", "-o", "-")
    assert done.returncode == 4 and done.stderr.startswith("standard output: could not be written")


def test_collection_of_files_cannot_go_to_standard_output(program, finished):
    [line] = export(program, "vtp", target="-", code=2)
    assert ".pvd" in line


def test_quiet_export_prints_nothing(program, finished):
    assert export(program, "extxyz", "--quiet") == []
