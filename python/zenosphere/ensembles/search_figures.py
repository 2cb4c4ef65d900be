"""The figures and the table of an adaptive search: where the runs went, and what they found."""

import numpy as np

from ..csv_file import write_csv
from ..drawing.pictures import Pictures, made_folder, points
from . import panels
from .crossing import Crossing
from .figures import figure_grid

MOST_PANELS = 24


def draw_search(ensemble, folder, pictures=Pictures()):
    """Writes boundaries.csv, search.png and, over numeric keys, boundary.png; returns the paths.

    Raises OutputError.
    """
    made_folder(folder)
    rows = ensemble.boundaries()
    written = [write_csv(folder / "boundaries.csv", rows)]
    for name, draw in (("search", _searches), ("boundary", _boundaries)):
        with pictures.style():
            figure = draw(ensemble, rows, pictures)
            written += pictures.write(figure, folder / name) if figure else []
    return written


def _searches(ensemble, rows, pictures):
    """Each run in turn at its x, filled where the criterion was met; the interval as a band."""
    rows = rows[:MOST_PANELS]
    columns = min(len(rows), 4)
    key, criterion = rows[0]["axis"], rows[0]["criterion"]
    heading = (f"{sum(row['runs'] for row in ensemble.boundaries())} runs; filled:"
               f" {panels.TITLES[criterion]}; band: 95 % interval of P = 1/2")
    figure, grid = figure_grid(pictures, heading, -(-len(rows) // columns), columns, (2.0, 1.7),
                               sharey=True)
    for axes in grid.flat[len(rows):]:
        axes.set_axis_off()
    for (place, axes), row in zip(np.ndenumerate(grid), rows):
        x, met = ensemble.searched(row["point"], key, criterion)
        number = np.arange(1, len(x) + 1)
        for chosen, face in ((met, panels.COLOURS[0]), (~met, "white")):
            axes.plot(number[chosen], x[chosen], "o", color=panels.COLOURS[0], markersize=3,
                      markerfacecolor=face, markeredgewidth=0.7)
        if row["place"] is not None:
            ends = [row[end] if row[name] is None else row[name]
                    for name, end in (("low", "from"), ("high", "to"))]
            axes.axhspan(*ends, color=panels.COLOURS[4], alpha=0.35, linewidth=0)
        axes.set_title(", ".join(panels.said(each, row[each]) for each in _others(row))
                       + f" ({row['finding']})", fontsize=points(7.5))
        panels.outer_labels(axes, grid.shape, place, "Run", panels.label(key))
    return figure


def _others(row):
    """The keys of the other axes: their columns, and no others, have a dot in the name."""
    return [key for key in row if "." in key]


def _boundaries(ensemble, rows, pictures):
    """The places found against the first numeric key, a series for each value of the second."""
    numeric = [axis for axis in ensemble.axes if axis.key in _others(rows[0]) and axis.is_numeric
               and len(axis.values) > 1]
    if not numeric:
        return None
    key, values = numeric[0].key, numeric[0].values
    other = numeric[1] if len(numeric) > 1 else None
    crossings = {tuple(row[axis.key] for axis in numeric[:2]): crossing_of(row) for row in rows}
    handles = panels.series_handles(*(other.key, other.values) if other else (None, ()), any(
        panels.is_outside(each) for each in crossings.values()))
    figure, grid = figure_grid(pictures, "bars: 95 %", 1, 1, (3.6, 2.4), handles)
    span = rows[0]["from"], rows[0]["to"]
    series_values = other.values if other else (None,)
    for series, style in zip(series_values, panels.styles(len(series_values))):
        found = [crossings[(value,) if other is None else (value, series)] for value in values]
        panels.boundary(grid[0, 0], values, found, style, span)
    grid[0, 0].set_xlabel(panels.label(key))
    grid[0, 0].set_ylabel(f"{panels.symbol(rows[0]['axis'])} where P = 1/2:\n"
                          + panels.TITLES[rows[0]["criterion"]], fontsize=points(9))
    return figure


def crossing_of(row):
    """A row of the table `boundary` as what a grid would have given."""
    how = {"crossing": "fit", "unresolved": "unclear"}.get(row["finding"], row["finding"])
    return Crossing(row["place"], row["low"], row["high"], how)
