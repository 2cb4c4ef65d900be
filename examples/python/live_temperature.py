#!/usr/bin/python3
"""A live plot of the granular temperature of a sheared gas; without a display, a PNG.

    PYTHONPATH=build/python /usr/bin/python3 examples/python/live_temperature.py [COLLISIONS]

Ctrl-C ends it early. The figure is kept in live_temperature.png.
"""

import os
import sys
from pathlib import Path

import matplotlib

HAS_DISPLAY = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
if not HAS_DISPLAY:
    matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  after the choice of its backend

import zenosphere  # noqa: E402

CASE = Path(__file__).resolve().parents[1] / "shear-e06.toml"


def main(collisions):
    times, temperatures = [], []
    figure, axes = plt.subplots(figsize=(7, 4))
    (line,) = axes.semilogy([], [])
    axes.set(xlabel="strain", ylabel="granular temperature / (diameter x shear rate)$^2$")
    with zenosphere.Run(CASE, overrides={"run.collisions": collisions}) as run:
        try:
            while not run.is_over:
                run.skip(until=run.time + 0.1)
                times.append(run.time)
                temperatures.append(run.state().granular_temperature)
                line.set_data(times, temperatures)
                axes.relim()
                axes.autoscale_view()
                if HAS_DISPLAY:
                    plt.pause(0.001)
        except KeyboardInterrupt:
            print("ended early")
    figure.savefig("live_temperature.png", dpi=120, bbox_inches="tight")
    print(f"{run.collisions} collisions up to strain {run.time:.2f}; granular temperature"
          f" {temperatures[-1]:.4f}; see live_temperature.png")


main(int(sys.argv[1]) if len(sys.argv) > 1 else 300_000)
