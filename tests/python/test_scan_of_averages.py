"""The scripts of examples/ about averages: onset of streaks, a2 of cooling spheres."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
sys.path.append(str(EXAMPLES))

import scan_cooling_a2 as cooling  # noqa: E402
import scan_streaks as streaks  # noqa: E402

SPHERES, ALONG = 4000, 0.3
STRAIN = np.arange(1.0, 151.0)


def waves(energies):
    """Amplitudes of four waves of which the third has these energies over the thermal one."""
    modes = np.full((len(STRAIN), 4), np.sqrt(4 * ALONG / SPHERES))
    modes[:, 2] *= np.sqrt(energies)
    return modes


def onset(energies):
    return streaks.onset(STRAIN, waves(energies), np.full(len(STRAIN), ALONG), SPHERES)


# The third wave carries (energy - 1) 2/N of T_xx: 2.5 % from 51 on; averages over strain 10.
def test_streak_sets_in_in_the_middle_of_the_first_strain_of_ten_that_has_it():
    assert onset(np.where(STRAIN > 40, 60.0, 1.0)) == 44  # 9 intervals of 60, one of 1: 54.1
    assert onset(np.where(STRAIN > 40, 52.0, 1.0)) == 45


def test_waves_below_the_limits_are_no_streak():
    assert math.isnan(onset(np.full(len(STRAIN), 50.0)))
    # Short of ten strains: its average is (5 x 95 + 5)/10 = 48.
    assert math.isnan(onset(np.where((STRAIN > 40) & (STRAIN <= 45), 95.0, 1.0)))


# The theory to first order is near a direct simulation for e > 0.6 (Montanero & Santos, Granular
# Matter 2 (2000) 53). A mean over two gases at one time is good to 0.73 / sqrt(80 000) = 0.0026;
# over seven times, about independent, to 0.001: tolerances of five of these.
def test_gas_without_correlations_has_the_sonine_coefficient_of_theory():
    a2, temperature = cooling.molecular_chaos(0.9, spheres=40_000, gases=2)
    assert a2[:, cooling.STEADY:].mean() == pytest.approx(cooling.theory(0.9), abs=0.005)
    assert a2[:, 0].mean() == pytest.approx(0, abs=0.013)
    # dT/T = -(1 - e^2)/3 a collision of each sphere, (1 + a2/4) of it; 1 % for steps and chance
    found = cooling.summed_up(0.9, (a2, temperature))
    assert found["speed"][0] == pytest.approx(1 + cooling.theory(0.9) / 4, abs=0.01)
