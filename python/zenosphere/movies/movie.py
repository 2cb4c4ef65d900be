"""Draws a movie of the snapshots of a run: spheres in their sheared cell."""

from subprocess import CalledProcessError

import matplotlib
import numpy as np
from matplotlib import animation, colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from ..drawing import words
from ..drawing.pictures import INK, STYLE
from ..errors import InputError, OutputError
from .cell import Cell, View

WIDTH, HEIGHT = 7.2, 6.4  # inches; even numbers of pixels, which H.264 asks for
DOTS_PER_INCH = 150
LEAST_SECONDS, FRAMES_PER_SECOND = 3, 12  # of a movie, if it can be; of a long one
MISTY = 0.45  # how far the colour of the farthest sphere is on its way to white
GREY = (0.8, 0.8, 0.8, 1.0)  # a sphere that has not collided yet


class Speeds:
    """Peculiar speed of every sphere: without the mean flow of the shear."""

    label, colours = "Peculiar speed (diameters/time)", colormaps["viridis"]

    def __init__(self, run):
        self._rate = run.setting("drive", "shear_rate") or 0.0

    def values(self, _, positions, velocities, edges):
        """(N) of a snapshot; NaN where there is none."""
        peculiar = np.array(velocities, dtype=float)
        if self._rate:
            peculiar[:, 0] -= self._rate * (positions[:, 1] - edges[1, 1] / 2)
        return np.linalg.norm(peculiar, axis=1)


class LastCollisions:
    """How many collisions of all spheres ago each sphere has collided last; 1 is the last one.

    Counted in collisions, because the clock of a collapse stands still.
    """

    label, colours = "Collisions of all since its last one", colormaps["viridis_r"]

    def __init__(self, run):
        log = run.collisions
        if not log.complete:
            raise InputError(f"{run.path}: collision log is incomplete (collisions {log.first} to"
                             f" {log.last}; who collided last is not known); run the case again"
                             ' with --set output.collision_log="all", or use --colour speed')
        self._k, i, j = log.read("k", "i", "j")
        self._pairs = np.stack([i, j], axis=1)

    def values(self, step, positions, _, __):
        """(N) of a snapshot; NaN where a sphere has not collided yet."""
        last = np.full(len(positions) + 2, np.nan)  # and two walls
        done = np.searchsorted(self._k, step, "right")
        # Of values for one place the last counts, and rows are in their order.
        last[self._pairs[:done].ravel()] = np.repeat(self._k[:done], 2)
        return step + 1 - last[:-2]


COLOURINGS = {"speed": Speeds, "last": LastCollisions}


