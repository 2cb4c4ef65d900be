"""Zenosphere: inelastic hard spheres by events, and whether they collapse.

`Run` and `Case` run the simulator from Python (docs/python.md); they need the compiled part of the
package. The rest reads output files and draws the figures and reports: `python3 -m zenosphere
--help`.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .errors import InputError, OutputError

if TYPE_CHECKING:
    from .case import Case
    from .run import COLLISION_DTYPE, Run, State

__all__ = ["COLLISION_DTYPE", "Case", "InputError", "OutputError", "Run", "State"]

_COMPILED = {"COLLISION_DTYPE": ".run", "Case": ".case", "Run": ".run", "State": ".run"}


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
