#!/usr/bin/python3
"""Does the steady flow at e = 0.6 depend on how the collapse of the cold lattice is passed?

Runs shear-e06 with several seeds under each way to get past its collapse, and compares averages of
the flow with those of the same spheres from a hot random start, which never collapses.

Usage: scan_after_collapse.py [--spheres N ...] [--seeds N] [--until STRAIN] [--ways NAME ...]
       [--store RUNS.jsonl] [--stored] [--figure FIGURE.png]
"""

import argparse
import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import averages
import scanning

CASE = "shear-e06"
FIRST_STRAIN = 20        # averages begin there; the last hits come before strain 1
BLOCKS = 10              # of equal strain, from there to the end
UNTIL = {500: 420, 4000: 100}  # strain, for the numbers of spheres that are not told otherwise
MEAN_SPEED = 0.871       # mean closing speed of the flow at e = 0.6, diameters x shear rate
SHARE = 1 - 0.6**2       # of the kinetic energy along the normal that a collision takes there

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


def viscoelastic_restitution(speed, constant):
    """e(v) of docs/contact-models.md at a closing speed, both in units of the case."""
    x = np.sqrt(constant * speed**0.2)
    b2 = 1.1534488580952884
    b4 = 0.4 * b2 * b2
    b1 = 4 / (15 * b4)
    return (1 + b1 * x) / (1 + b1 * x + b2 * x**2 + b1 * b2 * x**3 + b4 * x**4)


def share_lost(restitution, mean_speed):
    """Energy lost over energy along the normal before, in collisions of Maxwellian spheres.

    restitution: function of an array of closing speeds, which are distributed as
    v exp(-v^2 / (4 T)) with the mean sqrt(pi T) = mean_speed
    """
    temperature = mean_speed**2 / np.pi
    speed = (np.arange(4000) + 0.5) / 4000 * 14 * np.sqrt(temperature)
    weight = speed**3 * np.exp(-speed**2 / (4 * temperature))
    return float(np.sum(weight * (1 - restitution(speed)**2)) / np.sum(weight))


def viscoelastic_constant(share=SHARE, mean_speed=MEAN_SPEED):
    """The A with which viscoelastic spheres lose that share of the energy along the normal."""
    low, high = 1e-3, 10.0  # the share grows with A
    for _ in range(60):
        middle = np.sqrt(low * high)
        share_there = share_lost(lambda v: viscoelastic_restitution(v, middle), mean_speed)
        low, high = (middle, high) if share_there < share else (low, middle)
    return round(low, 4)


HOT = {"start.arrangement": "random", "start.granular_temperature": 1}
VISCOELASTIC = {"collision.restitution_law": "viscoelastic",
                "collision.viscoelastic_constant": viscoelastic_constant()}
# The share that a fixed loss takes, x exp(-x) with x = loss / T, is largest where x = 1: 0.37, less
# than the 0.64 of e = 0.6. With this loss the flow comes to that, as it settles at T = 0.5.
FIXED_LOSS = {"collision.restitution_law": "fixed-loss", "collision.energy_loss": 0.5}


@dataclass(frozen=True)
class Way:
    """One way past the collapse: what it changes in the case, and what it is compared with."""

    name: str
    changes: dict = field(hash=False)
    control: str = "hot start"
    is_same_law: bool = False  # but for a collapse, collisions are those of the constant e = 0.6


WAYS = (
    Way("hot start", HOT, is_same_law=True),
    Way("rewind", {}, is_same_law=True),
    Way("rewind, 64 bits", {"collision.precision": "extended"}, is_same_law=True),
    *(Way(f"t_c = {t}", {"collision.contact_duration": float(t)}, is_same_law=t != "1e-3")
      for t in ("1e-6", "1e-5", "1e-4", "1e-3")),
    *(Way(f"rotation {a:g}", {"collision.rotation_angle": a}, is_same_law=a < 0.1)
      for a in (1e-3, 1e-2, 1e-1)),
    Way("immediate", {"collision.overlap": "immediate"}),
    Way("guarded", {"collision.overlap": "guarded"}),
    Way("viscoelastic, hot start", {**VISCOELASTIC, **HOT}, "viscoelastic, hot start"),
    Way("viscoelastic", VISCOELASTIC, "viscoelastic, hot start"),
    Way("e = 0.8, hot start", {"system.restitution": 0.8, **HOT}, "e = 0.8, hot start"),
    Way("fixed loss, hot start", {**FIXED_LOSS, **HOT}, "fixed loss, hot start"),
    Way("fixed loss", FIXED_LOSS, "fixed loss, hot start"),
)


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


