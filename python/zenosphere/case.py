"""A checked case: what a run is started from."""

import os
import tomllib
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from .toml_text import override_texts, tables_text

Overrides = Mapping[str, Any]


class Grains(NamedTuple):
    """What each of N spheres is, spheres in the order of the species of their case.

    diameter, mass: (N,), in the units of the case
    kind: (N,) int32, number of the species, from 0
    immobile: (N,) bool
    """

    diameter: NDArray[np.float64]
    mass: NDArray[np.float64]
    kind: NDArray[np.int32]
    immobile: NDArray[np.bool_]


class Case:
    """One run as its user describes it (docs/case-file.md lists the keys), checked.

    Units: sphere diameter = mass = 1, times in the case's own unit.

    tables: the case as nested dicts, `{"system": {"spheres": 108, ...}, ...}`; numbers may be
    NumPy's; `species` and `contact` are lists of dicts
    overrides: keys and the values that replace theirs, `{"system.restitution": 0.2}`
    name: what the messages call the case; a relative `start.file` is relative to its folder
    Raises InputError, one line for each problem, with the texts of the program. In a case from a
    dict they name the key, `case: system.restitution = 1.2 (must be in [0, 1]; 1 is elastic)`.

    Cases are equal if they describe the same run, key by key, whatever text they were read from.
    They can be pickled, and so given to the processes of `multiprocessing`.
    """

    def __init__(self, tables: Mapping[str, Mapping[str, Any]], *,
                 overrides: Overrides | None = None, name: str = "case") -> None:
        self._core = _core.Case.parse_written(tables_text(tables, name), name,
                                              override_texts(overrides))

    @classmethod
    def read(cls, file: str | os.PathLike[str], *, overrides: Overrides | None = None) -> "Case":
        """The case of a TOML file; problems name `file:line:column`."""
        return cls._of(_core.Case.read(os.fspath(file), override_texts(overrides)))

    @classmethod
    def parse(cls, text: str, *, overrides: Overrides | None = None, name: str = "case") -> "Case":
        """The case of a TOML text; problems name `name:line:column`."""
        return cls._of(_core.Case.parse(text, name, override_texts(overrides)))

    @classmethod
    def _of(cls, core: _core.Case) -> "Case":
        case = cls.__new__(cls)
        case._core = core
        return case

    @property
    def text(self) -> str:
        """The TOML text that the case was read from, without overrides."""
        return self._core.text

    @property
    def resolved(self) -> str:
        """A complete TOML text: every key that has a value, defaults and overrides included.

        `Case.parse` makes the same case of it, bit for bit.
        """
        return self._core.resolved

    @property
    def tables(self) -> dict[str, dict[str, Any]]:
        """The same as nested dicts."""
        return tomllib.loads(self.resolved)

    @property
    def derived(self) -> str:
        """What follows from the case, in words, as `zenosphere check` prints it."""
        return self._core.derived

    @property
    def grains(self) -> Grains:
        """Diameter, mass, kind and immobile of each sphere, drawn where the case draws them."""
        diameter, mass, kind, immobile = self._core.grains()
        return Grains(diameter, mass, kind, immobile.astype(bool))

    @property
    def grains_if_different(self) -> Grains | None:
        """The same, or None where all are mobile unit spheres of one kind."""
        has_kinds = "species" in self.tables or "polydispersity" in self.tables
        return self.grains if has_kinds else None

    def __eq__(self, other: object) -> bool:
        return self.resolved == other.resolved if isinstance(other, Case) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.resolved)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.resolved, self.text)

    def __repr__(self) -> str:
        system = self.tables["system"]
        return (f"<zenosphere.Case: {system['spheres']} spheres, {system['dimension']} dimensions,"
                f" restitution {system.get('restitution')}>")


def _restored(resolved: str, text: str) -> Case:
    """A case that was pickled."""
    return Case._of(_core.Case.restored(resolved, text))
