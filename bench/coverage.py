#!/usr/bin/env python3
"""Do the standard errors of a run's averages tell the truth? And its word about the steady state?

Runs a case with many seeds. The mean over all seeds stands for the true mean (its own error is a
tenth of that of one run, for 100 seeds); counted is how many intervals of 1.96 errors, and of
Student's t for `blocks` values, hold it. The spread between seeds over the mean error is 1 where
errors are right.

    bench/coverage.py [--seeds 100] [--program build/zenosphere]

The figures of docs/measurements.md come from here.
"""

import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import tempfile

import numpy as np
from scipy import stats

CASE = """[system]
dimension = 3
spheres = {spheres}
restitution = {restitution}
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1.0
seed = {seed}
[drive]
kind = "{kind}"
{rate}
[run]
time = {time}
[measure]
after_time = {after}
[output]
collision_log = "none"
"""
# name, spheres, restitution, shear, averages start, end of the run
CASES = [("elastic, N = 500", 500, 1.0, False, 2, 42),
         ("e = 0.9, N = 500", 500, 0.9, True, 20, 100),
         ("e = 0.6, N = 500", 500, 0.6, True, 50, 150)]
AVERAGES = ["granular_temperature", "pressure", "collision_rate", "dissipation",
            "compressibility_factor", "normal_speed", "shear_work"]


def averages_of(program, folder, settings, seed):
    name, spheres, restitution, is_sheared, after, time = settings
    case = folder / f"{spheres}-{restitution}-{seed}.toml"
    case.write_text(CASE.format(spheres=spheres, restitution=restitution, seed=seed, time=time,
                                after=after, kind="shear" if is_sheared else "none",
                                rate="shear_rate = 1.0" if is_sheared else ""))
    done = subprocess.run([program, "run", str(case), "--json", "--quiet"], check=True,
                          capture_output=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])["averages"]


def table(runs):
    """A row for each average whose error is known in most runs and not 0."""
    for name in AVERAGES:
        values = np.array([run[name] for run in runs], dtype=float)
        errors = np.array([run["standard_error"][name] for run in runs], dtype=float)
        blocks = np.array([run["blocks"] or 2 for run in runs])
        known = np.isfinite(errors) & (errors > 0)
        if known.sum() < len(runs) / 2:
            continue
        away = np.abs(values - values.mean())[known] / errors[known]
        student = stats.t.ppf(0.975, np.maximum(blocks[known] - 1, 1))
        yield (name, known.sum(), (away < 1.96).sum(), (away < student).sum(),
               values.std(ddof=1) / np.sqrt(np.mean(errors[known] ** 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--program", default="build/zenosphere")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--only", default="", help="states whose name has this in it")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        for settings in CASES:
            if options.only not in settings[0]:
                continue
            with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
                runs = list(pool.map(lambda seed: averages_of(
                    options.program, pathlib.Path(place), settings, seed),
                    range(1, options.seeds + 1)))
            words = {True: "steady", False: "not steady", None: "cannot tell"}
            said = {word: sum(run["steady"] is key for run in runs) for key, word in words.items()}
            print(f"{settings[0]}, time {settings[4]} to {settings[5]}: {said}, "
                  f"{np.median([run['blocks'] or 0 for run in runs]):.0f} blocks (median)")
            for row in table(runs):
                print("| {} | {} | {} | {} | {:.2f} |".format(*row))


if __name__ == "__main__":
    main()
