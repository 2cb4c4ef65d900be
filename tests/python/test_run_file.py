"""RunFile gives what the file holds, and says what is wrong with the others."""

import h5py
import numpy as np
import pytest

from zenosphere.errors import InputError
from zenosphere.flags import HIT
from zenosphere.run_file import RunFile


def message(path, ask=lambda run: None):
    with pytest.raises(InputError) as caught:
        with RunFile(path) as run:
            ask(run)
    return str(caught.value)


def test_run_gives_verdict_spheres_threshold_and_case(written):
    with RunFile(written(gap=[1e-3, 0, 1e-4], threshold=1e-14)) as run:
        assert (run.verdict, run.spheres, run.threshold) == ("temporary", 4000, 1e-14)
        assert run.setting("system", "restitution") == 0.6
        assert run.setting("system", "unheard_of") is None
        assert run.separation["first_collision"] == run.separation["last_collision"] == 2
        assert run.attributes["git_hash"] == "0123abc"


def test_columns_are_read_between_two_collision_numbers_inclusive(written):
    with RunFile(written(gap=[5, 4, 3, 0, 1], first=11)) as run:
        k, gap, flags = run.collisions.read("k", "gap", "flags", first=12, last=14)
        np.testing.assert_array_equal(k, [12, 13, 14])
        np.testing.assert_array_equal(gap, [4, 3, 0])
        np.testing.assert_array_equal(flags & HIT, [0, 0, 1])
        assert (run.collisions.first, run.collisions.last, len(run.collisions)) == (11, 15, 5)


def test_window_outside_the_log_reads_nothing(written):
    with RunFile(written(gap=[1, 1])) as run:
        (k,) = run.collisions.read("k", first=100, last=200)
        assert k.size == 0


def test_missing_file_is_named(tmp_path):
    assert "nowhere.h5: does not exist" in message(tmp_path / "nowhere.h5")


def test_text_file_is_not_hdf5(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text("[system]\n")
    assert "case.toml: not an HDF5 file (begins with \"[system]\")" in message(path)


def test_truncated_file_cannot_be_read(written):
    path = written(gap=np.ones(1000))
    path.write_bytes(path.read_bytes()[:2000])
    assert "run.h5: cannot be read" in message(path)


def test_hdf5_of_another_program_is_not_ours(tmp_path):
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["data"] = [1, 2, 3]
    assert "not a Zenosphere file" in message(tmp_path / "other.h5")


def test_newer_format_version_is_refused_with_both_numbers(written):
    path = written(gap=[1])
    with h5py.File(path, "r+") as file:
        file["zenosphere"].attrs["format_version"] = 2
    assert "format version 2 (this program reads 1)" in message(path)


def test_run_that_has_not_ended_points_to_resume(written):
    path = written(gap=[1])
    with h5py.File(path, "r+") as file:
        file["zenosphere"].attrs["complete"] = np.uint8(0)
    text = message(path)
    assert "run has not ended" in text and f"zenosphere resume {path}" in text


def test_broken_summary_is_named_by_its_dataset(written):
    path = written(gap=[1])
    with h5py.File(path, "r+") as file:
        del file["zenosphere/summary"]
        file["zenosphere/summary"] = "{"
    assert "run.h5:/zenosphere/summary: cannot be parsed" in message(path)


def test_missing_case_key_is_named_with_its_table(written):
    path = written(gap=[1])
    with h5py.File(path, "r+") as file:
        del file["zenosphere/resolved"]
        file["zenosphere/resolved"] = "[system]\n"
    assert "/zenosphere/resolved: no system.spheres" in message(path, lambda run: run.spheres)


def test_file_without_collisions_says_there_is_no_log(written):
    text = message(written(gap=[1], log=False), lambda run: run.collisions)
    assert 'no collision log (/collisions lacks k, time' in text and "collision_log" in text


def test_empty_log_is_no_log(written):
    path = written(gap=[1])
    with h5py.File(path, "r+") as file:
        del file["collisions/k"]
        file["collisions/k"] = np.array([], dtype=np.int64)
    assert "/collisions is empty" in message(path, lambda run: run.collisions)


def test_windowed_log_is_incomplete_with_its_range(written):
    path = written(gap=np.ones(10), first=91, complete=False)
    text = message(path, lambda run: run.complete_collisions())
    assert "collision log is incomplete (collisions 91 to 100 of 100)" in text
