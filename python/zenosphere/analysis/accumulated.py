"""What a run has accumulated itself (`measure.sampling_interval`), in place of its snapshots."""

import numpy as np

from .accumulated_displacements import AccumulatedDisplacements
from .blocking import errors_of_means, measured
from .collision_log import LogarithmicHistogram
from .contacts import FreePath
from .displacements import Displacements
from .partial import PartialDistributions
from .profiles import Profiles
from .radial import RadialDistribution
from .structure import StructureFactor
from .velocities import Velocities, VelocitiesOfKinds

class AccumulatedRadial(RadialDistribution):
    """RadialDistribution of rows.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        if "pair_counts" not in rows:  # of a single sphere
            return
        density = (frames.spheres - 1) / frames.box.volume * frames.spheres
        self._rows = list(rows.means("pair_counts") / (density * self._shell))
        self._contacts = list(rows.means("contact_values"))
        ones = np.ones((len(rows), len(self._shell)))
        self._shares = rows.means("share_inside") if "share_inside" in rows else ones
        if self._sectors is not None:
            self._sectors += rows.means("pair_counts_by_direction").sum(axis=0) / density

    def add(self, frame):
        """Nothing: snapshots do not count."""


class AccumulatedPartial(PartialDistributions):
    """PartialDistributions of rows.

    frames: Frames, with kinds;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        if not self._is_counted:
            return
        density = frames.spheres * (frames.spheres - 1) / frames.box.volume
        self._rows = list(rows.means("pair_counts") / (density * self._shells(self._edges)))
        weights, contacts = (rows.means(f"partial_{name}_weights") for name in ("pair", "contact"))
        for pair in self._pairs:
            place, number = rows_of_pair(*pair, self._highest), self._number(*pair)
            self._partial_rows[pair] = list(
                weights[:, place] / (number * self._shells(self._partial_edges)))
            self._contacts[pair] = list(contacts[:, place] / number)

    def add(self, frame):
        """Nothing: snapshots do not count."""

    @property
    def _highest(self):
        return int(self._kinds.kind.max()) + 1


def rows_of_pair(a, b, kinds):
    """Place of two kinds, a <= b, in the order (0, 0), (0, 1), ..., (1, 1), ..."""
    return a * kinds - a * (a + 1) // 2 + b


class AccumulatedStructure(StructureFactor):
    """StructureFactor whose long waves are those of rows, and the others those of snapshots.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        self._long = [np.empty((len(rows), 0))] * 3
        if "waves" not in rows:  # between walls in one dimension
            return
        self._long = [rows.sums(name) for name in ("waves", "wave_numbers", "wave_powers")]
        samples, limits = rows.sums("limit_samples"), rows.sums("structure_limits")
        self._limits = list(limits[samples > 0] / samples[samples > 0])

    def add(self, frame):
        """Adds all waves of a snapshot, if in detail."""
        if frame.box.periodic and frame.is_in_detail:
            self._add_all(frame)

    def _curve(self):
        waves, numbers, powers = self._long
        curve, known = super()._curve(), slice(waves.shape[1])
        with np.errstate(invalid="ignore", divide="ignore"):
            found = (numbers.sum(axis=0) / waves.sum(axis=0), powers.sum(axis=0) / waves.sum(axis=0),
                     errors_of_means(powers / waves))
        for column, those in zip(curve, found):
            column[known] = those
        return curve


class AccumulatedVelocities(Velocities):
    """Velocities of rows.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        self.temperatures = list(rows.means("granular_temperatures"))
        samples = rows.sums("velocity_samples")
        moving = samples > 0
        self._a2 = list(rows.sums("sonine_a2")[moving] / samples[moving])
        self._a3 = list(rows.sums("sonine_a3")[moving] / samples[moving])
        self._components += rows.sums("component_counts").sum(axis=0)
        self._speeds += rows.sums("speed_counts").sum(axis=0)
        self._number = rows.sums("velocities").sum()

    def add(self, frame):
        """Nothing: snapshots do not count."""


