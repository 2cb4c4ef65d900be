"""What a wrong command, case or file costs: one line that says it, and the right exit code."""

import os
import resource
import subprocess

import h5py
import pytest

from sweeps import SWEEP


def blame(program, *words, code=2):
    """The only line of standard error of a command that fails."""
    lines = program.fail(*words, code=code)
    assert len(lines) == 1, lines
    return lines[0]


def rewrite(program, old, new):
    text = program.case.read_text()
    assert old in text
    program.case.write_text(text.replace(old, new))


@pytest.mark.parametrize("old, new, where, words", [
    ("spheres = 108", 'spheres = "many"', "case.toml:3:", ["system.spheres", '"many"', "integer"]),
    ("spheres = 108", "spheres = 109", "case.toml:3:", ["system.spheres", "109", "108"]),
    ("restitution = 0.9", "restitution = 1.2", "case.toml:4:", ["1.2", "[0, 1]"]),
    ("restitution = 0.9", "restitution = -0.1", "case.toml:4:", ["-0.1", "[0, 1]"]),
    ("restitution = 0.9", "restitution = nan", "case.toml:4:", ["system.restitution", "nan"]),
    ("restitution", "restituton", "case.toml:4:", ["unknown", "did you mean restitution?"]),
    ("spheres = 108", "spheres = 108\nbox = 9", "case.toml:4:", ["unknown", "mean system.sides?"]),
    ('"shear"', '"gravity"', "case.toml:13:", ['"gravity"', "[gravity] acceleration"]),
    ("fraction = 0.3", "fraction = 0.75", "case.toml:5:", ["0.75", "0.74048"]),
    ("fraction = 0.3", "fraction = 0", "case.toml:5:", ["solids_volume_fraction", "0"]),
    ("[collapse]", "[colapse]", "case.toml:16:", ["unknown table", "[collapse]?"]),
    ('"shear"', '"sheer"', "case.toml:13:", ["drive.kind", '"sheer"', '"shear"']),
    ("shear_rate = 2.0", "", "case.toml: ", ["missing", "drive.shear_rate"]),
    ("collisions = 2000", "", "case.toml: ", ["run.collisions", "run.time"]),
    ("[start]", "[start", "case.toml:7:", ["not valid TOML"]),
])
def test_wrong_case_is_blamed_at_its_place(program, old, new, where, words):
    rewrite(program, old, new)
    for command in ("run", "check"):
        line = blame(program, command, "case.toml")
        assert line.startswith(where)
        assert all(word in line for word in words), line


def test_all_problems_of_a_case_are_told_in_the_order_of_its_lines(program):
    rewrite(program, "restitution = 0.9", "restitution = 9")
    rewrite(program, "seed = 7", "sede = 7")
    lines = program.fail("run", "case.toml")
    assert [line.split(":")[1] for line in lines] == ["4", "10"]


@pytest.mark.parametrize("override, words", [
    ("system.restitution=1.2", ["1.2", "[0, 1]"]),
    ("system.restituton=0.2", ["unknown", "did you mean system.restitution?"]),
    ("collision.overlap=rewnd", ['"rewnd"', '"rewind"']),
    ("collision.precision=half", ['"half"', '"double"']),
    ("system.spheres=4", ["system.spheres", "box side", "2"]),
    ("run.time=-1", ["run.time", "-1"]),
    ("nonsense", ["KEY=VALUE"]),
])
def test_wrong_override_is_blamed_by_its_words(program, override, words):
    line = blame(program, "run", "case.toml", "--set", override)
    assert line.startswith(f"--set {override}: ")
    assert all(word in line for word in words), line


def test_number_with_underscores_is_not_read_as_zero_wherever_it_stands(program):
    # Ten times 1e-400, in a case, an override, a start and the axis of a sweep.
    wrong = "1_0e-400 (real numbers other than 0 are at least 4.94e-324)"
    assert wrong in blame(program, "check", "case.toml", "--set", "start.positions=[[1, 1_0e-400]]")
    assert wrong in blame(program, "check", "case.toml", "--set", "collapse.gap_threshold=1_0e-400")
    sweep = program.folder / "sweep.toml"
    sweep.write_text(SWEEP.replace("0.2, 0.9", "1_0e-400, 0.9"))
    assert wrong in blame(program, "sweep", "sweep.toml")
    rewrite(program, "restitution = 0.9", "restitution = 1_0e-400")
    assert wrong in blame(program, "check", "case.toml")


