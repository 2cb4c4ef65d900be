"""How numbers of a run are written, in figures and reports alike."""

SPACE = "\N{NO-BREAK SPACE}"


def grouped(number):
    """12345678 as 12 345 678 (no-break spaces)."""
    return f"{number:,}".replace(",", SPACE)


def short(number, digits=4):
    """A real number in at most `digits` significant digits; a dash for None, text as it is."""
    if number is None:
        return "\N{EN DASH}"
    return f"{number:.{digits}g}" if isinstance(number, (int, float)) else str(number)


def per_sphere(run, collision):
    """Collisions per sphere done at a collision number: each collision counts for two spheres."""
    return 2 * collision / run.spheres


def pair(run, first, second):
    """`17-2305`, or `0-lower wall`: the walls come behind the spheres."""
    walls = {run.spheres: "lower wall", run.spheres + 1: "upper wall"}
    return f"{first}\N{EN DASH}{walls.get(int(second), second)}"


def pairs(run, most=8):
    """The pairs of the arrest as `1-2, 3-4`, at most `most` of them; a dash for none."""
    listed = run.arrest.get("pairs") or []
    text = ", ".join(pair(run, i, j) for i, j in listed[:most])
    rest = f" and {len(listed) - most} more" if len(listed) > most else ""
    return text + rest if listed else "\N{EN DASH}"


def restitutions(run):
    """What the run's collisions keep of their speed, as mathtext: of the spheres, of the walls."""
    parts, walls = [], run.setting("walls", "restitution")
    law = run.setting("collision", "restitution_law")
    if law == "fixed-loss":
        parts.append(f"$e(v)$, loss {short(run.setting('collision', 'energy_loss'))}")
    elif law == "two-valued":
        slow, fast, speed = (short(run.setting("collision", key)) for key in
                             ("slow_restitution", "fast_restitution", "threshold_speed"))
        parts.append(f"$e = {slow}$ below the speed {speed}, else {fast}")
    elif law == "viscoelastic":
        parts.append(f"$e(v)$, $A = {short(run.setting('collision', 'viscoelastic_constant'))}$")
    elif law not in (None, "constant"):
        parts.append(f"$e(v)$, {law}")
    elif run.setting("system", "restitution") is not None and run.spheres > 1:
        parts.append(f"$e = {short(run.setting('system', 'restitution'))}$")
    if walls is not None:
        parts.append(rf"$e_\mathrm{{wall}} = {short(walls)}$")
    return parts
