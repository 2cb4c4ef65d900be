#!/usr/bin/python3
"""When streaks set in: repeats the runs of sweeps/shear-streaks.toml and reads their time series.

The onset of a run is the middle of the first strain of 10 over which what the summary calls a
streak is there on average: the four longest waves carry more than 2.5 % of T_xx, and the strongest
has more than 30 times the thermal energy (docs/measurements.md#streaks).

Usage: scan_streaks.py [FIGURE.png [KEPT.json]]
"""

import math
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np

import scanning
from averages import error_of_mean

SWEEP = scanning.EXAMPLES / "sweeps" / "shear-streaks.toml"
WINDOW = 10  # strain, over which a streak has to be there
SHARE, STRENGTH = 0.025, 30  # the limits of src/flow


def strength(modes, along_flow, spheres):
    """Energy of each wave over that in a gas without any, A^2 N / (4 T_xx).

    modes: amplitudes A, (K, waves);  along_flow: T_xx (K)
    """
    return modes**2 * spheres / (4 * along_flow[:, None])


def onset(strain, modes, along_flow, spheres):
    """Strain at which the streak is there for the first time; NaN if it never is.

    strain: of the ends of equal intervals (K);  modes, along_flow: as for `strength`
    """
    over_thermal = strength(modes, along_flow, spheres)
    share = np.sum(over_thermal - 1, axis=1) * 2 / spheres
    step = strain[1] - strain[0]
    intervals = max(1, round(WINDOW / step))
    weights = np.full(intervals, 1 / intervals)
    strongest = np.max([np.convolve(wave, weights, "valid") for wave in over_thermal.T], axis=0)
    met = (np.convolve(share, weights, "valid") > SHARE) & (strongest > STRENGTH)
    return float(strain[np.argmax(met)] - step + WINDOW / 2) if met.any() else math.nan


def lift_up(shear_stress, fraction, spheres):
    """Strength of the wave along z in a stable gas, 1 + 1 / (2 lambda^2), at shear rate 1.

    v_x' = -lambda v_x - v_y, and v_y is a thermal wave of the same damping, lambda = nu k^2.
    shear_stress: -P_xy, the viscosity
    """
    density = 6 * fraction / math.pi
    damping = shear_stress / density * (2 * math.pi)**2 * (density / spheres)**(2 / 3)
    return 1 + 1 / (2 * damping**2)


def measured():
    """Of each run what docs/results-shear.md has of it."""
    sweep = tomllib.loads(SWEEP.read_text(encoding="utf-8"))
    points = math.prod(len(values) for values in sweep["axes"].values())
    return [_run(number) for number in range(points * sweep["sweep"]["seeds"])]


def _run(number):
    import h5py
    with tempfile.TemporaryDirectory() as folder:
        case, output = Path(folder) / "case.toml", Path(folder) / "run.h5"
        case.write_bytes(subprocess.run([scanning.program(), "sweep", "show", SWEEP, "--run",
                                         str(number)], capture_output=True, check=True).stdout)
        subprocess.run([scanning.program(), "run", case, "-o", output, "--quiet", "--set",
                        'output.collision_log="none"'], capture_output=True, check=True)
        system = tomllib.loads(case.read_text(encoding="utf-8"))["system"]
        with h5py.File(output) as file:
            series = file["zenosphere/series"]
            strain, modes = series["time"][:], series["streak_modes/value"][:]
            along_flow = series["temperature_diagonal/value"][:, 0]
            stress = -series["pressure_tensor/value"][:, 0, 1]
    over_thermal, third = strength(modes, along_flow, system["spheres"]), len(strain) // 3
    late = over_thermal[2 * third:]
    return {"restitution": system["restitution"], "fraction": system["solids_volume_fraction"],
            "onset": onset(strain, modes, along_flow, system["spheres"]),
            "share": float(np.sum(late - 1, axis=1).mean() * 2 / system["spheres"]),
            "strengths": list(over_thermal[third:].mean(axis=0)),
            "lift_up": lift_up(stress[third:].mean(), system["solids_volume_fraction"],
                               system["spheres"])}


def by_point(runs):
    """(fraction, restitution) -> its runs, in ascending order."""
    points = {}
    for run in sorted(runs, key=lambda run: (run["fraction"], run["restitution"])):
        points.setdefault((run["fraction"], run["restitution"]), []).append(run)
    return points


def row(runs):
    """Cells of a table: runs with a streak, mean onset of these, its error, least and largest."""
    onsets = np.array([run["onset"] for run in runs if not math.isnan(run["onset"])])
    shares = [run["share"] for run in runs]
    seen = f"{len(onsets)} of {len(runs)}"
    shown = f"{min(shares):.3f} to {max(shares):.3f}"
    if len(onsets) == 0:
        return seen, "-", "-", shown
    error = f" +- {error_of_mean(onsets):.0f}" if len(onsets) > 1 else ""
    return seen, f"{onsets.mean():.0f}{error}", ", ".join(f"{x:.0f}" for x in sorted(onsets)), shown


def draw(points, path):
    """Onset against e, a mark for each run; those without a streak at the upper edge, open."""
    with scanning.drawn(path) as axes:
        fractions = sorted({fraction for fraction, _ in points})
        for place, fraction in enumerate(fractions):
            found = [(e + 0.008 * (place - 1), run["onset"]) for (phi, e), runs in points.items()
                     if phi == fraction for run in runs]
            late = [(e, 155) for e, strain in found if math.isnan(strain)]
            line = axes.plot(*zip(*[x for x in found if not math.isnan(x[1])]), "os^"[place],
                             markersize=4, label=rf"$\phi$ = {fraction}")[0]
            if late:
                axes.plot(*zip(*late), "os^"[place], markersize=4, fillstyle="none",
                          color=line.get_color())
        axes.set(xlabel="restitution $e$", ylabel="strain at the onset of a streak", ylim=(0, 160))
        axes.legend()


def main():
    """Prints a row for each point, and draws the figure if a file is named."""
    runs = scanning.kept(sys.argv[2] if len(sys.argv) > 2 else None, measured)
    points = by_point(runs)
    print("phi   e     streak    onset (strain)   of each run               share of T_xx later"
          "  lift-up  waves along y, z and both diagonals")
    for (fraction, restitution), found in points.items():
        seen, mean, each, shares = row(found)
        waves = np.mean([run["strengths"] for run in found], axis=0)
        lift = np.mean([run["lift_up"] for run in found])
        print(f"{fraction:<4}  {restitution:<4}  {seen:8}  {mean:15}  {each:24}  {shares:18}"
              f"  {lift:7.1f}  " + " ".join(f"{wave:6.1f}" for wave in waves))
    if len(sys.argv) > 1:
        draw(points, sys.argv[1])


if __name__ == "__main__":
    main()
