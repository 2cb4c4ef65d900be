"""bench/compare and its adapters, with peers that are some lines of shell."""

import bz2
import csv
import subprocess
import sys
from pathlib import Path

import pytest
from processes import MOST_SECONDS, wait_for

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(BENCH))

import programs  # noqa: E402
from programs import BenchError, Output, Program, State  # noqa: E402

ELASTIC = State(4000, 0.3)
SHEARED = State(4000, 0.3, 0.9, 1.0)


def output(text="", user=1.0, system=0.0, folder=Path()):
    return Output(text, user, system, folder)


def write_program(path, text):
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)
    return path


@pytest.fixture
def build(tmp_path):
    """A build folder whose bench_collisions says one million collisions in two seconds."""
    folder = tmp_path / "build"
    folder.mkdir()
    write_program(folder / "bench_collisions",
                  'echo \'{"collisions": 1000000, "user_seconds": 2.0}\'\n')
    return folder


def compare(build, *words):
    return subprocess.run([BENCH / "compare", "--build", build, *words], capture_output=True,
                          text=True, timeout=MOST_SECONDS)


def fake_peer(tmp_path):
    """A peer of 0.5, 0.4 and 0.1 million collisions per second in its first, second, third run."""
    calls = tmp_path / "calls"
    return write_program(tmp_path / "peer", f"""\
echo call >> {calls}
case $(wc -l < {calls}) in 1) seconds=2;; 2) seconds=2.5;; *) seconds=10;; esac
echo "{{\\"collisions\\": 1000000, \\"user_seconds\\": $seconds}}"
""")


def test_table_has_median_and_spread_of_the_ratios_of_each_round(build, tmp_path):
    done = compare(build, "--rounds", "3", "--state", "4000,0.3", "--peer",
                   f"fake=bench:{fake_peer(tmp_path)}")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[2] == "| elastic, phi 0.3, N 4000 | Zenosphere | 0.500 (0.500-0.500) |  |"
    assert lines[3] == ("| elastic, phi 0.3, N 4000 | fake | 0.400 (0.100-0.500) "
                        "| 1.25 (1.00-5.00) |")


def test_programs_take_turns(build, tmp_path):
    done = compare(build, "--rounds", "2", "--state", "4000,0.3", "--peer",
                   f"fake=bench:{fake_peer(tmp_path)}")
    turns = [line.split(": ")[2].rsplit(" ", 2)[0] for line in done.stderr.splitlines()]
    assert turns == ["Zenosphere", "fake", "Zenosphere", "fake"]


def test_every_trial_is_a_row(build, tmp_path):
    table = tmp_path / "results.csv"
    for _ in range(2):
        done = compare(build, "--rounds", "1", "--state", "4000,0.3", "--append", table,
                       "--note", "a, note", "--peer", f"fake=bench:{fake_peer(tmp_path)}")
        assert done.returncode == 0, done.stderr
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["peer"], row["ratio"], row["note"]) for row in rows] == [
        ("", "", "a, note"), ("fake", "1.000", "a, note"),
        ("", "", "a, note"), ("fake", "1.250", "a, note")]
    assert rows[0]["zenosphere_mcps"] == "0.5000"
    assert rows[0]["state"] == "elastic, phi 0.3, N 4000"


def test_shear_is_set_against_no_shear_in_the_same_rounds(build):
    done = compare(build, "--rounds", "1", "--state", "4000,0.3", "--state", "4000,0.3,0.9,1")
    assert done.stdout.splitlines()[-1] == (
        "| sheared, e 0.9, phi 0.3, N 4000 | elastic, phi 0.3, N 4000 | 1.00 (1.00-1.00) |")


@pytest.mark.parametrize("words, message", [
    (["--peer", "fake=gromacs:md"], "program 'fake=gromacs:md' (must be NAME=ADAPTER:COMMAND)"),
    (["--state", "4000"], "state '4000' (must be N,phi"),
    (["--peer", "fake=edmd:md {sphere}"], "fake: unknown placeholder 'sphere'"),
    (["--peer", "fake=edmd:false"], "false: exit code 1"),
    (["--peer", "fake=edmd:true"], "no 'Collisions: ' in the output of EDMD"),
    (["--peer", "fake=dynamo:true"], "fake: its output is not what the adapter dynamo expects"),
    (["--peer", "fake=bench:echo {{}}"], "fake: its output is not what the adapter bench expects"),
    (["--peer", "fake=edmd:no-such-program"], "no-such-program: could not be started"),
])
def test_a_wrong_word_is_named(build, words, message):
    done = compare(build, "--rounds", "1", *(words if "--state" in words
                                             else ["--state", "4000,0.3", *words]))
    assert done.returncode == 1
    assert message in done.stderr
    assert "Traceback" not in done.stderr


