"""Haff's law: the granular temperature of a cooling gas against time, measured and predicted.

Granular temperature is the mean square of one component of the peculiar velocity, in
(diameter/time)^2; the peculiar velocity is the laboratory velocity minus the imposed profile and
minus the mean velocity, which a cooling gas keeps.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import InputError

EARLY = 0.5  # a fitted tau uses the snapshots with T above this fraction of T0


@dataclass(frozen=True)
class Haff:
    """T(t) = T0 / (1 + t / tau)^power. Source: Haff, J. Fluid Mech. 134 (1983) 401.

    The power is 2 for a constant restitution and 5/3 for viscoelastic spheres (Brilliantov &
    Poeschel, Phys. Rev. E 61 (2000) 5573).
    """

    start: float  # T0, (diameter/time)^2
    tau: float  # time
    is_fitted: bool  # to the early part of the run, where no formula is known
    power: float = 2

    def temperature(self, time):
        """T at the times given, (diameter/time)^2."""
        return self.start / (1 + np.asarray(time) / self.tau) ** self.power


def granular_temperature(positions, velocities, shear_rate=0.0, side=0.0):
    """Granular temperature of one snapshot.

    positions, velocities: (N, D), laboratory;  side: of the box along the gradient (y)
    """
    peculiar = np.array(velocities, dtype=float)
    if shear_rate:
        peculiar[:, 0] -= shear_rate * (positions[:, 1] - side / 2)
    return float(np.mean((peculiar - peculiar.mean(axis=0)) ** 2))


def temperature_of_snapshots(run):
    """Time and granular temperature of every snapshot, float64 (T) each.

    run: RunFile, of spheres of one mass
    Raises InputError for a mixture.
    """
    if {"species", "polydispersity"} & set(run.case):
        raise InputError(f"{run.path}: is a run of spheres that differ (a cooling figure knows unit"
                         " spheres); zenosphere export --format csv-series tells its temperatures")
    rate = run.setting("drive", "shear_rate") or 0.0
    temperatures = [granular_temperature(positions, velocities, rate, edges[1, 1] if rate else 0)
                    for positions, velocities, edges in run.snapshots()]
    return run.snapshot_times, np.array(temperatures)


def temperature_of_collisions(run, start, most=2000):
    """Time and granular temperature after collisions, from the energy that each of them lost.

    A collision at the closing speed v takes (1 - e^2) v^2 / 4. Only for a run that nothing drives
    and that has a complete log; at most `most` collisions, equally apart in ln k.
    start: T0.  Returns float64 (K), float64 (K); both empty where the run is of another kind.
    """
    if not is_plain(run) or not run.has_log or not run.collisions.complete:
        return np.empty(0), np.empty(0)
    time, speed = run.collisions.read("time", "normal_speed")
    restitution, dimension = (run.setting("system", key) for key in ("restitution", "dimension"))
    lost = (1 - restitution**2) / 4 * np.cumsum(speed**2)
    chosen = np.unique(np.geomspace(1, len(time), most).astype(int)) - 1
    return time[chosen], start - 2 * lost[chosen] / (dimension * run.spheres)


def is_plain(run):
    """Whether nothing feeds energy to the spheres of a run, and each collision takes one share."""
    return (run.setting("drive", "kind") == "none" and not {"walls", "gravity"} & set(run.case)
            and restitution_law(run) == "constant"
            and not run.setting("collision", "contact_duration")
            and run.setting("collision", "friction") is None)


def restitution_law(run):
    """The law of restitution of a run, as the case names it; older files name none."""
    return run.setting("collision", "restitution_law") or "constant"


def contact_value(dimension, fraction):
    """Pair distribution at contact of elastic spheres, disks or rods.

    fraction: solids volume, area or line fraction
    Source: 3-D Carnahan & Starling, J. Chem. Phys. 51 (1969) 635; 2-D Henderson, Mol. Phys. 30
    (1975) 971; 1-D exact (Tonks, Phys. Rev. 50 (1936) 955).
    """
    free = 1 - fraction
    return {1: 1 / free, 2: (1 - 7 / 16 * fraction) / free**2,
            3: (1 - fraction / 2) / free**3}[dimension]


def collision_rate(dimension, fraction, temperature):
    """Collisions per sphere and time of a gas with Gaussian velocities.

    Source: Chapman & Cowling, The Mathematical Theory of Non-Uniform Gases; in 1-D the mean
    relative speed 2 sqrt(T / pi) times the density of neighbours at contact.
    """
    per_speed = {1: 2 * fraction / np.sqrt(np.pi),
                 2: 8 * fraction / np.sqrt(np.pi),
                 3: 24 * fraction / np.sqrt(np.pi)}[dimension]
    return per_speed * contact_value(dimension, fraction) * np.sqrt(temperature)


def fourth_cumulant(dimension, restitution):
    """a2 of the cooling gas: how far its velocities are from Gaussian.

    Taken as 0 in 1-D, where a cooling gas has no such state: there the law holds for short times.
    Source: van Noije & Ernst, Granular Matter 1 (1998) 57.
    """
    if dimension == 1:
        return 0.0
    e, d = restitution, dimension
    return 16 * (1 - e) * (1 - 2 * e**2) / (
        9 + 24 * d + (8 * d - 41) * e + 30 * e**2 * (1 - e))


def haff_time(dimension, fraction, restitution, temperature):
    """tau of Haff's law; infinite where nothing is lost.

    1 / tau = (1 - e^2) / (2 D) x collision rate x (1 + 3 a2 / 16)
    """
    loss = (1 - restitution**2) / (2 * dimension) * collision_rate(dimension, fraction, temperature)
    with np.errstate(divide="ignore"):
        return float(1 / np.float64(loss * (1 + 3 / 16 * fourth_cumulant(dimension, restitution))))


def fitted_time(time, temperature, power=2):
    """tau from the early part, where (T0 / T)^(1 / power) - 1 = t / tau; infinite without decay.

    time, temperature: (T), the first one at the start
    """
    early = (temperature > EARLY * temperature[0]) & (time > 0)
    if not early.any():
        raise InputError("no snapshot in the early part (T falls below T0 / 2 before the first);"
                         " run the case again with a smaller output.snapshot_interval")
    t, decay = time[early], (temperature[0] / temperature[early]) ** (1 / power) - 1
    slope = np.sum(t * decay) / np.sum(t * t)
    return float(1 / slope) if slope > 0 else float("inf")


def haff_of(run, time, temperature):
    """Haff's law of a run: by formula for smooth spheres of one restitution, else fitted.

    run: RunFile;  time, temperature: of its snapshots
    """
    fraction = run.setting("system", "solids_volume_fraction")
    if is_plain(run) and fraction:
        tau = haff_time(run.setting("system", "dimension"), fraction,
                        run.setting("system", "restitution"), temperature[0])
        return Haff(temperature[0], tau, is_fitted=False)
    power = 5 / 3 if restitution_law(run) == "viscoelastic" else 2
    return Haff(temperature[0], fitted_time(time, temperature, power), is_fitted=True, power=power)
