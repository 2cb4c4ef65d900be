#!/usr/bin/python3
"""Pressure of elastic binary mixtures of spheres and of disks, beside their equations of state.

Prints Z = p V / (N T) of each composition with its standard error, and that of Boublik (1970) and
Mansoori, Carnahan, Starling & Leland (J. Chem. Phys. 54 (1971) 1523) for spheres, of Jenkins &
Mancini (J. Appl. Mech. 54 (1987) 27) for disks. The latter is that of Santos, Yuste & Lopez de Haro
(Mol. Phys. 96 (1999) 1) with Henderson's equation for disks of one size. The last two columns
compare spheres with the first equation, and with that of Hansen-Goos & Roth, times what Kolafa's for
one size is of Carnahan & Starling's.

Usage: mixture_pressure.py [COLLISIONS_PER_SPHERE [SEED]]      default 1000 and 1, about a minute
"""

import sys

import scanning

SPHERES = 4000

# Dimension, solids fraction, diameter of the large ones, their share of the number
COMPOSITIONS = ((3, 0.3, 1, 0.5), (3, 0.3, 1.4, 0.5), (3, 0.3, 2, 0.2), (3, 0.3, 3, 0.05),
                (3, 0.4, 1, 0.5), (3, 0.4, 2, 0.2), (2, 0.4, 1.4, 0.5), (2, 0.5, 2, 0.2), (2, 0.5, 3, 0.05))


def moments(diameter, share):
    """Means of diameter^k, k = 0 to 3, of unit spheres and a share of larger ones."""
    return [1 - share + share * diameter**k for k in range(4)]


def of_spheres(fraction, diameter, share):
    """Z of Boublik and of Mansoori, Carnahan, Starling & Leland, of additive hard spheres."""
    m = moments(diameter, share)
    xi = [fraction * each / m[3] for each in m]  # (pi/6) rho <s^k>
    free = 1 - fraction
    return (1 / free + 3 * xi[1] * xi[2] / (xi[0] * free**2)
            + xi[2]**3 * (3 - fraction) / (xi[0] * free**3))


def of_disks(fraction, diameter, share):
    """Z of Jenkins & Mancini, of additive hard disks.

    Their g_ij at contact is 1/(1 - phi) + (9/16) phi s_i s_j <s> / (s_ij <s^2>) / (1 - phi)^2, with
    s_ij the mean diameter; Z - 1 is (pi/2) rho times the mean of s_ij^2 g_ij over all pairs.
    """
    m = moments(diameter, share)
    alike = m[1]**2 / m[2]  # 1 for disks of one size
    free = 1 - fraction
    return 1 / free + alike * fraction * (1 + fraction / 8) / free**2


def of_one_size(fraction):
    """Z of Kolafa for spheres of one size (Boublik & Nezbeda, Collect. Czech. Chem. Commun. 51
    (1986) 2301), over that of Carnahan & Starling."""
    first = 1 + fraction + fraction**2
    return (first - 2 / 3 * fraction**3 * (1 + fraction)) / (first - fraction**3)


def of_spheres_in_white_bear(fraction, diameter, share):
    """Z of Hansen-Goos & Roth (J. Chem. Phys. 124 (2006) 154506), of additive hard spheres."""
    m = moments(diameter, share)
    pairs = 3 * m[1] * m[2] / m[3]
    triples = 3 * m[2]**3 / m[3]**2
    free = 1 - fraction
    return (1 / free + fraction * pairs * (1 + fraction**2 / 3) / free**2
            + fraction**2 * triples * (1 - 2 * fraction / 3 + fraction**2 / 3) / free**3)


def better(*composition):
    """Z of the two equations of spheres that both are Kolafa's for one size."""
    return [of_one_size(composition[0]) * equation(*composition)
            for equation in (of_spheres, of_spheres_in_white_bear)]


def expected(dimension, *composition):
    """Z of the equation of state."""
    return (of_spheres if dimension == 3 else of_disks)(*composition)


def changes(dimension, fraction, diameter, share, per_sphere, seed):
    """What makes an elastic gas of this composition of the case binary-shear."""
    return {"system.dimension": dimension, "system.spheres": SPHERES, "system.restitution": 1,
            "system.solids_volume_fraction": fraction, "species.large.diameter": diameter,
            "species.large.share": share, "species.small.share": 1 - share, "drive.kind": "none",
            "run.collisions": int(per_sphere * SPHERES / 2), "run.time": 1e6,
            "measure.after_time": 0.5, "start.seed": seed}


def measured(composition, per_sphere, seed):
    """Z of a run and its standard error, NaN where the run is too short for one."""
    averages = scanning.summary("binary-shear", changes(*composition, per_sphere, seed))["averages"]
    error = averages["standard_error"]["compressibility_factor"]
    return averages["compressibility_factor"], float("nan") if error is None else error


def main(per_sphere=1000, seed=1):
    """Prints a table in Markdown."""
    print("| D | phi | diameters | share of the large | Z measured | equation of state |"
          " difference | with Kolafa | Hansen-Goos & Roth |\n|---|---|---|---|---|---|---|---|---|")
    for composition in COMPOSITIONS:
        z, error = measured(composition, per_sphere, int(seed))
        theory = expected(*composition)
        dimension, fraction, diameter, share = composition
        others = better(*composition[1:]) if dimension == 3 else ()
        differences = "".join(f" {100 * (z / each - 1):+.2f} % |" for each in (theory, *others))
        print(f"| {dimension} | {fraction} | 1, {diameter} | {share} | {z:.4f} ± {error:.4f} |"
              f" {theory:.4f} |{differences}", flush=True)


if __name__ == "__main__":
    main(*map(float, sys.argv[1:3]))
