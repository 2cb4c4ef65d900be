"""Makes `zenosphere` importable without installation, and runs that need no simulator."""

import importlib.util
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
if importlib.util.find_spec("zenosphere") is None:  # pytest by hand; ctest says where it is
    sys.path[:0] = [str(CHECKOUT / "build" / "python"), str(CHECKOUT / "python")]
sys.path.append(str(CHECKOUT / "tests" / "program"))  # identity.py, processes.py

from synthetic import false_positive, true_collapse, write_run  # noqa: E402


@pytest.fixture
def written(tmp_path):
    """A function that writes a run of given arrays, and returns its path."""
    return lambda name="run.h5", **content: write_run(tmp_path / name, **content)


@pytest.fixture
def e06(tmp_path):
    """A run that meets the criterion for a while, and leaves it."""
    return write_run(tmp_path / "e06.h5", **false_positive(collisions=40000))


@pytest.fixture
def e02(tmp_path):
    """A run that arrests."""
    return write_run(tmp_path / "e02.h5", **true_collapse(collisions=30000))
