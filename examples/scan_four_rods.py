#!/usr/bin/python3
"""Scans the restitution of four rods that collapse, and names the words of their contacts.

Gaps between neighbours are a, b, c; the word is the order in which they close, and of a periodic
one a period is given, up to rotation and mirror image. A contact takes gaps and their rates through
the same linear map, so that a word repeats along eigenvectors of its round map.
Source: Dolmaire & Huebner-Rosenau, arXiv 2411.10324 (2024).

Usage: scan_four_rods.py [WORDS.png PATTERN.png [RESULTS.json]]
RESULTS.json keeps what was measured; where it exists, nothing is run.
"""

import sys
import tempfile
from collections import Counter
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np

import scanning
from contact_words import (before_contact, common_length, contact, eventual_word, exact_contacts,
                           in_order, name, places, rounds_held, scaled_contacts)

from zenosphere.run_file import RunFile  # scanning has put it on the path

CASE = "dolmaire-huebner-rosenau-2024-four-rods"
THREE, PATTERN, FOUR = 7 - 4 * np.sqrt(3), 5 - 2 * np.sqrt(6), 3 - 2 * np.sqrt(2)
RESTITUTION = np.arange(50, 201, 2) / 1000
STARTS = 6  # at each restitution
DIGITS, CONTACTS = 400, 1200  # some 750 to 1200 contacts fit in before the digits are spent
SPENT = f"1e-{DIGITS - 10}"  # gap: places of ten diameters have digits down to 1e-399
STABLE_AT = {2: 0.15, 3: 0.098, 4: 0.0853, 5: 0.0802}  # inside the window of (ab)^n (cb)^n
PATTERN_AT = Decimal("0.1")
WITHOUT_PERIOD = tuple(map(Decimal, ("0.082", "0.09", "0.102", "0.11", "0.12")))
IN_RUNS, EXACT = range(2, 15), range(4, 101, 8)  # k of errors 10^-k of a gap, on the pattern ababcb


def keys_of(gaps, rates, decimals=6):
    """A start with the given gaps and rates of gaps, as keys of the case file."""
    positions, velocities = [10], [0]
    for gap, rate in zip(gaps, rates):
        positions.append(positions[-1] + 1 + gap)
        velocities.append(velocities[-1] + rate)
    return {"start.positions": [round(each, decimals) for each in positions],
            "start.velocities": [round(each, decimals) for each in velocities]}


def random_start(random):
    """Gaps and rates of rods that all approach; six decimals."""
    gaps, rates = random.uniform(0.1, 1, 3), -random.uniform(0.1, 1, 3)
    return gaps.round(6).tolist(), rates.round(6).tolist()


def contacts_of(keys, output):
    """The gaps of all contacts that the digits show, list of int, and whether digits ran out."""
    summary = scanning.summary(CASE, keys | {"collision.precision": f"digits{DIGITS}",
                                             "collapse.gap_threshold": SPENT}, output)
    with RunFile(output) as run:
        order = run.collisions.read("i")[0].tolist()
    spent = summary["separation"]["first_collision"]
    return order[:spent], spent is not None or summary["ended_by"] == "collisions"


def scan(folder):
    """(counts, agreeing): a Counter of words at each restitution, runs that both codes agree on."""
    random, counts, agreeing = np.random.default_rng(1), [], 0
    for restitution in RESTITUTION:
        counter = Counter()
        for _ in range(STARTS):
            gaps, rates = random_start(random)
            keys = keys_of(gaps, rates) | {
                "system.restitution": float(restitution), "run.collisions": CONTACTS}
            order, collapsing = contacts_of(keys, folder / "rods.h5")
            again = scaled_contacts(gaps, rates, restitution, len(order))
            agreeing += again == order[:len(again)] and (not collapsing or len(again) > 400)
            word = eventual_word(order) if collapsing else "fly apart"
            counter[name(word) if word else "no period"] += 1
        counts.append(counter)
        print(f"{restitution:.3f}  " + ", ".join(f"{count} {word}" for word, count
                                                 in counter.most_common()), flush=True)
    return counts, agreeing


def repeats(word, restitution):
    """Whether the word repeats along the two largest eigenvectors of its round map (stable)."""
    columns = [np.eye(3)[k].tolist() for k in range(3)]
    for gap in places(word):
        columns = [contact(gap, column, restitution) for column in columns]
    values, vectors = np.linalg.eig(np.transpose(columns))
    largest = np.argsort(-abs(values))
    if np.iscomplex(values).any() or values[largest[1]].real <= 0:
        return False
    rates, offsets = (vectors[:, k].real for k in largest[:2])
    return any(in_order(word, list(one * offsets), list(two * rates), restitution)
               for one in (1, -1) for two in (1, -1))


