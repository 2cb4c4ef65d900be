"""Draws one panel of a run."""

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator

from . import windows, words
from .errors import OutputError
from .run_file import HIT
from .thinning import PLOT_FLOOR, PLOT_LIMIT, plotted_separation, thinned

# Okabe & Ito's palette, distinct to every kind of colour vision and in grey print.
INK, HIT_COLOUR, MARK_COLOUR = "#1b2a41", "#d55e00", "#0072b2"
WIDTH, HEIGHT = 5.2, 3.4  # inches
DOTS_PER_INCH = 300

STYLE = {
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 10,
    "axes.labelsize": 10, "axes.linewidth": 0.7, "xtick.labelsize": 9, "ytick.labelsize": 9,
    "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
    "legend.fontsize": 8.5, "legend.frameon": False, "pdf.fonttype": 42,
}


def save(draw, run, window, path):
    """Writes one figure as path.png and path.pdf and returns the two paths.

    draw:   a panel of this module or of anatomy_panels
    window: (first, last) collision numbers shown, or what else `draw` takes
    path:   Path without suffix
    Raises OutputError where a file cannot be written.
    """
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DOTS_PER_INCH)
        axes = figure.add_axes([0.145, 0.14, 0.735, 0.70])
        draw(axes, run, window)
        written = [path.parent / f"{path.name}.{suffix}" for suffix in ("png", "pdf")]
        for target in written:
            metadata = {"CreationDate": None} if target.suffix == ".pdf" else None
            try:
                figure.savefig(target, metadata=metadata)
            except OSError as error:
                raise OutputError(f"{target}: cannot be written ({error.strerror});"
                                  " choose another folder with -o") from error
    return written


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
    axes.yaxis.set_label_coords(-0.14, 0.5)
    _collision_scale(axes, run, window)
    if hit.any():
        name = "hits, drawn\nat $10^{-17}$" if run.threshold == PLOT_LIMIT else "ticks: hits"
        axes.text(1.012, PLOT_FLOOR, name, color=HIT_COLOUR, fontsize=8, va="center",
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
            axes.text(1.012, 0.02, "hits", color=HIT_COLOUR, fontsize=8, va="center",
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
            names[place] = f"{first}\N{EN DASH}{second}"
    if len(counts) > most:
        names.append(f"{len(counts) - most} others")
    axes.set_yticks(range(len(names)), names, fontsize=7.5)
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
    axes.text(0.97, 0.07, f"{rate} collisions per sphere per unit {unit}\n"
                          f"({unit} {begin} to {end})",
              ha="right", fontsize=8, linespacing=1.1, transform=axes.transAxes)


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
        axes.text(1.012, run.threshold, f"threshold\n{_power(run.threshold)}", fontsize=8,
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
    axes.text(0, 1.155, _heading(run), transform=axes.transAxes, va="bottom", fontsize=9.5)
    if not run.collisions.complete:
        _remark(axes, "the log holds a part of the run only", y=0.9)


def _heading(run):
    parts = []
    restitution, fraction = (run.setting("system", key)
                             for key in ("restitution", "solids_volume_fraction"))
    if restitution is not None:
        parts.append(f"$e = {words.short(restitution)}$")
    parts.append(f"$N = {run.spheres}$")
    if fraction is not None:
        parts.append(rf"$\phi = {words.short(fraction)}$")
    window = run.arrest.get("window")
    among = f" (window {words.grouped(window)} collisions)" if window else ""
    heading = ",  ".join(parts) + f";  verdict: $\\bf{{{run.verdict}}}${among}"
    return heading.replace(words.SPACE, " ")  # mathtext has no no-break space


def marks(run):
    """The collisions worth a line: [(collision number, label)], ascending.

    The last hit is left out where the arrest makes it meaningless.
    """
    found, hits = [], run.separation
    if hits["first_collision"] is not None:
        number = hits["first_collision"]
        found.append((number, f"first hit {words.grouped(number)}\n"
                              f"({words.short(words.per_sphere(run, number), 3)} per sphere)"))
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
                      xytext=(place, 1.035), textcoords="axes fraction", ha="center", va="bottom",
                      fontsize=8, linespacing=1.1, color=MARK_COLOUR, annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": MARK_COLOUR, "linewidth": 0.7,
                                  "shrinkA": 0, "shrinkB": 0, "relpos": (0.5, 0)})
    if not inside:
        state = ("no hit and no arrest in the run" if run.separation["first_collision"] is None
                 else "first hit, last hit and arrest lie outside this window")
        axes.text(0, 1.035, state, transform=axes.transAxes, va="bottom", fontsize=8,
                  color=MARK_COLOUR)


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
    axes.text(0.5, y, text, transform=axes.transAxes, ha="center", fontsize=9, style="italic",
              bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 2})
