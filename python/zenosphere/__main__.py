"""Command line: `python3 -m zenosphere figures ...`, `... report-md ...`, `... cooling ...`,
`... movie ...`, `... ensemble ...` and `... analyse ...`."""

import argparse
import os
import sys
from contextlib import ExitStack
from pathlib import Path

from .analysis.command import add_analyse
from .command_parser import CommandParser
from .cooling.figure import draw_cooling
from .drawing.pictures import FORMATS, Pictures, parsed_formats, parsed_size
from .ensembles.figures import draw_ensemble
from .ensembles.search_figures import draw_search
from .ensembles.store import Ensemble
from .errors import InputError, OutputError
from .figures import FALSE_POSITIVE, TRUE_COLLAPSE, draw_general_figures, draw_paper_figures
from .figures.report import write_report
from .movies.movie import COLOURINGS, draw_movie
from .run_file import RunFile


def main(arguments=None):
    """Does what the command line says and returns the exit code (0, 2 input, 4 output).

    A reader of the output that has left (`... | head`) is no error.
    """
    options = _parser().parse_args(arguments)
    try:
        options.command(options)
        sys.stdout.flush()
    except InputError as error:
        return _failed(error, 2)
    except OutputError as error:
        return _failed(error, 4)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # for the flush at exit
    return 0


def _figures(options):
    paper = ((options.false_positive, FALSE_POSITIVE), (options.true_collapse, TRUE_COLLAPSE))
    runs = options.run + options.files
    if not runs and not any(path for path, _ in paper):
        raise InputError("figures: no run given (nothing to draw); add --false-positive,"
                         " --true-collapse or --run")
    written = []
    for path, plans in paper:
        if path:
            with RunFile(path) as run:
                written += draw_paper_figures(run, plans, options.output, _pictures(options))
    for path in runs:
        with RunFile(path) as run:
            written += draw_general_figures(run, options.output, _pictures(options))
    for path in written:
        print(path)


def _pictures(options):
    return Pictures(options.format, options.size)


def _report(options):
    figures = options.figures or options.output.parent / "figures"
    with ExitStack() as open_files:
        runs = [open_files.enter_context(RunFile(path)) for path in options.files]
        write_report(runs, options.output, figures)
    print(options.output)


def _cooling(options):
    pictures = Pictures(options.format or _format_of(options.output), options.size)
    with RunFile(options.file) as run:
        said, written = draw_cooling(run, _without_format(options.output), pictures)
    print(said)
    for path in written:
        print(path)


def _format_of(path):
    """The one that a file's suffix names. Raises InputError."""
    suffix = path.suffix[1:].lower()
    if path == _without_format(path):
        raise InputError(f"{path}: {path.suffix or 'no suffix'} names no format of a figure (there"
                         f" are {', '.join(FORMATS)}); end the name in .png, or give --format")
    return (suffix,)


def _without_format(path):
    return path.with_suffix("") if path.suffix[1:].lower() in FORMATS else path


def _movie(options):
    with RunFile(options.file) as run:
        written, hint = draw_movie(run, options.output or Path(f"{run.name}.mp4"), options.colour,
                                   options.fps, options.every)
    print(written)
    if hint:
        print(hint, file=sys.stderr)


def _ensemble(options):
    ensemble = Ensemble(options.file)
    pictures = _pictures(options)
    written = (draw_search(ensemble, options.output, pictures) if ensemble.boundaries() else
               draw_ensemble(ensemble, options.output, options.x, options.y, pictures))
    for path in written:
        print(path)


