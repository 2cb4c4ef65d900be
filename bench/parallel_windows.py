#!/usr/bin/python3
"""What would a division of space give that runs one system on several cores, with the same bits?

    bench/parallel_windows.py out.h5 --division 1,1,2 --division 2,2,2 --exchange 1

Replays the collision log of a finished run on cores that each own a block of space, and counts. No
collision is computed: the log tells which spheres met and when, and the snapshots where they were.
A collision takes one unit of time. Three ways to keep the order of the one-core run are compared:

whole     windows of n collisions. Cores go through their own in parallel; if in the window any two
          spheres of different owners meet, it is thrown away and done again on one core
in step   a core runs until it meets a sphere of another core. Both do that collision together,
          the one that comes first waits, then both go on: the longest chain of such waits counts
undo      windows of n collisions. What a core did with a sphere that met a foreign one, and with
          all that these spheres met later in the window, is undone and done again on one core

`--exchange` is what it takes two cores to agree, in units of a collision: once a window, or for each
collision across a border. The log needs all collisions (output.collision_log = "all") and a
snapshot wherever ownership is to be renewed (output.snapshot_interval).
"""

import argparse
from dataclasses import dataclass

import h5py
import numpy as np

WINDOWS = [10, 30, 100, 300, 1000, 3000, 10000, 30000]


@dataclass(frozen=True)
class Log:
    """Collisions in the order in which they were done, each sphere with the core that owns it."""

    spheres: np.ndarray  # (K, 2), numbers of the spheres
    owners: np.ndarray  # (K, 2), cores from 0
    cores: int

    def crossings(self):
        """(K) whether the spheres have different owners."""
        return self.owners[:, 0] != self.owners[:, 1]


def block_numbers(positions, sides, division):
    """The block that holds each of the positions (N, 3) in a box cut into division[axis] pieces."""
    cuts = np.asarray(division)
    places = np.clip((positions / sides * cuts).astype(int), 0, cuts - 1)
    return (places[:, 0] * cuts[1] + places[:, 1]) * cuts[2] + places[:, 2]


def read_log(path, division):
    """The Log of an output file. Owners are those of the last snapshot before a collision."""
    with h5py.File(path) as file:
        spheres = np.stack([file["collisions/i"][:], file["collisions/j"][:]], axis=1)
        numbers = file["collisions/k"][:]
        position = file["particles/spheres/position"]
        sides = np.diagonal(file["particles/spheres/box/edges/value"][0])
        owners = np.empty_like(spheres)
        steps = list(position["step"][:])
        for snapshot, (first, last) in enumerate(zip(steps, steps[1:] + [numbers[-1]])):
            rows = slice(*np.searchsorted(numbers, [first, last], side="right"))
            blocks = block_numbers(position["value"][snapshot], sides, division)
            owners[rows] = blocks[spheres[rows]]
    return Log(spheres, owners, int(np.prod(division)))


def own_collisions(log, rows):
    """(cores) how many collisions each core does in these rows; one across a border counts twice."""
    owners = log.owners[rows]
    across = owners[:, 0] != owners[:, 1]
    return (np.bincount(owners[:, 0], minlength=log.cores)
            + np.bincount(owners[across, 1], minlength=log.cores))


def windows_of(log, length):
    """Slices of `length` collisions, without the rest at the end of the log."""
    return [slice(first, first + length)
            for first in range(0, len(log.spheres) - length + 1, length)]


def share_of_crossings(log):
    """Share of the collisions that cross a border."""
    return np.mean(log.crossings())


def whole_windows(log, length, exchange):
    """Speed-up, and the share of the windows that are thrown away."""
    windows = windows_of(log, length)
    crossings = log.crossings()
    thrown = [bool(crossings[rows].any()) for rows in windows]
    time = sum(own_collisions(log, rows).max() + exchange + again * length
               for rows, again in zip(windows, thrown))
    return length * len(windows) / time, np.mean(thrown)


def in_step(log, exchange):
    """Speed-up, and the share of the crossings that no core could foresee.

    Unforeseen is a collision across a border if one of its spheres has collided since the two cores
    last exchanged what they know: the other core holds an old path of it.
    """
    clock = [0.0] * log.cores
    met, touched, unforeseen = {}, {}, 0
    owners, spheres = log.owners.tolist(), log.spheres.tolist()
    for number, ((one, other), pair) in enumerate(zip(owners, spheres)):
        if one == other:
            clock[one] += 1
        else:
            cores = (min(one, other), max(one, other))
            last = met.get(cores, 0)
            unforeseen += any(touched.get(sphere, -1) > last for sphere in pair)
            met[cores] = number
            clock[one] = clock[other] = max(clock[one], clock[other]) + 1 + exchange
        touched[pair[0]] = touched[pair[1]] = number
    return len(owners) / max(clock), unforeseen / max(1, np.count_nonzero(log.crossings()))


def chains(pairs, starts):
    """How many collisions of a window are among `starts` or come after one on the same spheres."""
    spoilt, count = set(), 0
    for pair, start in zip(pairs, starts):
        if start or pair[0] in spoilt or pair[1] in spoilt:
            spoilt.update(pair)
            count += 1
    return count


def undone(pairs, crossing):
    """How many collisions of a window are undone: those across a border and all that depend on one.

    The chains of the unforeseen ones count twice. They stand for the collisions, not in the log,
    that a core does by mistake with an old path of a foreign sphere: that path leads to a collision
    about as often as the new one does.
    """
    touched, unforeseen = set(), []
    for pair, crosses in zip(pairs, crossing):
        unforeseen.append(crosses and not touched.isdisjoint(pair))
        touched.update(pair)
    return min(len(pairs), chains(pairs, crossing) + chains(pairs, unforeseen))


def undo(log, length, exchange):
    """Speed-up, and the share of the collisions that are done again."""
    windows = windows_of(log, length)
    crossing, spheres = log.crossings().tolist(), log.spheres.tolist()
    time = again = 0
    for rows in windows:
        repeated = undone(spheres[rows], crossing[rows])
        again += repeated
        time += own_collisions(log, rows).max() + repeated + exchange
    done = length * len(windows)
    return done / time, again / done


def print_division(log, division, exchange):
    """The tables of one division."""
    step, unforeseen = in_step(log, exchange)
    busiest = own_collisions(log, slice(None)).max()
    print(f"\n{log.cores} cores ({' x '.join(map(str, division))} blocks): "
          f"{share_of_crossings(log):.2%} of {len(log.spheres)} collisions cross a border; "
          f"balance alone {len(log.spheres) / busiest:.2f}; "
          f"in step {step:.2f}, {unforeseen:.1%} of the crossings unforeseen\n")
    print("| collisions a window | whole: thrown away | speed-up | undo: done again | speed-up |")
    print("|---|---|---|---|---|")
    for length in WINDOWS:
        if length <= len(log.spheres):
            whole, thrown = whole_windows(log, length, exchange)
            partly, again = undo(log, length, exchange)
            print(f"| {length} | {thrown:.0%} | {whole:.2f} | {again:.1%} | {partly:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="output of a run")
    parser.add_argument("--division", action="append", metavar="X,Y,Z",
                        help="blocks along each axis; repeatable; default 1,1,2")
    parser.add_argument("--exchange", type=float, default=1, metavar="COLLISIONS",
                        help="what an exchange of two cores takes (default %(default)s)")
    arguments = parser.parse_args()
    for text in arguments.division or ["1,1,2"]:
        division = tuple(map(int, text.split(",")))
        print_division(read_log(arguments.file, division), division, arguments.exchange)


if __name__ == "__main__":
    main()
