#!/usr/bin/python3
"""Does the steady flow at e = 0.6 depend on how the collapse of the cold lattice is passed?

Runs shear-e06 with several seeds in each variant that may lead past its collapse, and compares
averages of the flow with those of the same spheres from a hot start, which never collapses.

Usage: scan_after_collapse.py [--spheres N ...] [--seeds N] [--until STRAIN] [--variants NAME ...]
       [--store RUNS.jsonl] [--stored] [--figure FIGURE.png]
"""

import argparse
import json
from pathlib import Path

import numpy as np

import averages
import scanning
from collapse_variants import VARIANTS

CASE = "shear-e06"
FIRST_STRAIN = 20        # averages begin there; the last hits come before strain 1
BLOCKS = 10              # of equal strain, from there to the end
UNTIL = {500: 420, 4000: 100}  # strain, for the numbers of spheres that are not told otherwise

QUANTITIES = {
    "T": lambda a: a["granular_temperature"],
    "T_xx": lambda a: a["temperature_diagonal"][0],
    "T_yy": lambda a: a["temperature_diagonal"][1],
    "T_zz": lambda a: a["temperature_diagonal"][2],
    "p": lambda a: a["pressure"],
    "P_yy": lambda a: a["pressure_tensor"][1][1],
    "P_zz": lambda a: a["pressure_tensor"][2][2],
    "-P_xy": lambda a: -a["pressure_tensor"][1][0],
    "omega": lambda a: a["collision_rate"],
}


def ends_of(until, blocks=BLOCKS):
    """Strains at which blocks end, the first number being where the first one begins."""
    return [float(end) for end in np.linspace(FIRST_STRAIN, until, blocks + 1)]


def block_means(stages):
    """Mean of each quantity in each block: {name: (blocks)}.

    stages: averages of summaries at the ends of the blocks, each from the same beginning on
    """
    spans = np.array([stage["to_time"] - stage["from_time"] for stage in stages])
    means = {}
    for name, value in QUANTITIES.items():
        sums = spans * [value(stage) for stage in stages]
        means[name] = (np.diff(sums, prepend=0) / np.diff(spans, prepend=0)).tolist()
    return means


def measured(variant, spheres, seed, until):
    """One run in blocks: verdict, hits, strain reached and block means (none if it arrested)."""
    changes = {"system.spheres": spheres, "start.seed": seed, "run.collisions": 10**12,
               "measure.after_time": FIRST_STRAIN, "output.collision_log": "none",
               "output.snapshot_interval": 1e6, **variant.changes}
    runs = scanning.stages(CASE, changes, "run.time", ends_of(until)[1:])
    last = runs[-1]
    told = {"variant": variant.name, "spheres": spheres, "seed": seed, "until": until,
            "verdict": last["verdict"], "hits": last["separation"]["hits"],
            "last_hit": last["separation"]["last_time"], "strain": last["strain"],
            "collisions": last["collisions"], "contact": last["contact"],
            "normal_speed": last["averages"]["normal_speed"]}
    if last["outcome"] == "finished":
        told["blocks"] = block_means([run["averages"] for run in runs])
    return told


def stored(path):
    """{(variant, spheres, seed, end): run} of a file of JSON lines; empty where there is none."""
    lines = path.read_text().splitlines() if path and path.is_file() else []
    runs = [json.loads(line) for line in lines]
    return {(run["variant"], run["spheres"], run["seed"], run["until"]): run for run in runs}


def runs_of(variants, sizes, seeds, store):
    """All runs asked for; those that the store has are not done again.

    sizes: {spheres: strain at the end};  store: path of a file of JSON lines, or None
    """
    known = stored(store)
    for spheres, until in sizes.items():
        for seed in range(1, seeds + 1):
            for variant in variants:
                key = variant.name, spheres, seed, until
                if key not in known:
                    known[key] = measured(variant, spheres, seed, until)
                    if store:
                        with store.open("a") as lines:
                            lines.write(json.dumps(known[key]) + "\n")
                yield known[key]


def values(runs, name, blocks=slice(None)):
    """Mean of a quantity over some blocks of each run that has them: (runs)."""
    return np.array([np.mean(run["blocks"][name][blocks]) for run in runs if "blocks" in run])


def block_error(runs, name):
    """The error of the mean over runs if every block were independent of the others."""
    blocks = [run["blocks"][name] for run in runs if "blocks" in run]
    variance = np.mean([np.var(each, ddof=1) for each in blocks])
    return float(np.sqrt(variance / np.size(blocks)))


def counted(words):
    """["none", "none", "true"] as "2 `none`, 1 `true`"."""
    return ", ".join(f"{words.count(word)} `{word}`" for word in sorted(set(words)))


def passage(variant, runs):
    """One line of the table of what happened at the collapse."""
    hits = sorted(run["hits"] for run in runs)
    last = [run["last_hit"] for run in runs if run["last_hit"] is not None]
    elastic = np.mean([run["contact"]["made_elastic"] / run["collisions"] for run in runs])
    verdicts = counted([run["verdict"] for run in runs])
    return (f"| {variant.name} | {verdicts} | {hits[0]}-{hits[-1]} |"
            f" {f'{max(last):.3f}' if last else '–'} | {min(run['strain'] for run in runs):.3f} |"
            f" {elastic:.2g} |")


def flow(variant, by_name, blocks, spreads):
    """One line of the table of averages: mean(error), and the difference from the control.

    spreads: {name: averages.spread_of_a_run}, which the error of the difference is made from
    """
    cells = [variant.name]
    for name in QUANTITIES:
        ours, theirs = (values(by_name[each], name, blocks)
                        for each in (variant.name, variant.control))
        cell = f"{ours.mean():.4f}({1e4 * averages.error_of_mean(ours):.0f})"
        if variant.name != variant.control:
            error = spreads[name] * np.sqrt(1 / len(ours) + 1 / len(theirs))
            cell += f" {(ours.mean() / theirs.mean() - 1) / error:+.1f}"
        cells.append(cell)
    return "| " + " | ".join(cells) + " |"


