"""Runs cases of this folder with some keys changed, and draws: what the scan scripts share."""

import json
import os
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent
sys.path.append(str(EXAMPLES.parent / "python"))

from zenosphere.drawing.pictures import HEIGHT, WIDTH, Pictures  # noqa: E402


def program():
    """Path of the simulator: $ZENOSPHERE, else build/zenosphere of this checkout.

    Raises SystemExit where there is none.
    """
    path = Path(os.environ.get("ZENOSPHERE", EXAMPLES.parent / "build" / "zenosphere")).resolve()
    if not path.is_file():
        raise SystemExit(f"{path}: no such program (needed to run the cases); build it with"
                         " scripts/build, or name another one in ZENOSPHERE")
    return path


def written(value):
    """A value as TOML: a number, a Decimal with all its digits, a text, true/false, or a list."""
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(written(each) for each in value) + "]"
    return str(value) if isinstance(value, Decimal) else json.dumps(value)


def overrides(changes):
    """{"run.time": 3} as the words of the command line, `--set run.time=3`.

    changes: key -> number, Decimal, text, true/false or nested list of them
    """
    return [word for key, value in changes.items()
            for word in ("--set", f"{key}={written(value)}")]


def summary(case, changes, output=None):
    """The summary (docs/summary.md) of one run.

    case: name of a file of this folder, without .toml;  output: file for collisions and snapshots
    Raises SystemExit with the program's message where it fails.
    """
    kept = ["--overwrite", "-o", str(output)] if output else []
    return _told("run", EXAMPLES / f"{case}.toml", *kept, *overrides(changes))


def largest_restitution_with_a_hit(case, changes, below, above, steps):
    """Where the separation criterion alone puts the threshold of a case, by bisection.

    changes: keys of the case without its restitution
    below, above: restitutions between which it lies
    """
    for _ in range(steps):
        middle = (below + above) / 2
        keys = changes | {"system.restitution": middle}
        if summary(case, keys)["separation"]["hits"]:
            below = middle
        else:
            above = middle
    return (below + above) / 2


def stages(case, changes, key, limits):
    """Summaries of one run as it reaches one limit after the other; fewer where it ends before.

    key: of the limit, "run.time" or "run.collisions";  limits: ascending
    """
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "run.h5"
        summaries = [summary(case, {**changes, key: limits[0]}, output)]
        for limit in limits[1:]:
            if summaries[-1]["outcome"] != "finished":
                break
            summaries.append(_told("resume", output, *overrides({key: limit})))
    return summaries


def _told(command, path, *words):
    """The summary that a command of the program prints."""
    done = subprocess.run([program(), command, path, "--json", "--quiet", *words],
                          capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


def kept(path, measured):
    """What `measured()` returns, as JSON has it; read from a file where there is one.

    path: of the file, written where it is missing; None: nothing is kept
    """
    path = Path(path) if path else None
    if path and path.is_file():
        return json.loads(path.read_text(encoding="utf-8"))
    results = json.loads(json.dumps(measured()))
    if path:
        path.write_text(json.dumps(results) + "\n", encoding="utf-8")
    return results


@contextmanager
def drawn(path, size=(WIDTH, HEIGHT), columns=1):
    """Axes to draw on in the look of all figures, which are then written to a file.

    path: its suffix tells the format, .png, .pdf or .svg;  size: width and height in inches
    columns: panels side by side with one y axis; an array of them where there are more than one
    """
    from matplotlib.figure import Figure
    pictures, path = Pictures((Path(path).suffix[1:],)), Path(path)
    with pictures.style():
        figure = Figure(figsize=size, layout="constrained")
        yield figure.subplots(1, columns, sharey=True)
        pictures.write(figure, path.with_suffix(""))