def measured(way, spheres, seed, until):
    """One run in blocks: verdict, hits, strain reached and block means (none if it arrested)."""
    changes = {"system.spheres": spheres, "start.seed": seed, "run.collisions": 10**12,
               "measure.after_time": FIRST_STRAIN, "output.collision_log": "none",
               "output.snapshot_interval": 1e6, **way.changes}
    runs = scanning.stages(CASE, changes, "run.time", ends_of(until)[1:])
    last = runs[-1]
    told = {"way": way.name, "spheres": spheres, "seed": seed, "until": until,
            "verdict": last["verdict"], "hits": last["separation"]["hits"],
            "last_hit": last["separation"]["last_time"], "strain": last["strain"],
            "collisions": last["collisions"], "contact": last["contact"],
            "normal_speed": last["averages"]["normal_speed"]}
    if last["outcome"] == "finished":
        told["blocks"] = block_means([run["averages"] for run in runs])
    return told


def stored(path):
    """{(way, spheres, seed, end): run} of a file of JSON lines; empty where there is none."""
    lines = path.read_text().splitlines() if path and path.is_file() else []
    runs = [json.loads(line) for line in lines]
    return {(run["way"], run["spheres"], run["seed"], run["until"]): run for run in runs}


def runs_of(ways, sizes, seeds, store):
    """All runs asked for; those that the store has are not done again.

    sizes: {spheres: strain at the end};  store: path of a file of JSON lines, or None
    """
    known = stored(store)
    for spheres, until in sizes.items():
        for seed in range(1, seeds + 1):
            for way in ways:
                key = way.name, spheres, seed, until
                if key not in known:
                    known[key] = measured(way, spheres, seed, until)
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


def passage(way, runs):
    """One line of the table of what happened at the collapse."""
    hits = sorted(run["hits"] for run in runs)
    last = [run["last_hit"] for run in runs if run["last_hit"] is not None]
    elastic = np.mean([run["contact"]["made_elastic"] / run["collisions"] for run in runs])
    return (f"| {way.name} | {counted([run['verdict'] for run in runs])} | {hits[0]}-{hits[-1]} |"
            f" {f'{max(last):.3f}' if last else '–'} | {min(run['strain'] for run in runs):.3f} |"
            f" {elastic:.2g} |")


def flow(way, by_way, blocks, spreads):
    """One line of the table of averages: mean(error), and the difference from the control.

    spreads: {name: averages.spread_of_a_run}, which the error of the difference is made from
    """
    cells = [way.name]
    for name in QUANTITIES:
        ours, theirs = (values(by_way[each], name, blocks) for each in (way.name, way.control))
        cell = f"{ours.mean():.4f}({1e4 * averages.error_of_mean(ours):.0f})"
        if way.name != way.control:
            error = spreads[name] * np.sqrt(1 / len(ours) + 1 / len(theirs))
            cell += f" {(ours.mean() / theirs.mean() - 1) / error:+.1f}"
        cells.append(cell)
    return "| " + " | ".join(cells) + " |"


def show(spheres, by_way, blocks, strains):
    """Prints the averages of a window, the chance of one flow, and the check of the errors."""
    flowing = [way for way in WAYS if way.name in by_way and way.control in by_way
               and any("blocks" in run for run in by_way[way.name])]
    print(f"\nN = {spheres}, strain {strains[0]:g} to {strains[1]:g}: mean(error of the last"
          " digits), difference from the hot start in standard errors\n")
    print("| way | " + " | ".join(QUANTITIES) + " |\n|" + "---|" * (1 + len(QUANTITIES)))
    spreads = {name: averages.spread_of_a_run([values(by_way[way.name], name, blocks)
                                               for way in flowing]) for name in QUANTITIES}
    for way in flowing:
        print(flow(way, by_way, blocks, spreads))
    same = [way.name for way in flowing if way.is_same_law]
    chances = [averages.chance_of_one_mean([values(by_way[way], name, blocks) for way in same])
               for name in QUANTITIES]
    print("| chance of one flow | " + " | ".join(f"{chance:.2g}" for chance in chances) + " |")
    ratios = [averages.root_mean_square([block_error(by_way[way], name) for way in same])
              / averages.root_mean_square([averages.error_of_mean(values(by_way[way], name))
                                           for way in same]) for name in QUANTITIES]
    print("| error from blocks / from seeds | " + " | ".join(f"{r:.2f}" for r in ratios) + " |")