def test_wrong_case_leaves_no_output_file(program):
    program.fail("run", "case.toml", "-o", "out.h5", "--set", "system.restitution=2")
    assert not (program.folder / "out.h5").exists()


def test_random_start_that_cannot_be_placed_is_refused(program):
    line = blame(program, "run", "case.toml", "--set", "start.arrangement=random", "--set",
                 "system.solids_volume_fraction=0.7")
    assert "solids_volume_fraction" in line and "0.7" in line


@pytest.mark.parametrize("command", ["run", "check", "info"])
def test_missing_file_and_folder_are_named(program, command):
    (program.folder / "folder").mkdir()
    assert blame(program, command, "nowhere").startswith("nowhere: ")
    assert blame(program, command, "folder").startswith("folder: ")


@pytest.mark.parametrize("content", [b"\x00\xff\xfe\x89HDF\n" * 99, bytes(range(256)) * 40,
                                     b"\x89HDF\r\n\x1a\n" + bytes(3000)])
@pytest.mark.parametrize("command", ["run", "check", "info"])
def test_binary_garbage_is_one_line(program, command, content):
    (program.folder / "garbage").write_bytes(content)
    assert blame(program, command, "garbage").startswith("garbage:")


def test_the_wrong_kind_of_file_is_told_what_it_is_and_which_command_reads_it(program):
    program.keep()
    (program.folder / "study.toml").write_text('[sweep]\ncase = "case.toml"\nseeds = 1\n')
    (program.folder / "study.sqlite").write_bytes(b"SQLite format 3\0" + bytes(4096))
    for words, file, told in [
            (["run"], "out.h5", "zenosphere info"), (["check"], "study.sqlite", "sweep csv"),
            (["run"], "study.toml", "zenosphere sweep runs it"),
            (["sweep"], "case.toml", "zenosphere run runs it"),
            (["sweep"], "out.h5", "zenosphere info"), (["info"], "study.sqlite", "sweep csv"),
            (["info"], "case.toml", "zenosphere run"), (["verify"], "study.toml", "sweep"),
            (["sweep", "csv"], "out.h5", "figures and movie"),
            (["sweep", "csv"], "case.toml", "zenosphere run"),
            (["info"], "study.sqlite", "report and ensemble")]:
        line = blame(program, *words, file)
        assert line.startswith(f"{file}: is a") and told in line, line


@pytest.mark.parametrize("override, words", [
    ("start.granular_temperature=1e306", ["1e-150", "1e+150"]),
    ("drive.shear_rate=1e13", ["rounded to", "use at most"]),
    ("system.solids_volume_fraction=1e-30", ["1000000000", "use at least"]),
    ("system.restitution=1e-400", ["at least 4.94e-324"]),
    ("system.restitution=.3", ["write 0.3"]),
])
def test_what_the_number_type_cannot_do_is_refused_with_the_limit(program, override, words):
    for command in ("check", "run"):
        line = blame(program, command, "case.toml", "--set", override)
        assert all(word in line for word in words), line


def test_empty_file_is_neither_a_case_nor_an_output(program):
    (program.folder / "empty").touch()
    lines = program.fail("run", "empty")
    assert all(line.startswith("empty: missing key ") for line in lines)
    assert blame(program, "info", "empty").startswith("empty: ")


def test_info_refuses_what_no_run_wrote(program):
    with h5py.File(program.folder / "other.h5", "w") as file:
        file["data"] = [1, 2, 3]
    assert blame(program, "info", "other.h5").startswith("other.h5: ")
    assert blame(program, "info", "case.toml").startswith("case.toml: ")


@pytest.mark.parametrize("part", [0.001, 0.1, 0.5, 0.999])
def test_info_on_a_truncated_file_says_that_it_is_damaged(program, part):
    _, path = program.keep()
    content = path.read_bytes()
    (program.folder / "part.h5").write_bytes(content[:int(part * len(content))])
    line = blame(program, "info", "part.h5")
    assert line.startswith("part.h5: ") and "damaged" in line


