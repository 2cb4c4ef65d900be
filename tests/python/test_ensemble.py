"""Counts, tables and figures of a sweep's store."""

import csv
import sqlite3

import numpy as np
import pytest
from synthetic_store import write_store

from zenosphere.__main__ import main
from zenosphere.drawing.pictures import Pictures
from zenosphere.ensembles.figures import _heading, _probabilities
from zenosphere.ensembles.slices import chosen_parts, slices
from zenosphere.ensembles.store import Ensemble
from zenosphere.errors import InputError

AXES = {"system.restitution": (0.1, 0.3, 0.5), "system.spheres": (100, 200)}


def graded(keys, replica):
    """e = 0.1 arrests after 50, hits after 5; 0.3 hits in every second run after 200; 0.5 never."""
    e = keys["system.restitution"]
    return (5, 50) if e < 0.2 else (200 if e < 0.4 and replica % 2 else None, None)


def patchy(keys, replica):
    """The same with the last point waiting and a failure in the first."""
    if keys == {"system.restitution": 0.5, "system.spheres": 200}:
        return "pending"
    return "failed" if replica == 0 and keys["system.restitution"] == 0.1 else graded(keys, replica)


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def test_counts_are_those_of_the_runs(tmp_path):
    counts = Ensemble(write_store(tmp_path / "s.sqlite", AXES, graded)).counts()
    assert counts.done.tolist() == [[10, 10]] * 3
    assert counts.met["separation"].tolist() == [[10, 10], [5, 5], [0, 0]]
    assert counts.met["arrest"].tolist() == [[10, 10], [0, 0], [0, 0]]
    assert counts.met["false positive"].tolist() == [[0, 0], [5, 5], [0, 0]]
    assert counts.met["open"].tolist() == [[0, 0], [5, 5], [0, 0]]


def test_figures_say_by_which_overlap_rule_hits_were_left(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, graded)
    part = next(slices(Ensemble(store), chosen_parts(Ensemble(store))))
    assert _heading(part).endswith("; overlap rule rewind")  # that of a case that names none
    with sqlite3.connect(store) as opened:
        opened.execute("UPDATE sweep SET base_case = '[collision]\noverlap = \"guarded\"'")
    opened.close()
    part = next(slices(Ensemble(store), chosen_parts(Ensemble(store))))
    assert _heading(part).endswith("; overlap rule guarded")


def test_a_shorter_run_has_met_less(tmp_path):
    ensemble = Ensemble(write_store(tmp_path / "s.sqlite", AXES, graded))
    counts = ensemble.counts(limit=20)  # after the hit at 5, before the arrest at 50
    assert counts.met["separation"][:, 0].tolist() == [10, 0, 0]
    assert counts.met["arrest"][:, 0].tolist() == [0, 0, 0]
    assert counts.met["false positive"][:, 0].tolist() == [10, 0, 0]
    assert ensemble.counts(limit=50).met["arrest"][0, 0] == 10


def test_what_is_not_done_is_counted_apart(tmp_path):
    counts = Ensemble(write_store(tmp_path / "s.sqlite", AXES, patchy)).counts()
    assert (counts.done[0, 0], counts.failed[0, 0], counts.met["arrest"][0, 0]) == (9, 1, 9)
    assert (counts.done[2, 1], counts.pending[2, 1]) == (0, 10)


def test_run_that_its_wall_time_ended_is_no_result(tmp_path):
    path = write_store(tmp_path / "s.sqlite", AXES, graded)
    with sqlite3.connect(path) as store:
        store.execute("UPDATE run SET ended_by = 'wall time' WHERE run IN (0, 1)")
    store.close()
    ensemble = Ensemble(path)
    counts = ensemble.counts()
    assert (counts.done[0, 0], counts.failed[0, 0], counts.met["arrest"][0, 0]) == (9, 1, 9)
    assert counts.pending.sum() == 0
    assert len(ensemble.searched(0, "system.restitution", "arrest")[0]) == 9


def test_tables_and_figures_are_written(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES | {
        "system.solids_volume_fraction": (0.2, 0.4)}, graded)
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names == {"probabilities.csv", "boundaries.csv", "probability.png", "map.png",
                     "boundary.png", "run-length.png"}


def test_table_of_probabilities_has_a_row_a_point_with_its_interval(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, patchy)
    main(["ensemble", str(store), "-o", str(tmp_path / "out")])
    rows = table(tmp_path / "out" / "probabilities.csv")
    assert len(rows) == 6
    assert rows[0] | {"done": "9", "failed": "1", "pending": "0", "P_arrest": "1"} == rows[0]
    assert (rows[2]["P_false_positive"], rows[2]["P_false_positive_low"]) == ("0.5", "0.236593")
    assert (rows[5]["pending"], rows[5]["P_separation"]) == ("10", "")


