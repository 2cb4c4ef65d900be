#!/usr/bin/python3
"""Looks for the orders of contacts in which three disks or spheres collapse, from random starts.

Only two orders can last: nearly linear, where two pairs take turns, and triangular, where all three
pairs do. Source: Dolmaire & Velazquez, arXiv 2403.16905 (2024).

A bent row lasts if its bend t is small enough. With frozen normals a contact multiplies speeds by a
and gaps by b, the roots of x^2 - (1 + e) cos(t) x / 2 + e; sideways motion, which pushes the
spheres apart, is outrun if b < a^2 (docs/decisions/0019-certificates.md), that is for cos(t) >
2 (e^(1/3) + e^(2/3)) / (1 + e). At t = 0 this is e < 9 - 4 sqrt(5) (Zhou & Kadanoff 1996).

Usage: scan_three_spheres.py [FIGURE.png [RESULTS.json]]
RESULTS.json keeps what was found; where it exists, nothing is run.
"""

import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

import scanning

from zenosphere.run_file import RunFile  # scanning has put it on the path

CASE = "dolmaire-velazquez-2024-three-spheres"
STABLE = 9 - 4 * np.sqrt(5)
RESTITUTION = (0.01, 0.02, 0.03, 0.04, 0.05, 0.06)
STARTS = 200  # at each restitution and dimension
SIDEWAYS = 0.2  # standard deviation of each sideways velocity; spheres come with speeds of 0.1 to 1
MORE = "digits400"  # in which each collapse is looked at again
LAST = 24  # contacts whose order is the eventual one; more than fifty fit into a hundred digits


def largest_bend(restitution):
    """Bend (radians) of the row up to which a nearly linear collapse lasts; nan if none does."""
    root = np.cbrt(restitution)
    with np.errstate(invalid="ignore"):
        return np.arccos(2 * (root + root**2) / (1 + restitution))


def random_start(random, dimension):
    """One sphere at rest and two that come from anywhere, as keys of the case file."""
    while True:
        towards = random.normal(size=(2, dimension))
        towards /= np.linalg.norm(towards, axis=1)[:, None]
        places = towards * (1 + random.uniform(0.05, 1, (2, 1)))
        if np.linalg.norm(places[1] - places[0]) > 1.05:
            break
    sideways = random.normal(size=(2, dimension)) * SIDEWAYS
    sideways -= np.sum(sideways * towards, axis=1)[:, None] * towards
    velocities = sideways - towards * random.uniform(0.1, 1, (2, 1))
    rest = [[0] * dimension]
    return {"system.dimension": dimension, "system.sides": [100] * dimension,
            "start.positions": (50 + np.concatenate((rest, places))).round(6).tolist(),
            "start.velocities": np.concatenate((rest, velocities)).round(6).tolist()}


def eventual_order(pairs):
    """"nearly linear", "triangular" or "other": the order of the last contacts.

    pairs: int (K), K >= LAST, i + j of each contact, which tells the three pairs apart
    """
    last = list(pairs[-LAST:])
    for period, name in ((2, "nearly linear"), (3, "triangular")):
        if last[period:] == last[:-period] and len(set(last)) == period:
            return name
    return "other"


def longest_triangular(pairs):
    """Largest number of contacts in a row in which each three are of three different pairs."""
    longest = stretch = min(len(pairs), 2)
    for three in zip(pairs, pairs[1:], pairs[2:]):
        stretch = stretch + 1 if len(set(three)) == 3 else 2
        longest = max(longest, stretch)
    return longest


def bend(straightness):
    """Angle (radians) between the two bonds of a row of three; straightness: ends' distance / 2."""
    return 2 * np.arccos(min(straightness, 1))


