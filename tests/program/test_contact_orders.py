"""Orders of contacts in which few rods and disks collapse, from the log of the examples' cases."""

import json
import pathlib

import h5py
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
FOUR_RODS = EXAMPLES / "dolmaire-huebner-rosenau-2024-four-rods.toml"
THREE_DISKS = EXAMPLES / "dolmaire-velazquez-2024-three-spheres.toml"


def logged_until_digits_are_spent(program, case):
    """(i, j) of the contacts before the first hit, lists of int."""
    done = program("run", str(case), "-o", "out.h5", "--json", "--quiet")
    spent = json.loads(done.stdout.splitlines()[-1])["separation"]["first_collision"]
    with h5py.File(program.folder / "out.h5") as file:
        return tuple(file[f"collisions/{name}"][:spent].tolist() for name in "ij")


def adjudicated(program, *words):
    done = program("adjudicate", *map(str, words), "--quiet", "--json")
    return json.loads(done.stdout.splitlines()[-1])


def test_four_rods_leave_the_unstable_word_after_the_rounds_that_17_digits_allow(program):
    # x2 / x3 = 0.0106147 / 0.000354542 = 29.94 a round: an error of 1e-16 to 1e-14 lasts 10 rounds.
    gaps, _ = logged_until_digits_are_spent(program, FOUR_RODS)
    word = [0, 1, 0, 1, 2, 1]
    assert gaps[:60] == word * 10 and gaps[60:66] != word
    assert gaps[-120:] == gaps[-132:-12] != gaps[-126:-6]  # a period of 12, not of 6


def test_four_rods_are_proven_to_collapse_in_the_stable_word(program):
    result = adjudicated(program, FOUR_RODS)
    assert result["finding"] == "proven" and result["approaches"][0]["word"] == "abababcbcbcb"


@pytest.mark.parametrize("restitution, word", [("0.06", "ab"), ("0.0775", "ab" * 6 + "cb" * 6),
                                               ("0.15", "ababcbcb")])
def test_word_of_four_rods_changes_with_the_restitution(program, restitution, word):
    result = adjudicated(program, FOUR_RODS, "--set", f"system.restitution={restitution}",
                         "--set", "collision.precision=double")
    assert result["finding"] == "proven" and result["approaches"][0]["word"] == word


def test_three_disks_in_a_bent_row_take_turns_as_long_as_digits_last(program):
    first, second = logged_until_digits_are_spent(program, THREE_DISKS)
    pairs = list(zip(first, second))
    assert len(pairs) > 90 and set(pairs[::2]) | set(pairs[1::2]) == {(0, 1), (0, 2)}
    assert pairs[2:] == pairs[:-2]


def test_three_disks_in_a_row_bent_too_far_fly_apart(program):
    # Bent by 35 degrees at its collapse at e = 0.03; at 0.05 the most is 16.
    done = program("run", str(THREE_DISKS), "--set", "system.restitution=0.05", "--json")
    summary = json.loads(done.stdout)
    assert summary["separation"]["hits"] == 0 and summary["collisions"] < 20
