#!/usr/bin/python3
"""Scans the restitution of N = 3, 4, 5 rods across the threshold of their collapse.

Neighbours that always take turns collapse for e < e_c = tan^2[(pi/4)(1 - 2/N)]; above it they part
after n collisions, and 1/n^2 goes linearly to zero at e_c. A straight line through it measures e_c.
Source: Bernu & Mazighi, J. Phys. A 23 (1990) 5745.

Usage: scan_rods.py [FIGURE.png]
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import scanning

from zenosphere.run_file import RunFile

CASE = "bernu-mazighi-1990-three-rods"

# N -> gaps and differences of velocities between neighbours: starts found by search, from which
# neighbours take turns at every restitution scanned. Most starts of five rods do not.
STARTS = {3: ([0.01, 0.06], [-0.8, -0.58]),
          4: ([0.62, 0.63, 0.01], [-0.37, -0.08, -0.19]),
          5: ([0.05, 0.85, 0.14, 0.42], [-0.42, -0.69, -0.68, -0.32])}

# How far above e_c, relative to it: nearer, gaps fall below 1e-16 before the rods turn around.
ABOVE = np.geomspace(0.02, 0.3, 30)


def threshold(rods):
    """e_c of rods whose neighbours take turns."""
    return np.tan(np.pi / 4 * (1 - 2 / rods)) ** 2


def start(rods):
    """The start of a row of rods, as keys of the case file."""
    gaps, differences = STARTS[rods]
    places = 10 + np.concatenate(([0], np.cumsum(np.add(gaps, 1))))
    speeds = np.concatenate(([0], np.cumsum(differences)))
    return {"system.spheres": rods, "start.positions": places.round(6).tolist(),
            "start.velocities": speeds.round(6).tolist(), "run.collisions": 2000}


def take_turns(order, rods):
    """Whether between two collisions of a pair each pair beside it collides exactly once.

    order: the left rod of each collision
    """
    for left in range(rods - 2):
        both = [each for each in order if each in (left, left + 1)]
        if any(a == b for a, b in zip(both, both[1:])):
            return False
    return True


def extrapolated_threshold(restitution, collisions):
    """Where the straight line through 1/n^2 is zero.

    restitution, collisions: (K), K >= 2, of runs that parted
    """
    slope, offset = np.polyfit(restitution, np.asarray(collisions, dtype=float) ** -2, 1)
    return -offset / slope


def collisions_until_parted(rods):
    """(e, n) of the runs that rounding cannot have touched: no pair overlapped, all took turns."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "rods.h5"
        for restitution in threshold(rods) * (1 + ABOVE):
            keys = start(rods) | {"system.restitution": restitution}
            summary = scanning.summary(CASE, keys, output)
            with RunFile(output) as run:
                order = run.collisions.read("i")[0]
            if summary["overlap_collisions"] == 0 and take_turns(order, rods):
                rows.append((restitution, summary["collisions"]))
    return np.array(rows)


def draw(scans, path):
    """1/n^2 against e / e_c, with its straight line."""
    with scanning.drawn(path) as axes:
        for (rods, (rows, measured)), marker in zip(scans.items(), "os^"):
            exact, used = threshold(rods), rows[rows[:, 1] >= 6 * rods]
            scaled = (rods / rows[:, 1]) ** 2
            points, = axes.plot(rows[:, 0] / exact, scaled, marker, markersize=4,
                                label=f"$N = {rods}$")
            slope = np.polyfit(used[:, 0], (rods / used[:, 1]) ** 2, 1)[0]
            ends = np.array([measured, used[:, 0].max()])
            axes.plot(ends / exact, slope * (ends - measured), color=points.get_color(),
                      linewidth=1)
        axes.axvline(1, color="black", linewidth=0.8, linestyle="--")
        axes.set(xlabel=r"$e\,/\,e_c$", ylabel=r"$(N/n)^2$", xlim=(0.97, 1.32), ylim=(0, None))
        axes.legend()


def main():
    """Prints a row for each N, and draws the figure if a file is named."""
    scans = {}
    print("N  e_c exact   from 1/n^2  error   separation criterion  error")
    for rods in STARTS:
        rows = collisions_until_parted(rods)
        used = rows[rows[:, 1] >= 6 * rods]
        measured = extrapolated_threshold(used[:, 0], used[:, 1])
        exact = threshold(rods)
        hit = scanning.largest_restitution_with_a_hit(CASE, start(rods), exact * 0.9, exact * 1.3,
                                                      steps=24)
        print(f"{rods}  {exact:.6f}    {measured:.6f}   {measured / exact - 1:+.2%}"
              f"  {hit:.6f}              {hit / exact - 1:+.2%}   ({len(used)} of {len(ABOVE)} runs"
              f" used, n = {used[:, 1].min():.0f} to {used[:, 1].max():.0f})")
        scans[rods] = rows, measured
    if len(sys.argv) > 1:
        draw(scans, sys.argv[1])


if __name__ == "__main__":
    main()
