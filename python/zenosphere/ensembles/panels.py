"""Draws the panels of an ensemble: probabilities, maps, and where they cross one half."""

import numpy as np
from matplotlib.lines import Line2D

from ..drawing import words
from ..drawing.pictures import COLOURS, INK, points
from .proportions import fraction, wilson_interval

MARKERS = "osD^vPX"
MAP = "cividis"  # even in lightness for every kind of colour vision
NAMES = {  # symbol, and name with its unit
    "system.restitution": ("$e$", "Restitution $e$"),
    "system.solids_volume_fraction": (r"$\phi$", r"Solids volume fraction $\phi$"),
    "system.spheres": ("$N$", "Number of spheres $N$"),
    "drive.shear_rate": (r"$\dot\gamma$", r"Shear rate $\dot\gamma$ (1/time unit)"),
    "start.granular_temperature": (
        "$T_0$", "Granular temperature $T_0$ of the start (diameters/time unit)$^2$"),
    "walls.restitution": (r"$e_\mathrm{wall}$", r"Restitution of the walls $e_\mathrm{wall}$"),
    "collision.contact_duration": ("$t_c$", "Contact duration $t_c$ (time units)"),
    "collapse.gap_threshold": ("threshold", "Gap threshold (diameters)"),
    "collapse.window": ("window", "Window of the arrest (collisions)"),
}
HOLLOW = "hollow: P does not cross 1/2 in the range"
TITLES = {"separation": "separation criterion met", "arrest": "arrest criterion met",
          "false positive": "met, and left or still met", "open": "met, and still met at the end"}


def symbol(key):
    """Short name of a key: its symbol, or its last word."""
    return NAMES.get(key, (key.split(".")[-1].replace("_", " "),))[0]


def label(key):
    """Name of a key on an axis."""
    return NAMES.get(key, ("", key))[1]


def styles(count):
    """(colour, marker) of so many series."""
    return [(COLOURS[number % len(COLOURS)], MARKERS[number % len(MARKERS)])
            for number in range(count)]


def said(key, value):
    """`e = 0.2`."""
    number = words.short(value) if not isinstance(value, int) else words.grouped(value)
    return f"{symbol(key)} = {number.replace(words.SPACE, ' ')}"


def probability(axes, x, met, done, style, shift=0.0):
    """P with its 95 % interval against x, one series.

    x: (K);  met, done: (K) counts;  style: (colour, marker);  shift: of x, so that bars of
    neighbouring series stay apart
    """
    low, high = wilson_interval(met, done)
    p = fraction(met, done)
    known = done > 0
    axes.errorbar(x[known] + shift, p[known], yerr=_bars(p, low, high)[:, known], color=style[0],
                  marker=style[1], markersize=3.6, linewidth=0.8, elinewidth=0.7, capsize=1.5,
                  markeredgewidth=0, clip_on=False, zorder=3)
    axes.set_ylim(0, 1)


def _bars(p, low, high):
    return np.maximum([p - low, high - p], 0)


def outer_labels(axes, shape, place, x_label, y_label):
    """Labels and numbers at the left and bottom of the grid only."""
    if place[0] == shape[0] - 1:
        axes.set_xlabel(x_label)
    else:
        axes.tick_params(labelbottom=False)
    if place[1] == 0:
        axes.set_ylabel(y_label, fontsize=points(9))
    else:
        axes.tick_params(labelleft=False)


def boundary(axes, values, crossings, style, span, shift=1.0):
    """The place of the crossing against another key, with its interval; hollow marks at the end of
    the range where P stays on one side of 1/2.

    values: (K);  crossings: K of Crossing;  style: (colour, marker)
    span: (where it must lie if P is below 1/2 in the whole range, where if above), two ends of x
    shift: factor of the values, so that bars of neighbouring series stay apart
    """
    first, last = min(span), max(span)
    known = [(value * shift, each) for value, each in zip(values, crossings)
             if each.place is not None]
    if known:
        place = np.array([each.place for _, each in known])
        low = np.array([first if each.low is None else each.low for _, each in known])
        high = np.array([last if each.high is None else each.high for _, each in known])
        axes.errorbar([value for value, _ in known], place, yerr=_bars(place, low, high),
                      color=style[0], marker=style[1], markersize=4, linewidth=0.8, elinewidth=0.8,
                      capsize=2, markeredgewidth=0, zorder=3)
    for value, each in zip(values, crossings):
        if is_outside(each):
            axes.plot(value * shift, span[each.how == "above"], style[1], color=style[0],
                      markerfacecolor="white", markersize=4, clip_on=False, zorder=4)


def is_outside(crossing):
    """Whether P is on one side of 1/2 in the whole range: a hollow mark."""
    return crossing.how in ("below", "above")


def series_handles(key, values, has_hollow=False):
    """For a legend: which colour and marker is which value of a key, and what a hollow mark is."""
    handles = [Line2D([], [], color=colour, marker=marker, markersize=4, linewidth=0.8,
                      markeredgewidth=0, label=said(key, value))
               for value, (colour, marker) in zip(values, styles(len(values)))] if key else []
    if has_hollow:
        handles.append(Line2D([], [], color=INK, marker="o", markersize=4, linewidth=0,
                              markerfacecolor="white", label=HOLLOW))
    return handles
