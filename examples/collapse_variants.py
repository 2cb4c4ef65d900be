"""The variants of scan_after_collapse.py: what leads past the collapse of the cold lattice."""

from dataclasses import dataclass, field

import numpy as np

MEAN_SPEED = 0.871       # mean closing speed of the flow at e = 0.6, diameters x shear rate
SHARE = 1 - 0.6**2       # of the kinetic energy along the normal that a collision takes there


def viscoelastic_restitution(speed, constant):
    """e(v) of docs/contact-models.md at a closing speed, both in units of the case."""
    x = np.sqrt(constant * speed**0.2)
    b2 = 1.1534488580952884
    b4 = 0.4 * b2 * b2
    b1 = 4 / (15 * b4)
    return (1 + b1 * x) / (1 + b1 * x + b2 * x**2 + b1 * b2 * x**3 + b4 * x**4)


def share_lost(restitution, mean_speed):
    """Energy lost over energy along the normal before, in collisions of Maxwellian spheres.

    restitution: function of an array of closing speeds, which are distributed as
    v exp(-v^2 / (4 T)) with the mean sqrt(pi T) = mean_speed
    """
    temperature = mean_speed**2 / np.pi
    speed = (np.arange(4000) + 0.5) / 4000 * 14 * np.sqrt(temperature)
    weight = speed**3 * np.exp(-speed**2 / (4 * temperature))
    return float(np.sum(weight * (1 - restitution(speed)**2)) / np.sum(weight))


def viscoelastic_constant(share=SHARE, mean_speed=MEAN_SPEED):
    """The A with which viscoelastic spheres lose that share of the energy along the normal."""
    low, high = 1e-3, 10.0  # the share grows with A
    for _ in range(60):
        middle = np.sqrt(low * high)
        share_there = share_lost(lambda v: viscoelastic_restitution(v, middle), mean_speed)
        low, high = (middle, high) if share_there < share else (low, middle)
    return round(low, 4)


HOT = {"start.arrangement": "random", "start.granular_temperature": 1}
VISCOELASTIC = {"collision.restitution_law": "viscoelastic",
                "collision.viscoelastic_constant": viscoelastic_constant()}
# The share that a fixed loss takes, x exp(-x) with x = loss / T, is largest where x = 1: 0.37, less
# than the 0.64 of e = 0.6. With this loss the flow comes to that, as it settles at T = 0.5.
FIXED_LOSS = {"collision.restitution_law": "fixed-loss", "collision.energy_loss": 0.5}


@dataclass(frozen=True)
class Variant:
    """What it changes in the case, and what it is compared with."""

    name: str
    changes: dict = field(hash=False)
    control: str = "hot start"
    is_same_law: bool = False  # but for a collapse, collisions are those of the constant e = 0.6

    @property
    def label(self):
        """The name with symbols and units, for the figure."""
        kind, _, value = self.name.rpartition(" ")
        if kind == "t_c =":
            return rf"$t_c = 10^{{{value.removeprefix('1e')}}}/\dot\gamma$"
        return f"{self.name} rad" if kind == "rotation" else self.name


VARIANTS = (
    Variant("hot start", HOT, is_same_law=True),
    Variant("rewind", {}, is_same_law=True),
    Variant("rewind, 64 bits", {"collision.precision": "extended"}, is_same_law=True),
    *(Variant(f"t_c = {t}", {"collision.contact_duration": float(t)}, is_same_law=t != "1e-3")
      for t in ("1e-6", "1e-5", "1e-4", "1e-3")),
    *(Variant(f"rotation {a:g}", {"collision.rotation_angle": a}, is_same_law=a < 0.1)
      for a in (1e-3, 1e-2, 1e-1)),
    Variant("immediate", {"collision.overlap": "immediate"}),
    Variant("guarded", {"collision.overlap": "guarded"}),
    Variant("viscoelastic, hot start", {**VISCOELASTIC, **HOT}, "viscoelastic, hot start"),
    Variant("viscoelastic", VISCOELASTIC, "viscoelastic, hot start"),
    Variant("e = 0.8, hot start", {"system.restitution": 0.8, **HOT}, "e = 0.8, hot start"),
    Variant("fixed loss, hot start", {**FIXED_LOSS, **HOT}, "fixed loss, hot start"),
    Variant("fixed loss", FIXED_LOSS, "fixed loss, hot start"),
)
