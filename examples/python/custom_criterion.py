#!/usr/bin/python3
"""A criterion of your own, fed by the collisions of a run: one pair collides again and again.

    PYTHONPATH=build/python /usr/bin/python3 examples/python/custom_criterion.py [COLLISIONS]

It is met where one pair has had 1000 collisions in a row while the clock stood still; what it finds
is set beside the arrest criterion of the program.
"""

import sys
from pathlib import Path

import zenosphere
from zenosphere.flags import CLOCK_STOOD


class Monopoly:
    """Met once a single pair has had a whole window of collisions while the clock stood still."""

    def __init__(self, window):
        self.window, self.count, self.pair, self.met_at = window, 0, None, None

    def observe(self, rows):
        """Takes the next collisions, in order."""
        if self.met_at:
            return
        for k, i, j, flags in rows[["k", "i", "j", "flags"]].tolist():
            repeats = (i, j) == self.pair and flags & CLOCK_STOOD
            self.count = self.count + 1 if repeats else 1
            self.pair = (i, j)
            if self.count >= self.window:
                self.met_at = k
                break


case = Path(__file__).resolve().parents[1] / "shear-e02.toml"
limit = int(sys.argv[1]) if len(sys.argv) > 1 else 200_000
with zenosphere.Run(case, overrides={"run.collisions": limit}) as run:
    criterion = Monopoly(window=1000)
    for rows in run.chunks(1000):
        criterion.observe(rows)

print(f"{run.collisions} collisions, verdict {run.verdict}")
print(f"own criterion: collision {criterion.met_at}, pair {criterion.pair}")
print(f"arrest:        collision {run.arrest['collision']}, pairs {run.arrest['pairs']}")
