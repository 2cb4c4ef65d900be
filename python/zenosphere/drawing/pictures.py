"""How every figure looks, and how it is written: typeface, colours, size and file formats."""

import argparse
import re
import warnings
from dataclasses import dataclass

import matplotlib
from cycler import cycler

from ..errors import InputError, OutputError
from . import words

FORMATS = ("png", "pdf", "svg")
INCH = 2.54  # cm
WIDTH, HEIGHT = 5.2, 3.4  # inches, of a figure with one panel
PAGE_WIDTH = 7.0  # inches, of a figure with several: 1400 pixels
LEAST_SIZE, LARGEST_SIZE = 5.0, 100.0  # cm
LEAST_SCALE = 0.7  # of the text: 10 points become 7

# Okabe & Ito's palette; with markers, distinct to every kind of colour vision and in grey print.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#1b2a41")
INK, HIT_COLOUR, MARK_COLOUR = "#1b2a41", "#d55e00", "#0072b2"

STYLE = {
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 10.0,
    "axes.labelsize": "medium", "axes.linewidth": 0.7, "xtick.labelsize": 9.0,
    "ytick.labelsize": 9.0, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True,
    "ytick.right": True, "legend.fontsize": 8.5, "legend.frameon": False, "pdf.fonttype": 42,
    "hatch.linewidth": 0.5, "axes.prop_cycle": cycler(color=COLOURS),
    "svg.hashsalt": "zenosphere",  # the same figure is the same file
}
UNDATED = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}


@dataclass(frozen=True)
class Pictures:
    """Which files a figure becomes.

    formats: of FORMATS
    size: (width, height) in inches; None: what suits the figure
    """

    formats: tuple = ("png",)
    size: tuple | None = None

    def inches(self, width, height):
        """Size of a figure that would have this one by itself."""
        return self.size or (width, height)

    def style(self):
        """Context in which to draw: STYLE, with smaller text in figures that are narrow."""
        scale = max(LEAST_SCALE, min(1.0, self.inches(WIDTH, HEIGHT)[0] / WIDTH))
        return matplotlib.rc_context({key: value * scale if key.endswith("size") and isinstance(
            value, float) else value for key, value in STYLE.items()})

    def write(self, figure, path, dots_per_inch=200):
        """Writes path.png and so on, and returns the paths.

        path: Path without suffix
        Raises OutputError where a file cannot be written, InputError where the size is too small.
        """
        written = [path.parent / f"{path.name}.{suffix}" for suffix in self.formats]
        for target, suffix in zip(written, self.formats):
            try:
                with warnings.catch_warnings():
                    warnings.filterwarnings("error", "constrained_layout not applied", UserWarning)
                    figure.savefig(target, dpi=dots_per_inch, metadata=UNDATED.get(suffix))
            except UserWarning as warning:
                width, height = (side * INCH for side in figure.get_size_inches())
                raise InputError(f"{path.name}: does not fit in {width:g}x{height:g} cm (its labels"
                                 " leave no room for it); give a larger --size") from warning
            except OSError as error:
                raise OutputError(f"{target}: cannot be written ({error.strerror});"
                                  " choose another place with -o") from error
        return written


def points(size):
    """A size of text (points) in a figure with 10 points for its labels, scaled to this one."""
    return size * matplotlib.rcParams["font.size"] / STYLE["font.size"]


def above(axes, text, lift, **style):
    """Text over the left end of a panel; lift: of its foot, points."""
    axes.annotate(text.replace(words.SPACE, " "), xy=(0, 1), xycoords="axes fraction",
                  xytext=(0, points(lift)), textcoords="offset points", va="bottom",
                  annotation_clip=False, **style)  # mathtext has no no-break space


def parsed_formats(text):
    """`png,svg` as ("png", "svg"); for argparse."""
    formats = tuple(dict.fromkeys(text.lower().split(",")))
    wrong = [each for each in formats if each not in FORMATS]
    if wrong:
        raise argparse.ArgumentTypeError(f"{', '.join(map(repr, wrong))} is none of"
                                         f" {', '.join(FORMATS)}; write several as png,svg")
    return formats


def parsed_size(text):
    """`8.6x6` (cm) as (width, height) in inches; for argparse."""
    parts = re.fullmatch(r"(\d+\.?\d*)x(\d+\.?\d*)", text)
    sides = [float(part) for part in parts.groups()] if parts else []
    if not sides or not all(LEAST_SIZE <= side <= LARGEST_SIZE for side in sides):
        raise argparse.ArgumentTypeError(
            f"{text!r} (must be WIDTHxHEIGHT in centimetres, each from {LEAST_SIZE:g} to"
            f" {LARGEST_SIZE:g}); for example 8.6x6")
    return tuple(side / INCH for side in sides)


def made_folder(folder, option="-o"):
    """Makes a folder where there is none.

    folder: Path;  option: that of the command which names it. Raises OutputError.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{folder}: folder cannot be made ({error.strerror}); choose another one"
                          f" with {option}") from error
