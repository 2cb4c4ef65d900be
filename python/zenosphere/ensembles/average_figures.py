"""Draws the averages of an ensemble with their errors, beside kinetic theory where there is one."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, StrMethodFormatter

from ..drawing.pictures import COLOURS, INK, points
from ..errors import InputError
from . import panels

LABELS = {  # name on an axis
    "granular_temperature": "$T$", "pressure": "$p$", "shear_stress": "$-P_{xy}$",
    "n1": "$(P_{xx}-P_{yy})/p$", "n2": "$(P_{yy}-P_{zz})/p$", "sonine_a2": "$a_2$",
    "collision_rate": r"$\omega$", "compressibility_factor": "$Z$"}
SHEARED = ("granular_temperature", "pressure", "shear_stress", "n1", "n2", "sonine_a2",
           "collision_rate")
AT_REST = ("granular_temperature", "pressure", "compressibility_factor", "sonine_a2",
           "collision_rate")
POWERS = {"granular_temperature": 2, "pressure": 2, "shear_stress": 2, "collision_rate": 1}
ANISOTROPIC, NAVIER_STOKES = ("kinetic theory, anisotropic Maxwellian",
                              "kinetic theory, Navier-Stokes order")
THEORIES = {ANISOTROPIC: "-", NAVIER_STOKES: ":"}
CURVE = 40  # points of a theory's curve


def draw_averages(part, heading, figure_grid, styles, pictures):
    """A row for each average, a column for each y, a series for each third key; None without any.

    part: Slice;  figure_grid: makes the figure;  styles: of the series
    """
    flow = part.ensemble.shear_flow
    shown = [name for name in (AT_REST if flow is None else SHEARED) if part.averages.known(name)]
    if not shown:
        return None
    x_key, x = part.axis("x")
    y_key, columns = part.axis("y")
    x = np.array(x, dtype=float)
    curves = [theory_curves(part, fraction) for fraction in columns]
    handles = panels.series_handles(*part.axis("series")) + [
        Line2D([], [], color=INK, linestyle=THEORIES[name], linewidth=0.9, label=name)
        for name in THEORIES if any(name in each for each in curves)]
    figure, grid = figure_grid(pictures, heading, len(shown), len(columns), (1.9, 1.25), handles)
    for (row, column), axes in np.ndenumerate(grid):
        _draw_theories(axes, shown[row], curves[column])
        means = part.averages.means(shown[row])
        for number, style in enumerate(styles):
            place = (slice(None), column, number)
            _draw_means(axes, x, means, part.averages.any_steady, place, style)
        values = means.value[np.isfinite(means.value)]
        if shown[row] in POWERS and values.min() > 0 and values.max() > 3 * values.min():
            _log_scale(axes)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
        panels.outer_labels(axes, grid.shape, (row, column), panels.label(x_key),
                            LABELS[shown[row]])
        axes.tick_params(labelleft=True)
        if row == 0 and y_key:
            axes.set_title(panels.said(y_key, columns[column]), fontsize=points(9))
    return figure


def _log_scale(axes):
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def _draw_means(axes, x, means, any_steady, place, style):
    """Points with their errors; hollow where no run was steady."""
    for steady, face in ((True, style[0]), (False, "none")):
        drawn = np.isfinite(means.value[place]) & (any_steady[place] == steady)
        axes.errorbar(x[drawn], means.value[place][drawn], yerr=means.error[place][drawn],
                      color=style[0], marker=style[1], markersize=3.2, linewidth=0,
                      elinewidth=0.8, capsize=1.5, markerfacecolor=face, markeredgewidth=0.6,
                      zorder=3)


def theory_curves(part, fraction):
    """{theory: (x, list of ShearFlow)} at a solids volume fraction; empty where none applies.

    Theory is that of smooth spheres of one kind in three dimensions, against the restitution.
    """
    flow = part.ensemble.shear_flow
    x_key, x = part.axis("x")
    if flow is None or not flow["has_theory"] or x_key != "system.restitution":
        return {}
    fraction = fraction if part.axis("y")[0] else flow["solids_volume_fraction"]
    if part.axis("y")[0] not in (None, "system.solids_volume_fraction") or fraction is None:
        return {}
    span = np.linspace(min(x), min(max(x), 0.999), CURVE)
    try:
        return {name: (span, [solve(e, fraction) for e in span])
                for name, solve in _solvers().items()}
    except InputError:
        return {}


def _solvers():
    """What solves each of the theories: only where curves are drawn, since it reads SciPy."""
    from ..rheology.anisotropic import anisotropic_flow
    from ..rheology.navier_stokes import navier_stokes_flow
    return {ANISOTROPIC: anisotropic_flow, NAVIER_STOKES: navier_stokes_flow}


def _draw_theories(axes, name, curves):
    for theory, (span, flows) in curves.items():
        values = np.array([getattr(flow, name, np.nan) for flow in flows])
        if np.isfinite(values).any():
            axes.plot(span, values, THEORIES[theory], color=INK, linewidth=0.9, zorder=2)
