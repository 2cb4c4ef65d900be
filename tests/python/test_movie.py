"""Movies of the snapshots: where spheres are seen, what their colours mean, and what is written."""

import json
import subprocess

import h5py
import matplotlib
import numpy as np
import pytest
from matplotlib import animation

from zenosphere.__main__ import main
from zenosphere.movies.cell import Cell, View
from zenosphere.movies.movie import LastCollisions, Speeds
from zenosphere.run_file import RunFile

SPHERES = 6


def write_sheared(path, dimension=2, collisions=((1, 0, 1), (2, 2, 3), (5, 0, 4)), complete=True):
    """Three snapshots, after 0, 2 and 5 collisions, in a cell whose offset grows; and its path."""
    random = np.random.default_rng(seed=1)
    edges = np.tile(8.0 * np.eye(dimension), (3, 1, 1))
    if dimension > 1:
        edges[:, 1, 0] = (0.0, 1.5, 3.0)
    shear = 'kind = "shear"\nshear_rate = 2.0' if dimension > 1 else 'kind = "none"'
    with h5py.File(path, "w") as file:
        spheres = file.create_group("particles/spheres")
        places = random.random((3, SPHERES, dimension)) * 8
        spheres["position/value"] = places
        velocities = np.ones((3, SPHERES, dimension)) * 0.3
        if dimension > 1:
            velocities[:, :, 0] = 0.3 + 2.0 * (places[:, :, 1] - 4)
        spheres["velocity/value"] = velocities
        spheres["position/time"] = [0.0, 0.5, 1.0]
        spheres["position/step"] = np.array([0, 2, 5])
        spheres["box/edges/value"] = edges
        log = file.create_group("collisions")
        log.attrs["complete"] = int(complete)
        rows = np.array(collisions)
        log["k"], log["i"], log["j"] = rows.T
        for name in ("time", "gap", "normal_speed", "flags"):
            log[name] = np.zeros(len(rows))
        group = file.create_group("zenosphere")
        group.attrs.update({"format_version": 1, "complete": 1})
        group["summary"] = json.dumps({"verdict": "none"})
        group["resolved"] = (f"[system]\ndimension = {dimension}\nspheres = {SPHERES}\n"
                             f"restitution = 0.9\n[drive]\n{shear}\n")
    return path


def test_spheres_are_drawn_inside_the_slanted_cell():
    cell = Cell([[10, 0, 0], [4, 10, 0], [0, 0, 10]])
    assert cell.slanted([[1, 5, 3], [3, 5, 3]]).tolist() == [[11, 5, 3], [3, 5, 3]]
    assert Cell(cell.edges, "x").slanted([[1, 5, 3]]).tolist() == [[1, 5, 3]]


def test_cell_has_twelve_sides_of_which_those_of_the_farthest_corner_are_behind():
    cell, view = Cell(np.diag([4.0, 4, 4])), View(3)
    lines, is_front = view.outline(cell)
    assert lines.shape == (12, 2, 2) and is_front.sum() == 9
    behind = view.seen(np.array([[0.0, 0, 0]]))[0, :2]  # seen from +x, +y, +z
    assert all((np.abs(line - behind) < 1e-12).all(axis=1).any() for line in lines[~is_front])


def test_length_is_kept_by_the_view():
    places = View(3).seen(np.eye(3))
    assert np.linalg.norm(places, axis=1) == pytest.approx(1)
    assert np.linalg.norm(places[0] - places[1]) == pytest.approx(np.sqrt(2))


def test_long_line_is_folded_into_rows():
    view = View(1, length=400.0)
    assert view.rows == 10
    assert view.seen(np.array([[41.0]])).tolist() == [[1, -3, 0]]


def test_peculiar_speed_is_without_the_mean_flow(tmp_path):
    with RunFile(write_sheared(tmp_path / "run.h5")) as run:
        values = [Speeds(run).values(0, *snapshot) for snapshot in run.snapshots()]
    assert np.concatenate(values) == pytest.approx(0.3 * np.sqrt(2))


