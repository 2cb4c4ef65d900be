"""What a reader of the figures sees: titles apart, legends, labels with one unit, one typeface."""

import itertools
import re

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from synthetic import write_run
from synthetic_store import write_search, write_store

from zenosphere.__main__ import main
from zenosphere.drawing import words
from zenosphere.drawing.pictures import Pictures
from zenosphere.ensembles import figures as ensemble_figures
from zenosphere.ensembles import panels as ensemble_panels
from zenosphere.ensembles.maps import probability_maps
from zenosphere.ensembles.slices import chosen_parts, slices
from zenosphere.ensembles.store import Ensemble
from zenosphere.figures import panels
from zenosphere.run_file import RunFile

RESTITUTIONS = tuple(round(0.1 + 0.05 * step, 2) for step in range(13))


def part_of(folder, axes, outcome=lambda *_: (5, 50)):
    ensemble = Ensemble(write_store(folder / "s.sqlite", axes, outcome, seeds=2))
    return next(slices(ensemble, chosen_parts(ensemble)))


def map_of(part, pictures=Pictures()):
    with pictures.style():
        figure = probability_maps(part, "heading", pictures)
        FigureCanvasAgg(figure).draw()
    return figure


SMALL = {"system.restitution": (0.1, 0.5), "system.spheres": (100, 200, 400)}
PLANE = {"system.restitution": RESTITUTIONS, "system.solids_volume_fraction": (0.1, 0.2),
         "system.spheres": (100, 200)}


@pytest.mark.parametrize("axes, size, width", [
    (SMALL, None, 1400), (SMALL, (3.4, 3.0), 680), (PLANE, None, 1400)],
    ids=["2 e x 3 N", "2 e x 3 N in a column", "13 e x 2 phi x 2 N"])
def test_texts_of_a_map_lie_apart_in_its_width(tmp_path, axes, size, width):
    figure = map_of(part_of(tmp_path, axes), Pictures(size=size))
    assert figure.get_figwidth() * 200 == width  # pixels
    boxes = [axes.title.get_window_extent() for axes in figure.axes if axes.title.get_text()]
    boxes += [text.get_window_extent() for axes in figure.axes for text in axes.texts]
    for one, other in itertools.combinations(boxes, 2):
        assert not one.overlaps(other)


def test_cells_without_room_have_no_numbers(tmp_path):
    part = part_of(tmp_path, {"system.restitution": RESTITUTIONS,
                              "system.solids_volume_fraction": (0.1, 0.2)})
    assert any(axes.texts for axes in map_of(part).axes)
    small = map_of(part, Pictures(size=(2.4, 2.4)))
    assert not any(axes.texts for axes in small.axes)


def legend_texts(figure):
    legends = [*(each.get_legend() for each in figure.axes),
               *(each for part in figure.subfigs for each in part.legends)]
    return [text.get_text() for legend in legends if legend for text in legend.get_texts()]


@pytest.mark.parametrize("arrest, is_outside", [(50, True), (None, False)])
def test_hollow_marks_are_in_the_legend_where_there_are_any(tmp_path, arrest, is_outside):
    def outcome(keys, _):  # all arrest, or the hits end between 0.3 and 0.5
        return (5, 50) if arrest else (5 if keys["system.restitution"] < 0.4 else None,
                                       50 if keys["system.restitution"] < 0.4 else None)
    part = part_of(tmp_path, {"system.restitution": (0.1, 0.3, 0.5, 0.7),
                              "system.spheres": (100, 200)}, outcome)
    figure = ensemble_figures._boundaries(part, Pictures())
    assert (ensemble_panels.HOLLOW in legend_texts(figure)) == is_outside


def test_hollow_marks_of_a_search_are_in_its_legend(tmp_path):
    from zenosphere.ensembles.search_figures import _boundaries
    found = {0.1: ("below", None, None, None), 0.2: ("crossing", 0.2, 0.1, 0.3)}
    ensemble = Ensemble(write_search(tmp_path / "s.sqlite", found))
    figure = _boundaries(ensemble, ensemble.boundaries(), Pictures())
    assert legend_texts(figure) == [ensemble_panels.HOLLOW]


def test_size_that_leaves_no_room_is_exit_code_2(tmp_path, capsys):
    axes = {"system.restitution": (0.1, 0.3, 0.5), "system.solids_volume_fraction": (0.1, 0.2),
            "system.spheres": tuple(range(100, 1700, 100))}
    store = write_store(tmp_path / "s.sqlite", axes, lambda *_: (5, 50), seeds=1)
    assert main(["ensemble", str(store), "-o", str(tmp_path / "out"), "--size", "5x5"]) == 2
    assert "does not fit in 5x5 cm" in capsys.readouterr().err


def test_labels_have_one_quantity_and_at_most_one_unit():
    for _, label in ensemble_panels.NAMES.values():
        assert label.count("(") <= 1 and "," not in label


def with_walls(path, spheres):
    """A run of a case with walls of e = 0.75."""
    import h5py
    with h5py.File(write_run(path, gap=[0.1, 0.01, 0], j=np.full(3, spheres)), "a") as file:
        text = file["zenosphere/resolved"][()].decode()
        del file["zenosphere/resolved"]
        file["zenosphere/resolved"] = re.sub(r"spheres = \d+", f"spheres = {spheres}", text) + (
            '[walls]\naxis = "x"\nrestitution = 0.75\n')
    return path


@pytest.mark.parametrize("spheres, said", [
    (1, [r"$e_\mathrm{wall} = 0.75$"]), (2, ["$e = 0.6$", r"$e_\mathrm{wall} = 0.75$"])])
def test_heading_names_the_restitutions_that_matter(tmp_path, spheres, said):
    with RunFile(with_walls(tmp_path / "run.h5", spheres)) as run:
        assert words.restitutions(run) == said


def test_pair_of_a_sphere_and_a_wall_is_called_so(tmp_path):
    with RunFile(with_walls(tmp_path / "run.h5", 1)) as run:
        axes = Figure().add_subplot()
        panels.pairs_raster(axes, run, (1, 3))
    assert [label.get_text() for label in axes.get_yticklabels()] == ["0\N{EN DASH}lower wall"]


def test_long_names_of_pairs_are_not_cut(written, tmp_path, monkeypatch):
    figures = []
    monkeypatch.setattr(Pictures, "write", lambda self, figure, *_: figures.append(figure))
    path = written(gap=[1e-3], i=[123456789], j=[123456790])
    with RunFile(path) as run:
        panels.save(panels.pairs_raster, run, (1, 1), tmp_path / "pairs", Pictures())
    (figure,) = figures
    (axes,) = figure.axes
    assert axes.yaxis.get_tightbbox(FigureCanvasAgg(figure).get_renderer()).x0 > 0


@pytest.mark.parametrize("pairs, last", [(13, "1 other"), (14, "2 others")])
def test_pairs_beyond_twelve_are_counted_in_plain_english(written, pairs, last):
    with RunFile(written(gap=np.full(pairs, 1e-3), i=np.arange(pairs),
                         j=np.arange(pairs) + 1)) as run:
        axes = Figure().add_subplot()
        panels.pairs_raster(axes, run, (1, pairs))
    assert axes.get_yticklabels()[-1].get_text() == last
