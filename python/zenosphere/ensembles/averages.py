"""The averages of the runs of an ensemble: over the seeds of a point, with both of their errors."""

import itertools
import json
from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Quantity:
    """A number of each run, in its store.

    column: of the table run; index: place in its JSON, from 0;  sign: what it is multiplied with
    """

    column: str
    index: tuple = ()
    sign: int = 1

    @property
    def columns(self):
        """The column of the value, and that of its standard error."""
        return self.column, f"{self.column}_standard_error"

    def of(self, cell):
        """The number in a cell; nan where there is none."""
        if cell is None:
            return np.nan
        number = json.loads(cell) if self.index else cell
        for place in self.index:
            number = number[place] if place < len(number) else None
            if number is None:
                return np.nan
        return self.sign * number


QUANTITIES = {
    "granular_temperature": Quantity("granular_temperature"),
    "temperature_without_streak": Quantity("temperature_without_streak"),
    "pressure": Quantity("pressure"),
    "shear_stress": Quantity("pressure_tensor", (0, 1), -1),
    "n1": Quantity("normal_stress_differences", (0,)),
    "n2": Quantity("normal_stress_differences", (1,)),
    "sonine_a2": Quantity("sonine_a2"),
    "collision_rate": Quantity("collision_rate"),
    "compressibility_factor": Quantity("compressibility_factor"),
    "dissipation": Quantity("dissipation"),
    "streak_amplitude": Quantity("streak_amplitude"),
}


@dataclass(frozen=True)
class Means:
    """Over the seeds of each point.

    value: mean;  spread: standard deviation between the seeds, nan for fewer than two
    runs: how many count;  run_error: root mean square of the standard errors that the runs tell
    """

    value: np.ndarray
    spread: np.ndarray
    runs: np.ndarray
    run_error: np.ndarray

    @property
    def error(self):
        """Standard error of the mean: from the spread; of a single run the one that it tells."""
        between = self.spread / np.sqrt(np.maximum(self.runs, 1))
        return np.where(self.runs > 1, between, self.run_error)

    @property
    def ratio(self):
        """Spread over the error of one run: near 1 where one run samples the whole state."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.run_error > 0, self.spread / self.run_error, np.nan)


@dataclass(frozen=True)
class Averages:
    """What the runs of an ensemble measured: arrays with a dimension for each axis, seeds last.

    Runs that arrested, or that stop.wall_seconds ended, count for nothing: nan.
    """

    values: dict = field(default_factory=dict)  # of QUANTITIES
    errors: dict = field(default_factory=dict)  # that each run tells
    steady: np.ndarray | None = None  # 1 or 0; nan where the run could not tell

    def mapped(self, change):
        """The same with each array changed: `change` takes an array and gives another."""
        return Averages({name: change(array) for name, array in self.values.items()},
                        {name: change(array) for name, array in self.errors.items()},
                        None if self.steady is None else change(self.steady))

    def known(self, name):
        """Whether any run has it."""
        return name in self.values and bool(np.isfinite(self.values[name]).any())

    @property
    def any_steady(self):
        """Of each point, whether any run was steady; seeds are summed over."""
        return (self.steady == 1).any(axis=-1)

    def means(self, name):
        """Means over the seeds."""
        value, error = self.values[name], self.errors[name]
        runs = np.isfinite(value).sum(axis=-1)
        told = np.isfinite(error)
        with np.errstate(divide="ignore", invalid="ignore"):
            mean = np.nansum(value, axis=-1) / runs
            squares = np.nansum((value - mean[..., None]) ** 2, axis=-1)
            spread = np.where(runs > 1, np.sqrt(squares / np.maximum(runs - 1, 1)), np.nan)
            own = np.sqrt(np.nansum(error**2, axis=-1) / told.sum(axis=-1))
        return Means(mean, spread, runs, own)


def read_averages(rows, columns, axes, seeds):
    """The averages in rows of a store.

    rows: of dicts, with a value of each axis, `replica` and all `columns`;  columns: that there are
    axes: of the ensemble;  seeds: replicas at most
    """
    shape = [len(axis.values) for axis in axes] + [seeds]
    places = [{value: place for place, value in enumerate(axis.values)} for axis in axes]
    known = {name: quantity for name, quantity in QUANTITIES.items()
             if quantity.column in columns}
    values, errors = ({name: np.full(shape, np.nan) for name in known} for _ in range(2))
    steady = np.full(shape, np.nan)
    for row in rows:
        point = (*(where[row[axis.key]] for where, axis in zip(places, axes)), row["replica"])
        for name, quantity in known.items():
            value, error = (quantity.of(row.get(column)) for column in quantity.columns)
            values[name][point], errors[name][point] = value, abs(error)
        told = row.get("averages_steady")
        steady[point] = np.nan if told is None else told
    return Averages(values, errors, steady if known else None)


def average_rows(ensemble):
    """One dict a point, the last axis fastest: its values, how many runs count and are steady, and
    of each average the mean, its standard error, the error of one run, and spread over that."""
    averages = ensemble.averages()
    means = {name: averages.means(name) for name in averages.values if averages.known(name)}
    if not means:
        return
    runs = means["granular_temperature"].runs
    for place in itertools.product(*(range(len(axis.values)) for axis in ensemble.axes)):
        steady = averages.steady[place]
        row = {axis.key: axis.values[index] for axis, index in zip(ensemble.axes, place)}
        row |= {"runs": int(runs[place]), "steady": int(np.sum(steady == 1)),
                "not_steady": int(np.sum(steady == 0))}
        for name, mean in means.items():
            row |= {name: float(mean.value[place]),
                    f"{name}_standard_error": float(mean.error[place]),
                    f"{name}_error_of_a_run": float(mean.run_error[place]),
                    f"{name}_spread_over_error": float(mean.ratio[place])}
        yield row
