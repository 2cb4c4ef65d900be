"""What the first groups of hits of a sweep's runs were: counts, table and map."""

import csv
import sqlite3

import matplotlib.image
import numpy as np
import pytest
from synthetic_store import write_store

from zenosphere.__main__ import main
from zenosphere.drawing.pictures import Pictures
from zenosphere.ensembles.findings import KINDS, finding_rows
from zenosphere.ensembles.maps import FINDINGS, finding_maps, short_fraction
from zenosphere.ensembles.slices import chosen_parts, slices
from zenosphere.ensembles.store import Ensemble

AXES = {"system.restitution": (0.1, 0.3), "system.solids_volume_fraction": (0.2, 0.4)}
OUTCOMES = (  # first hit, arrest, finding, verdict: one run each
    (5, 50, "proven", "true"), (5, 50, "singular", "true", 0.4),
    (5, None, "singular", "temporary", 0.5), (5, None, "singular", "open", -0.03), (5, None, "near-collapse", "temporary"),
    (5, 50, "arithmetic arrest", "true"), (5, None, "exact contact", "temporary"),
    (5, None, "chance close pair", "temporary"), (5, None, "undecided", "temporary"),
    (5, None, None, "temporary"), (None, None, None, "none"))


def by_replica(keys, replica):
    """Each outcome once at e = 0.1; no hit at e = 0.3."""
    return OUTCOMES[replica] if keys["system.restitution"] == 0.1 else OUTCOMES[-1]


@pytest.fixture
def store(tmp_path):
    return write_store(tmp_path / "s.sqlite", AXES, by_replica, seeds=len(OUTCOMES),
                       adjudicated=True)


def drawn(store):
    """The map of findings of a store with one set of figures."""
    part, = slices(Ensemble(store), chosen_parts(Ensemble(store)))
    with Pictures().style():
        return finding_maps(part, "heading", Pictures())


def test_each_run_with_hits_has_one_kind(store):
    counts = Ensemble(store).counts()
    here = {name: int(counts.findings[name][0, 0]) for name in KINDS}
    assert here == {"real, arrested": 2, "real, open": 1, "real, went on": 1, "near-collapse": 1,
                    "arithmetic arrest": 1, "chance or exact": 2, "undecided": 1,
                    "not adjudicated": 1}
    assert sum(here.values()) == counts.findings["hit"][0, 0] == counts.met["separation"][0, 0]
    assert not any(counts.findings[name][1].any() for name in KINDS)


def test_table_has_the_share_that_is_real_with_its_interval(store):
    ensemble = Ensemble(store)
    rows = list(finding_rows(ensemble, ensemble.counts()))
    expected = {"done": 11, "hit": 10, "adjudicated": 9, "proven": 1, "singular": 3,
                "chance_close_pair": 1, "undecided": 1, "real_went_on": 1,
                "real_curvature_dies_out": 2, "real_curvature_grows": 1}
    assert rows[0] | expected == rows[0]
    assert rows[0]["real_of_adjudicated"] == pytest.approx(4 / 9)
    half = 1.959964 / (2 * np.sqrt(8 + 1.959964**2))  # Wilson for 4 of the 8 that are decided
    assert [rows[0][f"real_of_decided{end}"] for end in ("_low", "", "_high")] == pytest.approx(
        [0.5 - half, 0.5, 0.5 + half], rel=1e-6)
    assert rows[2]["hit"] == 0 and np.isnan(rows[2]["real_of_decided"])


def test_map_shows_every_kind_that_occurs_within_1400_pixels(store, tmp_path):
    drawn(store).savefig(tmp_path / "findings.png", dpi=200)
    image = matplotlib.image.imread(tmp_path / "findings.png")
    assert image.shape[1] == 1400
    seen = {tuple((255 * pixel).round().astype(int)) for pixel in
            image[:, :, :3].reshape(-1, 3)[::7]}
    for colour, _ in list(FINDINGS.values())[:-1]:
        assert tuple(int(colour[place:place + 2], 16) for place in (1, 3, 5)) in seen


def test_legend_of_an_incomplete_map_says_what_hatching_means(tmp_path, store):
    def last_waits(keys, replica):
        return "pending" if replica == 0 else by_replica(keys, replica)
    incomplete = write_store(tmp_path / "i.sqlite", AXES, last_waits, seeds=len(OUTCOMES),
                             adjudicated=True)
    texts = [[text.get_text() for text in drawn(each).subfigs[1].legends[0].get_texts()]
             for each in (store, incomplete)]
    assert not any("hatched" in text for text in texts[0])
    assert texts[1][-1] == "hatched: only some of the runs of this point are done"


def test_table_of_a_store_without_margins_says_nothing_of_the_curvature(store):
    with sqlite3.connect(store) as database:
        database.execute("ALTER TABLE run DROP COLUMN adjudication_margin_per_decade")
    ensemble = Ensemble(store)
    rows = list(finding_rows(ensemble, ensemble.counts()))
    assert rows[0]["singular"] == 3 and "real_curvature_grows" not in rows[0]


def test_store_of_a_sweep_that_did_not_adjudicate_has_no_findings(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, lambda *_: (5, 50))
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert not [path for path in (tmp_path / "out").iterdir() if "findings" in path.name]


def test_columns_of_findings_are_left_alone_where_the_sweep_did_not_adjudicate(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, lambda *_: (5, 50, None), adjudicated=True)
    with sqlite3.connect(store) as opened:  # as `zenosphere sweep` writes it without [adjudicate]
        opened.execute("ALTER TABLE sweep ADD COLUMN adjudicate_seconds REAL")
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert not [path for path in (tmp_path / "out").iterdir() if "findings" in path.name]


def test_store_without_a_hit_has_a_table_and_no_map_of_findings(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, lambda *_: OUTCOMES[-1], adjudicated=True)
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert [path.name for path in (tmp_path / "out").iterdir() if "findings" in path.name] == [
        "findings.csv"]


def test_table_and_map_are_written(store, tmp_path):
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    with open(tmp_path / "out" / "findings.csv", newline="") as file:
        assert [row["hit"] for row in csv.DictReader(file)] == ["10", "10", "0", "0"]
    assert (tmp_path / "out" / "findings.png").is_file()


@pytest.mark.parametrize("keys, panels", [(1, 1), (2, 1), (3, 4)])
def test_map_of_findings_has_a_panel_for_each_third_key(tmp_path, keys, panels):
    axes = dict(list((AXES | {"system.spheres": (100, 200, 300, 400)}).items())[:keys])
    figure = drawn(write_store(tmp_path / "s.sqlite", axes, by_replica, seeds=len(OUTCOMES),
                               adjudicated=True))
    assert sum(axes.axison for axes in figure.subfigs[0].axes) == panels


@pytest.mark.parametrize("value, text", [(0, "0"), (1, "1"), (0.5, "0.5"), (1 / 3, "0.33"),
                                         (0.003, ">0"), (0.997, "<1")])
def test_fraction_in_a_cell_is_0_or_1_only_where_it_is_exactly(value, text):
    assert short_fraction(value) == text