def test_edmd_is_understood():
    text = ("Simtime: 1.000000, Collisions: 17855, Press: 2.142265, T: 1.000000\n"
            "Simtime: 2.000000, Collisions: 37001, Press: 2.142265, T: 1.000000\n")
    assert programs.read_edmd(output(text)).collisions == 37001
    assert programs.read_edmd(output(text + "Total collisions: 40000\n")).collisions == 40000


def test_dynamo_is_understood(tmp_path):
    text = ('<?xml version="1.0"?><OutputData><Misc><Duration Events="170" OneParticleEvents="5" '
            'TwoParticleEvents="100" VirtualEvents="65" Time="5.07"/></Misc></OutputData>')
    (tmp_path / "output.xml.bz2").write_bytes(bz2.compress(text.encode()))
    assert programs.read_dynamo(output(folder=tmp_path)).collisions == 100


def test_a_run_of_zenosphere_pays_for_its_writing():
    reading = programs.read_zenosphere(output('{"collisions": 7}\n', user=2.0, system=0.5))
    assert (reading.collisions, reading.user_seconds) == (7, 2.5)


def test_start_up_and_warm_up_drop_out(monkeypatch):
    # 3 s of start-up, then 1000 collisions a second: 500 of warm-up, 2000 measured.
    def run(folder, words):
        collisions = int(words[1])
        return output(f"Collisions: {collisions}", user=3 + collisions / 1000)
    monkeypatch.setattr(programs, "run_in", run)
    peer = Program("peer", "edmd", "md {collisions}")
    assert peer.collisions_per_second(ELASTIC, 500, 2000, {}) == pytest.approx(1000)


def test_a_run_too_short_to_measure_is_refused(monkeypatch):
    monkeypatch.setattr(programs, "run_in", lambda *_: output("Collisions: 5", user=0.1))
    with pytest.raises(BenchError, match="took no longer .* raise --collisions"):
        Program("peer", "edmd", "md").collisions_per_second(ELASTIC, 500, 2000, {})


def test_states_that_a_peer_cannot_run_are_left_out():
    edmd = Program.parse("EDMD=edmd:md {spheres}")
    assert edmd.can_run(ELASTIC) and not edmd.can_run(SHEARED)
    dynamo = Program.parse("DynamO<=1e5=dynamo:run {spheres}")
    assert dynamo.can_run(SHEARED) and not dynamo.can_run(State(100_001, 0.3))
    assert not edmd.can_run(State(4000, 0.5, start="random"))
    assert Program.parse("EDMD=edmd:md {start_file}").can_run(State(4000, 0.5, start="random"))


def test_length_of_a_run_in_time_follows_the_collision_rate():
    # 10.07 collisions per sphere and time at phi = 0.3 (Enskog, Carnahan-Starling)
    assert ELASTIC.expected_time(2000 * 10.07) == pytest.approx(1, rel=1e-3)


def is_running(process_id):
    status = Path("/proc") / process_id / "stat"
    try:
        return status.read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def test_copies_run_at_once_and_end_with_the_one_that_is_measured(build, tmp_path):
    started = tmp_path / "started"
    started.mkdir()
    peer = write_program(tmp_path / "peer", f"""\
touch {started}/$$
while [ $(ls {started} | wc -l) -lt 3 ]; do sleep 0.01; done
echo '{{"collisions": 1000000, "user_seconds": 2.0}}'
""")
    done = compare(build, "--copies", "3", "--rounds", "1", "--state", "4000,0.3", "--peer",
                   f"fake=bench:{peer}")
    assert done.returncode == 0, done.stderr
    assert "| fake | 0.500 (0.500-0.500) |" in done.stdout
    wait_for(lambda: not any(is_running(path.name) for path in started.iterdir()))
