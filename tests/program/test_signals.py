"""A run that is interrupted: what it prints, and what is left on the disk."""

import fcntl
import json
import os
import pty
import signal
import struct
import subprocess
import termios

import h5py
import numpy as np
import pytest
from processes import MOST_SECONDS, let_work, shown_until

LOGGED = {"output.collision_log": "all", "output.snapshot_interval": 1}


def ended(process, *signals):
    """Standard output and error of a process that these signals end."""
    for each in signals:
        process.send_signal(each)
    try:
        return process.communicate(timeout=MOST_SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_interrupted_run_prints_its_summary_and_exits_with_130(program, sent):
    process = program.start((), "--json")
    output, errors = ended(process, sent)
    summary = json.loads(output)
    assert process.returncode == 130 and errors == ""
    assert (summary["outcome"], summary["ended_by"]) == ("interrupted", "signal")
    assert summary["collisions"] > 0 and summary["verdict"] == "none"


def test_interrupted_run_tells_people_so(program):
    process = program.start()
    output, _ = ended(process, signal.SIGINT)
    assert process.returncode == 130
    assert output.startswith("Interrupted at collision ")
    headline, verdict = output.splitlines()[:2]
    assert headline.endswith("; zenosphere resume out.h5 goes on with it.")
    assert verdict.startswith("Up to there: No collapse: ")
    assert program("info", "out.h5").stdout.splitlines()[:2] == [headline, verdict]


def test_interrupted_run_without_output_says_that_nothing_is_left(program):
    process = subprocess.Popen(program.command("run", "case.toml", "--set", "run.collisions=1e12"),
                               cwd=program.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    assert "not kept" in process.stderr.readline()
    let_work(process)
    output, _ = ended(process, signal.SIGINT)
    assert output.splitlines()[0].endswith(", and not kept (no -o).")


def test_interrupted_run_leaves_a_complete_file(program):
    output, _ = ended(program.start(LOGGED, "--json"), signal.SIGTERM)
    summary = json.loads(output)
    with h5py.File(program.folder / "out.h5") as file:
        assert file["zenosphere"].attrs["complete"] == 1
        assert file["collisions"].attrs["complete"] == 1
        assert json.loads(file["zenosphere/summary"][()]) == summary
        assert np.array_equal(file["collisions/k"], np.arange(1, summary["collisions"] + 1))
        position = file["particles/spheres/position"]
        assert position["step"][-1] == summary["collisions"]
        assert position["time"][-1] == summary["time"]


def test_info_reads_the_file_of_an_interrupted_run(program):
    output, _ = ended(program.start((), "--json"), signal.SIGINT)
    told = json.loads(program("info", "out.h5", "--json").stdout.splitlines()[-1])
    assert {key: told[key] for key in json.loads(output)} == json.loads(output)
    assert "interrupted" in program("info", "out.h5").stdout


def test_interrupted_run_is_the_beginning_of_the_whole_run(program):
    done = json.loads(ended(program.start(LOGGED, "--json"), signal.SIGINT)[0])
    count = min(done["collisions"], 20000)
    program.keep({"run.collisions": count}, "whole.h5")
    with h5py.File(program.folder / "out.h5") as part, \
            h5py.File(program.folder / "whole.h5") as whole:
        for name in ("i", "j", "time"):
            same = part["collisions"][name][:count] == whole["collisions"][name][:count]
            assert np.all(same), name


def test_interrupted_run_without_output_file_prints_its_summary(program):
    words = program.words({"run.collisions": 10**12})
    process = subprocess.Popen(program.command("run", "case.toml", "--json", *words),
                               cwd=program.folder, stdout=subprocess.PIPE, text=True,
                               stderr=subprocess.PIPE)
    process.stderr.readline()  # the remark that nothing is kept: the case is read
    let_work(process)
    assert json.loads(ended(process, signal.SIGINT)[0])["outcome"] == "interrupted"
    assert process.returncode == 130


@pytest.mark.parametrize("second", [signal.SIGINT, signal.SIGTERM])
def test_second_signal_does_not_hang(program, second):
    process = program.start(LOGGED)
    ended(process, signal.SIGINT, second)
    assert process.returncode in (130, -second)
    with h5py.File(program.folder / "out.h5") as file:
        assert file["zenosphere"].attrs["complete"] in (0, 1)


def test_killed_run_leaves_a_file_that_can_be_read(program):
    ended(program.start(LOGGED), signal.SIGKILL)
    with h5py.File(program.folder / "out.h5") as file:
        assert file["zenosphere"].attrs["complete"] == 0
        assert "summary" not in file["zenosphere"]
    assert program("info", "out.h5").stdout


def test_running_output_can_be_read(program):
    process = program.start(LOGGED)
    try:
        with h5py.File(program.folder / "out.h5") as file:
            assert file["zenosphere"].attrs["complete"] == 0
        assert program("info", "out.h5").stdout
        assert process.poll() is None
    finally:
        ended(process, signal.SIGINT)


def ignore_hangup():
    signal.signal(signal.SIGHUP, signal.SIG_IGN)


def test_run_under_nohup_survives_the_end_of_the_terminal(program):
    process = program.start(preexec_fn=ignore_hangup)
    process.send_signal(signal.SIGHUP)
    let_work(process)
    assert process.poll() is None
    ended(process, signal.SIGINT)
    assert process.returncode == 130


def read_all(descriptor):
    """What is in a pseudo-terminal until its other end is closed."""
    parts = []
    try:
        while part := os.read(descriptor, 65536):
            parts.append(part)
    except OSError:  # Linux: the last writer has closed
        pass
    return b"".join(parts).decode()


def has_lines(shown):
    """Whether a progress line has been written over another one."""
    return len([line for line in shown.split("\r") if line.strip()]) >= 2


def test_terminal_shows_one_progress_line(program):
    ours, theirs = pty.openpty()
    process = program.start({"run.time": 1e6}, "--json", stderr=theirs)
    os.close(theirs)
    shown = shown_until(ours, has_lines)
    output, _ = ended(process, signal.SIGINT)
    shown += read_all(ours)
    os.close(ours)
    assert json.loads(output)["outcome"] == "interrupted"
    assert "\n" not in shown  # each line is written over the one before
    lines = [line for line in shown.split("\r") if line.strip()]
    assert len(lines) >= 2
    assert all(word in lines[0] for word in ("collisions", "time", "/s", "hits"))
    assert "left" in lines[-1]


def test_progress_line_fits_a_narrow_terminal(program):
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 40, 0, 0))
    process = program.start({"run.time": 1e6}, "--json", stderr=theirs)
    os.close(theirs)
    shown = shown_until(ours, has_lines)
    ended(process, signal.SIGINT)
    shown = (shown + read_all(ours)).split("\r")
    os.close(ours)
    assert all(len(line) < 40 for line in shown)
    lines = [line.rstrip() for line in shown if line.strip()]
    assert len(lines) >= 2 and all(line.lstrip()[0].isdigit() for line in lines)
    assert "left" in lines[-1] and not lines[-1].endswith("lef")


def test_quiet_run_shows_nothing_on_a_terminal(program):
    ours, theirs = pty.openpty()
    process = program.start((), "--quiet", stderr=theirs)
    os.close(theirs)
    let_work(process, 0.3)  # one that is not quiet begins with a line
    output, _ = ended(process, signal.SIGINT)
    assert (output, read_all(ours)) == ("", "")
    os.close(ours)
