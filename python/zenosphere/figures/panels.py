"""Draws one panel of a run."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator

from ..drawing import words
from ..drawing.pictures import HEIGHT, HIT_COLOUR, INK, MARK_COLOUR, WIDTH, above, points
from ..flags import HIT
from . import windows
from .thinning import PLOT_FLOOR, PLOT_LIMIT, plotted_separation, thinned

DOTS_PER_INCH = 300
EDGE = 0.04  # inches, free around a figure
ROW = 0.75  # inches that a further row adds
MARGINS = {"left": 0.76, "right": 0.62, "bottom": 0.48, "top": 0.54}  # inches, at full text size


def save(draw, run, window, path, pictures, rows=1):
    """Writes one figure in every format and returns the paths.

    draw:     a panel of this module or of anatomy_panels; takes a column of axes if rows > 1
    window:   (first, last) collision numbers shown, or what else `draw` takes
    path:     Path without suffix
    pictures: Pictures
    Raises OutputError where a file cannot be written.
    """
    with pictures.style():
        width, height = size = pictures.inches(WIDTH, HEIGHT + ROW * (rows - 1))
        left, right, bottom, top = (points(margin) for margin in MARGINS.values())
        figure = Figure(figsize=size, dpi=DOTS_PER_INCH)
        figure.subplots_adjust(left / width, bottom / height, 1 - right / width, 1 - top / height,
                               hspace=0.08)
        column = figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0]
        draw(column if rows > 1 else column[0], run, window)
        _make_room(figure, column)
        return pictures.write(figure, path, DOTS_PER_INCH)


def _make_room(figure, column):
    """Moves the left edge of the panels so that no name of a pair is cut."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    left = min(axes.yaxis.get_tightbbox(renderer).x0 for axes in column) / figure.dpi
    if left < EDGE:
        more = (EDGE - left) / figure.get_figwidth()
        figure.subplots_adjust(left=figure.subplotpars.left + more)


def separation(axes, run, window):
    """Separation of the next pair (log) against collisions, hits apart from the others."""
    k, gap, flags = run.collisions.read("k", "gap", "flags", first=window[0], last=window[1])
    known = ~np.isnan(gap)
    k, height, hit = k[known], plotted_separation(gap[known]), (flags[known] & HIT) > 0
    if k.size:
        drawn = thinned(k, height, keep=hit | (height == PLOT_FLOOR))
        k, height, hit = k[drawn], height[drawn], hit[drawn]
    axes.plot(k[~hit], height[~hit], ".", color=INK, markersize=_dot_size(k.size),
              markeredgewidth=0, rasterized=True)
    _ticks(axes, k[hit], height[hit])
    _separation_scale(axes, run, height)
    axes.set_ylabel("Separation of the next pair (diameters)")
    _collision_scale(axes, run, window)
    if hit.any():
        name = "hits, drawn\nat $10^{-17}$" if run.threshold == PLOT_LIMIT else "ticks: hits"
        axes.text(1.012, PLOT_FLOOR, name, color=HIT_COLOUR, fontsize=points(8), va="center",
                  linespacing=1.05, transform=axes.get_yaxis_transform())
    else:
        _remark(axes, "separation criterion not met here" if k.size else
                "no separation is known here", y=0.22)


def time(axes, run, window):
    """Time against collisions: strain under shear, else time in the case's unit."""
    k, clock, flags = run.collisions.read("k", "time", "flags", first=window[0], last=window[1])
    rate = run.setting("drive", "shear_rate") or 0
    if k.size:
        hits = k[(flags & HIT) > 0]
        drawn = thinned(k, clock, keep=np.zeros(len(k), dtype=bool))
        axes.plot(k[drawn], clock[drawn] * (rate or 1), color=INK, linewidth=1.0)
        if hits.size:
            _ticks(axes, hits, np.full(len(hits), 0.02), transform=axes.get_xaxis_transform())
            axes.text(1.012, 0.02, "hits", color=HIT_COLOUR, fontsize=points(8), va="center",
                      transform=axes.transAxes)
    if window[1] == run.collisions.last and run.verdict != "true":
        _collision_rate(axes, run, rate)
    axes.set_ylabel(r"Dimensionless time (strain) $\dot\gamma t$" if rate else
                    "Time $t$ (time unit of the case)")
    _collision_scale(axes, run, window)


