"""Draws maps of an ensemble over x and y: the probability of each criterion, and the findings."""

import textwrap
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from ..drawing import words
from ..drawing.pictures import PAGE_WIDTH, points
from . import panels
from .proportions import fraction
from .store import CRITERIA

CELL_HEIGHT, LEAST_CELL = 0.27, 0.17  # inches: two decimals in 6 points are as wide
LEAST_HEIGHT, SMALLEST_CELL = 0.11, 0.02  # inches: with a number, without
MARGIN, TITLE = 0.8, 0.45  # inches: labels on the left and around a figure, title of a panel
COLOUR_BAR, LEGEND_ROW = 0.5, 0.19  # inches, below the panels: of a bar, of two entries
TICK_SIZE, TITLE_SIZE, LARGEST_NUMBER = 8, 9, 7  # points
GLYPH = 0.5  # mean width of a letter over the font size
FRAME = 0.03  # of a cell, around a bar
NO_RUN, NOT_DONE, INCOMPLETE = "#d9d9d9", "#d55e00", "0.6"

# Okabe & Ito's palette; blue, darker the more the run shows of it, is a collapse of the spheres.
FINDINGS = {
    "real, arrested": ("#003a5d", "singular or proven, and the run arrested"),
    "real, open": ("#0072b2", "singular or proven, hit to the end of the run"),
    "real, went on": ("#7cc4ee", "singular or proven, dissolved by rounding: the run went on"),
    "near-collapse": ("#f0b400", "near-collapse"),
    "arithmetic arrest": ("#d55e00", "arithmetic arrest"),
    "chance or exact": ("#009e73", "chance close pair or exact contact"),
    "undecided": ("#8c8c8c", "undecided"),
    "not adjudicated": ("white", "hit, not adjudicated"),
}
HATCHED = {"not adjudicated": "//////"}


@dataclass(frozen=True)
class Layout:
    """Panels in rows and columns, and the sizes of the figure and of a cell (inches)."""

    size: tuple  # (width, height) of the figure
    shape: tuple  # (rows, columns)
    cell: tuple  # (width, height)

    @property
    def has_numbers(self):
        """Whether a number fits in a cell."""
        return self.cell[0] >= LEAST_CELL and self.cell[1] >= LEAST_HEIGHT


def layout(part, pictures, panel_count, candidates, below):
    """The first number of columns at which numbers fit in the cells; the first one if none.

    candidates: numbers of columns;  below: inches, of a legend or a colour bar
    """
    plans = [_with_columns(part, pictures, panel_count, columns, below) for columns in candidates]
    return next((plan for plan in plans if plan.has_numbers), plans[0])