def test_info_on_a_damaged_file_works_or_is_one_line(program):
    _, path = program.keep()
    content = path.read_bytes()
    ends = [*range(0, 1 << 13, 512), *range(len(content) - (1 << 14), len(content), 512)]
    for start in ends:
        bad = content[:start] + b"\xa5" * 512 + content[start + 512:]
        (program.folder / "bad.h5").write_bytes(bad)
        done = program("info", "bad.h5", code=None)
        assert done.returncode in (0, 2), f"{start}: {done.returncode} {done.stderr}"
        assert done.stderr.count("\n") == (done.returncode == 2)


@pytest.mark.parametrize("target", ["nowhere/out.h5", "case.toml/out.h5", "/proc/x.h5",
                                    "/dev/null/x.h5", "folder"])
def test_output_that_cannot_be_created_is_exit_code_4(program, target):
    (program.folder / "folder").mkdir()
    assert blame(program, "run", "case.toml", "--quiet", "-o", target, code=4).startswith(target)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_folder_without_permission_is_exit_code_4(program):
    (program.folder / "closed").mkdir(mode=0o500)
    line = blame(program, "run", "case.toml", "--quiet", "-o", "closed/out.h5", code=4)
    assert "ermission" in line


def test_existing_output_is_not_overwritten_unless_asked(program):
    path = program.folder / "out.h5"
    path.write_bytes(b"years of work")
    line = blame(program, "run", "case.toml", "--quiet", "-o", "out.h5", code=4)
    assert "--overwrite" in line and path.read_bytes() == b"years of work"
    program("run", "case.toml", "--quiet", "-o", "out.h5", "--overwrite")
    with h5py.File(path) as file:
        assert file["zenosphere"].attrs["complete"] == 1


def test_overwrite_with_a_wrong_case_keeps_the_old_output(program):
    path = program.folder / "out.h5"
    path.write_bytes(b"years of work")
    program.fail("run", "case.toml", "-o", "out.h5", "--overwrite", "--set", "system.spheres=0")
    assert path.read_bytes() == b"years of work"
    assert sorted(os.listdir(program.folder)) == ["case.toml", "out.h5"]


def test_output_never_replaces_the_case_itself(program):
    before = program.case.read_bytes()
    blame(program, "run", "case.toml", "--quiet", "-o", "case.toml", "--overwrite", code=4)
    assert program.case.read_bytes() == before


def test_empty_output_name_is_refused(program):
    assert program("run", "case.toml", "--quiet", "-o", "", code=2).stdout == ""


def limited_to(size):
    """What a child process does before it starts: no file of it grows beyond `size` bytes."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def fill_disk(program, size, changes=()):
    long_run = {"run.collisions": 300000, "output.snapshot_interval": 0.1, **dict(changes)}
    done = program("run", "case.toml", "--quiet", "-o", "out.h5", *program.words(long_run),
                   code=4, preexec_fn=limited_to(size))
    assert done.stdout == "" and len(done.stderr.splitlines()) == 1
    assert done.stderr.startswith("out.h5: ")
    return program.folder / "out.h5"


@pytest.mark.parametrize("size", [2**18, 2**20, 3 * 2**20])
def test_full_disk_is_exit_code_4_and_leaves_a_readable_file(program, size):
    path = fill_disk(program, size)
    with h5py.File(path) as file:
        assert file["zenosphere"].attrs["complete"] == 0
        assert file["collisions"].attrs["complete"] == 0
        assert "summary" not in file["zenosphere"]
        rows = {len(file["collisions"][name]) for name in file["collisions"]}
        assert len(rows) == 1
    program("info", "out.h5")


def test_disk_full_from_the_start_leaves_nothing(program):
    assert not fill_disk(program, 1000).exists()


@pytest.mark.parametrize("command", [["run", "case.toml", "--json"], ["run", "case.toml"],
                                     ["check", "case.toml"], ["info", "out.h5"]])
def test_full_standard_output_is_exit_code_4(program, command):
    program.keep()
    done = program.redirected("/dev/full", *command)
    assert done.returncode == 4 and "standard output" in done.stderr


def test_error_without_a_listener_still_has_its_exit_code(program):
    script = 'exec "$0" check missing.toml 2>&-'
    done = subprocess.run(["sh", "-c", script, *program.command()], cwd=program.folder)
    assert done.returncode == 2
