"""Draws one panel of the anatomy of a collapse."""

import numpy as np
from matplotlib.patches import Circle
from matplotlib.ticker import FuncFormatter, MaxNLocator

from . import words
from .dissection import QUANTITIES, plane_of
from .panels import HIT_COLOUR, INK, MARK_COLOUR

LABELS = {"gap": ("gap closed", "gap"), "normal_speed": ("closing speed", "speed"),
          "flight": ("flight", "flight")}
COLOURS = {"gap": INK, "normal_speed": HIT_COLOUR, "flight": MARK_COLOUR}
MARKS = {"gap": "o", "normal_speed": "^", "flight": "s"}
IN_CURVES, IN_RASTER = 400, 90  # most collisions of the cluster shown
FITTED = 64  # last collisions that a factor is measured on
LEAST_NAME = 4.0  # points: smaller numbers of spheres are left out


def decay(axes, run, which):
    """Gap, closing speed and flight of each collision of the cluster, on a logarithmic scale.

    which: "hit" or "arrest", as in the other panels
    """
    found = run.dissection(which)
    place, rows = _shown(found, which, IN_CURVES)
    size = float(np.clip(40 / np.sqrt(len(place) + 1), 1.5, 3.5))
    for quantity in QUANTITIES:
        values = rows[quantity]
        seen = np.isfinite(values) & (values > 0)
        axes.plot(place[seen], values[seen], MARKS[quantity], color=COLOURS[quantity],
                  markersize=size, markeredgewidth=0, label=_factor(found, quantity))
        counts = _counts(quantity, rows, found.attributes["resolution"])
        fitted = np.flatnonzero(seen & counts)[-FITTED:]
        _slope(axes, place[fitted], values[fitted], found.ratio(quantity), COLOURS[quantity])
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    axes.set_ylim(low * (low / high) ** 0.4, high)  # room for the legend
    axes.set_xlabel(_place_name(which))
    axes.set_ylabel("In diameters, time unit of the case")
    axes.xaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
    axes.legend(loc="lower left", title=_legend_title(found), title_fontsize=8,
                alignment="left", handletextpad=0.2)
    _heading(axes, run, found, which)


def cluster(axes, run, which):
    """The spheres of the first cluster in the plane in which it is widest, with their contacts."""
    found = run.dissection(which)
    first = found.cluster == 0
    spheres, places = found.sphere[first], plane_of(found.position[first])
    at, size = dict(zip(spheres.tolist(), places)), _name_size(places)
    for sphere, place in at.items():
        inside = sphere in found.chain
        axes.add_patch(Circle(place, 0.5, facecolor="#e8eef5" if inside else "white",
                              edgecolor=INK, linewidth=0.7))
        if size > LEAST_NAME:
            axes.text(*place, str(sphere), fontsize=size, ha="center", va="center")
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
    names = [_pair_name(pair, run.spheres) for pair in pairs]
    axes.set_yticks(range(len(pairs)), names, fontsize=min(8, 110 / max(len(pairs), 1)))
    axes.set_ylim(len(pairs) - 0.4, -0.6)
    axes.set_xlabel(_place_name(which))
    axes.xaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.0f}"))
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
    return "Collisions of the cluster, from " + (
        "the first hit on" if which == "hit" else "where the clock stopped")


def _factor(found, quantity):
    name, short = LABELS[quantity]
    ratio, exact = found.ratio(quantity), found.exact_ratio(quantity)
    if not np.isfinite(ratio):
        return name
    text = rf"{name}  $\times\,{words.short(ratio)}$"
    return text + (f"  ({words.short(exact)})" if np.isfinite(exact) else "")


def _legend_title(found):
    if not np.isfinite(found.ratio("normal_speed")):
        return None
    exact = np.isfinite(found.exact_ratio("gap"))
    chain = f" (straight chain of {len(found.chain)})" if exact else ""
    return f"factor per collision{chain}"


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


def _pair_name(pair, spheres):
    first, second = pair
    return f"{first}\N{EN DASH}{second}" if second < spheres else (
        f"{first}\N{EN DASH}{'lower' if second == spheres else 'upper'} wall")


def _name_size(places):
    """Points in which a number fits a sphere."""
    extent = max(float(np.ptp(places, axis=0).max()) + 1.4, 3)
    return min(66 / extent, 9.0)


def _moment_name(which):
    return "first hit" if which == "hit" else "arrest"


def _heading(axes, run, found, which):
    restitution = run.setting("system", "restitution")
    parts = [] if restitution is None else [f"$e = {words.short(restitution)}$"]
    first = int((found.cluster == 0).sum())
    others = len(found.straightness) - 1
    parts += [f"$N = {run.spheres}$", f"cluster of {first}"]
    if len(found.chain) > 2:
        parts.append(f"chain of {len(found.chain)}, straightness {found.straightness[0]:.4f}")
    if others:
        parts.append(f"{others} other cluster" + ("s" if others > 1 else ""))
    axes.text(0, 1.10, ", ".join(parts), transform=axes.transAxes, va="bottom", fontsize=9)
    axes.text(0, 1.03, f"{_moment_name(which)}: collision {words.grouped(found.collision)},"
                       f" time {words.short(found.time, digits=8)}; verdict: {run.verdict}",
              transform=axes.transAxes, va="bottom", fontsize=8, color=MARK_COLOUR)
