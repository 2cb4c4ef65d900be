"""Draws one panel of the anatomy of a collapse."""

import numpy as np
from matplotlib.patches import Circle
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator

from ..drawing import words
from ..drawing.pictures import HIT_COLOUR, INK, MARK_COLOUR, above, points
from .dissection import QUANTITIES, plane_of

LABELS = {"gap": "Gap closed\n(diameters)", "normal_speed": "Closing speed\n(diameters/time unit)",
          "flight": "Flight\n(time units)"}
COLOURS = {"gap": INK, "normal_speed": HIT_COLOUR, "flight": MARK_COLOUR}
MARKS = {"gap": "o", "normal_speed": "^", "flight": "s"}
IN_CURVES, IN_RASTER = 400, 90  # most collisions of the cluster shown
FITTED = 64  # last collisions that a factor is measured on
LEAST_A_PAIR, LARGEST_MISS = 3, 0.2  # of a decay that is drawn as a line: see decay_holds
LONGEST_LABEL = 8.5  # its length over the size of its letters
LEAST_NAME = 4.0  # points: smaller numbers of spheres are left out


def decay(column, run, which):
    """Gap, closing speed and flight of each collision of the cluster, on logarithmic scales.

    column: three axes, from above;  which: "hit" or "arrest", as in the other panels
    """
    found = run.dissection(which)
    place, rows = _shown(found, which, IN_CURVES)
    size = float(np.clip(40 / np.sqrt(len(place) + 1), 1.5, 3.5))
    for axes, quantity in zip(column, QUANTITIES):
        values, seen, fitted = _measured(found, quantity, rows)
        axes.plot(place[seen], values[seen], MARKS[quantity], color=COLOURS[quantity],
                  markersize=size, markeredgewidth=0)
        if decay_holds(place[fitted], values[fitted], _pairs(rows, fitted), found.ratio(quantity)):
            _slope(axes, place[fitted], values[fitted], found.ratio(quantity), COLOURS[quantity])
            said = rf"$\times\,{words.short(found.ratio(quantity))}$ per collision"
        else:
            said = "no steady factor" if fitted.size else "not measured"
        _log_scale(axes, values[seen])
        axes.set_ylabel(LABELS[quantity], fontsize=_label_size(axes))
        axes.text(0.02, 0.06, said + _exact(found, quantity), transform=axes.transAxes,
                  fontsize=points(8.5))
    column[-1].set_xlabel(_place_name(which))
    column[-1].xaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
    _heading(column[0], run, found, which)


def decay_holds(place, values, pairs, ratio):
    """Whether a geometric decay describes the values it was measured on.

    It does where nine of ten values lie within a fifth of the line's whole fall (in logarithms)
    from it, the line being moved up or down for each pair, and there are three values a pair.
    place: (n) collisions;  values: (n) > 0;  pairs: (n) which pair each belongs to
    ratio: factor per collision, NaN where none could be measured
    """
    names = np.unique(pairs)
    if not np.isfinite(ratio) or len(values) < max(LEAST_A_PAIR * len(names), 1):
        return False
    off = np.log(values) - place * np.log(ratio)
    for name in names:
        off[pairs == name] -= np.median(off[pairs == name])
    return np.quantile(np.abs(off), 0.9) <= LARGEST_MISS * abs(np.log(ratio)) * np.ptp(place)


def cluster(axes, run, which):
    """The spheres of the first cluster in the plane in which it is widest, with their contacts."""
    found = run.dissection(which)
    first = found.cluster == 0
    spheres, places = found.sphere[first], plane_of(found.position[first])
    at, size = dict(zip(spheres.tolist(), places)), _name_size(places)
    for sphere, place in at.items():
        face = "#e8eef5" if sphere in found.chain else "white"
        axes.add_patch(Circle(place, 0.5, facecolor=face, edgecolor=INK, linewidth=0.7))
        if size > LEAST_NAME:  # on a ground that keeps the lines of the contacts off the number
            axes.text(*place, str(sphere), fontsize=size, ha="center", va="center", zorder=4,
                      bbox={"boxstyle": "round,pad=0.15", "facecolor": face, "edgecolor": "none"})
    for i, j, collisions in _contacts(found):
        if j in at:
            line = np.array([at[i], at[j]])
            axes.plot(*line.T, color=HIT_COLOUR, linewidth=0.6 + 0.25 * np.log(1 + collisions),
                      alpha=0.45, solid_capstyle="round")
    low, high = places.min(axis=0) - 0.7, places.max(axis=0) + 0.7
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("Along the cluster (diameters)")
    axes.set_ylabel("Across (diameters)")
    _heading(axes, run, found, which)