def draw_movie(run, path, colour="speed", frames_per_second=None, every=1):
    """Writes a movie, or numbered PNGs into a folder where `path` has no suffix.

    run: RunFile with snapshots;  path: Path, .mp4 or no suffix;  colour: of COLOURINGS
    frames_per_second: None: 12, or as few as make a movie of few frames last three seconds
    every: one snapshot of so many
    Returns what was written, and a line for those who asked for a movie that needs ffmpeg.
    Raises InputError, OutputError.
    """
    if path.suffix not in ("", ".mp4"):
        raise InputError(f"{path}: a movie is .mp4 (not {path.suffix}); give no suffix for a"
                         " folder of PNGs")
    if not path.parent.is_dir():
        raise OutputError(f"{path}: there is no folder {path.parent}; create it or choose another")
    scene = _Scene(run, COLOURINGS[colour](run), every)
    if frames_per_second is None:
        frames_per_second = min(max(scene.count // LEAST_SECONDS, 1), FRAMES_PER_SECOND)
    if path.suffix and animation.writers.is_available("ffmpeg"):
        writer = animation.FFMpegWriter(fps=frames_per_second, codec="libx264",
                                        extra_args=["-pix_fmt", "yuv420p"])
        _written(scene, path, writer)
        return path, ""
    folder = path.with_name(f"{path.stem}-frames") if path.suffix else path
    _frames(scene, folder)
    hint = (f"no ffmpeg here (apt install ffmpeg); with it: ffmpeg -framerate {frames_per_second}"
            f" -i {folder}/frame-%04d.png -pix_fmt yuv420p {path}") if path.suffix else ""
    return folder, hint


def _written(scene, path, writer):
    was_there = path.exists()
    try:
        with matplotlib.rc_context(STYLE), writer.saving(scene.figure, path, DOTS_PER_INCH):
            for _ in scene.frames():
                writer.grab_frame()
    except (OSError, CalledProcessError) as error:
        if not was_there:
            path.unlink(missing_ok=True)
        raise OutputError(f"{path}: cannot be written ({error}); choose another file with -o"
                          ) from error


def _frames(scene, folder):
    try:
        folder.mkdir(exist_ok=True)
        if any(folder.iterdir()):
            raise OutputError(f"{folder}: is not empty (old frames would mix with new ones);"
                              " remove it or choose another with -o")
        with matplotlib.rc_context(STYLE):
            for number, _ in enumerate(scene.frames(), start=1):
                scene.figure.savefig(folder / f"frame-{number:04d}.png", dpi=DOTS_PER_INCH)
    except OutputError:
        raise
    except OSError as error:
        raise OutputError(f"{folder}: cannot be written ({error.strerror}); choose another place"
                          " with -o") from error


class _Scene:
    """A figure that shows one snapshot after another."""

    def __init__(self, run, colouring, every):
        self._run, self._colouring, self._every = run, colouring, every
        walls = run.setting("walls", "axis")
        self._walls = walls if walls in ("x", "y", "z") else None
        cells = [self._cell(edges) for *_, edges in self._snapshots()]
        if not cells:
            raise InputError(f"{run.path}: holds no snapshot; run the case again")
        self.count = len(cells)  # of frames
        self._view = View(cells[0].dimension, cells[0].edges[0, 0])
        self._norm = self._norm_of_all()
        with matplotlib.rc_context(STYLE):
            self.figure = Figure(figsize=(WIDTH, HEIGHT), dpi=DOTS_PER_INCH)
            self._prepare(cells)

    def frames(self):
        """Draws snapshot after snapshot, and gives the number of each."""
        for number, (moment, *snapshot) in enumerate(self._moments()):
            self._draw(moment, *snapshot)
            yield number

    def _snapshots(self):
        for number, snapshot in enumerate(self._run.snapshots()):
            if number % self._every == 0:
                yield snapshot

    def _moments(self):
        steps = self._run.snapshot_steps[::self._every]
        times = self._run.snapshot_times[::self._every]
        for step, time, snapshot in zip(steps, times, self._snapshots(), strict=True):
            yield (int(step), float(time)), *snapshot

    def _cell(self, edges):
        return Cell(edges, self._walls)

    def _norm_of_all(self):
        """One scale for the whole movie: from the 2nd to the 98th hundredth of each snapshot."""
        low, high = np.inf, 0.0
        for (step, _), *snapshot in self._moments():
            values = self._colouring.values(step, *snapshot)
            values = values[values > 0]  # and no NaN
            if values.size:
                ends = np.percentile(values, (2, 98))
                low, high = min(low, ends[0]), max(high, ends[1])
        return LogNorm(low, max(high, 1.01 * low), clip=True) if high else LogNorm(1, 10, clip=True)

    def _prepare(self, cells):
        axes = self._axes = self.figure.add_axes([0.02, 0.02, 0.80, 0.90])
        axes.set_axis_off()
        axes.set_aspect("equal")
        lines = np.concatenate([self._view.outline(cell)[0] for cell in cells]).reshape(-1, 2)
        (left, bottom), (right, top) = lines.min(axis=0) - 1, lines.max(axis=0) + 1
        axes.set_xlim(left, right)
        axes.set_ylim(bottom, top)
        self._behind, self._before = (
            axes.add_collection(LineCollection([], colors=INK, linewidths=0.8, zorder=zorder))
            for zorder in (1, 3))
        self._spheres = None
        bar = self.figure.add_axes([0.85, 0.12, 0.02, 0.70])
        self.figure.colorbar(ScalarMappable(self._norm, self._colouring.colours), cax=bar,
                             label=self._colouring.label)
        decades = np.log10(self._norm.vmax / self._norm.vmin)
        if decades < 2:  # numbers at 2 and 5 too, where powers of ten are few
            bar.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            bar.yaxis.set_major_formatter(FuncFormatter(lambda value, _: words.short(value)))
            bar.yaxis.set_minor_formatter(NullFormatter())
        self._title = self.figure.text(0.03, 0.95, "", fontsize=11)

    def _draw(self, moment, positions, velocities, edges):
        step, time = moment
        cell = self._cell(edges)
        places = self._view.seen(cell.slanted(positions))
        order = np.argsort(places[:, 2], kind="stable")  # what is near comes last
        values = self._colouring.values(step, positions, velocities, edges)
        colours = self._misty(self._colours(values), places[:, 2])
        if self._spheres:
            self._spheres.remove()
        size = np.ones(len(places))
        self._spheres = self._axes.add_collection(EllipseCollection(
            size, size, 0 * size, units="xy", offsets=places[order, :2],
            offset_transform=self._axes.transData, facecolors=colours[order],
            edgecolors=colours[order] * (0.55, 0.55, 0.55, 1), linewidths=0.3, zorder=2))
        lines, is_front = self._view.outline(cell)
        self._behind.set_segments(lines[~is_front])
        self._before.set_segments(lines[is_front])
        self._title.set_text(self._said(step, time))

    def _colours(self, values):
        colours = self._colouring.colours(self._norm(np.where(values > 0, values, self._norm.vmin)))
        colours[np.isnan(values)] = GREY
        return colours

    def _misty(self, colours, depth):
        if self._view.dimension < 3:
            return colours
        span = max(np.ptp(depth), 1e-9)
        mist = MISTY * (depth.max() - depth)[:, None] / span
        colours[:, :3] += mist * (1 - colours[:, :3])
        return colours

    def _said(self, step, time):
        rate = self._run.setting("drive", "shear_rate")
        clock = f"strain {time * rate:.6g}" if rate else f"time {time:.6g}"
        restitution = self._run.setting("system", "restitution")
        known = "" if restitution is None else f"e = {words.short(restitution)}, "
        return (f"{self._run.name}: {known}N = {words.grouped(self._run.spheres)};"
                f" {clock}, collision {words.grouped(step)}")
