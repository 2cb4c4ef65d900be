"""bench/performance: its grid, its file of trials, its tables and its figure."""

import subprocess
import sys
from pathlib import Path

import pytest
from processes import MOST_SECONDS

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(BENCH))

import grid  # noqa: E402
import page  # noqa: E402
import trials  # noqa: E402
from programs import BenchError, Program, State  # noqa: E402


@pytest.fixture
def table(tmp_path):
    return grid.Table(tmp_path / "performance.csv", tmp_path)


def trial(state, rate, program="Zenosphere", number=1):
    return trials.Trial(state, number, program, rate)


def test_quick_form_draws_and_prints_without_touching_the_page(tmp_path):
    loop = tmp_path / "bench_collisions"
    loop.write_text("#!/bin/sh\necho '{\"collisions\": 3000000, \"user_seconds\": 2}'\n")
    loop.chmod(0o755)
    done = subprocess.run([BENCH / "performance", "--quick", "--build", tmp_path],
                          timeout=MOST_SECONDS, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "| 4000 | 1.50 | 1.50 |" in done.stdout
    assert (tmp_path / "performance.png").stat().st_size > 10_000
    assert len((tmp_path / "performance.csv").read_text().splitlines()) == 1 + 8


def test_dense_states_and_disks_start_at_random_and_the_others_from_a_lattice():
    starts = {state.fraction: state.start for state in grid.states() if state.dimension == 3}
    assert set(starts) == set(grid.FRACTIONS)
    assert {fraction for fraction, start in starts.items() if start == "random"} == {0.5}
    assert {state.start for state in grid.states() if state.dimension == 2} == {"random"}


def test_each_state_is_measured_once():
    states = grid.states()
    assert len(set(states)) == len(states)


def test_lead_is_that_over_the_fastest_peer_of_each_round(table):
    state = grid.state_of("elastic", 4000, 0.1)
    for number, ours, fast, slow in [(1, 6e5, 4e5, 1e5), (2, 3e5, 1e5, 2e5), (3, 9e5, 1e5, 9e5)]:
        table.add(trial(state, ours, number=number))
        table.add(trial(state, fast, "fast", number))
        table.add(trial(state, slow, "slow", number))
    assert table.lead(state) == 1.5
    assert table.lead(grid.state_of("sheared", 4000, 0.1)) is None


def test_every_lattice_of_the_grid_can_be_made():
    sides = [round((spheres / 4) ** (1 / 3)) for spheres in grid.SPHERES]
    assert [4 * side**3 for side in sides] == grid.SPHERES


def test_trials_survive_in_the_file(table, tmp_path):
    dense = grid.state_of("sheared", 4000, 0.5)
    table.add(trial(dense, 2e5, number=1))
    table.add(trial(dense, 4e5, number=2))
    again = grid.Table(tmp_path / "performance.csv", tmp_path)
    assert again.keys() == {(dense, 1, "Zenosphere"), (dense, 2, "Zenosphere")}
    assert again.rate("Zenosphere", dense) == 3e5
    assert again.rate("EDMD", dense) is None


def test_trials_that_have_a_row_are_not_made_again(monkeypatch):
    monkeypatch.setattr(Program, "collisions_per_second", lambda *_: 1e6)
    ours, peer = Program("ours", "bench", "a"), Program("peer", "edmd", "b")
    state = State(4000, 0.3)
    done = {(state, 1, "ours"), (state, 1, "peer"), (state, 2, "ours")}
    made = list(trials.alternate([ours, peer], [state], 2, trials.Length(), None, done))
    assert [(trial.round, trial.program) for trial in made] == [(2, "peer")]


def test_tables_stand_between_the_marks_of_the_page(table, tmp_path):
    table.add(trial(grid.state_of("elastic", 4000, 0.3), 1.25e6))
    text = tmp_path / "page.md"
    text.write_text(f"above\n{page.BEGIN}\nold\n{page.END}\nbelow\n")
    for _ in range(2):
        page.replace_tables(text, page.tables(table))
    lines = text.read_text().splitlines()
    assert (lines[0], lines[-1]) == ("above", "below")
    assert "old" not in lines
    assert lines.count("| N, at phi = 0.3 | Zenosphere, elastic |") == 1
    assert "| 4000 | 1.25 |" in lines


def test_page_without_marks_is_refused(tmp_path):
    text = tmp_path / "page.md"
    text.write_text("nothing")
    with pytest.raises(BenchError, match="has no marks"):
        page.replace_tables(text, "tables")


def test_length_covers_a_unit_of_strain_and_ends():
    length = trials.Length()
    assert length.collisions(4000) == (20_000, 400_000)
    assert length.collisions(1_000_188) == (5_000_940, 5_501_034)
    assert length.collisions(10_061_824) == (20_000_000, 6_000_000)
