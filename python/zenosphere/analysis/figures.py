"""One figure for each result of an analysis."""

import numpy as np
from matplotlib.figure import Figure

from ..drawing.pictures import COLOURS, HEIGHT, INK, MARK_COLOUR, WIDTH, made_folder

SPEED = "in units of $\\sqrt{T}$"


def draw_analysis(results, folder, name, pictures):
    """Draws every result that there is, files named after the run.

    results: of `analyse`;  folder: Path, made where missing;  name: of the run
    pictures: Pictures
    Returns the paths written. Raises InputError, OutputError.
    """
    made_folder(folder, option="--figures")
    written = []
    for figure, draw in FIGURES.items():
        with pictures.style():
            page = Figure(figsize=pictures.inches(WIDTH, HEIGHT), layout="constrained")
            if draw(page.add_subplot(), results):
                written += pictures.write(page, folder / f"{name}-{figure}")
    return written


def radial_distribution(axes, results):
    """g(r), its value at contact, and where places are independent."""
    curve, contact = results["radial_distribution"], results["contact_value"]
    if not curve["r"].size:
        return False
    _band(axes, curve["r"], curve["g"], curve["standard_error"])
    if contact["value"] is not None:
        axes.errorbar([1], contact["value"], yerr=contact["standard_error"], fmt="o",
                      color=COLOURS[1], markersize=4, label=f"contact: {_told(contact)}")
        axes.legend()
    axes.axhline(1, color="0.7", linewidth=0.6, zorder=0)
    axes.set(xlabel="Distance $r$ (diameters)", ylabel="Radial distribution $g(r)$",
             ylim=(0, None))
    return True


def partial_distributions(axes, results):
    """g_ab of each two kinds of a mixture, and their values at contact."""
    pairs = [pair for pair in results.get("partial_radial_distributions", ()) if pair["x"].size]
    for number, pair in enumerate(pairs):
        colour = COLOURS[number % len(COLOURS)]
        axes.plot(pair["x"], pair["g"], linewidth=1, color=colour,
                  label="–".join(pair["between"]))
        if pair["contact_value"]["value"] is not None:
            axes.plot([1], pair["contact_value"]["value"], "o", color=colour, markersize=4)
    if not pairs:
        return False
    axes.axhline(1, color="0.7", linewidth=0.6, zorder=0)
    axes.set(xlabel="Distance over the mean diameter of the two",
             ylabel="Radial distribution $g_{ab}$", ylim=(0, None))
    axes.legend()
    return True


