"""The figures and tables of an ensemble."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ..csv_file import write_csv
from ..drawing import words
from ..drawing.pictures import PAGE_WIDTH, Pictures, made_folder, points
from . import panels
from .average_figures import draw_averages
from .averages import average_rows
from .findings import finding_rows
from .maps import finding_maps, probability_maps
from .slices import chosen_parts, slices
from .store import CRITERIA
from .table import crossing_rows, crossings_along, probability_rows

LEAST_PANEL = 1.0  # inches, width of one of many
SPREAD = 0.5  # of the step from point to point, over which the series lie side by side
LENGTHS = 9  # run lengths of the figure, a factor of two apart


def draw_ensemble(ensemble, folder, x=None, y=None, pictures=Pictures()):
    """Writes the tables and the figures of a store; returns the paths.

    folder: Path, made where missing;  x, y: keys of the curves' x and of the panels (rows of the
    maps); by default restitution and solids volume fraction, else the axes with most values
    pictures: how figures are written
    Raises InputError, OutputError.
    """
    parts = chosen_parts(ensemble, x, y)
    made_folder(folder)
    counts = ensemble.counts()
    written = [
        write_csv(folder / "probabilities.csv", probability_rows(ensemble, counts)),
        write_csv(folder / "boundaries.csv", crossing_rows(ensemble, counts, parts.x))]
    if ensemble.has_findings:
        written.append(write_csv(folder / "findings.csv", finding_rows(ensemble, counts)))
    averages = list(average_rows(ensemble))
    if averages:
        written.append(write_csv(folder / "averages.csv", averages))
    for number, part in enumerate(slices(ensemble, parts)):
        suffix = f"-{number + 1}" if parts.rest else ""
        for name, draw in FIGURES.items():
            with pictures.style():
                figure = draw(part, pictures)
                written += pictures.write(figure, folder / f"{name}{suffix}") if figure else []
    return written


def _probabilities(part, pictures):
    """P against x: a row for each criterion, a column for each y, a series for each third key."""
    if not part.counts.done.any():
        return None
    x_key, x = part.axis("x")
    y_key, columns = part.axis("y")
    x = np.array(x, dtype=float)
    figure, grid = figure_grid(pictures, _heading(part), 3, len(columns), (1.75, 1.55),
                               panels.series_handles(*part.axis("series")))
    step = np.diff(np.sort(x)).min()
    for (row, column), axes in np.ndenumerate(grid):
        met = part.counts.met[CRITERIA[row]]
        for number, style in enumerate(_styles(part)):
            shift = step * SPREAD * ((number + 0.5) / met.shape[2] - 0.5)
            panels.probability(axes, x, met[:, column, number],
                               part.counts.done[:, column, number], style, shift)
        axes.set_xlim(x.min() - step / 2, x.max() + step / 2)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
        panels.outer_labels(axes, grid.shape, (row, column), panels.label(x_key),
                      "$P$: " + panels.TITLES[CRITERIA[row]].replace(" ", "\n", 1))
        if row == 0 and y_key:
            axes.set_title(panels.said(y_key, columns[column]), fontsize=points(9))
    return figure


def _boundaries(part, pictures):
    """Where P crosses 1/2 along x: a row for each criterion, against y and against the third."""
    x_key, _ = part.axis("x")
    against = [name for name in ("y", "series") if part.axis(name)[0]]
    found, span = crossings_of(part), _span(part)
    if not against or all(each.how in ("nothing", "unclear") for each in found["separation"].flat):
        return None
    figure, grid = figure_grid(pictures, _heading(part), 2, len(against), (2.9, 2.2), sharex="col",
                               sharey=True)
    for (row, column), axes in np.ndenumerate(grid):
        name = ("separation", "arrest")[row]
        other = "series" if against[column] == "y" else "y"
        table = found[name] if against[column] == "y" else found[name].T
        key, values = part.axis(against[column])
        for number, style in enumerate(_styles(part, other)):
            shift = 1 + 0.012 * (number - (table.shape[1] - 1) / 2)
            panels.boundary(axes, values, table[:, number], style, span, shift)
        if _is_geometric(values):
            _log_scale(axes, values)
        panels.outer_labels(axes, grid.shape, (row, column), panels.label(key),
                      f"{panels.symbol(x_key)} where P = 1/2:\n{panels.TITLES[name]}")
        if row == 0:
            hollow = any(panels.is_outside(each) for one in found.values() for each in one.flat)
            handles = panels.series_handles(*part.axis(other), hollow)
            axes.legend(handles=handles, fontsize=points(7)) if handles else None
    return figure


def _run_lengths(part, pictures):
    """The crossings of both criteria against the length of the runs, at the last third key."""
    x_key, _ = part.axis("x")
    longest = part.ensemble.longest
    if not longest:
        return None
    lengths = longest / 2.0 ** np.arange(LENGTHS)[::-1]
    found = [crossings_of(part.with_limit(limit).last()) for limit in lengths]
    hollow = any(panels.is_outside(one) for each in found for table in each.values()
                 for one in table[:, -1])
    figure, grid = figure_grid(pictures, _heading(part), 1, 2, (2.9, 2.4),
                               panels.series_handles(*part.axis("y"), hollow), sharey=True)
    for axes, name in zip(grid[0], ("separation", "arrest")):
        for number, style in enumerate(_styles(part, "y")):
            row = [each[name][number, -1] for each in found]
            panels.boundary(axes, lengths, row, style, _span(part),
                            1 + 0.03 * (number - len(part.axis("y")[1]) / 2))
        axes.set_xscale("log")
        axes.set_xlabel("Run length (collisions per sphere)")
        axes.set_title(panels.TITLES[name], fontsize=points(9))
    key, values = part.axis("series")
    at = f"\n({panels.said(key, values[-1])})" if key else ""
    grid[0, 0].set_ylabel(f"{panels.symbol(x_key)} where P = 1/2{at}")
    return figure


def _maps(part, pictures):
    return probability_maps(part, _heading(part, remark=""), pictures)


def _findings(part, pictures):
    """What the first groups of hits were; None without findings or without a hit."""
    if not part.counts.findings or not part.counts.findings["hit"].any():
        return None
    return finding_maps(part, _findings_heading(part), pictures)


def _averages(part, pictures):
    """Averages with their errors; None where no run has any."""
    remark = ";\nbars: error of the mean; hollow: no steady run"
    return draw_averages(part, _heading(part, remark), figure_grid, _styles(part), pictures)


FIGURES = {"averages": _averages, "probability": _probabilities, "map": _maps, "findings": _findings,
           "boundary": _boundaries, "run-length": _run_lengths}


def crossings_of(part):
    """For both criteria, an array of Crossing over (y, series)."""
    return crossings_along(part.axis("x")[1], part.counts, 0)


def _span(part):
    """(where the crossing lies if P is below 1/2 in the whole range, where if above)."""
    x = np.array(part.axis("x")[1], dtype=float)
    hits, done = (array.sum(axis=(1, 2)) for array in (part.counts.met["separation"],
                                                       part.counts.done))
    known = done > 0
    falls = np.polyfit(x[known], hits[known] / done[known], 1)[0] <= 0 if known.sum() > 1 else True
    return (x.min(), x.max()) if falls else (x.max(), x.min())


def _styles(part, name="series"):
    return panels.styles(len(part.axis(name)[1]))


def figure_grid(pictures, heading, rows, columns, size, legend=(), **sharing):
    """A figure with a heading, and its axes (rows, columns).

    size: (width, height) of one of them, inches;  legend: handles, in a strip below
    """
    width = min(max(columns * size[0] + 0.9, 4.2), max(PAGE_WIDTH, columns * LEAST_PANEL + 0.9))
    width = pictures.inches(width, 0)[0]
    longest = max((len(each.get_label()) for each in legend), default=0)
    beside = max(int(width / (0.5 + points(7) * 0.5 / 72 * longest)), 1)
    strip = points(0.18) * -(-len(legend) // beside)  # inches
    inches = pictures.inches(width, max(rows * size[1] + 0.8, 2.6) + strip)
    figure = Figure(figsize=inches, layout="constrained")
    above = figure
    if legend:
        above, below = figure.subfigures(2, 1, height_ratios=(inches[1] - strip, strip))
        below.legend(handles=legend, loc="center", ncol=beside, fontsize=points(7), borderpad=0)
    grid = above.subplots(rows, columns, squeeze=False, **sharing)
    above.suptitle(heading, fontsize=points(9), x=0.01, ha="left")
    return figure, grid


def _heading(part, remark="; bars: 95 %, side by side"):
    """How many runs are shown, by which overlap rule they left their hits, what is incomplete."""
    counts, most = part.counts, int(part.counts.done.max())
    runs, done, failed, pending = (int(getattr(counts, name).sum())
                                   for name in ("runs", "done", "failed", "pending"))
    least = int(counts.done.min())
    text = (f"{words.grouped(done)} runs, {least if least == most else f'{least} to {most}'} a"
            f" point{remark}")
    if part.ensemble.rule:
        text += f"; overlap rule {part.ensemble.rule}"
    if done < runs:
        text += f"; incomplete: {pending} pending, {failed} failed of {runs} (maps: hatched)"
    return _at_others(part, text)


def _findings_heading(part):
    """How many of the runs had hits, and of how many it is known what they were."""
    found = {name: int(array.sum()) for name, array in part.counts.findings.items()}
    text = (f"{words.grouped(int(part.counts.done.sum()))} runs, {words.grouped(found['hit'])} with"
            f" hits, {words.grouped(found['hit'] - found['not adjudicated'])} of them adjudicated;"
            " height of a colour: share of the runs\nwhose first group of hits was found to be ...")
    return _at_others(part, text)


def _at_others(part, text):
    others = ", ".join(panels.said(key, value) for key, value in part.others)
    return (f"{others}: {text}" if others else text).replace(words.SPACE, " ")


def _is_geometric(values):
    """Whether the ratios of neighbouring values are more even than their differences."""
    if len(values) < 3 or min(values) <= 0:
        return False
    steps, ratios = np.diff(values), np.diff(np.log(values))
    return np.std(ratios) / np.mean(ratios) < np.std(steps) / np.mean(steps)


def _log_scale(axes, values):
    axes.set_xscale("log")
    axes.set_xticks(values, [words.short(value) for value in values], minor=False)
    axes.set_xticks([], minor=True)
