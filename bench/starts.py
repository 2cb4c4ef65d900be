"""Files that describe a state to the programs that read one."""

import subprocess

import h5py

from programs import BenchError

CASE = """\
[system]
dimension = {dimension}
spheres = {spheres}
restitution = {restitution!r}
solids_volume_fraction = {fraction!r}

[start]
arrangement = "{start}"
granular_temperature = 1.0
seed = 1

[drive]
{drive}

[run]
collisions = 0
"""


def write_case(state, folder):
    """The state as a case of Zenosphere; returns its path."""
    drive = f'kind = "shear"\nshear_rate = {state.shear_rate!r}' if state.shear_rate else (
        'kind = "none"')
    path = folder / "case.toml"
    path.write_text(CASE.format(drive=drive, **vars(state)))
    return path


def write_sph(positions, side, path):
    """Positions of unit spheres in a cube as EDMD reads them: count, box, type x y z radius."""
    lines = [str(len(positions)), f"{side!r} {side!r} {side!r}"]
    lines += [f"a {x:.17g} {y:.17g} {z:.17g} 0.5" for x, y, z in positions.tolist()]
    path.write_text("\n".join(lines) + "\n")


def write_random_start(state, case, zenosphere, path):
    """The places that `zenosphere` makes for a random start, for programs that read them."""
    made = path.with_suffix(".h5")
    done = subprocess.run([zenosphere, "run", case, "-o", made, "--quiet"], capture_output=True,
                          text=True)
    if done.returncode != 0:
        raise BenchError(f"{zenosphere}: {done.stderr.strip()}")
    with h5py.File(made) as file:
        positions = file["particles/spheres/position/value"][0]
        side = float(file["particles/spheres/box/edges/value"][0, 0, 0])
    write_sph(positions, side, path)


def files_for(state, folder, programs, zenosphere):
    """Values of the placeholders {case} and {start_file} for a state.

    Every program starts from the same places: a lattice, which each makes itself, or random ones.
    {start_file} is empty for a lattice, and where no program asks for it.
    """
    files = {"case": str(write_case(state, folder)), "start_file": ""}
    if state.start == "random" and any("{start_file}" in program.command for program in programs):
        path = folder / "start.sph"
        write_random_start(state, files["case"], zenosphere, path)
        files["start_file"] = str(path)
    return files
