#!/usr/bin/python3
"""Measures the restitution below which a randomly accelerated particle collapses onto a wall.

A particle that leaves a wall with the speed u comes back with a speed w, and w / u has a
distribution of its own, whatever u is (McKean, J. Math. Kyoto Univ. 2 (1963) 227): p(r) =
(3 / 2 pi) r^(3/2) / (1 + r^3). A bounce multiplies the speed by e r; the mean of ln(e r) is negative,
and the particle collapses, for e < exp(-<ln r>) = exp(-pi / sqrt(3)) = 0.163.
Source: Cornell, Swift & Bray, Phys. Rev. Lett. 81 (1998) 1142.

Measured is <ln r> from the collision log of kicked particles, for launch speeds much above one
kick, at several kick intervals, and extrapolated to the interval zero.

Usage: scan_random_acceleration.py [FIGURE.png [RESULTS.json]]
RESULTS.json keeps what was measured; where it exists, nothing is run.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import scanning

from zenosphere.run_file import RunFile

CASE = "cornell-swift-bray-1998-random-acceleration"
EXACT = np.pi / np.sqrt(3)
SLOWEST, FASTEST = 8.0, 16.0  # launches used; with noise_strength = 1
INTERVALS = (1.0, 2.0, 4.0, 8.0)  # a kick is sqrt(interval): 1 to 2.8
CUT = 3.0  # speed ratios above are only counted: the box is not large enough for all of them
RUNS, TIME = 8, 2e7  # per interval


def excursions(walls, speeds, restitution):
    """(u, r) of every flight: launch speed, and return speed / launch speed.

    walls: int (K), the wall of each bounce;  speeds: (K) before each bounce
    r is infinite where the next bounce is at the other wall: the return would be a fast one.
    """
    launch = restitution * speeds[:-1]
    ratio = np.where(walls[1:] == walls[:-1], speeds[1:] / launch, np.inf)
    return launch, ratio


def mean_logarithm(ratio, cut=CUT):
    """<ln r> and its standard error, the part above `cut` from its power law P(r > R) ~ R^(-1/2).

    <ln r> = <min(ln r, ln cut)> + 2 P(r > cut)
    """
    parts = np.where(ratio > cut, np.log(cut) + 2, np.log(np.minimum(ratio, cut)))
    return parts.mean(), parts.std() / np.sqrt(len(parts))


def extrapolated(kick, mean, error):
    """Value and standard error at kick 0 of the straight line through the means."""
    line, covariance = np.polyfit(kick, mean, 1, w=1 / np.asarray(error), cov="unscaled")
    return line[1], np.sqrt(covariance[1, 1])


def cumulative(ratio):
    """P(r < ratio) of McKean's density."""
    fine = np.linspace(0, np.sqrt(ratio), 2001)  # r = y^2 takes the square root out of the integral
    density = 3 / np.pi * fine**4 / (1 + fine**6)
    return np.sum((density[1:] + density[:-1]) / 2 * np.diff(fine))


def measured(interval):
    """Speed ratios of the launches used, at one kick interval; fresh kicks in each run."""
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, RUNS + 1):
            output = Path(folder) / "run.h5"
            scanning.summary(CASE, {"drive.kick_interval": interval, "run.time": TIME,
                                    "run.collisions": 10**9, "start.seed": seed}, output)
            with RunFile(output) as run:
                walls, speeds = run.collisions.read("j", "normal_speed")
                launch, ratio = excursions(walls, speeds, run.setting("walls", "restitution"))
            ratios.append(ratio[(launch >= SLOWEST) & (launch < FASTEST)])
    return np.concatenate(ratios)


def draw(kick, mean, error, line, path):
    """<ln r> against the size of a kick, with the straight line and the exact value."""
    with scanning.drawn(path) as axes:
        axes.errorbar(kick, mean, error, fmt="o", markersize=4, capsize=2, label="measured")
        ends = np.array([0, max(kick)])
        axes.plot(ends, np.polyval(np.polyfit(kick, mean, 1, w=1 / np.array(error)), ends),
                  color="C0", linewidth=1, label="weighted linear fit")
        axes.errorbar([0], [line[0]], [line[1]], fmt="s", color="C1", markersize=5, capsize=3,
                      label="extrapolated to white noise")
        axes.axhline(EXACT, color="black", linewidth=0.8, linestyle="--",
                     label=r"exact: $\pi/\sqrt{3}$")
        axes.set(xlabel="standard deviation of a kick / geometric mean of launch speeds",
                 ylabel=r"$\langle\ln(w/u)\rangle$, return speed $w$, launch speed $u$")
        axes.legend()


def scan():
    """One dict for each kick interval: `interval`, `launches`, `slower` (share of the returns
    slower than their launch), `mean` and `error` of ln r."""
    rows = []
    for interval in INTERVALS:
        ratio = measured(interval)
        mean, error = mean_logarithm(ratio)
        rows.append({"interval": interval, "launches": len(ratio), "slower": np.mean(ratio < 1),
                     "mean": mean, "error": error})
    return rows


def main():
    """Prints a row for each kick interval, the extrapolation, and draws the figure."""
    figure, results = (*sys.argv[1:], None, None)[:2]
    print(f"interval  launches  P(r < 1) (exact {cumulative(1):.4f})  <ln r>")
    rows = scanning.kept(results, scan)
    for row in rows:
        print(f"{row['interval']:8g}  {row['launches']:8d}  {row['slower']:.4f}"
              f"                 {row['mean']:.4f} +- {row['error']:.4f}")
    kick = [np.sqrt(row["interval"] / (SLOWEST * FASTEST)) for row in rows]
    mean, error = ([row[name] for row in rows] for name in ("mean", "error"))
    line = extrapolated(kick, mean, error)
    print(f"zero: <ln r> = {line[0]:.4f} +- {line[1]:.4f} (exact {EXACT:.4f}),"
          f" e_c = {np.exp(-line[0]):.4f} +- {np.exp(-line[0]) * line[1]:.4f}"
          f" (exact {np.exp(-EXACT):.4f})")
    if figure:
        draw(kick, mean, error, line, figure)


if __name__ == "__main__":
    main()
