"""Writes a table."""

import csv
import math

from .errors import OutputError


def write_csv(path, rows):
    """Writes dicts of the same keys as CSV, numbers in 6 digits; nothing known is left empty."""
    try:
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = None
            for row in rows:
                if writer is None:
                    writer = csv.DictWriter(file, row.keys(), lineterminator="\n")
                    writer.writeheader()
                writer.writerow({key: _written(value) for key, value in row.items()})
    except OSError as error:
        raise OutputError(f"{path}: cannot be written ({error.strerror});"
                          " choose another folder with -o") from error
    return path


def _written(value):
    if value is None or isinstance(value, str):
        return value
    return "" if math.isnan(value) else f"{value:.6g}" if value != int(value) else int(value)
