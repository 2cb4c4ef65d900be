#!/usr/bin/python3
"""Measures how long a ball bounces on a platform whose velocity makes random steps.

Seen from the platform the steps are kicks of the ball. Its bounces end where they are over before
the next kick: an inelastic collapse. For a platform that is struck at random velocities Majumdar &
Kearney, Phys. Rev. E 76 (2007) 031130, find an exponential tail of the time until the collapse.

Usage: scan_random_platform.py [FIGURE.png [RESULTS.json]]
RESULTS.json keeps what was measured; where it exists, nothing is run.
"""

import sys

import numpy as np

import scanning

CASE = "kadanoff-1999-bouncing-ball"
RESTITUTION = (0.2, 0.4, 0.6)
RUNS, LONGEST = 500, 4000.0  # runs of each restitution, and the time at which one is cut off
COMPUTED = 3000  # balls of the second computation
KICKS = {"drive.kind": "random", "drive.noise_strength": 1, "drive.kick_interval": 1,
         "system.sides": [10**6], "run.collisions": 10**6, "run.time": LONGEST,
         "output.collision_log": "none"}


def times_until_collapse(restitution):
    """Of RUNS runs with different kicks, sorted; infinite where none came in time."""
    times = []
    for seed in range(1, RUNS + 1):
        run = scanning.summary(CASE, KICKS | {"walls.restitution": restitution, "start.seed": seed})
        times.append(run["arrest"]["time"] if run["arrest"]["met"] else np.inf)
    return np.sort(times)


def computed_time(restitution, random):
    """The same without the program: time until the collapse of one ball, bounce by bounce."""
    height, velocity = 0.5, 0.0  # of the case, at t = 0
    for interval in range(int(LONGEST)):
        left = 1.0
        while True:
            flight = velocity + np.sqrt(velocity**2 + 2 * height)
            if flight > left:
                break
            left, height = left - flight, 0.0
            velocity = restitution * (flight - velocity)
            remaining = 2 * velocity / (1 - restitution)  # of all bounces to come
            if remaining <= left:
                return interval + 1 - left + remaining
        height = max(height + velocity * left - left**2 / 2, 0)
        velocity += random.normal() - left
    return np.inf


def tail_rate(times, begin):
    """Rate of an exponential tail beyond `begin`, and its standard error; cut-off runs count.

    The most likely rate is the number of collapses over the time spent beyond `begin`.
    """
    beyond = times[times > begin]
    collapses = np.sum(np.isfinite(beyond))
    rate = collapses / np.sum(np.minimum(beyond, LONGEST) - begin)
    return rate, rate / np.sqrt(collapses)


def draw(scans, path):
    """Share of balls that still bounce, against the time since the median over that of the tail.

    The line is the exponential whose rate tail_rate() finds beyond the median.
    """
    with scanning.drawn(path) as axes:
        for (restitution, times), marker in zip(scans.items(), "osv"):
            median = times[len(times) // 2]
            left = 1 - np.arange(1, len(times) + 1) / len(times)
            since = (times - median) * tail_rate(times, median)[0]
            axes.semilogy(since[:-1], left[:-1], marker, markersize=2,
                          label=f"$e = {restitution}$")
        ends = np.array([0, 5.5])
        axes.semilogy(ends, np.exp(-ends) / 2, color="black", linewidth=0.8,
                      label=r"$\frac{1}{2}\exp[-\theta\,(t-t_{1/2})]$, fitted from $t_{1/2}$ on")
        axes.set(xlabel=r"$\theta\,(t-t_{1/2})$: time since the median, times the rate of the tail",
                 ylabel="share that still bounces", ylim=(0.8 / RUNS, 1.1))
        axes.legend()


def line(restitution, times):
    """Median and rates of the tail beyond it and beyond the upper quartile, as text."""
    rates = [tail_rate(times, times[part * len(times) // 4]) for part in (2, 3)]
    return (f"{restitution}  {len(times)}   {times[len(times) // 2]:6.2f}  "
            + "  ".join(f"{rate:.4f} +- {error:.4f}      " for rate, error in rates)
            + f"  {np.sum(np.isinf(times))}")


def scan():
    """Sorted times of each restitution, of runs and of balls that are computed without them."""
    random = np.random.default_rng(3)
    computed = [np.sort([computed_time(each, random) for _ in range(COMPUTED)])
                for each in RESTITUTION]
    runs = [times_until_collapse(each) for each in RESTITUTION]
    return {"runs": [each.round(6).tolist() for each in runs],
            "computed": [each.round(6).tolist() for each in computed]}


def main():
    """Prints the tail of each restitution, run and computed, and draws the figure."""
    figure, results = (*sys.argv[1:], None, None)[:2]
    print("e    balls  median  rate beyond it        beyond the upper quartile  not ended")
    times = scanning.kept(results, scan)
    for kind, remark in (("runs", ""), ("computed", " computed")):
        for restitution, each in zip(RESTITUTION, times[kind]):
            print(line(restitution, np.array(each)) + remark)
    if figure:
        draw(dict(zip(RESTITUTION, map(np.array, times["runs"]))), figure)


if __name__ == "__main__":
    main()
