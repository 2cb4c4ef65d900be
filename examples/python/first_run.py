#!/usr/bin/python3
"""Runs a case from Python, keeps its output, and tells what came out.

    PYTHONPATH=build/python /usr/bin/python3 examples/python/first_run.py [COLLISIONS]
"""

import sys

import numpy as np

import zenosphere

CASE = {
    "system": {"dimension": 3, "spheres": 500, "restitution": 0.2, "solids_volume_fraction": 0.3},
    "start": {"arrangement": "fcc", "granular_temperature": 0.01, "seed": 1},
    "drive": {"kind": "shear", "shear_rate": 1.0},
    "run": {"collisions": int(sys.argv[1]) if len(sys.argv) > 1 else 200_000},
}

with zenosphere.Run(CASE, output="first_run.h5", overwrite=True) as run:
    for rows in run.chunks(10_000):
        print(f"collision {run.collisions}, time {run.time:.4f}:"
              f" smallest gap {np.nanmin(rows['gap']):.2g}, verdict so far {run.verdict}")

summary = run.finish()
print(f"{summary['outcome']} after {summary['collisions']} collisions: {summary['verdict']}")
print("repeating pairs:", summary["arrest"]["pairs"])
