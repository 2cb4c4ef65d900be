"""`zenosphere report`: what is in the page, and what it refuses. The page at work: page/test."""

import base64
import json
import os
import re
import resource
import signal
import sqlite3
from collections import Counter

import h5py
import numpy as np
import pytest

from conftest import Program
from sweeps import SWEEP

pytestmark = pytest.mark.skipif(os.environ.get("ZENOSPHERE_HAS_PAGE") == "OFF",
                                reason="built without npm, and so without the page")
BLOCK = re.compile(r'<script type="(?:application/json|text/plain)" id="([\w.]+)"'
                   r'(?: data-type="(\w+)")?>([^<]*)</script>')


def blocks(page):
    """{name: JSON or array} of what the program put into a page."""
    return {name: np.frombuffer(base64.b64decode(text), kind) if kind else json.loads(text)
            for name, kind, text in BLOCK.findall(page.read_text()) if name != "licences"}


def small_files():
    """Lets no file grow over 300 kB, as if the disk were full."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, 300_000))


@pytest.fixture(scope="module")
def page(collapsed, tmp_path_factory):
    """The file of a true collapse, and what is in its page."""
    _, output = collapsed
    made = tmp_path_factory.mktemp("page") / "page.html"
    Program(made.parent)("report", str(output), "-o", str(made))
    return output, blocks(made)


@pytest.fixture(scope="module")
def long_log(tmp_path_factory):
    """The columns of a log of more rows than a page shows one by one, and what is in its page."""
    program = Program(tmp_path_factory.mktemp("long"))
    _, output = program.keep({"run.collisions": 70000})
    program("report", "out.h5", "-o", "page.html")
    with h5py.File(output) as run:
        log = {name: values[()] for name, values in run["collisions"].items()}
    return log, blocks(program.folder / "page.html")


def test_page_says_what_info_says(page, program):
    output, found = page
    summary = json.loads(program("info", str(output), "--json").stdout)
    assert summary["file"].pop("checksums") == "bytes unchanged"
    found["run"]["summary"]["file"].pop("checksums")  # a page does not look at them
    assert found["run"]["summary"] == summary
    assert found["run"]["values"]["restitution"] == 0.2
    assert found["run"]["values"]["restitution_law"] == "constant"


def test_page_has_the_radii_of_spheres_that_differ(mixture):
    mixture.keep({"run.collisions": 10})
    mixture("report", "out.h5", "-o", "page.html")
    grains = blocks(mixture.folder / "page.html")["run"]["grains"]
    assert grains["radii"] == [0.5] * 60 + [0.7] * 30
    assert grains["kinds"] == [0] * 60 + [1] * 30 and grains["names"] == ["small", "large"]


def test_page_has_the_series_of_the_run(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", "--set", "run.collisions=20000")
    program("report", "out.h5", "-o", "page.html")
    series = blocks(program.folder / "page.html")["run"]["series"]
    with h5py.File(program.folder / "out.h5") as file:
        group = file["zenosphere/series"]
        assert series["time"] == list(group["time"]) and len(series["time"]) > 16
        assert set(series["columns"]) == set(group) - {"step", "time"}
        for name, numbers in series["columns"].items():
            recorded = np.ravel(group[name]["value"])
            assert np.array(numbers, dtype=float) == pytest.approx(recorded, rel=1e-6, nan_ok=True)


def test_page_of_a_run_that_was_too_short_for_a_series_has_none(page):
    _, found = page
    assert found["run"]["series"] == {"time": [], "columns": {}}


def test_page_names_the_law_of_a_run_without_a_constant_restitution(program):
    program("run", "case.toml", "--quiet", "-o", "out.h5", "--set", "run.collisions=100", "--set",
            "collision.restitution_law=fixed-loss", "--set", "collision.energy_loss=0.1")
    program("report", "out.h5", "-o", "page.html")
    values = blocks(program.folder / "page.html")["run"]["values"]
    assert (values["restitution"], values["restitution_law"]) == (None, "fixed loss")


def test_every_row_of_a_short_log_is_in_the_page_bit_for_bit(page):
    output, found = page
    with h5py.File(output) as run:
        for column, dataset in (("k", "k"), ("time", "time"), ("gap_low", "gap"), ("flags", "flags"),
                                ("speed_low", "normal_speed"), ("i", "i"), ("j", "j")):
            assert np.array_equal(found[f"log0.{column}"], run["collisions"][dataset][()],
                                  equal_nan=column == "gap_low"), column


def test_snapshots_are_in_the_page_as_they_are_in_the_file(page):
    output, found = page
    with h5py.File(output) as run:
        spheres = run["particles/spheres"]
        position = spheres["position/value"][()]
        assert np.array_equal(found["frames.positions"], position.ravel().astype(np.float32))
        edges = spheres["box/edges/value"][()]
        assert np.array_equal(found["run"]["snapshots"]["box_edges"], edges.ravel())
        flow = position[..., 1] - edges[:, None, 1, 1] / 2  # shear rate 1
        velocity = spheres["velocity/value"][()]
        velocity[..., 0] -= flow
        temperature = (velocity**2).mean(axis=(1, 2))
    # Two orders of one sum of 324 squares.
    assert found["run"]["snapshots"]["granular_temperature"] == pytest.approx(temperature, rel=1e-13)
    counted = found["frames.collisions"].reshape(len(position), -1).sum(axis=1)
    assert list(counted) == [2 * step for step in found["run"]["snapshots"]["step"]]


def test_extremes_of_a_long_log_survive_the_binning(long_log):
    log, found = long_log
    assert found["run"]["log"][0] == {"name": "log0", "width": 3, "bins": 23334, "last": 70000}
    assert found["log0.speed_low"].min() == log["normal_speed"].min()
    assert found["log0.speed_high"].max() == log["normal_speed"].max()
    assert np.nanmin(found["log0.gap_low"]) == np.nanmin(log["gap"])
    assert found["log0.hits"].sum() == (log["flags"] & 1).sum()


def test_pairs_of_a_long_log_are_in_the_page_with_the_bins_they_collide_in(long_log):
    log, found = long_log
    pairs = list(zip(log["i"].tolist(), log["j"].tolist()))
    # Fewer pairs than counters, so that every count is exact; of equal counts the smaller numbers.
    counts = sorted(Counter(pairs).items(), key=lambda entry: (-entry[1], entry[0]))
    assert len(counts) < 65536
    assert found["run"]["pairs"] == [[*pair, count] for pair, count in counts[:10]]
    row = {pair: n for n, (pair, _) in enumerate(counts[:10])}
    rows = np.array([row.get(pair, 10) for pair in pairs])
    bits = (1 << rows) | np.where(log["flags"] & 1, 1 << (rows + 11), 0)
    assert list(found["log0.pairs"]) == list(np.bitwise_or.reduceat(bits, range(0, 70000, 3)))


def test_short_log_has_no_list_of_pairs(page):
    _, found = page
    assert found["run"]["pairs"] == [] and "log0.pairs" not in found


def test_page_of_an_unfinished_run_shows_its_last_checkpoint(program):
    program.kill_with_journal(program.start({"output.checkpoint_collisions": 1000,
                                             "output.collision_log": "all"}))
    program("report", "out.h5", "-o", "page.html")
    run = blocks(program.folder / "page.html")["run"]
    assert run["summary"]["file"]["complete"] is False
    with h5py.File(program.folder / "out.h5") as file:
        in_the_file = file["collisions/k"][-1] if len(file["collisions/k"]) else 0
    assert run["log"][0]["last"] == run["summary"]["file"]["logged_collisions"] > in_the_file


def test_report_says_what_it_wrote(program):
    program.keep()
    [line] = program("report", "out.h5", "-o", "page.html").stdout.splitlines()
    megabytes = (program.folder / "page.html").stat().st_size / 1e6
    assert line == f"page.html: report page of the run out.h5, {megabytes:.1f} MB; open it in a browser"
    done = program("report", "out.h5", "-o", "page.html", "--overwrite", "--quiet")
    assert done.stdout == done.stderr == ""


def test_nothing_from_the_file_can_end_its_script(program):
    program.case.write_text("# </script><!-- <script> \N{LINE SEPARATOR}\n" + program.case.read_text())
    program.keep()
    program("report", "out.h5", "-o", "page.html")
    found = blocks(program.folder / "page.html")
    assert found["run"]["case_text"].startswith("# </script><!-- <script> ")
    text = (program.folder / "page.html").read_text()
    assert text.count("</script><!--") == 0


def test_page_of_a_sweep_holds_its_rows_and_the_case_of_every_point(program):
    (program.folder / "s.toml").write_text(SWEEP)
    program("sweep", "s.toml", "--quiet")
    before = (program.folder / "s.sqlite").read_bytes()
    program("report", "s.sqlite", "-o", "page.html")
    assert (program.folder / "s.sqlite").read_bytes() == before
    sweep = blocks(program.folder / "page.html")["sweep"]
    with sqlite3.connect(program.folder / "s.sqlite") as store:
        for column in ("run", "point", "status", "verdict", "separation_hits", "arrest_met", "time"):
            stored = [value for value, in store.execute(f"SELECT {column} FROM run ORDER BY run")]
            assert sweep["runs"][column] == stored
        seeds = [str(seed) for seed, in store.execute("SELECT seed FROM run ORDER BY run")]
    store.close()
    assert sweep["runs"]["seed"] == seeds
    assert sweep["places"] == {"0": [0.2, "rewind"], "1": [0.2, "guarded"], "2": [0.9, "rewind"],
                               "3": [0.9, "guarded"]}
    changed = sweep["cases"]["points"]["3"]
    lines = [changed.get(str(n), line) for n, line in enumerate(sweep["cases"]["first"])]
    assert program("sweep", "show", "s.sqlite", "--run", "3").stdout.endswith("\n".join(lines))


FINDINGS = ("adjudication_first_finding", "adjudication_finding", "adjudication_sentence")


def test_page_of_a_sweep_has_the_findings_of_a_store_that_has_them(program):
    (program.folder / "s.toml").write_text(SWEEP)
    program("sweep", "s.toml", "--quiet")
    with sqlite3.connect(program.folder / "s.sqlite") as store:
        there = {name for _, name, *_ in store.execute("PRAGMA table_info(run)")}
        for name in FINDINGS:
            if name not in there:
                store.execute(f"ALTER TABLE run ADD COLUMN {name} TEXT")
        store.execute("UPDATE run SET adjudication_first_finding = 'near-collapse',"
                      " adjudication_finding = 'singular' WHERE run = 1")
    store.close()
    program("report", "s.sqlite", "-o", "page.html")
    runs = blocks(program.folder / "page.html")["sweep"]["runs"]
    assert runs["adjudication_first_finding"][:2] == [None, "near-collapse"]
    assert runs["adjudication_finding"][1] == "singular"
    assert len(runs["adjudication_sentence"]) == len(runs["run"])


def test_point_of_a_search_has_the_runs_of_one_value_and_their_case(program):
    (program.folder / "s.toml").write_text("""[sweep]
case = "case.toml"
[axes]
"system.solids_volume_fraction" = [0.2, 0.3]
[boundary]
axis = "system.restitution"
criterion = "separation"
from = 0.1
to = 0.9
resolution = 0.2
[stop]
collisions_per_sphere = 20
""")
    program("sweep", "s.toml", "--quiet")
    program("report", "s.sqlite", "-o", "s.html")
    found = blocks(program.folder / "s.html")["sweep"]
    runs, places = found["runs"], found["places"]
    with sqlite3.connect(program.folder / "s.sqlite") as store:
        stored = store.execute('SELECT "system.solids_volume_fraction", "system.restitution" '
                               "FROM run ORDER BY run").fetchall()
    store.close()
    assert [tuple(places[str(point)]) for point in runs["point"]] == stored
    assert set(found["axes"][1]["values"]) == {restitution for _, restitution in stored}
    assert len(places) > 2 and set(found["cases"]["points"]) == set(places)
