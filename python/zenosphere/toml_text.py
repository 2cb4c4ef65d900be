"""Python values as TOML text: Python's library reads TOML, but writes none."""

import json
import math
from collections.abc import Mapping, Sequence
from numbers import Integral, Real
from typing import Any

from .errors import InputError


def tables_text(tables: Mapping[str, Mapping[str, Any]], name: str) -> str:
    """A TOML text of tables of values.

    tables: `{"system": {"restitution": 0.2}}`; a value is a bool, a number, a text or a sequence
    of those, NumPy's included. A list of such dicts in place of one is an array of tables
    name: what error messages begin with
    Raises InputError for what TOML cannot say.
    """
    if not isinstance(tables, Mapping):
        raise InputError(f"{name}: is a {type(tables).__name__} (a case is nested dicts); give"
                         " {'system': {...}, ...}, or use Case.read or Case.parse")
    lines = []
    for table, values in tables.items():
        if _is_list_of_tables(values):
            for item in values:
                lines += ["", f"[[{_key(table)}]]", *_table_lines(item, f"{name}: {table}")]
            continue
        if not isinstance(values, Mapping):
            raise InputError(f"{name}: {table} = {values!r} (found no dict, needs one with"
                             " the keys of a table); give {'system': {...}, ...}")
        lines += ["", f"[{_key(table)}]", *_table_lines(values, f"{name}: {table}")]
    return "\n".join(lines[1:]) + "\n"


def _is_list_of_tables(values: Any) -> bool:
    return (isinstance(values, Sequence) and not isinstance(values, str) and len(values) > 0
            and all(isinstance(item, Mapping) for item in values))


def _table_lines(values: Mapping[str, Any], where: str) -> list[str]:
    return [f"{_key(key)} = {value_text(value, f'{where}.{key}')}" for key, value in values.items()]


def override_texts(overrides: Mapping[str, Any] | None) -> list[str]:
    """`{"system.restitution": 0.2}` as the arguments of the program's `--set`."""
    texts = []
    for key, value in (overrides or {}).items():
        where = f'overrides["{key}"]'
        texts.append(f"{key}={value_text(value, where)}")
    return texts


def value_text(value: Any, where: str) -> str:
    """One value; real numbers so that they read back to the same bits."""
    if hasattr(value, "tolist"):  # a NumPy array or scalar
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return _integer_text(int(value), where)
    if isinstance(value, Real):
        return _real_text(float(value))
    if isinstance(value, str):
        return _quoted(value, where)
    if isinstance(value, Sequence):
        return "[" + ", ".join(value_text(item, where) for item in value) + "]"
    raise InputError(f"{where} = {value!r} (a {type(value).__name__}, which TOML has not); give a"
                     " number, a text, a bool or a list of them")


def _integer_text(number: int, where: str) -> str:
    if -2**63 <= number < 2**63:
        return str(number)
    raise InputError(f"{where} = {number} (TOML's integers have 64 bits); give a smaller one")


def _quoted(text: str, where: str) -> str:
    try:
        text.encode()
    except UnicodeEncodeError:
        raise InputError(f"{where} = {text!r} (half of a pair of surrogates is no character); give"
                         " Unicode text") from None
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _real_text(number: float) -> str:
    return repr(number) if math.isfinite(number) else str(number)  # inf and nan are TOML


def _key(name: str) -> str:
    if not isinstance(name, str):
        raise InputError(f"case: key {name!r} (a {type(name).__name__}, keys are text); quote it")
    bare = name and all(letter.isascii() and (letter.isalnum() or letter in "_-")
                        for letter in name)
    return name if bare else _quoted(name, "case: key")