def window(number):
    """(from, to): the restitutions at which (ab)^n (cb)^n is stable, by bisection."""
    word, ends = "ab" * number + "cb" * number, []
    for outside in (0.07, 0.2):
        good, bad = STABLE_AT[number], outside
        for _ in range(50):
            middle = (good + bad) / 2
            good, bad = (middle, bad) if repeats(word, middle) else (good, middle)
        ends.append(good)
    return tuple(ends)


def pattern_start(word, restitution, digits=130):
    """Start on the unstable pattern: gaps and rates, lists (3) of Decimal; the end is at t = 1.

    Rates are the eigenvector of the largest eigenvalue, offsets (gaps less rates x time) that of
    the smallest: the one is found by applying the round map again and again, the other its inverse.
    """
    with localcontext() as context:
        context.prec = digits
        rates = offsets = [Decimal(-1), Decimal(-1) / 2, Decimal(-1) / 3]
        for _ in range(digits):
            grown, shrunk = rates, offsets
            for gap in places(word):
                grown = contact(gap, grown, restitution)
            for gap in reversed(places(word)):
                shrunk = before_contact(gap, shrunk, restitution)
            rates, offsets = unit(grown), unit(shrunk)
        if rates[places(word)[0]] > 0:
            rates = [-each for each in rates]
        if offsets[places(word)[0]] > 0:  # the first contact lies before the end, t = 0
            offsets = [-each for each in offsets]
        return between_rounds(word, offsets, rates, restitution)


def unit(vector):
    """A vector with the largest entry 1 in size."""
    size = max(abs(each) for each in vector)
    return [each / size for each in vector]


def between_rounds(word, offsets, rates, restitution):
    """Gaps and rates halfway between the last contact of a round and the first of the next."""
    first, last = places(word)[0], places(word)[-1]
    before = before_contact(last, offsets, restitution), before_contact(last, rates, restitution)
    begin = (-offsets[first] / rates[first] - before[0][last] / before[1][last]) / 2
    gaps = [offset + rate * begin for offset, rate in zip(offsets, rates)]
    widest = max(gaps)
    return [gap / widest for gap in gaps], [-rate * begin / widest for rate in rates]


def instability(folder):
    """{"run": rows, "exact": rows}: (k, rounds that ababcb lasts if a gap is off by 10^-k).

    A case is read with 17 digits, so that runs can follow errors down to 1e-14; fractions any.
    """
    rows = {"run": [], "exact": []}
    with localcontext() as context:
        context.prec = 130
        gaps, rates = pattern_start("ababcb", PATTERN_AT)
        for power in IN_RUNS:
            off = [gaps[0] + Decimal(10) ** -power, *gaps[1:]]
            keys = keys_of(off, rates, decimals=16) | {"run.collisions": CONTACTS}
            order, _ = contacts_of(keys, folder / "rods.h5")
            rows["run"].append((power, rounds_held(order, "ababcb"), eventual_word(order)))
        for power in EXACT:
            off = [gaps[0] + Decimal(10) ** -power, *gaps[1:]]
            order = exact_contacts(off, rates, PATTERN_AT, 1000)
            rows["exact"].append((power, rounds_held(order, "ababcb"), eventual_word(order)))
    for kind, each in rows.items():
        for power, rounds, word in each:
            print(f"{kind}, a gap off by 1e-{power}: {rounds:.1f} rounds of ababcb, then"
                  f" {name(word) if word else 'no period'}")
    return rows


def sensitivity(restitution, random):
    """Rows (k, contacts): how long a start and one whose gap is off by 10^-k have one order.

    restitution: Decimal;  in fractions, from a random start
    """
    gaps, rates = ([Decimal(str(each)) for each in vector] for vector in random_start(random))
    with localcontext() as context:
        context.prec = 130
        order, rows = exact_contacts(gaps, rates, restitution, CONTACTS), []
        for power in (20, 40, 60, 80):
            off = [gaps[0] + Decimal(10) ** -power, *gaps[1:]]
            rows.append((power, common_length(order, exact_contacts(off, rates, restitution,
                                                                    CONTACTS))))
    return rows


