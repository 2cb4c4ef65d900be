"""What a user types, and what lies there afterwards."""

import os
import subprocess
import sys
from pathlib import Path

import h5py
import matplotlib.image
import numpy as np
import pytest

from zenosphere.__main__ import main

PAPER = ("figure-1", "figure-2", "figure-3a", "figure-3b", "figure-4", "figure-5", "figure-6")
BEGINNING = {"png": b"\x89PNG", "pdf": b"%PDF"}
MEGABYTE = 1 << 20


def assert_figures(folder, names):
    expected = {f"{name}.{suffix}" for name in names for suffix in BEGINNING}
    assert {path.name for path in folder.iterdir()} == expected
    for path in folder.iterdir():
        content = path.read_bytes()
        assert content.startswith(BEGINNING[path.suffix[1:]]), path
        assert 5000 < len(content) < MEGABYTE, path


def test_both_runs_give_the_papers_seven_figures(e06, e02, tmp_path, capsys):
    folder = tmp_path / "figures"
    assert main(["figures", "--false-positive", str(e06), "--true-collapse", str(e02),
                 "-o", str(folder)]) == 0
    assert_figures(folder, PAPER)
    assert str(folder / "figure-3b.pdf") in capsys.readouterr().out


def test_no_two_of_the_papers_figures_are_the_same_picture(e02, tmp_path):
    folder = tmp_path / "figures"
    main(["figures", "--true-collapse", str(e02), "-o", str(folder), "--format", "png"])
    pictures = [path.read_bytes() for path in folder.iterdir()]
    assert len(set(pictures)) == len(pictures) == 3


def test_figures_have_the_formats_and_the_size_asked_for(e02, tmp_path):
    folder = tmp_path / "figures"
    assert main(["figures", "--true-collapse", str(e02), "-o", str(folder), "--format", "svg,png",
                 "--size", "8.6x6"]) == 0
    assert {path.suffix for path in folder.iterdir()} == {".svg", ".png"}
    height, width, _ = matplotlib.image.imread(folder / "figure-4.png").shape
    assert (width, height) == (int(8.6 / 2.54 * 300), int(6 / 2.54 * 300))
    assert "<svg" in (folder / "figure-4.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("option, value, reason", [
    ("--format", "jpg", "'jpg' is none of png, pdf, svg"), ("--format", "", "'' is none of"),
    ("--size", "8.6", "must be WIDTHxHEIGHT in centimetres"), ("--size", "4x6", "from 5 to 100"),
    ("--size", "8.6x101", "from 5 to 100")])
def test_wrong_format_or_size_is_exit_code_2_with_what_there_is(capsys, option, value, reason):
    with pytest.raises(SystemExit) as stopped:
        main(["figures", "--run", "run.h5", option, value])
    assert stopped.value.code == 2
    assert reason in capsys.readouterr().err


@pytest.mark.parametrize("words, line", [
    ("figures --formt png", "figures: unknown option --formt; did you mean --format? See {} figures"
     " --help"),
    ("movie", "movie: OUT.h5 missing; see {} movie --help"),
    ("movie run.h5 run.mp4", "movie: run.mp4 is one word too many; see {} movie --help"),
    ("movie run.h5 --fps 0", "movie: --fps: '0' (must be a whole number above 0); see {} movie --help"),
    ("cooling run.h5 -o", "cooling: -o/--output: expected one argument; see {} cooling --help"),
])
def test_wrong_words_are_told_in_one_line_as_by_the_program(capsys, monkeypatch, words, line):
    monkeypatch.setenv("ZENOSPHERE_COMMAND", "zenosphere")
    with pytest.raises(SystemExit) as stopped:
        main(words.split())
    assert stopped.value.code == 2
    assert capsys.readouterr().err == "zenosphere " + line.format("zenosphere") + "\n"


def test_same_figure_is_the_same_file(e02, tmp_path):
    for folder in ("one", "two"):
        main(["figures", "--true-collapse", str(e02), "-o", str(tmp_path / folder), "--format",
              "svg,pdf"])
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "two" / path.name).read_bytes()


def test_drawing_says_nothing_on_the_error_stream(e02, tmp_path, capsys, recwarn):
    main(["figures", "--true-collapse", str(e02), "-o", str(tmp_path / "figures")])
    assert capsys.readouterr().err == ""
    assert not [str(w.message) for w in recwarn if "Glyph" in str(w.message)]


# The file has the keys of docs/summary.md, each null.
NOTHING_AVERAGED = dict.fromkeys(("granular_temperature", "collision_rate", "from_time", "to_time"))


