#!/usr/bin/python3
"""Scans the contact duration of the TC model at e = 0.2 under shear: hits, T and collision rate.

Source of the model: Luding & McNamara, Granular Matter 1 (1998) 113.

Usage: scan_contact_duration.py [FIGURE.png]
"""

import sys

import numpy as np

import scanning

CASE = "luding-mcnamara-1998-tc-shear"
DURATIONS = (0, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2)
SEEDS = (1, 2, 3, 4)
MEANS = ("granular_temperature", "gradient_temperature", "collision_rate", "shear_stress")


def measured(run):
    """The averages of one run that the table shows; NaN where it ended before they began.

    run: summary
    """
    averages = run["averages"]
    if averages["to_time"] is None:
        return {name: float("nan") for name in MEANS}
    return {"granular_temperature": averages["granular_temperature"],
            "gradient_temperature": averages["temperature_diagonal"][1],
            "collision_rate": averages["collision_rate"],
            "shear_stress": -averages["pressure_tensor"][1][0]}


def mean_and_error(values):
    """Mean and its standard error over seeds; both NaN where a run has no value."""
    values = np.asarray(values, dtype=float)
    return values.mean(), values.std(ddof=1) / np.sqrt(len(values))


def row(duration, runs):
    """One line of the Markdown table.

    runs: summaries, one a seed
    """
    share = np.mean([run["contact"]["made_elastic"] / run["collisions"] for run in runs])
    cells = [f"{duration:g}", ", ".join(run["verdict"] for run in runs),
             ", ".join(str(run["separation"]["hits"]) for run in runs), f"{share:.2g}"]
    for name in MEANS:
        mean, error = mean_and_error([measured(run)[name] for run in runs])
        cells.append("–" if np.isnan(mean) else f"{mean:.4f} +- {error:.4f}")
    return "| " + " | ".join(cells) + " |"


def draw(scans, path):
    """T and collision rate against the duration, relative to their values at 1e-4."""
    with scanning.drawn(path) as axes:
        for name, label, style in (("granular_temperature", "granular temperature", "o-"),
                                   ("gradient_temperature", "its gradient component", "d-."),
                                   ("collision_rate", "collision rate", "s--"),
                                   ("shear_stress", "shear stress", "^:")):
            known = {duration: mean_and_error([measured(run)[name] for run in runs])
                     for duration, runs in scans.items() if duration > 0}
            reference = known[1e-4][0]
            axes.errorbar(list(known), [mean / reference for mean, _ in known.values()],
                          yerr=[error / reference for _, error in known.values()], fmt=style,
                          markersize=4, linewidth=1, capsize=2, label=label)
        axes.axhline(1, color="0.7", linewidth=0.6, zorder=0)
        axes.set(xscale="log", xlabel="contact duration $t_c$ (1 / shear rate)",
                 ylabel="relative to $t_c = 10^{-4}$")
        axes.legend()


def main():
    """Prints a row for each duration, and draws the figure if a file is named."""
    print("| t_c | verdicts | hits | made elastic | T | T_yy | omega | -Pxy |")
    print("|---|---|---|---|---|---|---|---|")
    scans = {}
    for duration in DURATIONS:
        scans[duration] = [scanning.summary(CASE, {"collision.contact_duration": duration,
                                                   "start.seed": seed}) for seed in SEEDS]
        print(row(duration, scans[duration]), flush=True)
    if len(sys.argv) > 1:
        draw(scans, sys.argv[1])


if __name__ == "__main__":
    main()
