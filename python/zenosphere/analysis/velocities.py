"""Distribution of velocities: Sonine coefficients, and the whole curve with its tails."""

import numpy as np
from scipy.stats import chi

from .blocking import mean_and_error, measured

WIDTH = 0.1  # of a bin, in units of the root of the granular temperature
FASTEST = 8.0


class Velocities:
    """How peculiar velocities are spread, each snapshot in units of its own temperature.

    a2 = D <v^4> / ((D + 2) <v^2>^2) - 1 and a3 = 1 + 3 a2 - D^2 <v^6> / ((D + 2) (D + 4) <v^2>^3),
    the first coefficients of the expansion in Sonine polynomials; both are 0 for a Maxwellian. The
    moments of N spheres whose momentum is 0 are multiplied by what makes them unbiased then.
    In a mixture a velocity counts in units of sqrt(T / m), T the temperature of its own kind, and
    immobile spheres do not.
    Source: Brilliantov & Poeschel, Europhys. Lett. 74 (2006) 424.

    frames: Frames
    """

    def __init__(self, frames):
        self.dimension = frames.dimension
        bins = round(FASTEST / WIDTH)
        self.component_edges = np.linspace(-FASTEST, FASTEST, 2 * bins + 1)
        self.speed_edges = np.linspace(0, FASTEST, bins + 1)
        self._components, self._speeds = np.zeros(2 * bins), np.zeros(bins)
        self._number = 0
        self._a2, self._a3, self.temperatures = [], [], []

    def add(self, frame):
        """Adds the velocities of a snapshot; one in which nothing moves has no distribution."""
        velocities = frame.velocities
        if frame.kinds is None:
            temperature = float(np.sum(velocities**2, axis=1).mean()) / self.dimension
            unit = np.sqrt(temperature)
        else:
            temperature = frame.kinds.temperature(velocities)
            unit = thermal_speeds(frame)
            velocities, unit = velocities[frame.kinds.mobile], unit[frame.kinds.mobile]
        self.temperatures.append(temperature)
        if len(velocities) < 2 or not np.all(unit > 0):
            return
        self._count(velocities, unit)

    def _count(self, velocities, unit):
        scaled = velocities / unit
        speeds = np.sqrt(np.sum(velocities**2, axis=1)) / np.ravel(unit)
        a2, a3 = sonine(speeds**2, self.dimension)
        self._a2.append(a2)
        self._a3.append(a3)
        self._components += np.histogram(scaled, self.component_edges)[0]
        self._speeds += np.histogram(speeds, self.speed_edges)[0]
        self._number += len(velocities)

    def result(self):
        """granular_temperature, sonine and velocity_distribution."""
        found = {}
        for name, series in (("a2", self._a2), ("a3", self._a3)):
            found[name], found[f"{name}_standard_error"] = mean_and_error(series)
        value, error = mean_and_error(self.temperatures)
        return {"granular_temperature": {"value": value, "standard_error": error}, "sonine": found,
                "velocity_distribution": self._distribution()}

    def _distribution(self):
        number = max(self._number, 1)
        component = (self.component_edges[1:] + self.component_edges[:-1]) / 2
        speed = (self.speed_edges[1:] + self.speed_edges[:-1]) / 2
        return {"component": component,
                "component_density": self._components / (number * self.dimension * WIDTH),
                "component_maxwell": np.exp(-component**2 / 2) / np.sqrt(2 * np.pi),
                "speed": speed, "speed_density": self._speeds / (number * WIDTH),
                "speed_maxwell": chi.pdf(speed, self.dimension)}


class VelocitiesOfKinds:
    """Granular temperature and Sonine coefficients of each kind of a mixture.

    frames: Frames, with kinds
    """

    def __init__(self, frames):
        self._kinds, self._dimension = frames.kinds, frames.dimension
        names = self._kinds.names
        self._temperatures = []
        self._a2, self._a3 = [[] for _ in names], [[] for _ in names]

    def add(self, frame):
        """Adds the velocities of a snapshot."""
        self._temperatures.append(self._kinds.temperatures(frame.velocities))
        energy = self._kinds.mass * np.sum(frame.velocities**2, axis=1)
        for number, member in enumerate(self._kinds.members):
            moving = energy[member & self._kinds.mobile]
            if len(moving) < 2 or not moving.any():
                continue
            a2, a3 = sonine(moving, self._dimension)
            self._a2[number].append(a2)
            self._a3[number].append(a3)

    def result(self):
        """species: name, spheres, granular_temperature, temperature_ratio and sonine of each."""
        temperatures = np.array(self._temperatures).T
        return {"species": [
            {"name": name, "spheres": int(self._kinds.members[number].sum()),
             "granular_temperature": measured(temperatures[number]),
             "temperature_ratio": ratio_of_means(temperatures[number], temperatures[0]),
             "sonine": {"a2": measured(self._a2[number]), "a3": measured(self._a3[number])}}
            for number, name in enumerate(self._kinds.names)]}


def ratio_of_means(values, others):
    """Mean of a series over that of another one, with the error of both together (they may be
    correlated); unknown where either is.

    values, others: (n)
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.mean(values) / np.mean(others)
        deviations = (values - ratio * others) / np.mean(others)
    return measured(ratio + deviations)


def thermal_speeds(frame):
    """sqrt(T / m) of each sphere with T of its kind, (N, 1); NaN of immobile kinds."""
    temperatures = frame.kinds.temperatures(frame.velocities)[frame.kinds.kind]
    return np.sqrt(temperatures / frame.kinds.mass)[:, None]


def sonine(squares, dimension):
    """a2 and a3 of one snapshot.

    squares: (N), squared velocities relative to their mean
    """
    number, d = len(squares), dimension
    free = (number - 1) * d  # components that the conserved momentum leaves free
    mean = squares.mean()
    fourth = np.mean((squares / mean) ** 2) * (free + 2) / free
    sixth = np.mean((squares / mean) ** 3) * (free + 2) * (free + 4) / free**2
    a2 = d / (d + 2) * fourth - 1
    return a2, 1 + 3 * a2 - d**2 / ((d + 2) * (d + 4)) * sixth