def show(spheres, by_name, blocks, strains):
    """Prints the averages of a window, the chance of one flow, and the check of the errors."""
    flowing = [variant for variant in VARIANTS if {variant.name, variant.control} <= by_name.keys()
               and any("blocks" in run for run in by_name[variant.name])]
    print(f"\nN = {spheres}, strain {strains[0]:g} to {strains[1]:g}: mean(error of the last"
          " digits), difference from the hot start in standard errors\n")
    print("| variant | " + " | ".join(QUANTITIES) + " |\n|" + "---|" * (1 + len(QUANTITIES)))
    spreads = {name: averages.spread_of_a_run([values(by_name[variant.name], name, blocks)
                                               for variant in flowing])
               for name in QUANTITIES}
    for variant in flowing:
        print(flow(variant, by_name, blocks, spreads))
    same = [variant.name for variant in flowing if variant.is_same_law]
    chances = [averages.chance_of_one_mean([values(by_name[each], name, blocks) for each in same])
               for name in QUANTITIES]
    print("| chance of one flow | " + " | ".join(f"{chance:.2g}" for chance in chances) + " |")
    ratios = [averages.root_mean_square([block_error(by_name[variant], name) for variant in same])
              / averages.root_mean_square([averages.error_of_mean(values(by_name[variant], name))
                                           for variant in same]) for name in QUANTITIES]
    print("| error from blocks / from seeds | " + " | ".join(f"{r:.2f}" for r in ratios) + " |")


SHOWN = {"T_yy": "$T_{yy}$", "P_yy": "$P_{yy}$", "-P_xy": "$-P_{xy}$",
         "omega": r"collision rate $\omega$"}


def draw(results, path):
    """Differences from the hot start in percent, one row a variant, one panel a quantity."""
    variants = [variant for variant in VARIANTS if variant.name != variant.control and any(
        "blocks" in run for by_name in results.values() for run in by_name.get(variant.name, ()))]
    with scanning.drawn(path, size=(7.2, 4.2), columns=len(SHOWN)) as panels:
        for panel, name in zip(panels, SHOWN):
            draw_panel(panel, name, variants, results)
        panels[0].set_yticks(range(len(variants)), [variant.label for variant in variants])
        panels[0].invert_yaxis()
        panels[1].legend(loc="lower right", handletextpad=0.2)
        panels[0].figure.supxlabel("difference from the hot start of the same law (%),"
                                   " with standard errors", fontsize=9)


def draw_panel(panel, name, variants, results):
    """One quantity: a point with its error for each variant and number of spheres."""
    for (spheres, by_name), style, shift in zip(results.items(), "os^", (-.15, .15, 0)):
        for place, variant in enumerate(variants):
            if not {variant.name, variant.control} <= by_name.keys():
                continue
            ours, theirs = (values(by_name[each], name)
                            for each in (variant.name, variant.control))
            error = np.hypot(averages.error_of_mean(ours), averages.error_of_mean(theirs))
            panel.errorbar(100 * (ours.mean() / theirs.mean() - 1), place + shift, fmt=style,
                           xerr=100 * error / theirs.mean(), color=f"C{'os^'.index(style)}",
                           markersize=4, capsize=2,
                           label=f"$N = {spheres}$" if variant.name == "rewind" else None)
    panel.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    panel.set_title(SHOWN[name], fontsize=9)


def arguments():
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spheres", type=int, nargs="+", default=list(UNTIL), metavar="N")
    parser.add_argument("--seeds", type=int, default=5, metavar="N", help="seeds 1 to N")
    parser.add_argument("--until", type=float, metavar="STRAIN", help="end of every run")
    names = [variant.name for variant in VARIANTS]
    parser.add_argument("--variants", nargs="+", metavar="NAME", choices=names, default=names,
                        help="some of them")
    parser.add_argument("--store", type=Path, metavar="RUNS.jsonl", help="keeps what was done")
    parser.add_argument("--stored", action="store_true", help="do no more runs, show the store")
    parser.add_argument("--figure", metavar="FIGURE.png")
    return parser.parse_args()


def main():
    """Does the runs, prints the tables, and draws the figure if a file is named."""
    asked = arguments()
    sizes = {n: asked.until or UNTIL.get(n, UNTIL[4000]) for n in asked.spheres}
    variants = [variant for variant in VARIANTS if variant.name in asked.variants]
    results = {n: {} for n in sizes}
    runs = stored(asked.store).values() if asked.stored else runs_of(variants, sizes, asked.seeds,
                                                                     asked.store)
    for run in runs:
        if run["until"] == sizes.get(run["spheres"]) and run["seed"] <= asked.seeds:
            results[run["spheres"]].setdefault(run["variant"], []).append(run)
    for spheres, by_name in results.items():
        print(f"\nN = {spheres}\n\n| variant | verdicts | hits | last hit at | end at |"
              " made elastic |")
        print("|---|---|---|---|---|---|")
        for variant in variants:
            if variant.name in by_name:
                print(passage(variant, by_name[variant.name]))
        ends = ends_of(sizes[spheres])
        for first, last in ((0, BLOCKS), (0, BLOCKS // 2), (BLOCKS // 2, BLOCKS)):
            show(spheres, by_name, slice(first, last), (ends[first], ends[last]))
    if asked.figure:
        draw(results, asked.figure)


if __name__ == "__main__":
    main()
