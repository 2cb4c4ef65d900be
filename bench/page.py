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
    """Speed against N at two fractions, and against the fraction; elastic left, sheared right."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(7.2, 7.8), dpi=200, layout="constrained")
        panels = figure.subplots(3, 2, sharey=True, sharex="row")
        for column, flow in enumerate(grid.FLOWS):
            for row, fraction in enumerate(grid.USUAL_FRACTIONS):
                _against_spheres(panels[row][column], table, flow, fraction)
            _against_fraction(panels[2][column], table, flow)
            panels[0][column].set_title(flow + (", e = 0.9" if flow == "sheared" else ""))
        for row in panels:
            row[0].set_ylabel("million collisions per second")
        for axes in panels.flat:
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axes.grid(alpha=0.25, linewidth=0.5)
        panels[2][1].legend(*panels[2][0].get_legend_handles_labels(), loc="lower right")
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


def _against_spheres(axes, table, flow, fraction):
    places = [(place[0], grid.state_of(flow, *place)) for place in grid.line_of_spheres(fraction)]
    for program in table.programs():
        _curve(axes, table, program, places, **_style(table, program))
    axes.set_xscale("log")
    axes.set_xlabel(f"spheres, at $\\phi$ = {fraction}")


def _against_fraction(axes, table, flow):
    places = [(place[1], grid.state_of(flow, *place)) for place in grid.line_of_fractions()]
    for program in table.programs():
        _curve(axes, table, program, places, **_style(table, program))
    disks = [(fraction, grid.state_of_disks(flow, fraction)) for fraction in grid.AREA_FRACTIONS]
    _curve(axes, table, OURS, disks, color="0.5", marker=".", linewidth=1, linestyle="--",
           label=OURS + ", disks")
    axes.set_xlabel(f"fraction of the volume, or of the area, at N = {grid.USUAL_SPHERES}")


def tables(table):
    """Markdown: all programs along the lines of the grid, then disks."""
    lines = [(f"phi, at N = {grid.USUAL_SPHERES}", grid.line_of_fractions(), 1)]
    lines += [(f"N, at phi = {fraction}", grid.line_of_spheres(fraction), 0)
              for fraction in grid.USUAL_FRACTIONS]
    text = [_line(table, title, places, which) for title, places, which in lines]
    rows = [[str(fraction)] + [_cell(table.rate(OURS, grid.state_of_disks(flow, fraction)), 1e6)
                               for flow in grid.FLOWS] for fraction in grid.AREA_FRACTIONS]
    heads = [f"area fraction, {grid.USUAL_SPHERES} disks"] + [f"{OURS}, {flow}"
                                                             for flow in grid.FLOWS]
    return "\n\n".join([*text, _markdown(heads, rows)])


def _line(table, title, places, which):
    """The states along a line: a column for each program, and our lead over the fastest peer."""
    peers = [name for name in table.programs() if name != OURS]
    heads = [title] + [f"{name}, elastic" for name in [OURS, *peers]] + [f"{OURS} / fastest peer"]
    heads += [f"{name}, sheared" for name in [OURS, *peers]]
    rows = []
    for place in places:
        elastic, sheared = (grid.state_of(flow, *place) for flow in grid.FLOWS)
        rows.append([str(place[which])]
                    + [_cell(table.rate(name, elastic), 1e6) for name in [OURS, *peers]]
                    + [_cell(table.lead(elastic))]
                    + [_cell(table.rate(name, sheared), 1e6) for name in [OURS, *peers]])
    return _markdown(*_without_empty_columns(heads, rows))


def _cell(number, unit=1):
    return f"{number / unit:#.3g}" if number else "–"


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