def _parser():
    parser = CommandParser(prog=os.environ.get("ZENOSPHERE_COMMAND", "python3 -m zenosphere"),
                           description=sys.modules["zenosphere"].__doc__)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    figures = commands.add_parser("figures", help="draw the figures of runs")
    figures.add_argument("--false-positive", metavar="OUT.h5", type=Path,
                         help="run for the paper's Figures 1, 2, 3a, 3b (e = 0.6)")
    figures.add_argument("--true-collapse", metavar="OUT.h5", type=Path,
                         help="run for the paper's Figures 4, 5, 6 (e = 0.2)")
    figures.add_argument("--run", metavar="OUT.h5", type=Path, action="append", default=[],
                         help="any run, for a general set; can be repeated")
    figures.add_argument("files", metavar="OUT.h5", type=Path, nargs="*", help="the same as --run")
    figures.add_argument("-o", "--output", metavar="DIR", type=Path, default=Path("figures"),
                         help="folder of the figures (default: figures)")
    _add_look(figures, ("png", "pdf"), "png,pdf")
    figures.set_defaults(command=_figures)

    report = commands.add_parser("report-md", help="write a Markdown report")
    report.add_argument("files", metavar="OUT.h5", type=Path, nargs="+", help="one column each")
    report.add_argument("-o", "--output", metavar="PAGE.md", type=Path,
                        default=Path("report.md"), help="the report (default: report.md)")
    report.add_argument("--figures", metavar="DIR", type=Path,
                        help="figures to embed (default: figures beside the report)")
    report.set_defaults(command=_report)

    cooling = commands.add_parser("cooling", help="draw the granular temperature against time,"
                                  " with Haff's law")
    cooling.add_argument("file", metavar="OUT.h5", type=Path, help="a run with snapshots")
    cooling.add_argument("-o", "--output", metavar="FIGURE.png", type=Path,
                         default=Path("cooling.png"), help="the figure (default: cooling.png)")
    _add_look(cooling, None, "by the suffix of FIGURE")
    cooling.set_defaults(command=_cooling)
    _add_movie(commands)
    _add_ensemble(commands)
    add_analyse(commands, _add_look)
    return parser


def _add_movie(commands):
    movie = commands.add_parser("movie", help="draw the snapshots one after another")
    movie.add_argument("file", metavar="OUT.h5", type=Path, help="a run with snapshots")
    movie.add_argument("-o", "--output", metavar="MOVIE.mp4", type=Path,
                       help="the movie, by ffmpeg; a name without suffix: a folder of PNGs"
                       " (default: OUT.mp4)")
    movie.add_argument("--colour", choices=COLOURINGS, default="speed",
                       help="of spheres: peculiar speed, or how many collisions ago each of them"
                       " collided last (default: speed)")
    movie.add_argument("--fps", metavar="N", type=_positive,
                       help="snapshots a second (default: 12, or fewer where the movie would last"
                       " less than three seconds)")
    movie.add_argument("--every", metavar="N", type=_positive, default=1,
                       help="one snapshot of so many (default: 1)")
    movie.set_defaults(command=_movie)


def _positive(text):
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} (must be a whole number above 0)")
    return int(text)


def _add_ensemble(commands):
    ensemble = commands.add_parser("ensemble", help="draw how likely collapse is, from the store of"
                                   " a sweep, and write the tables")
    ensemble.add_argument("file", metavar="STORE.sqlite", type=Path, help="a store, done or not")
    ensemble.add_argument("-o", "--output", metavar="DIR", type=Path, default=Path("figures"),
                          help="folder of figures and tables (default: figures)")
    ensemble.add_argument("--x", metavar="KEY", help="axis of the curves"
                          " (default: system.restitution, or the axis with most values)")
    ensemble.add_argument("--y", metavar="KEY", help="axis of the panels and of the maps' rows"
                          " (default: system.solids_volume_fraction, or the next)")
    _add_look(ensemble, ("png",), "png")
    ensemble.set_defaults(command=_ensemble)


def _add_look(command, formats, usual):
    """The options of every command that draws."""
    command.add_argument("--format", metavar="FORMATS", type=parsed_formats, default=formats,
                         help=f"{', '.join(FORMATS)}; several as png,svg (default: {usual})")
    command.add_argument("--size", metavar="WxH", type=parsed_size, help="width and height of each"
                         " figure in centimetres, as 8.6x6 (default: what suits the figure)")


def _failed(error, code):
    print(error, file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
