"""Whether two output files hold the same, but for what wall time and memory leave in them."""

import json

import h5py
import numpy as np

COSTS = {"wall_seconds", "collisions_per_second", "peak_memory_bytes"}


def same_values(a, b):
    """Alike in every bit: NaN equals itself, 0 differs from -0."""
    a, b = np.asarray(a), np.asarray(b)
    if a.dtype.kind not in "iuf":  # texts
        return a.tolist() == b.tolist()
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def summary(file):
    return {key: value for key, value in json.loads(file["zenosphere/summary"][()]).items()
            if key not in COSTS}


def paths(file):
    """Names of all objects; `visititems` would pass over the second name of a hard link."""
    found = []

    def walk(group, prefix):
        for name in group:
            found.append(prefix + name)
            if isinstance(group[name], h5py.Group):
                walk(group[name], prefix + name + "/")

    walk(file, "")
    return sorted(found)


def same_attributes(a, b):
    names = set(a.attrs) - COSTS
    return names == set(b.attrs) - COSTS and all(
        same_values(a.attrs[name], b.attrs[name]) for name in names)


def same_content(name, a, b):
    """Whether the objects of one name are alike."""
    if not same_attributes(a, b):
        return False
    if isinstance(a, h5py.Group):
        return isinstance(b, h5py.Group)
    if name == "zenosphere/checksums":  # those of wall times differ
        return True
    if name == "zenosphere/summary":
        return summary(a.file) == summary(b.file)
    return same_values(a[()], b[()])


def differences(path, other):
    """The names of all objects and attributes' owners that are not alike in the two files."""
    with h5py.File(path, "r") as a, h5py.File(other, "r") as b:
        if paths(a) != paths(b):
            return sorted(set(paths(a)) ^ set(paths(b)))
        return [name for name in paths(a) if not same_content(name, a[name], b[name])]