def pairs_raster(axes, run, window, most=12):
    """Which pair collides at each collision: the most frequent pairs one row each."""
    k, i, j, flags = run.collisions.read("k", "i", "j", "flags", first=window[0], last=window[1])
    pairs, which, counts = np.unique(np.stack((i, j)), axis=1, return_inverse=True,
                                     return_counts=True)
    rank = np.empty(len(counts), dtype=int)
    rank[np.argsort(-counts, kind="stable")] = np.arange(len(counts))
    row = np.minimum(rank[which.ravel()], most)
    hit = (flags & HIT) > 0
    for chosen, colour in ((~hit, INK), (hit, HIT_COLOUR)):
        _ticks(axes, k[chosen], row[chosen], color=colour)
    names = [""] * min(len(counts), most)
    for place, (first, second) in zip(rank, pairs.T):
        if place < most:
            names[place] = words.pair(run, first, second)
    if len(counts) > most:
        rest = len(counts) - most
        names.append(f"{rest} other" + ("s" if rest > 1 else ""))
    axes.set_yticks(range(len(names)), names, fontsize=points(7.5))
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.set_ylabel("Pair that collides")
    _collision_scale(axes, run, window)


def _dot_size(points):
    """Diameter of a dot (pt): dust for a cloud, a blob where there are few."""
    return float(np.clip(60 / np.sqrt(points + 1), 1.6, 5))


def _ticks(axes, x, y, color=HIT_COLOUR, **options):
    axes.plot(x, y, "|", color=color, markersize=5, markeredgewidth=0.35, rasterized=True,
              **options)


def _collision_rate(axes, run, shear_rate):
    """States the average of the summary: in the steady state, time per collision is constant."""
    averages = run.summary["averages"]  # nulls where the measured span is empty
    if averages["collision_rate"] is None:
        return
    unit, scale = ("strain", shear_rate) if shear_rate else ("time", 1)
    begin, end = (words.short(averages[key] * scale, 3) for key in ("from_time", "to_time"))
    rate = words.short(averages["collision_rate"] / scale, 4)
    state = ", not steady" if averages.get("steady") is False else ""
    axes.text(0.97, 0.07, f"{rate} collisions per sphere per unit {unit}\n"
                          f"({unit} {begin} to {end}{state})",
              ha="right", fontsize=points(8), linespacing=1.1, transform=axes.transAxes)


def _separation_scale(axes, run, height):
    """Decades from below the floor to above the largest separation, and the threshold."""
    top = height.max() * 4 if height.size else 1.0
    axes.set_yscale("log")
    axes.set_ylim(PLOT_FLOOR / 4, max(top, 1e-12))
    exponents = range(-17, int(np.floor(np.log10(max(top, 1e-12)))) + 1, 2)
    axes.yaxis.set_major_locator(FixedLocator([10.0**n for n in exponents]))
    axes.yaxis.set_minor_locator(FixedLocator([10.0 ** (n + 1) for n in exponents]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: _power(value)))
    axes.yaxis.set_minor_formatter(FuncFormatter(lambda value, _: ""))
    if run.threshold > 0:
        axes.axhline(run.threshold, color="black", linewidth=0.8, linestyle=(0, (5, 2)))
        axes.text(1.012, run.threshold, f"threshold\n{_power(run.threshold)}", fontsize=points(8),
                  va="bottom", linespacing=1.05, transform=axes.get_yaxis_transform())


