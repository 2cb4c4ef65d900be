"""The results of an analysis as text, as JSON and as CSV tables."""

import json
import math

import numpy as np

from ..csv_file import write_csv
from ..errors import OutputError

SCALARS = (  # key of the result, key in it, what it is called
    ("granular_temperature", "value", "granular temperature"),
    ("contact_value", "value", "g at contact"),
    ("structure_factor.at_zero", "value", "S(k -> 0)"),
    ("sonine", "a2", "a2"),
    ("sonine", "a3", "a3"),
    ("mean_free_path", "value", "mean free path"),
    ("touching", "coordination", "neighbours within the gap {gap:g}"),
    ("diffusion", "value", "self-diffusion"),
    ("shear_viscosity", "value", "shear viscosity"),
    ("normal_stress_differences", "n1", "N1 / p"),
    ("normal_stress_differences", "n2", "N2 / p"),
)
CURVES = ("radial_distribution", "structure_factor", "velocity_distribution", "profiles",
          "mean_square_displacement", "velocity_autocorrelation")


def as_json(results):
    """One JSON object on one line; what is not known or not finite is null."""
    return json.dumps(_plain(results), allow_nan=False)


def as_text(results):
    """The numbers with their standard errors, a line each, for people."""
    lines = [f"{results['file']}: {results['snapshots']} snapshots of {results['spheres']} spheres"]
    if results["snapshots"]:
        lines[0] += f", time {results['from_time']:g} to {results['to_time']:g}"
    if rows := results["accumulated"]:
        lines.append(f"accumulated in the run: {rows['samples']} samples, time"
                     f" {rows['from_time']:g} to {rows['to_time']:g}")
    for row in scalar_rows(results):
        value, error = row["value"], row["standard_error"]
        if value is not None:
            known = "" if error is None else f" +- {error:.2g}"
            lines.append(f"  {row['quantity']:32} {value:.6g}{known}")
    if results["velocity_autocorrelation"] is None:
        from .displacements import FEWEST_LAGS  # here: the command has to load without SciPy
        lines.append(f"  velocity autocorrelation and self-diffusion need {FEWEST_LAGS + 1} snapshots or"
                     " more at equal intervals (output.snapshot_interval, or"
                     " measure.sampling_interval)")
    return "\n".join(lines)


def write_json(results, path):
    """Writes the object as a file. Raises OutputError."""
    try:
        path.write_text(as_json(results) + "\n", encoding="utf-8")
    except OSError as error:
        raise OutputError(f"{path}: cannot be written ({error.strerror}); choose another place with"
                          " -o") from error
    return [path]


def write_tables(results, path):
    """Writes the numbers as PATH and each curve as a table beside it, PATH-curve.csv.

    Returns the paths. Raises OutputError.
    """
    written = [write_csv(path, scalar_rows(results))]
    for name, columns in curves(results).items():
        table = path.with_name(f"{path.stem}-{name.replace('_', '-')}.csv")
        written.append(write_csv(table, rows_of(columns)))
    return written


def scalar_rows(results):
    """One dict a number: quantity, value, standard_error."""
    for group, key, name in SCALARS:
        holder = results
        for part in group.split("."):
            holder = holder[part]
        error = holder.get("standard_error" if key == "value" else f"{key}_standard_error")
        yield {"quantity": name.format_map(holder), "value": holder[key], "standard_error": error}
    for kind in results.get("species", ()):
        yield {"quantity": f"granular temperature of {kind['name']}"} | kind["granular_temperature"]
        yield {"quantity": f"a2 of {kind['name']}"} | kind["sonine"]["a2"]
    for kind in results.get("species", ())[1:]:
        first = results["species"][0]["name"]
        yield {"quantity": f"temperature of {kind['name']} / {first}"} | kind["temperature_ratio"]
    for pair in results.get("partial_radial_distributions", ()):
        yield {"quantity": f"g at contact, {' and '.join(pair['between'])}"} | pair["contact_value"]


def curves(results):
    """Name -> columns, of every curve that there is; columns of one length in each."""
    found = {name: flat_columns(results[name]) for name in CURVES if results[name]}
    if results["radial_distribution_by_direction"]:
        sheared = results["radial_distribution_by_direction"]
        found["radial_distribution_by_direction"] = {"r": sheared["r"]} | {
            f"g_at_{math.degrees(angle):g}_degrees": g
            for angle, g in zip(sheared["angle"], sheared["g"])}
    for pair in results.get("partial_radial_distributions", ()):
        name = "radial_distribution_" + "_".join(pair["between"])
        found[name] = {key: pair[key] for key in ("x", "g", "standard_error")}
    touching = results["touching"]
    if touching["coordination"] is not None:
        found["touching"] = {key: touching[key] for key in ("neighbours", "share")}
    found |= {name: flat_columns(histogram)
              for name, histogram in (results["collision_distributions"] or {}).items()}
    return split_velocities(found)


def split_velocities(found):
    """The two curves of the velocity distribution as two tables: their lengths differ."""
    both = found.pop("velocity_distribution")
    return found | {f"{kind}_distribution": {key: column for key, column in both.items()
                                             if key.startswith(kind)}
                    for kind in ("component", "speed")}


def flat_columns(curve):
    """The columns of a curve; those of its dicts and of arrays (K, D) by their own names."""
    columns = {}
    for key, value in curve.items():
        if isinstance(value, dict) and key == "by_axis":
            columns |= {f"{key}_{axis}": column for axis, column in value.items()}
        elif isinstance(value, dict) and key.startswith("species_"):
            columns |= {f"{key}_{name}": column for name, column in value.items()}
        elif isinstance(value, np.ndarray) and value.ndim == 3:
            columns |= {f"{key}_{a}{b}": value[:, "xyz".index(a), "xyz".index(b)]
                        for a in "xyz"[:value.shape[1]] for b in "xyz"[:value.shape[2]]}
        elif isinstance(value, np.ndarray) and value.ndim == 2:
            columns |= {f"{key}_{axis}": column for axis, column in zip("xyz", value.T)}
        elif isinstance(value, np.ndarray):
            columns[key] = value
    return columns


def rows_of(columns):
    """Columns as dicts, a row each."""
    return (dict(zip(columns, row)) for row in zip(*columns.values()))


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, list):
        return [_plain(each) for each in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value
