"""Zenosphere: inelastic hard spheres by events, and whether they collapse.

`Case` describes a run, `Run` does it, `open` reads what one has recorded (docs/python.md) and
`analyse` measures it (docs/measurements.md). They need the compiled part of the package. The rest
draws figures and writes reports: `python3 -m zenosphere --help`.
"""

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from .errors import InputError, OutputError
from .version import __version__

if TYPE_CHECKING:
    from .analysis.results import analyse
    from .case import Case
    from .output import Output, open
    from .run import COLLISION_DTYPE, Run, State

__all__ = ["COLLISION_DTYPE", "Case", "InputError", "Output", "OutputError", "Run", "State",
           "analyse", "open"]

_COMPILED = {"COLLISION_DTYPE": ".run", "Case": ".case", "Output": ".output", "Run": ".run",
             "State": ".run", "analyse": ".analysis.results", "open": ".output"}


def __getattr__(name: str) -> Any:
    """Loads what needs the compiled part when it is asked for: figures do without."""
    if name not in _COMPILED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        return getattr(import_module(_COMPILED[name], __name__), name)
    except ImportError as error:
        if "_core" not in str(error):
            raise
        raise ImportError(f"zenosphere.{name}: needs the compiled part of the package ({error});"
                          " build it and use PYTHONPATH=build/python, or pip install it"
                          " (docs/python.md)") from error


def __dir__() -> list[str]:
    """Names for completion and `help`: those of the compiled part where that is there."""
    hidden = set() if find_spec("._core", __name__) else set(_COMPILED)
    return sorted((set(globals()) | set(__all__)) - hidden)
