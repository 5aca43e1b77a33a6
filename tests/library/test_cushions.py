"""Pieces under padded supports follow the drawn dome (``assets/blender/cushions.py``)."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.geometry import Array

from tests.by_path import module_at
from tests.library.test_carried import crossings, triangles_of

cushions = module_at("assets/blender/cushions.py")
#: The top of a cushion, seen from above (half its sides), and how high its dome is, metres.
HALF, HIGH, CROWN = (0.3, 0.25), 0.4, 0.02


def dome(x: Array, y: Array) -> Array:
    inset = np.minimum(HALF[0] - np.abs(x), HALF[1] - np.abs(y)) / min(HALF)
    return np.asarray(HIGH + CROWN * (1 - (1 - np.clip(inset, 0, 1)) ** 2))


def drawn() -> Array:
    """The dome as triangles (N, 3, 3)."""
    xs, ys = (np.linspace(-a, a, 31) for a in HALF)
    grid = np.stack(np.meshgrid(xs, ys, indexing="ij"), axis=-1)
    points = np.concatenate([grid, dome(grid[..., 0], grid[..., 1])[..., None]], axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return np.concatenate([np.stack(t, axis=2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])


@pytest.fixture(scope="module")
def seat() -> dict[str, object]:
    x, y = HALF[0] - 0.02, HALF[1] - 0.02
    ring = [[-x, -y], [x, -y], [x, y], [-x, y]]
    whole = {"name": "seat", "z_m": HIGH + CROWN - 0.004, "polygon_m": ring}
    (laid,) = cushions.laid(drawn(), whole)
    return dict(laid)


def test_a_support_lies_near_what_is_drawn(seat: dict[str, object]) -> None:
    ring = np.array(seat["polygon_m"])
    (x0, y0), (x1, y1) = ring.min(axis=0), ring.max(axis=0)
    x, y = np.meshgrid(np.linspace(x0, x1, 40), np.linspace(y0, y1, 40))
    off = dome(x, y) - np.array(seat["z_m"])
    assert off.max() <= 0.0035
    assert off.min() >= -0.0095
    assert laid_again(seat) == seat


def laid_again(seat: dict[str, object]) -> dict[str, object]:
    return dict(cushions.laid(drawn(), seat)[0])


def test_its_piece_is_level_in_the_middle_and_falls_with_the_dome(seat: dict[str, object]) -> None:
    z_m = float(np.array(seat["z_m"]))
    corners = [(x, y, z) for x in (-0.29, 0.29) for y in (-0.24, 0.24) for z in (0.3, z_m)]
    (piece,) = cushions.capped(drawn(), np.array(corners), [seat])
    xs, ys = np.linspace(-0.2, 0.2, 21), np.linspace(-0.2, 0.2, 21)
    ray, heights = crossings(triangles_of(piece), xs + 1e-5, ys + 1e-5)
    top = np.full(len(xs) * len(ys), -np.inf)
    np.maximum.at(top, ray, heights)
    x, y = (a.ravel() for a in np.meshgrid(xs, ys, indexing="ij"))
    assert top.max() == pytest.approx(z_m)
    assert (top > z_m - 1e-6).mean() > 0.2
    off = dome(x, y) - top
    assert off.max() < 0.004, "things sink in"
    assert off.min() > -0.006, "things hang"
    box_of = cushions.capped(drawn(), np.array(corners) - (0, 0, 0.2), [seat])
    assert [len(piece) for piece in box_of] == [8], "one far below stays as it is"
