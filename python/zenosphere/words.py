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


def pairs(run, most=8):
    """The pairs of the arrest as `1-2, 3-4`, at most `most` of them; a dash for none."""
    listed = run.arrest.get("pairs") or []
    text = ", ".join(f"{i}\N{EN DASH}{j}" for i, j in listed[:most])
    rest = f" and {len(listed) - most} more" if len(listed) > most else ""
    return text + rest if listed else "\N{EN DASH}"
