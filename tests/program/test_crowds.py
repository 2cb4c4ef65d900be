"""Spheres that crowd together in a box in which there is room for all: their lists stay short, and no pair is lost."""

import json

import numpy as np
import pytest

SIDE = 2000


def start(kind):
    """Places and velocities of 512 spheres, on a cubic lattice."""
    random = np.random.default_rng(1)
    lattice = np.indices((8, 8, 8)).reshape(3, -1).T - 3.5
    noise = random.normal(size=lattice.shape)
    if kind == "far apart, and fly together":
        return lattice * 60 + 1000, -lattice * 0.6 + 0.01 * noise
    return (lattice * 1.3 + {"in one cell": 300, "around a corner of the box": 1e-3}[kind]) % SIDE, noise


@pytest.mark.parametrize("kind", ["in one cell", "around a corner of the box",
                                  "far apart, and fly together"])
def test_no_pair_of_a_crowd_in_a_huge_box_is_lost(program, kind):
    places, velocities = start(kind)
    rows = [f"X {' '.join(repr(float(x)) for x in (*place, *velocity))}"
            for place, velocity in zip(places, velocities)]
    lattice = f'Lattice="{SIDE} 0 0 0 {SIDE} 0 0 0 {SIDE}" Properties=species:S:1:pos:R:3:velo:R:3'
    (program.folder / "crowd.xyz").write_text("\n".join(["512", lattice, *rows, ""]))
    program.case.write_text(
        f"[system]\ndimension = 3\nspheres = 512\nrestitution = 0.9\nsides = [{SIDE}, {SIDE}, {SIDE}]\n"
        '[start]\narrangement = "file"\nfile = "crowd.xyz"\n[drive]\nkind = "none"\n'
        "[run]\ncollisions = 1000\ntime = 120\n")
    done = program("run", program.case.name, "--json", "-o", "out.h5")
    assert json.loads(done.stdout.splitlines()[-1])["collisions"] == 1000
    program("verify", "out.h5")  # no sphere overlaps, and every collision has its way there
