"""The states of the performance page, and the file that keeps what was measured in them."""

import csv
import statistics

import trials
from programs import State

SPHERES = [864, 4000, 10976, 97556, 1000188, 10061824]  # 4 n^3, about 10^3 to 10^7
FRACTIONS = [0.1, 0.2, 0.3, 0.4, 0.5]
CUT_SPHERES, CUT_FRACTION = 4000, 0.3  # peers are measured along these two lines of the grid
FLOWS = {"elastic": (1.0, 0.0), "sheared": (0.9, 1.0)}  # restitution, shear rate
COLUMNS = ["date", "commit", "machine", "compiler", "program", "spheres", "fraction",
           "restitution", "shear_rate", "start", "round", "collisions_per_second"]


def state_of(flow, spheres, fraction):
    """A lattice melts at phi <= 0.4 and stays a crystal at 0.5: there the start is random."""
    restitution, shear_rate = FLOWS[flow]
    return State(spheres, fraction, restitution, shear_rate, "random" if fraction > 0.45 else "fcc")


def states(all_spheres, fractions):
    """The grid, small systems first. A dense random start of ten million spheres takes hours."""
    return [state_of(flow, spheres, fraction) for spheres in all_spheres for fraction in fractions
            for flow in FLOWS if not (spheres > 2_000_000 and fraction > 0.45)]


def is_for_peers(state):
    return state.spheres == CUT_SPHERES or state.fraction == CUT_FRACTION


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
            writer.writerow([*self._facts, trial.program, state.spheres, state.fraction,
                             state.restitution, state.shear_rate, state.start, trial.round,
                             f"{trial.rate:.0f}"])
        self.trials.append(trial)

    def programs(self):
        """Names in the order in which they came."""
        return list(dict.fromkeys(trial.program for trial in self.trials))

    def rate(self, program, state):
        """Median of a program's collisions per second in a state, or None."""
        rates = trials.rates(self.trials, state, program)
        return statistics.median(rates.values()) if rates else None


def _trial(row):
    state = State(int(row["spheres"]), float(row["fraction"]), float(row["restitution"]),
                  float(row["shear_rate"]), row["start"])
    return trials.Trial(state, int(row["round"]), row["program"],
                        float(row["collisions_per_second"]))
