#!/usr/bin/python3
"""Sonine coefficient a2 of cooling spheres against density, beside a gas without correlations.

Spheres of the simulator, from random places and Maxwellian velocities, and a model in which who
meets which, and along which direction, is left to chance, with the rate of the Enskog equation: what
differs between the two is that velocities of spheres about to collide are correlated.

Usage: scan_cooling_a2.py [RESTITUTION [KEPT.json]]
The simulator's package has to be on PYTHONPATH (build/python).
"""

import sys

import numpy as np

import scanning

from zenosphere.analysis.velocities import sonine

SPHERES = 1000
STARTS = 200
SPHERES_OF_CHAOS = 250_000
FRACTIONS = (0.03, 0.1, 0.3)
PER_SPHERE = (0, 1, 2, 3, 4, 5, 6, 9, 12, 15, 18, 21, 24)  # collisions of a sphere
STEADY = PER_SPHERE.index(6)  # from here on averages are taken: a2 has forgotten the Maxwellian
REFUSED = 5.5 * np.sqrt(2)  # largest normal speed over sqrt(T): 4e-8 of the pairs are faster


def theory(e):
    """a2 to first order. Source: van Noije & Ernst, Granular Matter 1 (1998) 57."""
    return 16 * (1 - e) * (1 - 2 * e**2) / (81 - 17 * e + 30 * e**2 * (1 - e))


def cooling(e, fraction, spheres=SPHERES, starts=STARTS):
    """(a2, T) of runs of the simulator, arrays of shape (starts, len(PER_SPHERE))."""
    import zenosphere  # the compiled part, which the model does not need
    courses = []
    for seed in range(1, starts + 1):
        run = zenosphere.Run({
            "system": {"dimension": 3, "spheres": spheres, "restitution": e,
                       "solids_volume_fraction": fraction},
            "start": {"arrangement": "random", "granular_temperature": 1.0, "seed": seed},
            "drive": {"kind": "none"}, "run": {"collisions": 10**9}})
        course = []
        for per_sphere in PER_SPHERE:
            run.skip(per_sphere * spheres // 2 - run.collisions)
            course.append(_measured(run.state().velocities))
        courses.append(course)
    return np.moveaxis(np.array(courses), 2, 0)


def molecular_chaos(e, spheres=SPHERES_OF_CHAOS, gases=6):
    """(a2, T) of the gas without places, arrays of shape (gases, len(PER_SPHERE)).

    A few pairs are drawn at random, each with a random direction, and collide with a probability in
    proportion to their normal speed; and so on. In a step less than 0.01 of the spheres collide.
    Source: Bird, Molecular Gas Dynamics (1994); Montanero & Santos, Granular Matter 2 (2000) 53.
    """
    courses = []
    for seed in range(1, gases + 1):
        random = np.random.default_rng(seed)
        velocities = random.standard_normal((spheres, 3))
        collisions, course = 0, [_measured(velocities)]
        for per_sphere in PER_SPHERE[1:]:
            while 2 * collisions < per_sphere * spheres:
                collisions += _meetings(velocities, spheres // 40, e, random)
            course.append(_measured(velocities))
        courses.append(course)
    return np.moveaxis(np.array(courses), 2, 0)


def _meetings(velocities, pairs, e, random):
    """Draws pairs, none with a sphere of another one; returns how many of them collided."""
    drawn = random.integers(len(velocities), size=2 * pairs)
    alone = np.zeros(2 * pairs, dtype=bool)
    alone[np.unique(drawn, return_index=True)[1]] = True
    i, j = drawn.reshape(2, pairs)[:, alone[:pairs] & alone[pairs:]]
    normal = random.standard_normal((len(i), 3))
    normal /= np.sqrt(np.sum(normal**2, axis=1))[:, None]
    speed = np.sum((velocities[i] - velocities[j]) * normal, axis=1)
    limit = REFUSED * np.sqrt(np.mean(velocities[i]**2))
    hit = random.random(len(i)) * limit < np.abs(speed)
    change = ((1 + e) / 2 * speed[hit])[:, None] * normal[hit]
    velocities[i[hit]] -= change
    velocities[j[hit]] += change
    return int(hit.sum())


def _measured(velocities):
    """a2 and T."""
    squares = np.sum((velocities - velocities.mean(axis=0))**2, axis=1)
    return sonine(squares, 3)[0], squares.mean() / 3


def summed_up(e, course):
    """Of (a2, T): the course of a2, its steady mean, and the squared speed of collisions."""
    a2, temperatures = course
    steady = a2[:, STEADY:].mean(axis=1)
    lost = np.log(temperatures[:, STEADY] / temperatures[:, -1])
    lost /= PER_SPHERE[-1] - PER_SPHERE[STEADY]
    speed = lost / ((1 - e**2) / 3)  # <v_n^2> / (4 T): 1 of a Maxwellian without correlations
    root = np.sqrt(len(a2))
    return {"a2": [steady.mean(), steady.std(ddof=1) / root],
            "speed": [speed.mean(), speed.std(ddof=1) / root],
            "course": [list(a2.mean(axis=0)), list(a2.std(axis=0, ddof=1) / root)]}


def scan(e):
    """Name of each gas -> what was found."""
    found = {"without correlations": summed_up(e, molecular_chaos(e))}
    for fraction in FRACTIONS:
        found[f"phi = {fraction}"] = summed_up(e, cooling(e, fraction))
    return found


def main():
    """Prints a row for each gas: steady means, then the course of a2."""
    e = float(sys.argv[1]) if len(sys.argv) > 1 else 0.7
    found = scanning.kept(sys.argv[2] if len(sys.argv) > 2 else None, lambda: scan(e))
    print(f"e = {e}; van Noije & Ernst: a2 = {theory(e):.5f}")
    print(f"{'gas':22}{'a2':>20}{'<v_n^2>/(4T)':>20}  a2 after "
          + ", ".join(map(str, PER_SPHERE)) + " collisions per sphere")
    for name, row in found.items():
        cells = "".join(f"{f'{value:.5f} +- {error:.5f}':>20}" for value, error in
                        (row["a2"], row["speed"]))
        print(f"{name:22}{cells}  " + " ".join(f"{value:.4f}" for value in row["course"][0]))


if __name__ == "__main__":
    main()
