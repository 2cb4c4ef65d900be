"""The command `zenosphere` that pip installs: the program, which lies in the package."""

import os
import sys
from pathlib import Path

PROGRAM = Path(__file__).resolve().parent / "bin" / "zenosphere"


def main():
    """Becomes the program; returns 2 where it is not there.

    The commands that draw come back to this package, in the interpreter that runs now.
    """
    if not os.access(PROGRAM, os.X_OK):
        print(f"{PROGRAM}: is not there (the package was not installed by pip); run"
              " build/zenosphere, or pip install the package (docs/python.md)", file=sys.stderr)
        return 2
    os.environ.setdefault("ZENOSPHERE_PYTHON", sys.executable)
    sys.stdout.flush()
    os.execv(PROGRAM, [str(PROGRAM), *sys.argv[1:]])