def test_table_of_boundaries_says_how_each_is_known(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, graded)
    main(["ensemble", str(store), "-o", str(tmp_path / "out")])
    rows = table(tmp_path / "out" / "boundaries.csv")
    arrest = next(row for row in rows if row["criterion"] == "arrest")
    assert (arrest["system.restitution"], arrest["low"], arrest["high"], arrest["how"]) == (
        "0.2", "0.1", "0.3", "separated")


def test_parts_can_be_chosen_and_words_make_figures_of_their_own(tmp_path):
    axes = {"collision.overlap": ("rewind", "immediate"), **AXES}
    ensemble = Ensemble(write_store(tmp_path / "s.sqlite", axes, graded))
    usual, swapped = chosen_parts(ensemble), chosen_parts(ensemble, x="system.spheres")
    assert (usual.x, usual.y, usual.series, usual.rest) == (1, 2, None, (0,))
    assert (swapped.x, swapped.y) == (2, 1)
    first, second = slices(ensemble, usual)
    assert (first.others, second.others) == ((("collision.overlap", "rewind"),),
                                             (("collision.overlap", "immediate"),))
    assert first.counts.done.shape == (3, 2, 1)


def test_slices_put_the_axes_in_the_order_of_their_parts(tmp_path):
    axes = {"system.spheres": (100, 200), "system.solids_volume_fraction": (0.1, 0.2, 0.3, 0.4),
            "system.restitution": (0.1, 0.3, 0.5)}
    ensemble = Ensemble(write_store(tmp_path / "s.sqlite", axes, graded))
    part, = slices(ensemble, chosen_parts(ensemble))
    assert part.counts.done.shape == (3, 4, 2)
    assert part.counts.met["arrest"][:, 0, 0].tolist() == [10, 0, 0]


def test_one_axis_alone_has_its_curves(tmp_path):
    store = write_store(tmp_path / "s.sqlite", {"system.restitution": (0.1, 0.3, 0.5)}, graded)
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "probabilities.csv", "boundaries.csv", "probability.png", "run-length.png"}


def test_store_without_a_finished_run_is_drawn_as_such(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, lambda *_: "pending")
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out")]) == 0
    assert table(tmp_path / "out" / "boundaries.csv")[0]["how"] == "nothing"


def test_axis_that_is_none_is_refused_with_those_there_are(tmp_path):
    ensemble = Ensemble(write_store(tmp_path / "s.sqlite", AXES, graded))
    with pytest.raises(InputError, match=r"system.size is no axis with numbers \(there are system"):
        chosen_parts(ensemble, x="system.size")


def test_one_axis_cannot_be_both_x_and_y(tmp_path):
    ensemble = Ensemble(write_store(tmp_path / "s.sqlite", AXES, graded))
    with pytest.raises(InputError, match="both system.spheres"):
        chosen_parts(ensemble, "system.spheres", "system.spheres")


def test_what_is_no_store_is_refused(tmp_path, capsys):
    (tmp_path / "text").write_text("hello")
    with sqlite3.connect(tmp_path / "other") as other:
        other.execute("CREATE TABLE sweep (format_version, seeds, program_version)")
        other.execute("INSERT INTO sweep VALUES (7, 1, '')")
    for name, reason in (("missing", "does not exist; name the store"), ("text", "is not the store of a sweep"),
                         ("other", "format version 7")):
        assert main(["ensemble", str(tmp_path / name)]) == 2
        assert reason in capsys.readouterr().err


def test_reading_leaves_the_store_as_it_is(tmp_path):
    store = write_store(tmp_path / "s.sqlite", AXES, graded)
    before = store.read_bytes()
    assert np.all(Ensemble(store).counts().runs == 10)
    assert store.read_bytes() == before


def test_series_lie_side_by_side_between_the_points(tmp_path):
    axes = {"system.restitution": (0.1, 0.3, 0.5), "system.solids_volume_fraction": (0.2, 0.3),
            "system.spheres": (100, 200, 300)}
    store = Ensemble(write_store(tmp_path / "s.sqlite", axes, graded, seeds=1))
    part, = slices(store, chosen_parts(store))
    curves = [each for each in _probabilities(part, Pictures()).axes[0].lines
              if each.get_linestyle() == "-"]
    places = np.sort(np.concatenate([curve.get_xdata() for curve in curves]))
    assert len(places) == 9
    assert np.diff(places).min() > 0.2 * 0.15  # bars of 1.5 pixels stay apart