def look(dimension, restitution, random, output):
    """What became of one start: dict with `contacts`, `triangular`, and of a collapse `order`,
    `bend` (degrees) and `opens`: whether the spheres come apart if they have MORE digits.

    triangular: longest stretch of contacts in the triangular order
    """
    keys = random_start(random, dimension) | {"system.restitution": restitution}
    summary = scanning.summary(CASE, keys, output)
    if not summary["collisions"]:
        return {"contacts": 0, "triangular": 0}
    with RunFile(output) as run:
        pairs = np.sum(run.collisions.read("i", "j"), axis=0).tolist()
    spent = summary["separation"]["first_collision"]
    found = {"contacts": len(pairs), "triangular": longest_triangular(pairs[:spent])}
    if spent is not None:
        more = scanning.summary(CASE, keys | {"collision.precision": MORE})["separation"]["hits"]
        found |= {"order": eventual_order(pairs[:spent]) if spent >= LAST else "other",
                  "bend": np.degrees(bend(summary["anatomy"]["hit"]["straightness"])),
                  "opens": more == 0}
    return found


def row(dimension, restitution, found):
    """The line printed for the starts of one restitution."""
    ends = [each for each in found if "order" in each]
    orders = Counter(each["order"] for each in ends)
    lasting = [each["bend"] for each in ends if not each["opens"]]
    opening = [f"{each['bend']:.2f}" for each in ends if each["opens"]]
    most = max(each["contacts"] for each in found if "order" not in each)
    return (f"{dimension}-D  {restitution}  {len(ends)} of {len(found)} collapse: "
            + (", ".join(f"{count} {order}" for order, count in orders.items()) or "-")
            + f"; bend up to {max(lasting, default=np.nan):.2f} degrees (theory"
            f" {np.degrees(largest_bend(restitution)):.2f}); open with {MORE}: {len(opening)}"
            f" {opening}; contacts without collapse at most {most}; longest triangular stretch"
            f" {max(each['triangular'] for each in found)}")


def scan():
    """One dict for each dimension and restitution: `dimension`, `restitution` and `found`, what
    became of each start."""
    rows = []
    for dimension in (2, 3):
        random = np.random.default_rng(dimension)
        with tempfile.TemporaryDirectory() as folder:
            for restitution in RESTITUTION:
                found = [look(dimension, restitution, random, Path(folder) / "three.h5")
                         for _ in range(STARTS)]
                rows.append({"dimension": dimension, "restitution": restitution, "found": found})
    return rows


def draw(rows, path):
    """Bend at the collapse against e, with the largest that theory allows."""
    with scanning.drawn(path) as axes:
        fine = np.linspace(0.004, STABLE, 400)
        axes.plot(fine, np.degrees(largest_bend(fine)), color="black", linewidth=1,
                  label="largest bend that lasts")
        for dimension, name, marker, shift in ((2, "disks", "o", -4e-4), (3, "spheres", "x", 4e-4)):
            lasting = np.array([(row["restitution"] + shift, each["bend"])
                                for row in rows if row["dimension"] == dimension
                                for each in row["found"] if "order" in each and not each["opens"]])
            axes.plot(*lasting.T, marker, markersize=3, alpha=0.6, label=f"collapses of {name}")
        axes.axhline(120, color="grey", linewidth=0.8, linestyle=":")
        axes.text(0.005, 121, r"equilateral triangle, $120\degree$", va="bottom", fontsize=8)
        axes.axvline(STABLE, color="grey", linewidth=0.8, linestyle="--")
        axes.text(STABLE + 5e-4, 60, r"$9-4\sqrt{5}$", va="center", fontsize=8)
        axes.set(xlabel="restitution $e$", ylabel="bend of the row at the end (degrees)",
                 xlim=(0.004, 0.064), ylim=(0, 135))
        axes.legend(loc="upper right", bbox_to_anchor=(0.85, 0.85))


def main():
    """Prints what was found in two and three dimensions, and draws the figure."""
    figure, results = (*sys.argv[1:], None, None)[:2]
    rows = scanning.kept(results, scan)
    for each in rows:
        print(row(each["dimension"], each["restitution"], each["found"]))
    if figure:
        draw(rows, figure)


if __name__ == "__main__":
    main()