class AccumulatedVelocitiesOfKinds(VelocitiesOfKinds):
    """VelocitiesOfKinds of rows.

    frames: Frames, with kinds;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        names, means = len(self._kinds.names), rows.means("temperatures_of_kind")
        without = np.full((len(rows), names - means.shape[1]), np.nan)  # kinds that have no sphere
        self._temperatures = list(np.hstack((means, without)))
        samples = rows.sums("samples_of_kind")
        for kind in range(means.shape[1]):
            moving = samples[:, kind] > 0
            for held, name in ((self._a2, "sonine_a2_of_kind"), (self._a3, "sonine_a3_of_kind")):
                held[kind] = list(rows.sums(name)[moving, kind] / samples[moving, kind])

    def add(self, frame):
        """Nothing: snapshots do not count."""


class AccumulatedProfiles(Profiles):
    """Profiles of rows, and those of stress and dissipation, which snapshots cannot tell.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        mass, self._momentum = rows.means("layer_mass"), rows.means("layer_momentum")
        self._mass, self._kinetic = mass, rows.means("layer_kinetic")
        self._collisional = rows.rates("layer_collisional")
        self._dissipation = rows.rates("layer_dissipation")
        diameters = rows.means("layer_diameters")
        volumes = (np.moveaxis(diameters, 2, 0) if frames.kinds is not None
                   else diameters.sum(axis=2)[None])
        square = np.trace(self._kinetic, axis1=2, axis2=3)
        columns = [rows.means("layer_spheres"), mass, *np.moveaxis(self._momentum, 2, 0), square]
        names = 1 if frames.kinds is None else len(frames.kinds.names)
        absent = np.zeros((names - len(volumes), *mass.shape))
        self._rows = np.stack([*columns, *volumes, *absent], axis=2)

    def add(self, frame):
        """Nothing: snapshots do not count."""

    def result(self):
        """profiles, with pressure_tensor and dissipation."""
        found = super().result()
        moved = self._momentum.sum(axis=0)
        mass = self._mass.sum(axis=0)[:, None]
        mean = np.divide(moved, mass, out=np.zeros_like(moved), where=mass > 0)
        streaming = self._momentum[:, :, :, None] * mean[:, None, :]
        about = (self._kinetic - streaming - np.swapaxes(streaming, 2, 3)
                 + self._mass[:, :, None, None] * mean[:, :, None] * mean[:, None, :])
        tensors = (about + self._collisional) / self._layer_volume
        losses = self._dissipation / self._layer_volume
        shape = tensors.shape[1:]
        errors = errors_of_means(tensors.reshape(len(tensors), -1)).reshape(shape)
        found["profiles"] |= {"pressure_tensor": tensors.mean(axis=0),
                              "pressure_tensor_standard_error": errors,
                              "dissipation": losses.mean(axis=0),
                              "dissipation_standard_error": errors_of_means(losses)}
        return found


class AccumulatedFreePath(FreePath):
    """FreePath of rows, each with its own collision rate.

    frames: Frames;  rows: Rows
    """

    def __init__(self, frames, rows):
        super().__init__(frames)
        self._rates = 2 * rows.rates("normal_speed_moments")[:, 0] / frames.spheres
        self._means = rows.means("speeds")

    def add(self, frame):
        """Nothing: snapshots do not count."""

    def result(self):
        """mean_free_path, diameters; null where nothing collides."""
        collide = self._rates > 0
        return {"mean_free_path": measured(self._means[collide] / self._rates[collide])}


def accumulated_distributions(rows):
    """flight_time, normal_speed and impact_angle, over the collisions of the rows; None: none."""
    if not rows.sums("normal_speed_moments")[:, 0].sum():
        return None
    found = {}
    for name in ("flight_time", "normal_speed"):
        number, total, below = rows.sums(f"{name}_moments").sum(axis=0)
        found[name] = LogarithmicHistogram.counted(
            rows.edges(name), rows.sums(f"{name}_counts").sum(axis=0), int(number), total,
            int(below)).result()
    counts, edges = rows.sums("impact_angle_counts").sum(axis=0), rows.edges("impact_angle")
    centres, number = (edges[1:] + edges[:-1]) / 2, counts.sum()
    if number:  # none where only walls are hit
        found["impact_angle"] = {"value": centres, "density": counts / np.diff(edges) / number,
                                 "mean": float(centres @ counts / number), "number": int(number),
                                 "below_smallest_bin": 0}
    return found


def losses_by_kinds(rows, kinds, volume):
    """Of each two kinds: between, collisions and dissipation per time and volume; [] of one kind.

    kinds: Kinds or None;  volume: of the box
    """
    if "collisions_of_kinds" not in rows:
        return []
    count = int(kinds.kind.max()) + 1
    collisions, losses = (rows.rates(f"{name}_of_kinds") / volume
                          for name in ("collisions", "dissipation"))
    return [{"between": [kinds.names[a], kinds.names[b]],
             "collisions": measured(collisions[:, rows_of_pair(a, b, count)]),
             "dissipation": measured(losses[:, rows_of_pair(a, b, count)])}
            for a in range(count) for b in range(a, count)]


IN_PLACE_OF = {RadialDistribution: AccumulatedRadial, PartialDistributions: AccumulatedPartial,
               Velocities: AccumulatedVelocities, VelocitiesOfKinds: AccumulatedVelocitiesOfKinds,
               Profiles: AccumulatedProfiles, FreePath: AccumulatedFreePath,
               StructureFactor: AccumulatedStructure, Displacements: AccumulatedDisplacements}