def _with_columns(part, pictures, panel_count, columns, below):
    across, along = (len(part.axis(name)[1]) for name in ("x", "y"))
    rows = -(-panel_count // columns)
    usual = rows * (max(CELL_HEIGHT * along, 0.9) + TITLE) + MARGIN + below
    width, height = pictures.inches(PAGE_WIDTH, usual)
    cell = (((width - MARGIN) / columns - 0.1) / across,
            max(((height - below - MARGIN) / rows - TITLE) / along, SMALLEST_CELL))
    return Layout((width, height), (rows, columns), cell)


def probability_maps(part, heading, pictures):
    """Figure of P over x and y: a panel for each criterion and third key; None without y.

    part: Slice;  pictures: Pictures
    """
    if part.axis("y")[0] is None:
        return None
    row_key, rows = part.axis("series")
    plan = layout(part, pictures, len(rows) * len(CRITERIA), (4, 2, 1), COLOUR_BAR)
    figure = Figure(figsize=plan.size, layout="constrained")
    grid = figure.subplots(*plan.shape, squeeze=False)
    figure.suptitle(heading, fontsize=points(TITLE_SIZE), x=0.01, ha="left")
    kinds = [(row, name) for row in range(len(rows)) for name in CRITERIA]
    for (place, axes), (row, name) in zip(np.ndenumerate(grid), kinds):
        image = _probabilities(axes, part.counts, name, row, plan)
        _label(axes, part, place, plan, f"{panels.said(row_key, rows[row])}\n" if row_key else "")
        if place[0] == 0 or plan.shape[1] < len(CRITERIA):
            _title(axes, panels.TITLES[name], plan.cell[0] * len(part.axis("x")[1]))
    figure.colorbar(image, ax=grid, label="fraction of the runs", location="bottom", shrink=0.5,
                    aspect=30, pad=0.1 / plan.size[1])
    return figure


def finding_maps(part, heading, pictures):
    """Figure of what the first group of hits was, as shares of the runs that are done, stacked.

    part: Slice with findings;  pictures: Pictures.  A panel for each third key
    """
    row_key, rows = part.axis("series")
    most = -(-len(rows) // -(-len(rows) // 3))  # up to three side by side, evenly
    entries = _findings_legend(part.counts)
    legend = LEGEND_ROW * (1 + -(-len(entries) // 2))
    plan = layout(part, pictures, len(rows), range(most, 0, -1), legend)
    whole = Figure(figsize=plan.size, layout="constrained")
    above, below = whole.subfigures(2, 1, height_ratios=(plan.size[1] - legend, legend))
    grid = above.subplots(*plan.shape, squeeze=False)
    above.suptitle(heading, fontsize=points(TITLE_SIZE), x=0.01, ha="left")
    for number, (place, axes) in enumerate(np.ndenumerate(grid)):
        if number >= len(rows):
            axes.set_axis_off()
            continue
        _stacks(axes, part.counts, number, FRAME if part.axis("y")[0] else 0)
        is_lowest = number + plan.shape[1] >= len(rows)
        _label(axes, part, (plan.shape[0] - 1 if is_lowest else 0, place[1]), plan, "")
        if row_key:
            axes.set_title(panels.said(row_key, rows[number]), fontsize=points(TITLE_SIZE))
    below.legend(handles=entries, loc="upper center", ncol=2, fontsize=points(TICK_SIZE))
    return whole


def _probabilities(axes, counts, name, row, plan):
    """P as colour; a cell whose runs are not all done is hatched, one without is grey.

    Returns the image for a colour bar.
    """
    met, done, runs = (array[:, :, row].T for array in (counts.met[name], counts.done, counts.runs))
    p = np.ma.masked_invalid(fraction(met, done))
    axes.set_facecolor(NO_RUN)
    image = axes.pcolormesh(*(np.arange(count + 1) for count in reversed(p.shape)), p,
                            cmap=panels.MAP, vmin=0, vmax=1, edgecolors="white", linewidth=0.6)
    for place in np.argwhere(done < runs):
        _hatch(axes, place, NOT_DONE)
    size = min(points(LARGEST_NUMBER), plan.cell[0] * 72 / (4 * GLYPH), plan.cell[1] * 72)
    for place in np.argwhere(done > 0) if plan.has_numbers else ():
        value = p[tuple(place)]
        axes.text(place[1] + 0.5, place[0] + 0.5, short_fraction(value), ha="center",
                  va="center", fontsize=size, color="white" if value < 0.55 else "black")
    return image


def _stacks(axes, counts, row, frame):
    """A bar in each cell: from below, the share of each kind; white above it are runs without.

    frame: free above and below, of the cell
    """
    done = counts.done[:, :, row]
    x, y = np.nonzero(done)
    axes.set_facecolor(NO_RUN)
    full, breadth = 1 - 2 * frame, 1 - 2 * FRAME
    axes.bar(x + 0.5, full, breadth, y + frame, color="white")
    bottom = y + frame
    for name, (colour, _) in FINDINGS.items():
        share = full * counts.findings[name][x, y, row] / done[x, y]
        some = share > 0
        axes.bar(x[some] + 0.5, share[some], breadth, bottom[some], color=colour, linewidth=0,
                 hatch=HATCHED.get(name), edgecolor="0.55")
        bottom = bottom + share
    for place in np.argwhere(counts.done[:, :, row] < counts.runs[:, :, row]):
        _hatch(axes, place[::-1], INCOMPLETE)
    axes.set_xlim(0, done.shape[0])
    axes.set_ylim(0, done.shape[1])


def _hatch(axes, place, colour):
    row, column = place
    axes.fill_between([column, column + 1], row, row + 1, facecolor="none", edgecolor=colour,
                      hatch="///", linewidth=0)


def _findings_legend(counts):
    """Patches of the kinds that occur; no hit, no run and what is incomplete last."""
    shown = [Patch(facecolor=colour, label=text, hatch=HATCHED.get(name), edgecolor="0.55",
                   linewidth=0.5)
             for name, (colour, text) in FINDINGS.items() if counts.findings[name].any()]
    shown.append(Patch(facecolor="white", edgecolor="0.55", linewidth=0.5, label="no hit"))
    if not counts.done.all():
        shown.append(Patch(facecolor=NO_RUN, label="no run done"))
    if (counts.done < counts.runs).any():
        shown.append(Patch(facecolor="white", edgecolor=INCOMPLETE, hatch="///", linewidth=0.5,
                           label="hatched: only some of the runs of this point are done"))
    return shown


def _label(axes, part, place, plan, name):
    """Ticks at the cells, those that fit; names and numbers on the left and at the bottom only."""
    (x_key, x), (y_key, y) = part.axis("x"), part.axis("y")
    every = _stride(x, plan.cell[0])
    each_row = int(np.ceil(points(TICK_SIZE) / 72 / plan.cell[1]))
    axes.set_xticks(np.arange(0, len(x), every) + 0.5, [words.short(each) for each in x[::every]])
    if y_key:
        axes.set_yticks(np.arange(0, len(y), each_row) + 0.5,
                        [words.short(each) for each in y[::each_row]])
    axes.tick_params(length=0, labelsize=points(TICK_SIZE))
    panels.outer_labels(axes, plan.shape, place, panels.label(x_key),
                        name + panels.symbol(y_key) if y_key else "share of the runs")


def _stride(values, cell):
    """Every how many cells a number fits; cell: inches."""
    widest = max(len(words.short(value)) for value in values) + 0.5
    return max(1, int(np.ceil(widest * GLYPH * points(TICK_SIZE) / 72 / cell)))


def _title(axes, text, width):
    """A title in as many lines as the panel's width (inches) asks for."""
    letters = max(int(width * 72 / (GLYPH * points(TITLE_SIZE))), 8)
    axes.set_title("\n".join(textwrap.wrap(text, letters)), fontsize=points(TITLE_SIZE))


def short_fraction(value):
    """A fraction in two decimals; 0 and 1 are exactly so."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return {"0": ">0", "1": "<1"}[text] if text in ("0", "1") and value != int(text) else text
