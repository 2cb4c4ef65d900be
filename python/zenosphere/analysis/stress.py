"""Shear viscosity and normal stress differences, from the averages of the file."""

import numpy as np


def stresses(summary, shear_rate):
    """shear_viscosity and normal_stress_differences (over the pressure); null without shear.

    viscosity = -P_xy / shear_rate, n1 = (P_xx - P_yy) / p, n2 = (P_yy - P_zz) / p, where P is the
    pressure tensor. Errors are those of the file, null where it has none; those of differences in a
    file of version 1.0, which has none for them, as if their two parts were independent.
    Source: Alam & Luding, Phys. Fluids 15 (2003) 2298.
    """
    averages = summary.get("averages") or {}
    tensor, pressure = averages.get("pressure_tensor"), averages.get("pressure")
    known = averages.get("standard_error") or {}
    errors, own = known.get("pressure_tensor"), known.get("normal_stress_differences")
    viscosity = {"value": None, "standard_error": None}
    differences = dict.fromkeys(("n1", "n2", "n1_standard_error", "n2_standard_error"))
    if not shear_rate or not pressure or tensor is None or tensor[0][1] is None:
        return {"shear_viscosity": viscosity, "normal_stress_differences": differences}
    viscosity["value"] = -(tensor[0][1] + tensor[1][0]) / (2 * shear_rate)
    if errors and errors[0][1] is not None:
        viscosity["standard_error"] = errors[0][1] / shear_rate
    for name, first in (("n1", 0), ("n2", 1)):
        if first + 1 == len(tensor):
            continue
        differences[name] = (tensor[first][first] - tensor[first + 1][first + 1]) / pressure
        if own:
            differences[f"{name}_standard_error"] = own[first]
        elif errors and errors[first][first] is not None:
            differences[f"{name}_standard_error"] = float(np.hypot(
                errors[first][first], errors[first + 1][first + 1]) / pressure)
    return {"shear_viscosity": viscosity, "normal_stress_differences": differences}