def raster(axes, run, which):
    """Which pair of the cluster collides: one row a pair, in the order of the chain."""
    found = run.dissection(which)
    place, rows = _shown(found, which, IN_RASTER)
    pairs = _ordered_pairs(found, set(zip(rows["i"].tolist(), rows["j"].tolist())))
    row = [pairs.index(pair) for pair in zip(rows["i"].tolist(), rows["j"].tolist())]
    axes.plot(place, row, "-", color="0.8", linewidth=0.6, zorder=1)
    axes.plot(place, row, "|", color=INK, markersize=7, markeredgewidth=1.1, zorder=2)
    names = [words.pair(run, *pair) for pair in pairs]
    axes.set_yticks(range(len(pairs)), names, fontsize=points(min(8, 110 / max(len(pairs), 1))))
    axes.set_ylim(len(pairs) - 0.4, -0.6)
    axes.set_xlabel(_place_name(which))
    axes.xaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0f}".replace(
        "-", "\N{MINUS SIGN}")))
    axes.set_ylabel("Pair that collides")
    _heading(axes, run, found, which)


def _shown(found, which, most):
    """Places and rows of the collisions to show: before the hit, or about where the clock stopped.

    Returns int64 (s), 0 at the hit or at the last collision that moved the clock, and the columns.
    """
    count = len(found.collisions["k"])
    moved = np.flatnonzero(found.collisions["flight"] > 0)
    zero = moved[-1] if which == "arrest" and moved.size else count - 1
    end = min(count, zero + most // 6 + 1)
    rows = {name: values[max(0, end - most):end] for name, values in found.collisions.items()}
    return np.arange(max(0, end - most), end) - zero, rows


def _counts(quantity, rows, resolution):
    """Where a quantity is far enough above rounding to be measured; a speed by the other two."""
    with np.errstate(invalid="ignore"):
        measured = {name: rows[name] > resolution for name in ("gap", "flight")}
    return measured.get(quantity, measured["gap"] | measured["flight"])


def _place_name(which):
    return "Collisions of the cluster, counted from " + (
        "the first hit" if which == "hit" else "where the clock stopped")


def _measured(found, quantity, rows):
    """Values of a quantity, which of them can be drawn, and the places of those that count."""
    values = rows[quantity]
    seen = np.isfinite(values) & (values > 0)
    counts = _counts(quantity, rows, found.attributes["resolution"])
    return values, seen, np.flatnonzero(seen & counts)[-FITTED:]


def _pairs(rows, chosen):
    """Which pair each of the chosen rows belongs to, int64."""
    return rows["i"][chosen].astype(np.int64) << 32 | rows["j"][chosen].astype(np.int64)


def _exact(found, quantity):
    ratio = found.exact_ratio(quantity)
    chain = rf"   (straight chain of {len(found.chain)}: $\times\,{words.short(ratio)}$)"
    return chain if np.isfinite(ratio) else ""


def _label_size(axes):
    """Points in which the longest label is about as long as a panel is high, 5 or more."""
    height = axes.get_position().height * axes.figure.get_figheight() * 72
    return max(min(points(9), height / LONGEST_LABEL), 5)


def _log_scale(axes, values):
    """Few decades, and room below for the factor."""
    axes.set_yscale("log")
    if values.size:
        low, high = values.min(), values.max()
        room = max(np.log10(high / low), 1)
        axes.set_ylim(low / 10 ** (0.35 * room), high * 10 ** (0.1 * room))
    axes.yaxis.set_major_locator(LogLocator(numticks=6))
    axes.yaxis.set_minor_locator(NullLocator())


def _slope(axes, place, values, ratio, color):
    """The geometric decay through the middle of the values it was measured on."""
    if not np.isfinite(ratio) or not len(place):
        return
    height = np.median(np.log(values) - place * np.log(ratio))
    axes.plot(place, np.exp(height + place * np.log(ratio)), color=color, linewidth=0.9, alpha=0.8)


def _contacts(found):
    """(i, j, collisions) of the first cluster; j may be a wall."""
    own = found.contacts["cluster"] == 0
    return [tuple(int(found.contacts[name][n]) for name in ("i", "j", "collisions"))
            for n in np.flatnonzero(own)]


def _ordered_pairs(found, seen):
    """The pairs along the chain first, then the others that were seen."""
    chain = [tuple(sorted(pair)) for pair in zip(found.chain.tolist(), found.chain[1:].tolist())]
    return [pair for pair in chain if pair in seen] + sorted(seen - set(chain))


def _name_size(places):
    """Points in which a number fits a sphere."""
    extent = max(float(np.ptp(places, axis=0).max()) + 1.4, 3)
    return min(66 / extent, 9.0)


def _moment_name(which):
    return "first hit" if which == "hit" else "arrest"


def _heading(axes, run, found, which):
    first = int((found.cluster == 0).sum())
    others = len(found.straightness) - 1
    parts = words.restitutions(run) + [f"$N = {run.spheres}$", f"cluster of {first}"]
    if len(found.chain) > 2:
        parts.append(f"chain of {len(found.chain)}, straightness {found.straightness[0]:.4f}")
    if others:
        parts.append(f"{others} other cluster" + ("s" if others > 1 else ""))
    above(axes, ", ".join(parts), 18, fontsize=points(9))
    above(axes, f"{_moment_name(which)}: collision {words.grouped(found.collision)}, time"
                f" {words.short(found.time, digits=8)}; verdict: {run.verdict}", 5,
          fontsize=points(8), color=MARK_COLOUR)
