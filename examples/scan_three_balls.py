#!/usr/bin/python3
"""Scans the restitution of three balls about the threshold below which their collapse is stable.

On a line three balls collapse for e < 7 - 4 sqrt(3) = 0.0718. A sideways speed d pushes them
apart: its effect, d^2, changes by the factor g(e) from one collision to the next, and g = 1 at
e = 9 - 4 sqrt(5) = 0.0557. In double some twenty collisions fit in before the gaps are below 1e-16,
so that below g = 1 no run can go on for ever; measured is g itself: the largest d with which n
collisions still happen falls as g^(-n/2).
Source: Zhou & Kadanoff, Phys. Rev. E 54 (1996) 623.

Usage: scan_three_balls.py [FIGURE.png]
"""

import sys

import numpy as np

import scanning

CASE = "zhou-kadanoff-1996-three-balls"
LINE, STABLE = 7 - 4 * np.sqrt(3), 9 - 4 * np.sqrt(5)
SIDEWAYS = np.geomspace(0.1, 1e-5, 60)  # speeds; the first ball comes with the speed 1
COUNTS = np.arange(8, 20)  # after the start is forgotten, before rounding is felt
RESTITUTION = (0.05, 0.052, 0.054, 0.056, 0.058, 0.060, 0.062, 0.064, 0.066, 0.068)
GROWING = 0.06  # from here on d^2 grows enough within 20 collisions to be told from a constant


def start(dimension, sideways, direction=None):
    """Three balls on a line, the second with a sideways speed, in 3-D the third too, across.

    direction: of the line, (dimension) of length 1, default x; sideways must be 0 with another one
    """
    along = np.eye(dimension)[0] if direction is None else np.asarray(direction)
    velocities = np.outer((1, 0, 0.125), along)
    velocities[1, 1] += sideways
    velocities[2, -1] += sideways if dimension == 3 else 0
    return {"system.dimension": dimension, "system.sides": [100] * dimension,
            "start.positions": (10 + np.outer((0, 1, 3), along)).tolist(),
            "start.velocities": velocities.tolist(), "run.collisions": 2000, "run.time": 50}


def growth(restitution):
    """ln g: of the effect of a sideways speed, per collision.

    On the line each collision multiplies relative speeds by a and gaps by b, the roots of
    x^2 - (1 + e) x / 2 + e; the push is d^2 times a flight, which changes by b / a, and counts
    relative to the speeds: g = b / a^2.
    """
    half = (1 + np.asarray(restitution)) / 4
    root = np.sqrt(half**2 - restitution)
    return np.log((half - root) / (half + root) ** 2)


def measured_growth(collisions):
    """ln g from the number of collisions at each of SIDEWAYS, int (60)."""
    largest = [SIDEWAYS[collisions >= count].max() for count in COUNTS]
    return -np.polyfit(COUNTS, 2 * np.log(largest), 1)[0]


def zero_of(restitution, rates):
    """Where ln g is zero: e as a straight line and as a parabola in ln g, through the rates."""
    return tuple(np.polyfit(rates, restitution, degree)[-1] for degree in (1, 2))


def scan(dimension):
    """ln g of each of RESTITUTION, float64."""
    rates = []
    for restitution in RESTITUTION:
        collisions = [scanning.summary(CASE, start(dimension, sideways) | {
            "system.restitution": restitution})["collisions"] for sideways in SIDEWAYS]
        rates.append(measured_growth(np.array(collisions)))
    return np.array(rates)


def draw(scans, path):
    """ln g against e, measured in 2-D and 3-D, and exact."""
    with scanning.drawn(path) as axes:
        fine = np.linspace(0.049, LINE - 1e-6, 400)
        axes.plot(fine, growth(fine), color="black", linewidth=1, label="exact")
        for (dimension, rates), marker in zip(scans.items(), "os"):
            axes.plot(RESTITUTION, rates, marker, markersize=4, label=f"{dimension}-D, measured")
        axes.axhline(0, color="grey", linewidth=0.6)
        for place, text in ((STABLE, r"$9-4\sqrt{5}$ "), (LINE, r"$7-4\sqrt{3}$ ")):
            axes.axvline(place, color="grey", linewidth=0.8, linestyle="--")
            axes.text(place, -0.3, text, ha="right", fontsize=8)
        axes.set(xlabel="restitution $e$", ylabel="growth per collision, ln $g$",
                 xlim=(0.049, 0.0725), ylim=(-0.35, 1.2))
        axes.legend(loc="upper left")


def main():
    """Prints the growth at each restitution and the two thresholds, and draws the figure."""
    scans = {dimension: scan(dimension) for dimension in (2, 3)}
    print("e      ln g exact   2-D     3-D")
    for restitution, two, three in zip(RESTITUTION, scans[2], scans[3]):
        print(f"{restitution:.3f}  {growth(restitution):+.3f}       {two:+.3f}  {three:+.3f}")
    growing = np.array(RESTITUTION) >= GROWING
    for dimension, rates in scans.items():
        line, parabola = zero_of(np.array(RESTITUTION)[growing], rates[growing])
        print(f"{dimension}-D: ln g = 0 at e = {line:.4f} by a straight line through"
              f" e >= {GROWING}, {parabola:.4f} by a parabola (exact {STABLE:.4f})")
    for dimension in (2, 3):
        for name, direction in (("x", None), ("diagonal", np.full(dimension, dimension**-0.5))):
            found = scanning.largest_restitution_with_a_hit(
                CASE, start(dimension, 0, direction), 0.06, 0.09, steps=20)
            print(f"{dimension}-D, exact line along {name}: separation criterion met up to"
                  f" e = {found:.5f} (exact {LINE:.5f}, {found / LINE - 1:+.2%})")
    if len(sys.argv) > 1:
        draw(scans, sys.argv[1])


if __name__ == "__main__":
    main()
