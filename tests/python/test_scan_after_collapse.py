"""What the scan of flows after a collapse computes, without running the program."""

import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES))

import averages as averages_of_runs  # noqa: E402
import collapse_variants as variants  # noqa: E402
import scan_after_collapse as after  # noqa: E402


def averages_until(to_time, value):
    """Averages of a summary from strain 20 on, every number being the same."""
    return {"from_time": 20, "to_time": to_time, "granular_temperature": value, "pressure": value,
            "temperature_diagonal": [value] * 3, "pressure_tensor": [[value] * 3] * 3,
            "collision_rate": value}


def test_blocks_are_what_longer_averages_add():
    # 1 over 40, 2 over 80: the second 40 have 3; 2 over 120: the third have 2.
    stages = [averages_until(60, 1), averages_until(100, 2), averages_until(140, 2)]
    assert after.block_means(stages)["T"] == pytest.approx([1, 3, 2])
    assert after.block_means(stages)["-P_xy"] == pytest.approx([-1, -3, -2])


def test_blocks_have_equal_strain():
    assert after.ends_of(420)[:2] == [20, 60] and after.ends_of(420)[-1] == 420


def test_viscoelastic_law_of_the_scan_is_that_of_the_page():
    # docs/contact-models.md, A v^(1/5) = 0.5
    assert variants.viscoelastic_restitution(32.0, 0.25) == pytest.approx(0.59703, abs=1e-5)


def test_viscoelastic_spheres_are_matched_by_the_share_that_they_lose():
    def law(speed):
        return variants.viscoelastic_restitution(speed, variants.viscoelastic_constant())
    assert variants.share_lost(law, variants.MEAN_SPEED) == pytest.approx(0.64, abs=1e-3)
    assert variants.share_lost(lambda v: 0.6 + 0 * v, variants.MEAN_SPEED) == pytest.approx(0.64)


def test_a_fixed_loss_takes_at_most_one_over_e_of_the_energy():
    def share(loss):  # at T = 1, where the mean speed is sqrt(pi): x exp(-x)
        def law(speed):
            return np.sqrt(np.where(speed**2 > 4 * loss, 1 - 4 * loss / speed**2, 1))
        return variants.share_lost(law, np.sqrt(np.pi))
    assert share(1) == pytest.approx(np.exp(-1), abs=2e-3)
    assert share(0.5) == pytest.approx(0.5 * np.exp(-0.5), abs=2e-3)
    assert share(1) > max(share(0.8), share(1.25))


def test_chance_of_one_mean_is_small_only_for_means_far_apart():
    random = np.random.default_rng(3)
    groups = [random.standard_normal(8) for _ in range(5)]
    assert averages_of_runs.chance_of_one_mean(groups) > 0.05
    groups[2] = groups[2] + 3
    assert averages_of_runs.chance_of_one_mean(groups) < 1e-3


def test_figure_names_variants_with_symbols_and_units():
    labels = {each.name: each.label for each in variants.VARIANTS}
    assert labels["t_c = 1e-6"] == r"$t_c = 10^{-6}/\dot\gamma$"
    assert labels["rotation 0.01"] == "rotation 0.01 rad"
    assert labels["rewind, 64 bits"] == "rewind, 64 bits"


def stored_run(variant, seed, value):
    return {"variant": variant, "spheres": 500, "seed": seed, "until": 420, "verdict": "none",
            "hits": 0, "blocks": {name: [value, value + 2] for name in after.QUANTITIES}}


def test_flow_is_shown_with_its_difference_from_the_control_in_errors():
    variant = next(variant for variant in after.VARIANTS if variant.name == "rewind")
    by_name = {"hot start": [stored_run("hot start", seed, seed) for seed in (1, 2, 3)],
              "rewind": [stored_run("rewind", seed, seed + 1) for seed in (1, 2, 3)]}
    # Means 4 and 3, each with the error 1/sqrt(3), and a variance of 1: 1/16 and 1/9 of their
    # squares, pooled (1/16 + 1/9)/2. The difference is 1/3 of the control.
    spread = averages_of_runs.spread_of_a_run([np.array([2.0, 3, 4]), np.array([3.0, 4, 5])])
    assert spread == pytest.approx(np.sqrt(1 / 18 + 1 / 32))
    line = after.flow(variant, by_name, slice(None), dict.fromkeys(after.QUANTITIES, spread))
    expected = (1 / 3) / (spread * np.sqrt(2 / 3))
    assert line.startswith(f"| rewind | 4.0000(5774) {expected:+.1f} |")


def test_errors_from_blocks_are_those_of_independent_blocks():
    runs = [stored_run("rewind", seed, 1.0) for seed in (1, 2, 3, 4)]
    assert after.block_error(runs, "T") == pytest.approx(np.sqrt(2 / 8))  # variance 2, 8 blocks


def test_a_run_that_the_store_has_is_not_done_again(tmp_path, monkeypatch):
    done = []

    def measured(variant, spheres, seed, until):
        done.append((variant.name, seed))
        return {"variant": variant.name, "spheres": spheres, "seed": seed, "until": until}
    monkeypatch.setattr(after, "measured", measured)
    store = tmp_path / "runs.jsonl"
    first = list(after.runs_of(after.VARIANTS[:2], {500: 420.0}, 1, store))
    again = list(after.runs_of(after.VARIANTS[:2], {500: 420.0}, 2, store))
    assert done == [("hot start", 1), ("rewind", 1), ("hot start", 2), ("rewind", 2)]
    assert again[:2] == first
