#!/usr/bin/python3
"""Runs the elastic equilateral triple in 100 orientations and counts what the criteria say.

Source: Schorghofer & Zhou, Phys. Rev. E 54 (1996) 5511.

Usage: scan_triple.py
"""

from collections import Counter

import numpy as np

import scanning

CASE = "schorghofer-zhou-1996-triple"
ORIENTATIONS = 100


def triple(angle, radius=1.5, centre=10.0):
    """Three disks on a circle, 120 degrees apart, that head for its centre with the speed 1.

    angle: of the first one, radians.  Returns keys of the case file.
    """
    angles = angle + np.arange(3) * 2 * np.pi / 3
    outward = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    return {"start.positions": (centre + radius * outward).tolist(),
            "start.velocities": (-outward).tolist()}


def main():
    """Prints how many orientations met each criterion, and how many collisions they had."""
    runs = [scanning.summary(CASE, triple(2 * np.pi / 3 * number / ORIENTATIONS))
            for number in range(ORIENTATIONS)]
    print("separation criterion met:", sum(run["separation"]["hits"] > 0 for run in runs))
    print("arrest criterion met:    ", sum(run["arrest"]["met"] for run in runs))
    print("verdicts:                ", dict(Counter(run["verdict"] for run in runs)))
    print("collisions -> runs:      ", dict(Counter(run["collisions"] for run in runs)))


if __name__ == "__main__":
    main()
