"""The version: that of CITATION.cff, which lies in the package or, in a checkout, at its top."""

import re
from contextlib import suppress
from pathlib import Path

__all__ = ["__version__"]


def _version() -> str:
    for folder in (Path(__file__).parent, *Path(__file__).parents[2:3]):
        with suppress(FileNotFoundError):
            found = re.search(r"^version: (.+)$", (folder / "CITATION.cff").read_text(), re.M)
            return found[1] if found else "unknown"
    return "unknown"


__version__ = _version()
