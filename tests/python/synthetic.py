"""Writes output files as docs/file-format.md describes them, with invented collisions.

`python3 synthetic.py DIR` writes e06.h5 and e02.h5 of realistic length, to look at figures with.
"""

import json
import sys
from pathlib import Path

import h5py
import numpy as np

SPHERES = 4000


def write_run(path, gap, time=None, i=None, j=None, first=1, complete=True, log=True,
              restitution=0.6, threshold=1e-16, arrest=None, window=10000, **summary):
    """Writes one file and returns its path.

    gap: (K) diameters, one per logged collision;  time: (K);  i, j: (K) spheres
    first: number of the first logged collision;  arrest: number of the arrest, or None
    summary: keys that replace those of the JSON summary
    """
    gap = np.asarray(gap, dtype=float)
    count = len(gap)
    k = np.arange(first, first + count, dtype=np.int64)
    time = np.linspace(0, 1, count) if time is None else np.asarray(time, dtype=float)
    hits = gap <= threshold
    with h5py.File(path, "w") as file:
        if log:
            _write_log(file, complete, k=k, time=time, gap=gap, flags=hits.astype(np.uint8),
                       i=np.zeros(count, np.int32) if i is None else i,
                       j=np.ones(count, np.int32) if j is None else j,
                       normal_speed=np.ones(count))
        text = _summary(k, time, hits, arrest, window) | summary
        _write_zenosphere(file, text, restitution, threshold, window)
    return path


def false_positive(collisions, seed=1):
    """e = 0.6: hits in bursts from 1/150 to 1/20 of the run; the clock nearly stops meanwhile."""
    random = np.random.default_rng(seed)
    k = np.arange(1, collisions + 1)
    begin, end = collisions // 150, collisions // 20
    gap = 10 ** random.uniform(-9, -2.2, collisions) * random.random(collisions)
    stage = (k >= begin) & (k <= end)
    cluster = stage & (np.sin(k / collisions * 700) + 0.8 * random.standard_normal(collisions) > 0)
    gap[cluster] = 10 ** random.uniform(-15.5, -7, cluster.sum())
    burst = cluster & (random.random(collisions) < 0.3)
    gap[burst] = random.choice([0, -4.4e-16, 1e-16, -8.9e-16], burst.sum())
    gap[[begin - 1, end - 1]] = 0
    step = np.where(stage, 2e-9, 1 / (2.53 * SPHERES)) * random.exponential(size=collisions)
    step[:begin] = 0.69 / begin
    i, j = _spheres(random, collisions, cluster)
    return {"gap": gap, "time": np.cumsum(step), "i": i, "j": j, "restitution": 0.6,
            "verdict": "temporary"}


def true_collapse(collisions, seed=2):
    """e = 0.2: the separation falls until only hits are left and the clock stands still."""
    random = np.random.default_rng(seed)
    k = np.arange(1, collisions + 1)
    settled = int(collisions * 0.9)
    depth = np.where(k < 0.1 * collisions, 0, -8.5 * (k / settled) ** 0.4)
    gap = 10 ** (random.uniform(-7, -2.5, collisions) + depth * random.random(collisions))
    gap[(k > 0.05 * collisions) & (random.random(collisions) < 0.15 * k / settled)] = -2.2e-16
    gap[k >= settled] = 0
    step = 1e-4 * np.exp(-18 * k / settled) * random.exponential(size=collisions)
    step[k >= settled] = 0
    i, j = _spheres(random, collisions, k > settled - 150)
    i[settled:], j[settled:] = 17, 2305
    return {"gap": gap, "time": np.cumsum(step), "i": i, "j": j, "restitution": 0.2,
            "verdict": "true", "arrest": collisions, "window": collisions - settled + 1}


def _spheres(random, collisions, cluster):
    """Partners of each collision: any two, but of one small cluster where `cluster` is true."""
    i = random.integers(0, SPHERES - 1, collisions).astype(np.int32)
    j = (i + 1).astype(np.int32)
    members = random.integers(0, 3, cluster.sum()).astype(np.int32) * 5 + 17
    i[cluster], j[cluster] = members, members + 2288
    return i, j


def _write_log(file, complete, **columns):
    group = file.create_group("collisions")
    group.attrs["complete"] = np.uint8(complete)
    for name, values in columns.items():
        group[name] = values


def _write_zenosphere(file, summary, restitution, threshold, window):
    group = file.create_group("zenosphere")
    group.attrs.update({"format_version": np.int64(1), "program_version": "0.1.0",
                        "git_hash": "0123abc", "compiler": "g++ 12.2.0",
                        "compiler_flags": "-O3", "complete": np.uint8(1)})
    group["case"] = "# as it was read\n"
    group["summary"] = json.dumps(summary)
    group["resolved"] = (
        f"[system]\ndimension = 3\nspheres = {SPHERES}\nrestitution = {restitution}\n"
        "solids_volume_fraction = 0.3\n"
        '[start]\narrangement = "fcc"\ngranular_temperature = 6e-3\nseed = 1\n'
        '[drive]\nkind = "shear"\nshear_rate = 1.0\n'
        '[collision]\noverlap = "rewind"\nprecision = "double"\n'
        f"[collapse]\ngap_threshold = {threshold}\nwindow = {window}\n")


def _summary(k, time, hits, arrest, window):
    """The JSON summary that these collisions would have, as a dict."""
    numbers, times = k[hits], time[hits]
    met = arrest is not None
    return {
        "collisions": int(k[-1]), "collisions_per_sphere": 2 * int(k[-1]) / SPHERES,
        "time": float(time[-1]), "strain": float(time[-1]), "outcome": "finished",
        "verdict": "true" if met else "temporary" if hits.any() else "none",
        "separation": {"hits": int(hits.sum()),
                       "first_collision": int(numbers[0]) if hits.any() else None,
                       "first_time": float(times[0]) if hits.any() else None,
                       "last_collision": int(numbers[-1]) if hits.any() else None},
        "arrest": {"met": met, "collision": arrest,
                   "time": float(time[arrest - int(k[0])]) if met else None,
                   "window": window, "pairs": [[17, 2305]] if met else []},
        "absorbed": 0,
        "averages": {"granular_temperature": 0.2417, "collision_rate": 5.063,
                     "from_time": 0.5, "to_time": float(time[-1])},
        "ledger_error": 3.1e-13}


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    write_run(folder / "e06.h5", **false_positive(collisions=2000000))
    write_run(folder / "e02.h5", **true_collapse(collisions=400000))
