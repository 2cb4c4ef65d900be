"""The states of the performance page, and the file that keeps what was measured in them."""

import csv
import statistics

import trials
from programs import OURS, State

SPHERES = [500, 4000, 10976, 97556, 1000188, 10061824]  # 4 n^3
FRACTIONS = [0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5]
AREA_FRACTIONS = [0.05, 0.1, 0.25, 0.5, 0.65]  # of disks
USUAL_SPHERES = 4000  # where the fraction varies
USUAL_FRACTIONS = [0.1, 0.3]  # where the number of spheres does
FLOWS = {"elastic": (1.0, 0.0), "sheared": (0.9, 1.0)}  # restitution, shear rate
COLUMNS = ["date", "commit", "machine", "compiler", "program", "dimension", "spheres", "fraction",
           "restitution", "shear_rate", "start", "round", "collisions_per_second"]


def state_of(flow, spheres, fraction):
    """A lattice melts at phi <= 0.4 and stays a crystal at 0.5: there the start is random."""
    restitution, shear_rate = FLOWS[flow]
    return State(spheres, fraction, restitution, shear_rate, "random" if fraction > 0.45 else "fcc")


def state_of_disks(flow, fraction):
    restitution, shear_rate = FLOWS[flow]
    return State(USUAL_SPHERES, fraction, restitution, shear_rate, "random", dimension=2)


def line_of_fractions():
    """(spheres, fraction) of the states along one line."""
    return [(USUAL_SPHERES, fraction) for fraction in FRACTIONS]


def line_of_spheres(fraction):
    return [(spheres, fraction) for spheres in SPHERES]


def states():
    """Each once, small systems first."""
    places = {*line_of_fractions(), *(place for fraction in USUAL_FRACTIONS
                                      for place in line_of_spheres(fraction))}
    return [state_of(flow, *place) for place in sorted(places) for flow in FLOWS] + [
        state_of_disks(flow, fraction) for fraction in AREA_FRACTIONS for flow in FLOWS]


class Table:
    """Trials in a CSV file: each is added as soon as it is done, and not measured again."""

    def __init__(self, path, build):
        self._path = path
        self._facts = [trials.today(), trials.commit(), trials.machine(), trials.compiler(build)]
        self.trials = []
        if path.exists():
            with open(path, newline="") as file:
                self.trials = [_trial(row) for row in csv.DictReader(file)]

    def keys(self):
        """(state, round, program) of every trial."""
        return {(trial.state, trial.round, trial.program) for trial in self.trials}

    def add(self, trial):
        is_new = not self._path.exists()
        state = trial.state
        with open(self._path, "a", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerows([COLUMNS] * is_new)
            writer.writerow([*self._facts, trial.program, state.dimension, state.spheres,
                             state.fraction, state.restitution, state.shear_rate, state.start,
                             trial.round, f"{trial.rate:.0f}"])
        self.trials.append(trial)

    def programs(self):
        """Names in the order in which they came."""
        return list(dict.fromkeys(trial.program for trial in self.trials))

    def rate(self, program, state):
        """Median of a program's collisions per second in a state, or None."""
        rates = trials.rates(self.trials, state, program)
        return statistics.median(rates.values()) if rates else None

    def lead(self, state):
        """Median, over the rounds, of our speed over that of the fastest peer; or None."""
        ours = trials.rates(self.trials, state, OURS)
        best = {}
        for trial in self.trials:
            if trial.state == state and trial.program != OURS:
                best[trial.round] = max(best.get(trial.round, 0), trial.rate)
        ratios = [rate / best[number] for number, rate in ours.items() if number in best]
        return statistics.median(ratios) if ratios else None


def _trial(row):
    state = State(int(row["spheres"]), float(row["fraction"]), float(row["restitution"]),
                  float(row["shear_rate"]), row["start"], int(row["dimension"]))
    return trials.Trial(state, int(row["round"]), row["program"],
                        float(row["collisions_per_second"]))
