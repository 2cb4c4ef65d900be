"""Runs cases of this folder with some keys changed, and draws: what the scan scripts share."""

import json
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent
sys.path.append(str(EXAMPLES.parent / "python"))

from zenosphere.pictures import HEIGHT, WIDTH, Pictures  # noqa: E402


def program():
    """Path of the simulator: $ZENOSPHERE, else build/zenosphere of this checkout.

    Raises SystemExit where there is none.
    """
    path = Path(os.environ.get("ZENOSPHERE", EXAMPLES.parent / "build" / "zenosphere")).resolve()
    if not path.is_file():
        raise SystemExit(f"{path}: no such program (needed to run the cases); build it with"
                         " scripts/build, or name another one in ZENOSPHERE")
    return path


def overrides(changes):
    """{"run.time": 3} as the words of the command line, `--set run.time=3`.

    changes: key -> number, text, true/false or nested list of them; JSON writes these as TOML does
    """
    return [word for key, value in changes.items()
            for word in ("--set", f"{key}={json.dumps(value)}")]


def summary(case, changes, output=None):
    """The summary (docs/summary.md) of one run.

    case: name of a file of this folder, without .toml;  output: file for collisions and snapshots
    Raises SystemExit with the program's message where it fails.
    """
    kept = ["--overwrite", "-o", str(output)] if output else []
    done = subprocess.run([program(), "run", EXAMPLES / f"{case}.toml", "--json", "--quiet", *kept,
                           *overrides(changes)], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


@contextmanager
def drawn(path):
    """Axes to draw on in the look of all figures, which are then written to a file.

    path: its suffix tells the format, .png, .pdf or .svg
    """
    from matplotlib.figure import Figure
    pictures, path = Pictures((Path(path).suffix[1:],)), Path(path)
    with pictures.style():
        figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
        yield figure.add_subplot()
        pictures.write(figure, path.with_suffix(""))
