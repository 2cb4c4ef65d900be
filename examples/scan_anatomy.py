#!/usr/bin/python3
"""Takes apart the first hit under shear for several restitutions: how many balls, and which factors.

Prints a Markdown table: the chain of the cluster beside the least number of balls whose straight
chain collapses, and the measured factors per collision beside the exact ones of such a chain.

Usage: scan_anatomy.py
"""

import math

import scanning

CASE = "shear-e02"
RESTITUTION = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
SEEDS = (1, 2, 3, 4, 5)
FACTORS = ("gap", "speed", "flight")


def least_chain(restitution):
    """Fewest balls on a line that collapse: e < tan^2[(pi/4)(1 - 2/N)].

    Source: Bernu & Mazighi, J. Phys. A 23 (1990) 5745.
    """
    balls = 3
    while restitution >= math.tan(math.pi / 4 * (1 - 2 / balls)) ** 2:
        balls += 1
    return balls


def cells(restitution, seed, hit):
    """The cells of one row.

    hit: the summary's anatomy.hit, or None
    """
    if hit is None:
        return [f"{restitution:g}", str(seed), "no hit"] + ["–"] * 9
    factors = [_pair(hit[f"{name}_ratio"], hit[f"exact_{name}_ratio"]) for name in FACTORS]
    return [f"{restitution:g}", str(seed), str(hit["collision"]), f"{hit['time']:.4f}",
            str(hit["clusters"]), str(hit["spheres"]), str(len(hit["chain"])),
            str(least_chain(restitution)), f"{hit['straightness']:.4f}", *factors]


def _pair(measured, exact):
    return " / ".join("–" if value is None else f"{value:.3f}" for value in (measured, exact))


def main():
    """Prints one row for each restitution and seed."""
    names = ["e", "seed", "hit", "strain", "clusters", "spheres", "chain", "least chain",
             "straightness", *(f"{name}: measured / exact" for name in FACTORS)]
    print("| " + " | ".join(names) + " |\n|" + "---|" * len(names))
    for restitution in RESTITUTION:
        for seed in SEEDS:
            run = scanning.summary(CASE, {"system.restitution": restitution, "start.seed": seed,
                                          "run.collisions": 30000})
            print("| " + " | ".join(cells(restitution, seed, run["anatomy"]["hit"])) + " |")


if __name__ == "__main__":
    main()