SHOWN = ("T_yy", "P_yy", "-P_xy", "omega")


def draw(results, path):
    """Differences from the hot start in percent, one row a way, one panel a quantity."""
    ways = [way for way in WAYS if way.name != way.control and any(
        "blocks" in run for by_way in results.values() for run in by_way.get(way.name, []))]
    with scanning.drawn(path, size=(7.2, 4.2), columns=len(SHOWN)) as panels:
        for panel, name in zip(panels, SHOWN):
            draw_panel(panel, name, ways, results)
        panels[0].set_yticks(range(len(ways)), [way.name for way in ways])
        panels[0].invert_yaxis()
        panels[1].legend(loc="lower right", frameon=False, fontsize=8)
        panels[0].figure.supxlabel("difference from the hot start of the same law (%)", fontsize=9)


def draw_panel(panel, name, ways, results):
    """One quantity: a point with its error for each way and number of spheres."""
    for (spheres, by_way), style, shift in zip(results.items(), "os^", (-.15, .15, 0)):
        for place, way in enumerate(ways):
            if not {way.name, way.control} <= by_way.keys():
                continue
            ours, theirs = (values(by_way[each], name) for each in (way.name, way.control))
            error = np.hypot(averages.error_of_mean(ours), averages.error_of_mean(theirs))
            panel.errorbar(100 * (ours.mean() / theirs.mean() - 1), place + shift, fmt=style,
                           xerr=100 * error / theirs.mean(), color=f"C{'os^'.index(style)}",
                           markersize=4, capsize=2,
                           label=f"N = {spheres}" if way.name == "rewind" else None)
    panel.axvline(0, color="0.7", linewidth=0.6, zorder=0)
    panel.set_title(name, fontsize=9)


def arguments():
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spheres", type=int, nargs="+", default=list(UNTIL), metavar="N")
    parser.add_argument("--seeds", type=int, default=5, metavar="N", help="seeds 1 to N")
    parser.add_argument("--until", type=float, metavar="STRAIN", help="end of every run")
    parser.add_argument("--ways", nargs="+", metavar="NAME", choices=[way.name for way in WAYS],
                        default=[way.name for way in WAYS], help="some of them")
    parser.add_argument("--store", type=Path, metavar="RUNS.jsonl", help="keeps what was done")
    parser.add_argument("--stored", action="store_true", help="do no more runs, show the store")
    parser.add_argument("--figure", metavar="FIGURE.png")
    return parser.parse_args()


def main():
    """Does the runs, prints the tables, and draws the figure if a file is named."""
    asked = arguments()
    sizes = {n: asked.until or UNTIL.get(n, UNTIL[4000]) for n in asked.spheres}
    ways = [way for way in WAYS if way.name in asked.ways]
    results = {n: {} for n in sizes}
    runs = stored(asked.store).values() if asked.stored else runs_of(ways, sizes, asked.seeds,
                                                                     asked.store)
    for run in runs:
        if run["until"] == sizes.get(run["spheres"]) and run["seed"] <= asked.seeds:
            results[run["spheres"]].setdefault(run["way"], []).append(run)
    for spheres, by_way in results.items():
        print(f"\nN = {spheres}\n\n| way | verdicts | hits | last hit at | end at | made elastic |")
        print("|---|---|---|---|---|---|")
        for way in ways:
            if way.name in by_way:
                print(passage(way, by_way[way.name]))
        ends = ends_of(sizes[spheres])
        for first, last in ((0, BLOCKS), (0, BLOCKS // 2), (BLOCKS // 2, BLOCKS)):
            show(spheres, by_way, slice(first, last), (ends[first], ends[last]))
    if asked.figure:
        draw(results, asked.figure)


if __name__ == "__main__":
    main()
