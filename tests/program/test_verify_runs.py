"""`zenosphere verify` of runs that were cut off, made longer, or went on in more digits."""

import json
import subprocess

import h5py
import pytest

from test_verify import EVERYTHING, replayed


def told_by_info(program):
    return json.loads(program("info", "out.h5", "--json").stdout.splitlines()[-1])["file"]


def test_killed_run_is_looked_at_up_to_its_last_checkpoint(program):
    program.kill_with_journal(program.start({"output.checkpoint_collisions": 1000,
                                             "output.collision_log": "all"}))
    told = program("verify", "out.h5").stdout
    assert "No contradiction found." in told
    assert "the run is not finished" in told
    logged = told_by_info(program)["logged_collisions"]
    assert f"logged collisions       {logged}\n" in told
    with h5py.File(program.folder / "out.h5") as file:
        assert logged > len(file["collisions/k"])


def test_longer_run_is_not_compared_with_the_summary_of_the_shorter(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING)
    longer = {"run.collisions": 10**12, "output.checkpoint_collisions": 1000}
    program.kill_with_journal(subprocess.Popen(
        program.command("resume", "out.h5", "--quiet", *program.words(longer)),
        cwd=program.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
    assert told_by_info(program)["extended_to"] > 2000
    told = program("verify", "out.h5").stdout
    assert "No contradiction found." in told
    assert "the run is not finished" in told


def test_run_that_went_on_in_more_digits_passes(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", *EVERYTHING)
    program("resume", "out.h5", "--quiet", "--set", "run.collisions=2500", "--set",
            "collision.precision=extended")
    assert replayed(program) == 2500
    assert "the precision is higher than in the case file" in program("verify", "out.h5").stdout


def test_gaps_below_the_range_of_double_stay_hits_that_verify_counts(program, checkout):
    """Rods in a thousand digits: gaps fall by 8 to 1e-1000, the log's numbers end at 5e-324."""
    rods = checkout / "examples" / "bernu-mazighi-1990-three-rods.toml"
    program("run", rods, "--quiet", "-o", "out.h5", "--set", "run.collisions=1200",
            "--set", "collision.precision=digits1000",
            "--set", 'collapse.gap_threshold="1e-900"')
    with h5py.File(program.folder / "out.h5") as run:
        gap, flags = run["collisions/gap"][:], run["collisions/flags"][:]
    tiny = gap == 5e-324
    assert (gap[:1000] > 0).all()
    assert tiny.sum() == pytest.approx(676 / 0.903, rel=0.02)  # decades, of log10(8) each
    assert (flags[tiny] & 1).sum() == pytest.approx(100 / 0.903, rel=0.05)
    assert "No contradiction" in program("verify", "out.h5").stdout


def test_run_promoted_from_digits_to_more_digits_passes(program):
    begin = ["--set", "collision.precision=digits30", "--set", "system.spheres=32"]
    program("run", "case.toml", "--quiet", "-o", "out.h5", *begin, "--set", "run.collisions=100")
    for precision, end in (("quad", 150), ("digits100", 200), ("digits150", 250)):
        program("resume", "out.h5", "--quiet", "--set", f"collision.precision={precision}",
                "--set", f"run.collisions={end}")
    assert replayed(program) == 250
    done = program("resume", "out.h5", "--set", "collision.precision=digits149", code=2)
    assert "fewer digits" in done.stderr


def test_beyond_predictability_nothing_is_claimed(program):
    """Between two snapshots far apart rounding grows to the size of a sphere."""
    program("run", "case.toml", "--quiet", "-o", "out.h5", "--set", "run.collisions=20000",
            "--set", "system.restitution=1", "--set", "drive.kind=none")
    told = program("verify", "out.h5").stdout
    followed = replayed(program)
    assert 108 * 5 < followed < 20000
    assert f"beyond predictability   {20000 - followed}" in told


DRIFTING = """
[system]
dimension = 2
spheres = 2
sides = [10, 10]
restitution = 0.9
[start]
arrangement = "given"
positions = [[3, 5], [6, 5.2]]
velocities = [[1, 0.5], [-1, 0.4]]
[drive]
kind = "shear"
shear_rate = 0.1
[run]
time = 20
[output]
snapshot_interval = 1
"""


def test_spheres_that_drift_across_the_shear_lose_momentum_along_it(program):
    program.case.write_text(DRIFTING)
    program("run", "case.toml", "--quiet", "-o", "out.h5")
    assert "No contradiction found." in program("verify", "out.h5").stdout