def by_direction(axes, results):
    """g(r) along two directions; inset, g near contact against the direction."""
    curve = results["radial_distribution_by_direction"]
    if not curve:
        return False
    angle, sectors = curve["angle"], len(curve["angle"])
    for place, name in ((sectors // 4, "extension"), (3 * sectors // 4, "compression")):
        pair = curve["g"][[place - 1, place]].mean(axis=0)
        middle = np.degrees((angle[place - 1] + angle[place]) / 2)
        axes.plot(curve["r"], pair, linewidth=1, label=f"{name}, {middle:.0f}°")
    axes.axhline(1, color="0.7", linewidth=0.6, zorder=0)
    axes.set(xlabel="Distance $r$ (diameters)", ylabel=r"$g(r, \theta)$", ylim=(0, None))
    axes.legend(loc="upper right", bbox_to_anchor=(1, 0.45), title=r"$\theta$ from the flow",
                title_fontsize="small")
    inset = axes.inset_axes((0.5, 0.58, 0.46, 0.38))
    inset.step(np.degrees(angle), curve["g"][:, 0], where="mid", color=INK, linewidth=1)
    inset.set(xlim=(0, 180), xticks=(0, 45, 90, 135, 180), xlabel=r"$\theta$ (degrees)",
              ylabel=f"$g$ at {curve['r'][0]:g}")
    inset.tick_params(labelsize="small")
    return True


def structure_factor(axes, results):
    """S(k) and its limit."""
    curve = results["structure_factor"]
    if not curve["k"].size:
        return False
    _band(axes, curve["k"], curve["s"], curve["standard_error"])
    limit = curve["at_zero"]
    if limit["value"] is not None:
        axes.errorbar([0], limit["value"], yerr=limit["standard_error"], fmt="o", color=COLOURS[1],
                      markersize=4, label=f"limit: {_told(limit)}", clip_on=False, zorder=3)
        axes.legend()
    axes.axhline(1, color="0.7", linewidth=0.6, zorder=0)
    axes.set(xlabel="Wave number $k$ (1/diameter)", ylabel="Structure factor $S(k)$",
             xlim=(0, None), ylim=(0, None))
    return True


def velocities(axes, results):
    """Distribution of one velocity component, to its tails, with a Maxwellian."""
    curve = results["velocity_distribution"]
    held = np.flatnonzero(curve["component_density"])
    if not held.size:
        return False
    axes.semilogy(curve["component"][held], curve["component_density"][held], "o", markersize=2.5,
                  color=MARK_COLOUR, label="snapshots")
    span = slice(held[0], held[-1] + 1)
    axes.semilogy(curve["component"][span], curve["component_maxwell"][span], color=INK,
                  linewidth=0.9, label="Maxwell")
    axes.set(xlabel=f"Peculiar velocity component, {SPEED}", ylabel="Probability density",
             ylim=(curve["component_density"][held].min() / 3, None))
    axes.legend(title=f"$a_2 = {results['sonine']['a2']:.4f}$", title_fontsize="small")
    return True


def profiles(axes, results):
    """Solids fraction and temperature, over their means, and the velocity beside them."""
    curve = results["profiles"]
    if len(curve["y"]) < 3:
        return False
    for name, label, style in (("solids_volume_fraction", "solids fraction", "-"),
                               ("granular_temperature", "granular temperature", "--")):
        mean = np.nanmean(curve[name])
        if mean > 0:
            axes.plot(curve["y"], curve[name] / mean, style, linewidth=1,
                      label=f"{label} / {mean:.3g}")
    axes.set(xlabel=f"Place ${curve['axis']}$ (diameters)", ylabel="Relative to the mean",
             ylim=(0, 1.1 * axes.dataLim.y1 if axes.get_lines() else 1))
    right = axes.twinx()
    right.plot(curve["y"], curve["velocity"], ":", color=COLOURS[2], linewidth=1.2,
               label="velocity $u_x$ (right)")
    right.set_ylabel("Velocity $u_x$ (diameters/time)")
    lines = axes.get_lines() + right.get_lines()
    axes.legend(lines, [line.get_label() for line in lines], loc="lower left", ncols=3,
                bbox_to_anchor=(0, 1), borderaxespad=0.2, columnspacing=1.2)
    return True


def mean_square_displacement(axes, results):
    """Displacement squared along each axis, and the slope of the diffusion found."""
    curve = results["mean_square_displacement"]
    if not curve:
        return False
    time = curve["time"][1:]
    for axis, column in curve["by_axis"].items():
        if np.isfinite(column).all() and (column[1:] > 0).any():
            axes.loglog(time, column[1:], linewidth=1, label=f"along {axis}")
    diffusion = results["diffusion"]
    if diffusion["value"] is not None:
        late = slice(len(time) // 2, None)
        known = [each for each in curve["by_axis"].values() if np.isfinite(each).all()]
        fitted = known[-1][-1] + 2 * diffusion["value"] * (time[late] - time[-1])
        axes.loglog(time[late], fitted, "--", color=INK, linewidth=1.1,
                    label=f"slope $2 D$, $D$ = {_told(diffusion)}")
    if not axes.get_lines():
        return False
    axes.set(xlabel="Time (time unit of the case)",
             ylabel="Mean-square displacement (diameters$^2$)")
    axes.legend()
    return True


def velocity_autocorrelation(axes, results):
    """Correlation of a sphere's velocity with its own earlier one."""
    curve = results["velocity_autocorrelation"]
    if not curve or not np.isfinite(curve["value"]).all():
        return False
    _band(axes, curve["time"], curve["value"], curve["standard_error"])
    axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
    axes.set(xlabel="Time (time unit of the case)", ylabel="Velocity autocorrelation",
             xlim=(0, None))
    return True


def touching(axes, results):
    """Share of spheres with each number of touching neighbours."""
    curve = results["touching"]
    if len(curve["share"]) < 2:
        return False
    axes.bar(curve["neighbours"], curve["share"], color=MARK_COLOUR, width=0.7)
    axes.set(xlabel=f"Neighbours within a gap of {curve['gap']:g} diameters",
             ylabel="Share of spheres", yscale="log", xticks=curve["neighbours"])
    return True


def _histogram(name, label):
    def draw(axes, results):
        curve = (results["collision_distributions"] or {}).get(name)
        if not curve or not curve["value"].size:
            return False
        share = curve["value"] * curve["density"]
        axes.step(curve["value"], share, where="mid", color=INK, linewidth=1)
        axes.axvline(curve["mean"], color=COLOURS[1], linewidth=0.9, linestyle="--",
                     label=f"mean {curve['mean']:.4g}")
        axes.set(xscale="log", yscale="log", xlabel=label,
                 ylabel="Density in the logarithm", ylim=(share[share > 0].min() / 2, None))
        axes.legend()
        return True
    return draw


def impact_angle(axes, results):
    """Angle between relative velocity and line of centres, beside that of molecular chaos."""
    curve = (results["collision_distributions"] or {}).get("impact_angle")
    if not curve or results["dimension"] == 1:
        return False
    angle = curve["value"]
    chaos = np.sin(2 * angle) if results["dimension"] == 3 else np.cos(angle)
    axes.step(np.degrees(angle), curve["density"], where="mid", color=MARK_COLOUR, linewidth=1)
    axes.plot(np.degrees(angle), chaos, color=INK, linewidth=0.9, label="molecular chaos")
    axes.set(xlabel="Impact angle (degrees; 0 is head-on)", ylabel="Density (1/radian)",
             xlim=(0, 90), xticks=(0, 30, 60, 90), ylim=(0, None))
    axes.legend()
    return True


def stress(axes, results):
    """Diagonal of the pressure tensor and dissipation in each layer, over their means."""
    curve = results["profiles"]
    if "pressure_tensor" not in curve or len(curve["y"]) < 3:
        return False
    for number, axis in enumerate("xyz"[:results["dimension"]]):
        axes.plot(curve["y"], curve["pressure_tensor"][:, number, number], linewidth=1,
                  label=f"$P_{{{axis}{axis}}}$")
    if results["dimension"] > 1:
        axes.plot(curve["y"], curve["pressure_tensor"][:, 0, 1], linewidth=1, label="$P_{xy}$")
    axes.plot(curve["y"], curve["dissipation"], "--", color=INK, linewidth=1, label="dissipation")
    axes.set(xlabel=f"Place ${curve['axis']}$ (diameters)",
             ylabel="Stress, dissipation (units of the case)")
    axes.legend()
    return True


FIGURES = {
    "radial-distribution": radial_distribution,
    "partial-radial-distributions": partial_distributions,
    "radial-distribution-by-direction": by_direction,
    "structure-factor": structure_factor,
    "velocity-distribution": velocities,
    "profiles": profiles,
    "mean-square-displacement": mean_square_displacement,
    "velocity-autocorrelation": velocity_autocorrelation,
    "touching": touching,
    "gap": _histogram("gap", "Gap of the next pair (diameters)"),
    "flight-time": _histogram("flight_time", "Flight time (time unit of the case)"),
    "impact-angle": impact_angle,
    "stress-profile": stress,
    "normal-speed": _histogram("normal_speed", "Normal speed at contact (diameters/time unit)"),
}


def _band(axes, x, y, error):
    axes.plot(x, y, color=MARK_COLOUR, linewidth=1)
    known = np.isfinite(error)
    if known.any():
        axes.fill_between(x[known], (y - 2 * error)[known], (y + 2 * error)[known], linewidth=0,
                          color=MARK_COLOUR, alpha=0.25)


def _told(number):
    error = number["standard_error"]
    return f"{number['value']:.4g}" + ("" if error is None else f" ± {error:.1g}")
