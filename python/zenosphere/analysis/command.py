"""The command `analyse`."""

import argparse
from pathlib import Path

from ..drawing.pictures import Pictures
from ..errors import InputError
from . import tables
from .figures import draw_analysis

WRITERS = {".json": tables.write_json, ".csv": tables.write_tables}

EPILOG = """FILE.json holds the object that --json prints; FILE.csv the numbers, with a table for
each curve beside it (FILE-radial-distribution.csv and so on). docs/measurements.md defines them."""


def add_analyse(commands, add_look):
    """Adds the command to the parser of the package.

    add_look: adds the options of every command that draws
    """
    analyse = commands.add_parser("analyse", help="structure, velocities, profiles and transport"
                                  " from the snapshots of a run", epilog=EPILOG)
    analyse.add_argument("file", metavar="OUT.h5", type=Path, help="a run, ended or not")
    analyse.add_argument("--json", action="store_true", help="print one JSON object")
    analyse.add_argument("-o", "--output", metavar="FILE", type=Path,
                         help="write the results too: one object (.json) or tables (.csv)")
    analyse.add_argument("--figures", metavar="DIR", type=Path, help="draw one figure for each")
    analyse.add_argument("--from-time", metavar="TIME", type=_time,
                         help="of the first snapshot that counts (default: where the averages of"
                         " the run begin, measure.after_time)")
    analyse.add_argument("--to-time", metavar="TIME", type=_time,
                         help="of the last one (default: the end)")
    add_look(analyse, ("png",), "png")
    analyse.set_defaults(command=_analyse)


def _time(text):
    try:
        time = float(text)
    except ValueError:
        time = float("nan")
    if time != time:
        raise argparse.ArgumentTypeError(f"{text!r} (must be a time, as 20 or 2.5)")
    return time


def _analyse(options):
    write = _writer(options.output)
    results = _analysis()(options.file, from_time=options.from_time, to_time=options.to_time)
    written = write(results, options.output) if write else []
    if options.figures:
        written += draw_analysis(results, options.figures, options.file.stem,
                                 Pictures(options.format, options.size))
    if not options.json:
        print(tables.as_text(results), *written, sep="\n")
    else:
        print(tables.as_json(results))


def _writer(path):
    """What writes a file of this suffix; None for no file. Raises InputError."""
    if path is None:
        return None
    if path.suffix.lower() not in WRITERS:
        raise InputError(f"-o {path}: {path.suffix or 'no suffix'} names no format of results (must"
                         " be .json or .csv); figures are drawn with --figures DIR")
    return WRITERS[path.suffix.lower()]


def _analysis():
    """`analyse`, or one line that says what is missing for it. Raises InputError."""
    try:
        from .results import analyse
        return analyse
    except ImportError as error:
        raise InputError(f"analyse: cannot begin ({error}); it needs SciPy (apt install"
                         " python3-scipy) and the compiled part of the package"
                         " (docs/python.md)") from error
