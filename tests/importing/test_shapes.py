"""Rotations as wrappers write them."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.importing.shapes import least_turn


@pytest.mark.parametrize("lean", [0.0, 1e-12, 1e-8, 1e-4, 1.0, np.pi - 1e-8, np.pi])
@pytest.mark.parametrize("start", [(1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0)])
def test_the_least_turn_leads_from_one_direction_to_the_other(
    start: tuple[float, float, float], lean: float
) -> None:
    side = np.roll(start, 1)
    end = np.cos(lean) * np.array(start) + np.sin(lean) * side
    turn = least_turn(start, end)
    assert np.allclose(turn @ start, end, atol=1e-8)
    assert np.allclose(turn @ turn.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    assert np.arccos(np.clip((np.trace(turn) - 1) / 2, -1, 1)) == pytest.approx(lean, abs=1e-7)
