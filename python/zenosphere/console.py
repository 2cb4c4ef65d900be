"""The command `zenosphere` that pip installs: the program's commands and those of this package."""

import os
import subprocess
import sys
from pathlib import Path

PROGRAM = Path(__file__).resolve().parent / "bin" / "zenosphere"
COMMANDS = ("figures", "report-md", "cooling", "ensemble")  # of this package


def main():
    """Does a command of this package, or becomes the program, which does any other.

    Returns the exit code; 2 where the program is not there.
    """
    words = sys.argv[1:]
    if words and words[0] in COMMANDS:
        from .__main__ import main as draw  # needs matplotlib, which runs do without
        return draw(words)
    if not os.access(PROGRAM, os.X_OK):
        print(f"{PROGRAM}: is not there (the package was not installed by pip); run"
              " build/zenosphere, or pip install the package (docs/python.md)", file=sys.stderr)
        return 2
    if words in (["--help"], ["-h"], ["help"]):
        code = subprocess.run([PROGRAM, *words]).returncode
        print(f"In Python, each with its own --help: {', '.join(COMMANDS)}")
        return code
    sys.stdout.flush()
    os.execv(PROGRAM, [str(PROGRAM), *words])