def test_last_collisions_are_counted_back_from_the_snapshot(tmp_path):
    with RunFile(write_sheared(tmp_path / "run.h5")) as run:
        colouring = LastCollisions(run)
        none, two, five = (colouring.values(step, *snapshot)
                           for step, snapshot in zip(run.snapshot_steps, run.snapshots()))
    assert np.isnan(none).all()
    assert two.tolist()[:4] == [2, 2, 1, 1] and np.isnan(two[4:]).all()
    assert five.tolist()[:5] == [1, 5, 4, 4, 1] and np.isnan(five[5])


@pytest.mark.parametrize("dimension", [1, 2, 3])
@pytest.mark.parametrize("colour", ["speed", "last"])
def test_folder_gets_a_picture_of_each_snapshot(tmp_path, capsys, dimension, colour):
    run = write_sheared(tmp_path / "run.h5", dimension)
    folder = tmp_path / "frames"
    assert main(["movie", str(run), "-o", str(folder), "--colour", colour]) == 0
    pictures = sorted(folder.iterdir())
    assert [path.name for path in pictures] == [f"frame-000{n}.png" for n in (1, 2, 3)]
    assert len({path.read_bytes() for path in pictures}) == 3
    said = capsys.readouterr()
    assert said.out == f"{folder}\n" and said.err == ""


def test_every_second_snapshot_is_drawn(tmp_path):
    run = write_sheared(tmp_path / "run.h5")
    assert main(["movie", str(run), "-o", str(tmp_path / "frames"), "--every", "2"]) == 0
    assert len(list((tmp_path / "frames").iterdir())) == 2


@pytest.mark.skipif(not animation.writers.is_available("ffmpeg"), reason="no ffmpeg here")
@pytest.mark.parametrize("options, rate", [(["--fps", "5"], "5/1"), ([], "1/1")])
def test_movie_has_a_frame_for_each_snapshot_and_lasts(tmp_path, options, rate):
    run = write_sheared(tmp_path / "run.h5")
    assert main(["movie", str(run), "-o", str(tmp_path / "run.mp4"), *options]) == 0
    shown = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                            "stream=nb_read_frames,r_frame_rate", "-of", "csv=p=0",
                            str(tmp_path / "run.mp4")], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == f"{rate},3"


def test_without_ffmpeg_pictures_are_written_and_the_command_for_them_is_said(tmp_path, capsys):
    run = write_sheared(tmp_path / "run.h5")
    with matplotlib.rc_context({"animation.ffmpeg_path": str(tmp_path / "nothing")}):
        assert main(["movie", str(run), "-o", str(tmp_path / "run.mp4")]) == 0
    assert len(list((tmp_path / "run-frames").glob("frame-*.png"))) == 3
    assert not (tmp_path / "run.mp4").exists()
    said = capsys.readouterr()
    assert said.out == f"{tmp_path / 'run-frames'}\n"
    assert "apt install ffmpeg" in said.err
    assert f"-i {tmp_path}/run-frames/frame-%04d.png" in said.err


def failing(tmp_path, capsys, *words, code=2, **about):
    run = write_sheared(tmp_path / "run.h5", **about)
    assert main(["movie", str(run), *words]) == code
    return capsys.readouterr().err


def test_colours_of_last_collisions_need_the_whole_log(tmp_path, capsys):
    text = failing(tmp_path, capsys, "-o", str(tmp_path / "f"), "--colour", "last", complete=False)
    assert "collision log is incomplete" in text and "--colour speed" in text


def test_other_kinds_of_movies_are_refused(tmp_path, capsys):
    assert "a movie is .mp4 (not .avi)" in failing(tmp_path, capsys, "-o", "run.avi")


def test_frames_are_not_mixed_with_older_ones(tmp_path, capsys):
    (tmp_path / "frames").mkdir()
    (tmp_path / "frames" / "frame-0009.png").write_text("mine")
    text = failing(tmp_path, capsys, "-o", str(tmp_path / "frames"), code=4)
    assert "is not empty" in text


def test_movie_into_a_folder_that_is_not_there_is_an_error_of_the_output(tmp_path, capsys):
    text = failing(tmp_path, capsys, "-o", str(tmp_path / "missing" / "run.mp4"), code=4)
    assert "there is no folder" in text
