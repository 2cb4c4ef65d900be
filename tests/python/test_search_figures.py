"""Figures and table of an adaptive search."""

import csv

import pytest
from synthetic_store import write_search

from zenosphere.__main__ import main
from zenosphere.ensembles.search_figures import crossing_of
from zenosphere.ensembles.store import Ensemble

FINDINGS = {0.1: ("crossing", 0.22, 0.2, 0.24), 0.2: ("below", None, None, None),
            0.3: ("unresolved", 0.3, 0.21, None)}


def test_runs_of_a_point_come_in_their_order_with_what_they_met(tmp_path):
    store = Ensemble(write_search(tmp_path / "s.sqlite", FINDINGS))
    x, met = store.searched(1, "system.restitution", "separation")
    assert x.tolist() == [0.1, 0.2, 0.3, 0.4] * 2
    assert met.tolist() == [True, True, False, False] * 2


def test_search_is_drawn_in_place_of_the_grid(tmp_path):
    store = write_search(tmp_path / "s.sqlite", FINDINGS)
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "boundaries.csv", "search.png", "boundary.png"}
    with open(tmp_path / "out" / "boundaries.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["finding"], row["place"]) for row in rows] == [
        ("crossing", "0.22"), ("below", ""), ("unresolved", "0.3")]


@pytest.mark.parametrize("finding, how", [("crossing", "fit"), ("below", "below"),
                                          ("above", "above"), ("unresolved", "unclear")])
def test_findings_are_told_as_those_of_a_grid(finding, how):
    row = {"finding": finding, "place": 0.2, "low": None, "high": 0.3}
    assert (crossing_of(row).how, crossing_of(row).place) == (how, 0.2)