@pytest.mark.parametrize("content", [
    {"gap": np.full(300, 1e-3)},
    {"gap": np.full(300, np.nan)},
    {"gap": [1e-3]},
    {"gap": [0.0]},
    {"gap": np.linspace(0, 1e-3, 300), "arrest": 1},
    {"gap": np.zeros(300), "arrest": 200},
    {"gap": np.zeros(300), "time": np.full(300, 2.0)},
    {"gap": np.full(300, 1e-3), "averages": NOTHING_AVERAGED},
    {"gap": np.full(300, 1e-3), "threshold": 0},
], ids=["no hit", "gaps unknown", "one collision", "one hit", "arrest at once", "hits only",
        "clock stands", "no averages", "threshold zero"])
def test_figures_are_drawn_for_a_run_that_lacks_what_they_show(written, tmp_path, content):
    path, folder = str(written(**content)), tmp_path / "figures"
    assert main(["figures", "--false-positive", path, "--true-collapse", path, "--run", path,
                 "-o", str(folder)]) == 0
    assert_figures(folder, PAPER + ("run-separation", "run-time", "run-pairs"))


def test_general_set_takes_a_part_of_a_log(written, tmp_path):
    path = written(gap=np.full(50, 1e-3), first=1000, complete=False)
    assert main(["figures", "--run", str(path), "-o", str(tmp_path / "figures")]) == 0
    assert_figures(tmp_path / "figures", ("run-separation", "run-time", "run-pairs"))


def test_paper_figures_refuse_a_part_of_a_log_with_exit_code_2(written, tmp_path, capsys):
    path = written(gap=np.full(50, 1e-3), first=1000, complete=False)
    assert main(["figures", "--false-positive", str(path), "-o", str(tmp_path / "figures")]) == 2
    assert "collision log is incomplete" in capsys.readouterr().err
    assert not (tmp_path / "figures").exists()


def test_figures_of_nothing_names_the_options(capsys):
    assert main(["figures"]) == 2
    assert "--false-positive" in capsys.readouterr().err


def test_folder_that_cannot_be_made_is_exit_code_4(e02, tmp_path, capsys):
    (tmp_path / "taken").write_text("")
    assert main(["figures", "--true-collapse", str(e02), "-o", str(tmp_path / "taken")]) == 4
    assert "taken: folder cannot be made" in capsys.readouterr().err


def test_report_holds_a_column_per_run_and_links_the_figures(e06, e02, tmp_path):
    main(["figures", "--true-collapse", str(e02), "-o", str(tmp_path / "out" / "figures")])
    report = tmp_path / "out" / "report.md"
    assert main(["report-md", str(e06), str(e02), "-o", str(report)]) == 0
    text = report.read_text(encoding="utf-8")
    assert "| | `e06.h5` | `e02.h5` |" in text
    assert "| **verdict** | **temporary** | **true** |" in text
    assert "17\N{EN DASH}2305" in text and "0123abc" in text and "5.063" in text
    assert "](figures/figure-6.png)" in text
    assert "figure-1" not in text  # was not drawn


def test_report_gives_first_hit_as_collision_per_sphere_and_time(written, tmp_path):
    # Collision 3 of 4: 2 x 3 / 4000 = 0.0015 collisions per sphere.
    path = written(gap=[1, 1, 0, 1], time=[0.1, 0.2, 0.25, 0.3])
    main(["report-md", str(path), "-o", str(tmp_path / "report.md")])
    text = (tmp_path / "report.md").read_text(encoding="utf-8")
    assert "| first hit | 3 (0.0015 per sphere), time 0.25 |" in text
    assert "| last hit | 3 (0.0015 per sphere), time 0.25 |" in text


def test_report_needs_no_collision_log(written, tmp_path):
    path = written(gap=[1, 0], log=False)
    assert main(["report-md", str(path), "-o", str(tmp_path / "report.md")]) == 0


def test_module_runs_without_installation_and_exits_with_2_on_wrong_input(tmp_path):
    python = Path(__file__).resolve().parents[2] / "python"
    done = subprocess.run([sys.executable, "-m", "zenosphere", "report-md", "nowhere.h5"],
                          cwd=tmp_path, env=os.environ | {"PYTHONPATH": str(python)},
                          capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.startswith("nowhere.h5: does not exist; name an output file")


def test_flag_bits_mark_the_hits_also_where_the_gap_is_larger(written, tmp_path):
    """A raised threshold makes hits above the floor; they are drawn, and counted, as hits."""
    path = written(gap=np.geomspace(1e-13, 1e-3, 100), threshold=1e-12)
    with h5py.File(path) as file:
        assert file["collisions/flags"][:].sum() == 10
    assert main(["figures", "--run", str(path), "-o", str(tmp_path / "figures")]) == 0
