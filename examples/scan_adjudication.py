#!/usr/bin/python3
"""Asks of sheared spheres near the paper's e = 0.6: which starts lead into a collapse of the model?

Each run goes through `zenosphere adjudicate` (docs/adjudication.md), which judges its first groups of
separation hits with as many digits as they need. The tables of that page come from here.

Usage: scan_adjudication.py SCAN [RESULTS.json]

SCAN is one of
    restitution   the cold lattice of the paper's cases, e = 0.3 to 0.7
    rows          the cold lattice in boxes of 4 to 12 cells: rows of 8 to 24 spheres
    temperature   the cold lattice, from colder to warmer than the paper's case needs
    density       the cold lattice at other solids volume fractions
    disorder      the cold lattice with every sphere moved at random
    melted        e = 0.3 from melted lattices and from random places
"""

import json
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import scanning

SECONDS = 300   # for each run: most need a tenth of it
GROUPS = 3      # of hits, the first of each run
SEEDS = (1, 2, 3)
STRENGTH = ("undecided", "chance close pair", "exact contact", "near-collapse", "arithmetic arrest",
            "singular", "proven")


def lattice_with_disorder(path, amplitude, seed, cells=10, fraction=0.3):
    """Writes an fcc lattice as extended XYZ, each sphere moved by a Gaussian step.

    amplitude: standard deviation of each component of a step, in diameters
    """
    import numpy
    count = 4 * cells**3
    side = (count * numpy.pi / (6 * fraction))**(1 / 3)
    corners = numpy.stack(numpy.meshgrid(*[numpy.arange(cells)] * 3, indexing="ij"), -1)
    base = numpy.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]]) + 0.25
    places = (corners.reshape(-1, 1, 3) + base).reshape(-1, 3) * (side / cells)
    places += numpy.random.default_rng(seed).normal(0, amplitude, places.shape)
    places %= side
    rows = "\n".join("A " + " ".join(repr(float(x)) for x in row) for row in places)
    path.write_text(f'{count}\nLattice="{side!r} 0 0 0 {side!r} 0 0 0 {side!r}"'
                    f' Properties=species:S:1:pos:R:3 pbc="T T T"\n{rows}\n')
    return side


def adjudicated(case, changes):
    """What `zenosphere adjudicate --json` prints of a case, or None where the run has no hit."""
    command = [scanning.program(), "adjudicate", scanning.EXAMPLES / f"{case}.toml", "--json",
               "--quiet", "--seconds", str(SECONDS), "--groups", str(GROUPS),
               *scanning.overrides(changes)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    found = json.loads(done.stdout.splitlines()[-1])
    return found if found["hits"] else None


def law_of(approach):
    """What the curvature of the contacts does to the fall."""
    curvature = approach["curvature"]
    if curvature is None:
        return ""
    end = curvature["gives_way_at_decade"]
    return ", curvature dies out" if end is None else f", gives way near 1e-{end:.0f}"


def row_of(finding):
    """The findings of a run as text: of its first group, and how many there are of each."""
    if finding is None:
        return "no hit"
    if not finding["approaches"]:
        return "no time"
    first = finding["approaches"][0]["run_hit"]
    group = [one for one in finding["approaches"] if one["run_hit"] == first]
    near = [one["decades"] for one in group if one["finding"] == "near-collapse"]
    last = max(group, key=lambda one: STRENGTH.index(one["finding"]))
    end = f", end at {last['collapse_time'][:24]}" if last["collapse_time"] else ""
    before = f", after near-collapses to 1e-{', 1e-'.join(map(str, near))}" if near else ""
    counts = Counter(one["finding"] for one in finding["approaches"])
    others = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
    return (f"{last['finding']}: {len(last['spheres'])} spheres, {last['decades']} decades,"
            f" hit {first}, {last['precision']}{end}{law_of(last)}{before} (all: {others})")


def cold(**changes):
    """The paper's first case, up to where the layers have slid past each other once."""
    return "shear-e06", {"run.collisions": 17000} | {key.replace("__", "."): value
                                                      for key, value in changes.items()}


def restitution(_):
    for value in (0.3, 0.4, 0.5, 0.6, 0.65, 0.7):
        for seed in SEEDS:
            yield f"e = {value}, seed {seed}", cold(system__restitution=value, start__seed=seed)


def rows(_):
    for cells in (4, 5, 6, 7, 8, 9, 10, 12):
        count = 4 * cells**3
        for seed in SEEDS:
            yield (f"rows of {2 * cells}, N = {count}, seed {seed}",
                   cold(system__spheres=count, start__seed=seed,
                        run__collisions=round(4.25 * count)))


def temperature(_):
    for value in (3e-4, 1e-3, 3e-3, 5e-3, 6e-3, 7e-3, 1e-2):
        for seed in SEEDS:
            yield (f"T0 = {value}, seed {seed}",
                   cold(start__granular_temperature=value, start__seed=seed))


def density(_):
    for value in (0.2, 0.25, 0.3, 0.35, 0.4):
        for seed in SEEDS:
            yield (f"phi = {value}, seed {seed}",
                   cold(system__solids_volume_fraction=value, start__seed=seed,
                        run__collisions=40000))


def disorder(folder):
    for amplitude in (0, 0.005, 0.01, 0.02, 0.05):
        for seed in SEEDS:
            start = folder / f"disorder-{amplitude}-{seed}.xyz"
            lattice_with_disorder(start, amplitude, seed)
            yield (f"disorder {amplitude}, seed {seed}",
                   cold(start__arrangement="file", start__file=str(start), start__seed=seed))


def melted(_):
    for name, start in (("fcc, T0 = 1", {"start.granular_temperature": 1}),
                        ("fcc, T0 = 100", {"start.granular_temperature": 100}),
                        ("random, T0 = 1", {"start.granular_temperature": 1,
                                            "start.arrangement": "random"})):
        for seed in range(1, 6):
            yield (f"e = 0.3, {name}, seed {seed}",
                   ("shear-e02", {"system.restitution": 0.3, "start.seed": seed} | start))


SCANS = {scan.__name__: scan for scan in (restitution, rows, temperature, density, disorder, melted)}


def main():
    """Prints a row for each run; with a second argument keeps all that was found as JSON."""
    if len(sys.argv) not in (2, 3) or sys.argv[1] not in SCANS:
        raise SystemExit(__doc__)
    kept = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (case, changes) in SCANS[sys.argv[1]](Path(folder)):
            kept[name] = adjudicated(case, changes)
            print(f"{name}: {row_of(kept[name])}", flush=True)
            if len(sys.argv) == 3:
                Path(sys.argv[2]).write_text(json.dumps(kept))


if __name__ == "__main__":
    main()
