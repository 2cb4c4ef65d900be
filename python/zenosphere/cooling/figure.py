"""Draws the granular temperature of a run against time, with Haff's law."""

import numpy as np
from matplotlib.figure import Figure

from ..drawing import words
from ..drawing.pictures import HEIGHT, HIT_COLOUR, INK, MARK_COLOUR, WIDTH, points
from ..errors import InputError
from . import law as cooling


def draw_cooling(run, path, pictures):
    """Writes the figure; returns a line that says which Haff time it shows, and the paths.

    run: RunFile with snapshots;  path: Path without suffix;  pictures: Pictures
    Raises InputError, OutputError.
    """
    time, temperature = cooling.temperature_of_snapshots(run)
    if len(time) < 3 or not temperature[0] > 0:
        raise InputError(f"{run.path}: {len(time)} snapshots, T0 = {temperature[0]:g} (needs three"
                         " or more and a start that moves); run the case again with an"
                         " output.snapshot_interval")
    haff = cooling.haff_of(run, time, temperature)
    ledger = cooling.temperature_of_collisions(run, temperature[0])
    with pictures.style():
        figure = Figure(figsize=pictures.inches(WIDTH, HEIGHT), layout="constrained")
        _panel(figure.add_subplot(), run, (time, temperature), ledger, haff)
        written = pictures.write(figure, path)
    return _said(haff, *(ledger if ledger[0].size else (time, temperature))), written


def _panel(axes, run, snapshots, ledger, haff):
    """snapshots, ledger: times and temperatures, from the velocities and from the losses."""
    time, temperature = snapshots
    shown = (time > 0) & (temperature > 0)
    first = time[shown][0] if shown.any() else 1.0
    smooth = np.geomspace(min(first, haff.tau / 30), time[-1], 300)
    axes.loglog(smooth, haff.temperature(smooth), "--", color=HIT_COLOUR, linewidth=1.1,
                label=f"{_law(haff)}, $\\tau$ = {haff.tau:.3f}"
                + (" (fitted)" if haff.is_fitted else ""))
    moment, level = ledger
    visible = (moment >= smooth[0]) & (level > 0)
    if visible.any():
        axes.plot(moment[visible], level[visible], color=INK, linewidth=0.9,
                  label="from the energy lost in collisions")
    places = _apart(time[shown])
    axes.plot(time[shown][places], temperature[shown][places], ".", color=MARK_COLOUR,
              markersize=4, label="from the snapshots")
    low = min(temperature[shown].min(), haff.temperature(time[-1]))
    axes.set_ylim(max(low, 1e-12 * haff.start) / 2, haff.start * 2)
    axes.set_xlabel("Time (time unit of the case)")
    axes.set_ylabel("Granular temperature (diameters/time unit)$^2$")
    parts = [f"$D = {run.setting('system', 'dimension')}$", *words.restitutions(run),
             f"$N = {run.spheres}$"]
    axes.set_title(f"{', '.join(parts)}; verdict: {run.verdict}", fontsize=points(9), loc="left")
    axes.legend(loc="lower left")


def _law(haff):
    return "Haff" if haff.power == 2 else "viscoelastic, $(1 + t/\\tau)^{-5/3}$"


def _apart(time, per_decade=12):
    """Indices of at most so many points a decade, float64 (T) ascending and > 0."""
    steps = np.floor(np.log10(time / time[0]) * per_decade + 1e-9)
    return np.unique(steps, return_index=True)[1]


def _said(haff, time, temperature):
    """The Haff time, and how far the law holds, in words."""
    how = "fitted to the snapshots with T > T0 / 2" if haff.is_fitted else "by formula"
    ratio = temperature / haff.temperature(time)
    off = np.flatnonzero(np.abs(ratio - 1) > 0.1)
    until = f"until t = {time[off[0]]:g}, where T / law = {ratio[off[0]]:.3g}" if off.size else (
        "in the whole run")
    return (f"tau = {haff.tau:.4g} ({how}); T within 10 % of the law {until};"
            f" T / law = {ratio[-1]:.4g} at the end, t = {time[-1]:g}")
