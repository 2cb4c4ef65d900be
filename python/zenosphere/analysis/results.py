"""All measurements of a run together."""

import os
from typing import Any

from ..output import open as open_output
from .accumulated import IN_PLACE_OF, accumulated_distributions, losses_by_kinds
from .collision_log import collision_distributions
from .contacts import Contacts, FreePath
from .displacements import Displacements
from .frames import Frames
from .partial import PartialDistributions
from .profiles import Profiles
from .radial import RadialDistribution
from .rows import Rows
from .stress import stresses
from .structure import StructureFactor
from .velocities import Velocities, VelocitiesOfKinds

MEASUREMENTS = (RadialDistribution, StructureFactor, Velocities, Profiles, FreePath, Contacts,
                Displacements)
OF_MIXTURES = (PartialDistributions, *MEASUREMENTS[1:], VelocitiesOfKinds)


def analyse(path: str | os.PathLike[str], *, from_time: float | None = None,
            to_time: float | None = None) -> dict[str, Any]:
    """Structure, velocities, profiles and transport of a run, from its snapshots.

    Where the run has accumulated samples (`measure.sampling_interval`), radial distributions,
    structure of long waves, velocities, profiles, displacements, free path and distributions over
    collisions are those of the samples.

    path: an output file, of a run that has ended or still goes on
    from_time, to_time: of the snapshots that count; from where the averages of the run begin, to
    the last one
    Returns the object that `zenosphere analyse --json` prints (docs/measurements.md), with NumPy
    arrays for its lists: `analyse("run.h5")["radial_distribution"]["g"]`. What cannot be known is
    None, in arrays NaN.
    Raises InputError where there is no such file, or no snapshot or sample of that time in it.
    """
    output = open_output(path)
    frames = Frames(output, from_time, to_time)
    chosen = MEASUREMENTS if frames.kinds is None else OF_MIXTURES
    rows = Rows(output.samples, frames.begin, to_time)
    if not len(rows):
        frames.require_some()
    replaced = IN_PLACE_OF if len(rows) else {}
    measurements = [replaced[measurement](frames, rows) if measurement in replaced
                    else measurement(frames) for measurement in chosen]
    for frame in frames:
        for measurement in measurements:
            measurement.add(frame)
    found = {"file": output.path, "spheres": frames.spheres, "dimension": frames.dimension,
             "snapshots": len(frames), "from_time": frames.first.time if len(frames) else None,
             "to_time": frames.last.time if len(frames) else None}
    for measurement in measurements:
        found |= measurement.result()
    found |= stresses(output.summary, frames.shear_rate)
    found["collision_distributions"] = (collision_distributions(output.path, *frames.span)
                                        if output.has_every_collision and len(frames) else None)
    if not len(rows):
        return found | {"accumulated": None}
    found["collision_distributions"] = (found["collision_distributions"] or {}
                                        ) | (accumulated_distributions(rows) or {}) or None
    kinds = {"dissipation_by_kinds": losses_by_kinds(rows, frames.kinds, frames.box.sides.prod())}
    return found | {"accumulated": rows.told() | kinds}