def _power(value):
    mantissa, exponent = f"{value:.2e}".split("e")
    factor = "" if float(mantissa) == 1 else rf"{float(mantissa):g}\times"
    return f"${factor}10^{{{int(exponent)}}}$"


def _collision_scale(axes, run, window):
    """Collision axis of the window, the marks of the run, and what run and verdict it is."""
    span = max(window[1] - window[0], 1)
    left = 0 if window[0] == 1 else window[0]
    axes.set_xlim(left, window[1] + 0.01 * span)
    axes.xaxis.set_major_locator(MaxNLocator(nbins=5, integer=True))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: words.grouped(round(value))))
    axes.set_xlabel("Number of collisions")
    _marks(axes, run, window)
    above(axes, _heading(run), 27, fontsize=points(9.5))
    if not run.collisions.complete:
        _remark(axes, "the log holds a part of the run only", y=0.9)


def _heading(run):
    parts = words.restitutions(run) + [f"$N = {run.spheres}$"]
    fraction = run.setting("system", "solids_volume_fraction")
    if fraction is not None:
        parts.append(rf"$\phi = {words.short(fraction)}$")
    window = run.arrest.get("window")
    among = f" (window {words.grouped(window)} collisions)" if window else ""
    return ",  ".join(parts) + f";  verdict: $\\bf{{{run.verdict}}}${among}"


def marks(run):
    """The collisions worth a line: [(collision number, label)], ascending.

    The last hit is left out where the arrest makes it meaningless.
    """
    found, hits = [], run.separation
    if hits["first_collision"] is not None:
        number = hits["first_collision"]
        each = words.short(words.per_sphere(run, number), 3)
        found.append((number, f"first hit {words.grouped(number)}" + (
            f"\n({each} per sphere)" if run.spheres > 1 else "")))
    if run.arrest["met"]:
        number = run.arrest["collision"]
        begin = windows.run_of_hits_begins(run)
        if run.collisions.complete or begin > run.collisions.first:
            found.append((begin, f"only hits from\n{words.grouped(begin)}"))
        found.append((number, f"arrest\n{words.grouped(number)}"))
    elif hits["last_collision"] not in (None, hits["first_collision"]):
        number = hits["last_collision"]
        found.append((number, f"last hit\n{words.grouped(number)}"))
    return found


def _marks(axes, run, window):
    """Thin vertical lines with labels above the panel, moved apart where they would overlap."""
    inside = [mark for mark in marks(run) if window[0] <= mark[0] <= window[1]]
    places = _spread([axes.transLimits.transform((number, 0))[0] for number, _ in inside])
    for place, (number, label) in zip(places, inside):
        axes.axvline(number, color=MARK_COLOUR, linewidth=0.7, alpha=0.9)
        axes.annotate(label, xy=(number, 1), xycoords=axes.get_xaxis_transform(),
                      xytext=(place, points(6)), textcoords=("axes fraction", "offset points"),
                      ha="center", va="bottom",
                      fontsize=points(8), linespacing=1.1, color=MARK_COLOUR, annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": MARK_COLOUR, "linewidth": 0.7,
                                  "shrinkA": 0, "shrinkB": 0, "relpos": (0.5, 0)})
    if not inside:
        state = ("no hit and no arrest in the run" if run.separation["first_collision"] is None
                 else "first hit, last hit and arrest lie outside this window")
        above(axes, state, 6, fontsize=points(8), color=MARK_COLOUR)


def _spread(places, apart=0.2):
    """Places in [0.06, 1], ascending, at least `apart` from each other, as near as given."""
    placed = []
    for place in places:
        placed.append(max(place, 0.06, placed[-1] + apart if placed else 0))
    limit = 1.0
    for index in reversed(range(len(placed))):
        placed[index] = min(placed[index], limit)
        limit = placed[index] - apart
    return placed


def _remark(axes, text, y):
    axes.text(0.5, y, text, transform=axes.transAxes, ha="center", fontsize=points(9),
              style="italic",
              bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 2})
