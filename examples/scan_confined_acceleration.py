#!/usr/bin/python3
"""Measures where a randomly accelerated particle between two inelastic walls is to be found.

Below e = exp(-pi / sqrt(3)) = 0.163 its bounces accumulate (Cornell, Swift & Bray, Phys. Rev. Lett.
81 (1998) 1142), yet it is not localised at the walls: Burkhardt & Kotsev, Phys. Rev. E 70 (2004)
026105. Lengths are in sides L, times in (L^2 / noise_strength)^(1/3); kicks come at intervals, and
the white noise of the theory is the limit of short ones.

Usage: scan_confined_acceleration.py [FIGURE.png [RESULTS.json]]
RESULTS.json keeps what was measured; where it exists, nothing is run.
"""

import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

import scanning

CASE = "cornell-swift-bray-1998-random-acceleration"
SIDE = 2e4  # diameters; with noise_strength = 1 the unit of time is 737
UNIT = SIDE ** (2 / 3)
RESTITUTION = (0.05, 0.1, 0.3, 0.5, 0.8)
INTERVALS = (64.0, 8.0, 1.0)  # 0.087, 0.011 and 0.0014 units of time
TIME = 4e6  # 5400 units of time
EDGE = 0.02  # "at a wall": within so much of it, of the side


def measured(restitution, interval):
    """(places / L, bounces in a unit of time) of one run; places: float64, at times 0, 100, ..."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "run.h5"
        summary = scanning.summary(CASE, {
            "system.sides": [SIDE], "start.positions": [SIDE / 2], "walls.restitution": restitution,
            "drive.kick_interval": interval, "run.time": TIME, "run.collisions": 10**9,
            "output.snapshot_interval": 100, "output.collision_log": "none"}, output)
        with h5py.File(output) as file:
            places = file["particles/spheres/position/value"][:, 0, 0]
    return (places - 0.5) / (SIDE - 1), summary["collisions"] / TIME * UNIT


def at_wall(places):
    """Share of places at a wall, and its standard error from ten parts of the run."""
    shares = [np.mean(np.minimum(part, 1 - part) < EDGE) for part in np.array_split(places, 10)]
    return np.mean(shares), np.std(shares, ddof=1) / np.sqrt(10)


def folded(places, bins=25):
    """(distance from the nearer wall, density): 1 is a uniform distribution over the box."""
    counts, edges = np.histogram(np.minimum(places, 1 - places), bins, (0, 0.5))
    return (edges[1:] + edges[:-1]) / 2, counts / len(places) * bins


def draw(rows, path):
    """Density of places at the shortest interval."""
    with scanning.drawn(path) as axes:
        for row, marker in zip(rows, "osv^D"):
            axes.plot(*row["density"], marker, linestyle="-", linewidth=0.8, markersize=3,
                      label=f"$e = {row['restitution']}$")
        axes.axhline(1, color="0.5", linewidth=0.7, linestyle=":", zorder=0, label="uniform")
        axes.set(xlabel="distance from the nearer wall / side $L$ of the box",
                 ylabel="probability density / uniform density", xlim=(0, 0.5), ylim=(0, None))
        axes.legend()


def scan():
    """One dict for each restitution: `restitution`, `cells` (share at a wall, its error and rate
    of bounces at each interval) and `density` (folded(), at the shortest interval)."""
    rows = []
    for restitution in RESTITUTION:
        cells = []
        for interval in INTERVALS:
            places, rate = measured(restitution, interval)
            cells.append([*at_wall(places), rate])
        density = [each.tolist() for each in folded(places)]
        rows.append({"restitution": restitution, "cells": cells, "density": density})
    return rows


def main():
    """Prints a row for each restitution, and draws the figure if a file is named."""
    figure, results = (*sys.argv[1:], None, None)[:2]
    print(f"share within {EDGE} L of a wall (uniform: {2 * EDGE}), bounces in a unit of time;"
          " kick intervals " + ", ".join(f"{interval / UNIT:.4f}" for interval in INTERVALS))
    rows = scanning.kept(results, scan)
    for row in rows:
        print(f"{row['restitution']:<5} " + "   ".join(
            f"{share:.3f} +- {error:.3f}, {rate:.1f}" for share, error, rate in row["cells"]))
    if figure:
        draw(rows, figure)


if __name__ == "__main__":
    main()
