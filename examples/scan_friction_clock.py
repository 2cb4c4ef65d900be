#!/usr/bin/python3
"""How far the clock of the paper's case at e = 0.6 comes when its spheres are rough: strain against
collisions, for several coefficients of friction with beta0 = 0.5.

Usage: scan_friction_clock.py [FIGURE.png] [COLLISIONS]      default 1e6, about half a minute
"""

import sys

import scanning

CASE = "shear-e06"
FRICTIONS = (0, 0.01, 0.03, 0.1, 1)
FIRST = 1000
A_DECADE = 8


def limits(last):
    """Numbers of collisions at which the clock is read, ascending, `last` the last one."""
    numbers = []
    while FIRST * 10**(len(numbers) / A_DECADE) < 0.999 * last:
        numbers.append(round(FIRST * 10**(len(numbers) / A_DECADE)))
    return [*numbers, int(last)]


def clock(friction, last):
    """Collisions, strains and hits of one run, as far as it comes."""
    changes = {"collision.tangential_restitution": 0.5, "collision.friction": friction,
               "measure.after_time": 0, "output.collision_log": "none"}
    runs = scanning.stages(CASE, changes, "run.collisions", limits(last))
    return {"collisions": [run["collisions"] for run in runs],
            "strain": [run["strain"] for run in runs],
            "hits": [run["separation"]["hits"] for run in runs], "verdict": runs[-1]["verdict"]}


def row(friction, told):
    """One line of the Markdown table."""
    return (f"| {friction:g} | {told['verdict']} | {told['hits'][-1]} | {told['collisions'][-1]} |"
            f" {told['strain'][-1]:.6g} |")


def draw(clocks, path):
    """Strain against collisions, both as logarithms; a straight line is a flow."""
    with scanning.drawn(path) as axes:
        for (friction, told), style in zip(clocks.items(), ("-", "--", "-.", ":", (0, (5, 1, 1, 1)))):
            axes.plot(told["collisions"], told["strain"], linestyle=style,
                      label=rf"$\mu = {friction:g}$")
        axes.set(xscale="log", yscale="log", xlabel="collisions", ylabel="strain")
        axes.legend()


def main(path=None, last=1e6):
    """Prints a row for each friction, and draws the figure if a file is named."""
    print("| mu | verdict | hits | collisions | strain |\n|---|---|---|---|---|")
    clocks = {}
    for friction in FRICTIONS:
        clocks[friction] = clock(friction, float(last))
        print(row(friction, clocks[friction]), flush=True)
    if path:
        draw(clocks, path)


if __name__ == "__main__":
    main(*sys.argv[1:3])
