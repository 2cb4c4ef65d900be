"""The figure and the tables of docs/performance.md."""

import matplotlib
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

import grid
from programs import OURS, BenchError

BEGIN, END = "<!-- made by bench/performance -->", "<!-- end -->"
# Okabe & Ito's palette, distinct to every kind of colour vision.
COLOURS = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00"]
MARKERS = "osD^vP"
STYLE = {"font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 10,
         "axes.linewidth": 0.7, "xtick.direction": "in", "ytick.direction": "in",
         "xtick.top": True, "ytick.right": True, "legend.fontsize": 8, "legend.frameon": False}


def draw(table, path):
    """Speed against N (above) and phi (below), elastic (left) and sheared (right)."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(7.2, 5.6), dpi=200, layout="constrained")
        panels = figure.subplots(2, 2, sharey=True, sharex="row")
        for column, flow in enumerate(grid.FLOWS):
            _against_spheres(panels[0][column], table, flow)
            _against_fraction(panels[1][column], table, flow)
            panels[0][column].set_title(flow + (", e = 0.9" if flow == "sheared" else ""))
        for row in panels:
            row[0].set_ylabel("million collisions per second")
        for axes in panels.flat:
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axes.grid(alpha=0.25, linewidth=0.5)
        panels[1][1].legend(*panels[0][0].get_legend_handles_labels(), loc="center")
        figure.savefig(path, metadata={"Software": None})


def _curve(axes, table, program, places, **style):
    """places: (x, state) of the points of a curve; those not measured are left out."""
    points = [(x, rate / 1e6) for x, state in places if (rate := table.rate(program, state))]
    if points:
        axes.plot(*zip(*points), **style)


def _style(table, program):
    place = table.programs().index(program) % len(COLOURS)
    return {"color": COLOURS[place], "marker": MARKERS[place], "markersize": 4,
            "linewidth": 1.8 if program == OURS else 1, "label": program}


def _against_spheres(axes, table, flow):
    for fraction in grid.FRACTIONS:
        places = [(n, grid.state_of(flow, n, fraction)) for n in grid.SPHERES]
        if fraction != grid.CUT_FRACTION:
            _curve(axes, table, OURS, places, color="0.6", linewidth=0.7)
            continue
        for program in table.programs():
            _curve(axes, table, program, places, **_style(table, program))
    axes.set_xscale("log")
    axes.set_xlabel(f"spheres, at $\\phi$ = {grid.CUT_FRACTION}"
                    " (grey: Zenosphere at other $\\phi$)")


def _against_fraction(axes, table, flow):
    places = [(phi, grid.state_of(flow, grid.CUT_SPHERES, phi)) for phi in grid.FRACTIONS]
    for program in table.programs():
        _curve(axes, table, program, places, **_style(table, program))
    axes.set_xlabel(f"solids volume fraction, at N = {grid.CUT_SPHERES}")


def tables(table):
    """Markdown: all programs along the two cuts, then Zenosphere on the whole grid."""
    peers = [name for name in table.programs() if name != OURS]
    columns = [(flow, name) for flow in grid.FLOWS for name in [OURS, *peers]]
    cuts = [("N, at phi = 0.3", [(n, grid.CUT_FRACTION) for n in grid.SPHERES], 0),
            ("phi, at N = 4000", [(grid.CUT_SPHERES, phi) for phi in grid.FRACTIONS], 1)]
    text = []
    for title, places, which in cuts:
        rows = [[str(place[which])] + [_cell(table, name, flow, place) for flow, name in columns]
                for place in places]
        heads = [title] + [f"{name}, {flow}" for flow, name in columns]
        text.append(_markdown(*_without_empty_columns(heads, rows)))
    columns = [(flow, phi) for flow in grid.FLOWS for phi in grid.FRACTIONS]
    rows = [[str(n)] + [_cell(table, OURS, flow, (n, phi)) for flow, phi in columns]
            for n in grid.SPHERES]
    text.append(_markdown(["Zenosphere, N"] + [f"{flow}, {phi}" for flow, phi in columns], rows))
    return "\n\n".join(text)


def _cell(table, program, flow, place):
    rate = table.rate(program, grid.state_of(flow, *place))
    return f"{rate / 1e6:#.3g}" if rate else "–"


def _without_empty_columns(heads, rows):
    kept = [k for k in range(len(heads)) if any(row[k] != "–" for row in rows)]
    return [heads[k] for k in kept], [[row[k] for k in kept] for row in rows]


def _markdown(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def replace_tables(path, text):
    """Puts the tables where the page has its marks."""
    before, _, rest = path.read_text().partition(BEGIN)
    _, end, after = rest.partition(END)
    if not end:
        raise BenchError(f"{path}: has no marks {BEGIN} and {END}; write them where the tables go")
    path.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}")