def draw_words(counts, windows, path):
    """Share of each word against e, with the windows of stability above."""
    with scanning.drawn(path, size=(5.6, 3.9)) as axes:
        words = ["ab", *(f"(ab)^{n}(cb)^{n}" for n in (6, 5, 4, 3, 2)), "other word", "no period",
                 "fly apart"]
        colors = ["#4477aa", "#882255", "#aa3377", "#ee6677", "#ccbb44", "#228833", "#66ccee",
                  "#bbbbbb", "#eeeeee"]
        bottom = np.zeros(len(RESTITUTION))
        for word, color in zip(words, colors):
            share = np.array([sum(count for key, count in counter.items()
                                  if (key if key in words else "other word") == word)
                              for counter in counts]) / STARTS
            if share.any():
                axes.bar(RESTITUTION, share, np.diff(RESTITUTION)[0], bottom, color=color,
                         label=word if " " in word else f"${word}$")
            bottom += share
        for number, ends in windows.items():
            axes.plot(ends, [1.04, 1.04], linewidth=4, solid_capstyle="butt",
                      color=colors[words.index(f"(ab)^{number}(cb)^{number}")])
        axes.text(0.0505, 1.04, "stable:", va="center", fontsize=8)
        for place, text in ((THREE, r"$7-4\sqrt{3}$"), (PATTERN, r"$5-2\sqrt{6}$"),
                            (FOUR, r"$3-2\sqrt{2}$")):
            axes.axvline(place, color="black", linewidth=0.8, linestyle="--")
            axes.text(place, 1.09, text, ha="center", fontsize=8,
                      bbox={"color": "white", "pad": 0.5})
        axes.set(xlabel="restitution $e$", ylabel="share of starts", xlim=(0.049, 0.201),
                 ylim=(0, 1.16), yticks=np.arange(0, 1.01, 0.25))
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=4)


def draw_pattern(rows, growth, path):
    """Rounds of ababcb against the size of the error, with the slope of the eigenvalues."""
    with scanning.drawn(path, size=(5.2, 3.2)) as axes:
        for kind, marker, label in (("run", "o", f"runs with {DIGITS} digits"),
                                    ("exact", "x", "exact fractions")):
            powers, rounds, _ = zip(*rows[kind])
            axes.plot(powers, rounds, marker, markersize=4, label=label)
        powers, rounds = np.array(powers), np.array(rounds)
        line = powers / np.log10(growth)
        axes.plot(powers, line + np.mean(rounds - line), linewidth=1, zorder=0,
                  label=rf"error $\times\;{growth:.1f}$ in each round")
        axes.set(xlabel="$k$, where a gap is off by $10^{-k}$ of the widest",
                 ylabel="rounds of the word $ababcb$")
        axes.legend()


def eigenvalues(word, restitution):
    """Of the round map, the largest first."""
    columns = [np.eye(3)[k].tolist() for k in range(3)]
    for gap in places(word):
        columns = [contact(gap, column, restitution) for column in columns]
    values = np.linalg.eigvals(np.transpose(columns))
    return values[np.argsort(-abs(values))].real


def all_runs():
    """What the program says: `counts` and `agreeing` of scan(), `rows` of instability()."""
    with tempfile.TemporaryDirectory() as folder:
        counts, agreeing = scan(Path(folder))
        return {"counts": counts, "agreeing": agreeing, "rows": instability(Path(folder))}


def main():
    """Prints words, windows and the life of ababcb, and draws the figures."""
    words, pattern, results = (*sys.argv[1:], None, None, None)[:3]
    found = scanning.kept(results, all_runs)
    print(f"{found['agreeing']} of {STARTS * len(RESTITUTION)} runs have the contacts of the scaled"
          " computation, one by one")
    random = np.random.default_rng(2)
    for restitution in WITHOUT_PERIOD:
        print(f"e = {restitution}, a gap off by 10^-k: (k, contacts in the same order) "
              + str(sensitivity(restitution, random)))
    windows = {number: window(number) for number in STABLE_AT}
    for number, ends in windows.items():
        print(f"(ab)^{number}(cb)^{number} is stable for e from {ends[0]:.9f} to {ends[1]:.9f}")
    values = eigenvalues("ababcb", float(PATTERN_AT))
    print(f"ababcb at e = 0.1: eigenvalues {values}, an error grows {values[1] / values[2]:.2f}"
          f" times a round; 5 - 2 sqrt(6) = {PATTERN:.9f}, 3 - 2 sqrt(2) = {FOUR:.9f}")
    if pattern:
        draw_words(found["counts"], windows, words)
        draw_pattern(found["rows"], values[1] / values[2], pattern)


if __name__ == "__main__":
    main()
