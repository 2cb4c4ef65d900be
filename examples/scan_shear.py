#!/usr/bin/python3
"""Scans the restitution of sheared disks: how often either criterion of collapse is met.

Source of the system: Alam & Hrenya, Phys. Rev. E 63 (2001) 061308.

Usage: scan_shear.py [FIGURE.png]
"""

import sys
from collections import Counter

import scanning

CASE = "alam-hrenya-2001-2d-shear"
RESTITUTION = (0.6, 0.5, 0.45, 0.4, 0.35, 0.3, 0.2)
SEEDS = range(1, 11)


def hits_per_million(runs):
    """Hits of the separation criterion in a million collisions, over all runs together.

    runs: summaries
    """
    return 1e6 * sum(run["separation"]["hits"] for run in runs) / sum(
        run["collisions"] for run in runs)


def counted(runs):
    """(runs with a hit, runs that met the arrest criterion, their verdicts as text)."""
    verdicts = Counter(run["verdict"] for run in runs)
    return (sum(run["separation"]["hits"] > 0 for run in runs),
            sum(run["arrest"]["met"] for run in runs),
            ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items())))


def draw(scans, path):
    """Share of the runs that met either criterion, against e."""
    with scanning.drawn(path) as axes:
        for place, name, style in ((0, "separation criterion", "o-"),
                                   (1, "arrest criterion", "s--")):
            axes.plot(scans.keys(), [counted(runs)[place] for runs in scans.values()], style,
                      markersize=4, linewidth=1, label=name)
        axes.set(xlabel="restitution $e$", ylabel=f"runs of {len(SEEDS)} that met it",
                 ylim=(-0.5, 10.5))
        axes.legend()


def main():
    """Prints a row for each restitution, and draws the figure if a file is named."""
    scans = {}
    print("e     with a hit  arrested  hits per million collisions  verdicts")
    for restitution in RESTITUTION:
        runs = [scanning.summary(CASE, {"system.restitution": restitution, "start.seed": seed})
                for seed in SEEDS]
        hit, arrested, verdicts = counted(runs)
        print(f"{restitution:<4}  {hit:10d}  {arrested:8d}  {hits_per_million(runs):27.0f}"
              f"  {verdicts}")
        scans[restitution] = runs
    if len(sys.argv) > 1:
        draw(scans, sys.argv[1])


if __name__ == "__main__":
    main()
