"""Folders that cannot be written, checkpoints from another user, and the scripts of docs/reliability.md."""

import ctypes
import os
import random
import shutil
import signal
import subprocess

import h5py
import pytest
from conftest import forged
from processes import MOST_SECONDS

PR_CAPBSET_DROP, CAP_DAC_OVERRIDE = 24, 1


def without_privilege():
    """In a child before it starts: permissions count for root too."""
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


@pytest.fixture
def read_only(program):
    """The folder of an unfinished run, with its journal, that may not be written to."""
    process = program.start({"output.checkpoint_collisions": 1000})
    process.kill()
    process.communicate()
    program.folder.chmod(0o500)
    for path in program.folder.iterdir():
        path.chmod(0o400)
    yield program
    program.folder.chmod(0o700)
    for path in program.folder.iterdir():
        path.chmod(0o600)


def test_info_needs_no_permission_to_write(read_only):
    assert read_only("info", "out.h5", preexec_fn=without_privilege).stdout.startswith("Unfinished")


def test_resume_in_a_read_only_folder_is_exit_code_4_and_changes_nothing(read_only):
    before = {path.name: path.read_bytes() for path in read_only.folder.iterdir()}
    done = read_only("resume", "out.h5", code=4, preexec_fn=without_privilege)
    assert done.stderr.startswith("out.h5: cannot be resumed (") and "ermission denied" in done.stderr
    assert {path.name: path.read_bytes() for path in read_only.folder.iterdir()} == before


def test_run_in_a_read_only_folder_is_exit_code_4(read_only):
    done = read_only("run", "case.toml", "--quiet", "-o", "new.h5", code=4,
                     preexec_fn=without_privilege)
    assert done.stderr == "new.h5: could not be created (Permission denied); choose another place\n"


def test_folder_that_vanishes_ends_the_run_at_once(program):
    process = program.start()
    process.send_signal(signal.SIGSTOP)  # or it might take a file away first
    shutil.rmtree(program.folder)
    process.send_signal(signal.SIGCONT)
    _, errors = process.communicate(timeout=MOST_SECONDS)
    assert process.returncode == 4 and "no longer there" in errors
    program.folder.mkdir()


def crc32c(data):
    value = 0xFFFFFFFF
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ (0x82F63B78 if value & 1 else 0)
    return value ^ 0xFFFFFFFF


def test_checkpoint_of_unknown_origin_does_no_harm(program):
    program.keep({"system.spheres": 4, "system.solids_volume_fraction": 0.1, "run.collisions": 5})
    with h5py.File(program.folder / "out.h5") as file:
        state = file["zenosphere/checkpoint/state"][()].tobytes()
    dice = random.Random(3)
    codes = []
    for _ in range(60):
        changed = bytearray(state)
        for _ in range(dice.randint(1, 3)):
            changed[dice.randrange(len(changed))] = dice.choice([0, 1, 0x7F, 0x80, 0xFF])
        with forged(program.folder / "out.h5") as file:
            file["zenosphere/checkpoint/state"][()] = list(changed)
            file["zenosphere/checkpoint"].attrs["checksum"] = crc32c(changed)
        (program.folder / "copy.h5").write_bytes((program.folder / "out.h5").read_bytes())
        done = program("resume", "copy.h5", "--quiet", "--set", "run.collisions=60", "--set",
                       "run.time=1e6", code=None)
        # What still can be told from a possible state later, the run's own checks tell.
        caught = done.returncode == 1 and "this cannot be right" in done.stderr
        assert done.returncode in (0, 2) or caught, done.stderr
        assert done.returncode == 0 or done.stderr.startswith("copy.h5: ")
        codes.append(done.returncode)
    assert codes.count(2) > 3  # a cell, a partner, a length: where nonsense can be told


@pytest.mark.parametrize("script, system", [("kill-and-resume", "sheared"), ("lose-power", "quad")])
def test_script_finds_resumed_runs_bit_identical(program, checkout, script, system):
    done = subprocess.run(
        [checkout / "scripts" / "reliability" / script, "2", "--system", system], text=True,
        capture_output=True, timeout=MOST_SECONDS,
        env={**os.environ, "ZENOSPHERE": str(program.command()[0])})
    assert done.stdout.startswith("2 of 2 ") and done.returncode == 0, done.stdout + done.stderr
