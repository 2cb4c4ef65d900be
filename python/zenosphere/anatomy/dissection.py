"""What was found at the first hit or at the arrest: the group /zenosphere/anatomy of a file."""

from dataclasses import dataclass

import numpy as np

QUANTITIES = ("gap", "normal_speed", "flight")
_RATIOS = {"gap": "gap", "normal_speed": "speed", "flight": "flight"}


@dataclass(frozen=True)
class Dissection:
    """One dissection (docs/file-format.md). Lengths in diameters, times in the case's unit."""

    collision: int  # after which it was made
    time: float  # of that
    attributes: dict  # ratios per collision, collapse time, ...
    sphere: np.ndarray  # int32 (n)
    cluster: np.ndarray  # int32 (n): which cluster the sphere is in
    position: np.ndarray  # float64 (n, D), from the mean of the cluster
    contacts: dict  # i, j, cluster, collisions: (m) each
    chain: np.ndarray  # int32 (c): the spheres along the first cluster
    straightness: np.ndarray  # float64, one a cluster
    collisions: dict  # k, time, i, j, gap, normal_speed, flight: (s) each, of the first cluster

    def ratio(self, quantity):
        """Factor per collision of one of QUANTITIES; NaN where it could not be measured."""
        return float(self.attributes[f"{_RATIOS[quantity]}_ratio"])

    def exact_ratio(self, quantity):
        """The same of a straight chain of as many balls; NaN where such a one does not collapse."""
        return float(self.attributes[f"exact_{_RATIOS[quantity]}_ratio"])


def read(group):
    """The dissection in an open HDF5 group."""
    columns = {name: {key: values[()] for key, values in group[name].items()}
               for name in ("spheres", "contacts", "collisions")}
    attributes = dict(group.attrs)
    return Dissection(int(attributes["collision"]), float(attributes["time"]), attributes,
                      columns["spheres"]["sphere"], columns["spheres"]["cluster"],
                      columns["spheres"]["position"], columns["contacts"], group["chain"][()],
                      group["straightness"][()], columns["collisions"])


def plane_of(position):
    """Places in the plane in which a cluster is widest.

    position: float64 (n, D), D of 1, 2 or 3
    Returns float64 (n, 2): along the longest and the second axis of the cluster. The signs are
    those in which the first sphere has positive coordinates.
    """
    centred = position - position.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=True)[2] if len(position) > 1 else np.eye(
        position.shape[1])
    plane = np.zeros((len(position), 2))
    seen = (centred @ axes.T)[:, :2]
    plane[:, :seen.shape[1]] = seen
    return plane * np.where(plane[0] < 0, -1, 1)
