"""Collision pieces: each a solid, hollows left free, what is flat given some thickness."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull
from sdgen.importing.convex import MAX_PIECES, MAX_VERTICES, convex_pieces


def pieces(mesh: trimesh.Trimesh) -> list[np.ndarray]:
    return convex_pieces(np.asarray(mesh.vertices, float), np.asarray(mesh.faces))


def holds(piece: np.ndarray, point: tuple[float, float, float]) -> bool:
    planes = ConvexHull(piece).equations
    return bool((planes[:, :3] @ np.array(point) + planes[:, 3] < 1e-9).all())


def test_a_ball_is_one_piece_of_few_corners() -> None:
    (ball,) = pieces(trimesh.creation.icosphere(subdivisions=4, radius=0.05))
    assert len(ball) <= MAX_VERTICES
    assert ConvexHull(ball).volume > 0.75 * 4 / 3 * np.pi * 0.05**3


@pytest.mark.parametrize("turn", [(0, 0, 0), (0.4, 1.1, 0.3)])
def test_a_sheet_gets_a_thickness_whatever_way_it_leans(turn: tuple[float, float, float]) -> None:
    square = trimesh.Trimesh(
        [[0, 0, 0], [0.3, 0, 0], [0.3, 0.2, 0], [0, 0.2, 0]], [[0, 1, 2], [0, 2, 3]], process=False
    )
    square.apply_transform(trimesh.transformations.euler_matrix(*turn))
    (sheet,) = pieces(square)
    assert np.isclose(ConvexHull(sheet.round(4)).volume, 0.3 * 0.2 * 0.002, rtol=0.1)


def test_a_tube_of_loose_panels_stays_hollow() -> None:
    angles = np.linspace(0, 2 * np.pi, 9)
    panels = []
    for a, b in pairwise(angles):
        ring = [
            (0.02 * np.cos(t), 0.02 * np.sin(t), z) for t, z in ((a, 0), (b, 0), (b, 1), (a, 1))
        ]
        panels.append(trimesh.Trimesh(ring, [[0, 1, 2], [0, 2, 3]], process=False))
    found = pieces(trimesh.util.concatenate(panels))
    assert len(found) == 8
    assert all(ConvexHull(piece.round(4)).volume > 0 for piece in found)
    assert not any(holds(piece, (0, 0, 0.5)) for piece in found)


def test_shells_that_do_not_touch_are_taken_one_by_one() -> None:
    grid = [
        trimesh.creation.box(
            (0.02, 0.02, 0.4), trimesh.transformations.translation_matrix((x, y, 0))
        )
        for x in (-0.2, 0, 0.2)
        for y in (-0.2, 0, 0.2)
    ]
    found = pieces(trimesh.util.concatenate(grid))
    assert len(found) == 9 <= MAX_PIECES
    assert not any(holds(piece, (0.1, 0.1, 0)) for piece in found)


def test_many_shells_become_few_pieces() -> None:
    many = [
        trimesh.creation.box(
            (0.02, 0.02, 0.02), trimesh.transformations.translation_matrix((x, y, 0))
        )
        for x in np.linspace(0, 1, 6)
        for y in np.linspace(0, 1, 6)
    ]
    assert 1 <= len(pieces(trimesh.util.concatenate(many))) <= MAX_PIECES
