"""Collision pieces reach as far as what is drawn, and fill nothing that is open."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from sdgen.geometry import box_corners
from sdgen.library import Library
from sdgen.library.meshes import Hull, MeshData
from sdgen.library.reaching import OWN_PIECE_M, STANDS_OUT_M, reaching_meshes
from sdgen.library.records import Asset, Support
from sdgen.library.shape import corners_of, outside_share, surface_points

from tests.shipped import shipped_library

BOARD = Hull("body", np.array(box_corners((-0.1, -0.1, 0.0), (0.1, 0.1, 0.02))))


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


@pytest.fixture(scope="module")
def plain(library: Library) -> Asset:
    """A model of one part that nothing stands on."""
    found = (a for a in library.by_category("apple") if not a.supports)
    return next(found).model_copy(update={"containers": (), "supports": ()})


def mesh(*boxes: tuple[tuple[float, float, float], tuple[float, float, float]]) -> MeshData:
    """Boxes from corner to corner."""
    made = trimesh.util.concatenate([trimesh.creation.box(bounds=np.array(box)) for box in boxes])
    count = len(made.vertices)
    return MeshData(made.vertices, np.zeros((count, 3)), np.zeros((count, 2)), made.faces)


def reach(pieces: tuple[Hull, ...]) -> float:
    return max(float(piece.vertices_m[:, 0].max()) for piece in pieces)


def test_a_piece_is_drawn_out_to_what_stands_a_little_out_of_it(plain: Asset) -> None:
    drawn = mesh(((-0.1, -0.1, 0), (0.108, 0.1, 0.02)))
    found = reaching_meshes([BOARD], {"body": drawn}, plain)
    assert len(found) == 1
    assert reach(found) == pytest.approx(0.108)
    assert {tuple(p) for p in BOARD.vertices_m} <= {tuple(p) for p in found[0].vertices_m}


def test_what_stands_far_out_is_a_piece_of_its_own_and_fills_nothing_between(plain: Asset) -> None:
    post = ((0.05, -0.01, 0.0), (0.07, 0.01, 0.2))
    drawn = mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.02)), post)
    board, found = reaching_meshes([BOARD], {"body": drawn}, plain)
    assert np.array_equal(board.vertices_m, BOARD.vertices_m)
    assert found.vertices_m.max(axis=0) == pytest.approx(post[1])
    assert found.vertices_m.min(axis=0) == pytest.approx(post[0])


def test_what_is_close_enough_complete_or_stood_on_stays_as_it_is(plain: Asset) -> None:
    near = mesh(((-0.1, -0.1, 0), (0.1 + STANDS_OUT_M / 2, 0.1, 0.02)))
    assert reaching_meshes([BOARD], {"body": near}, plain) == (BOARD,)
    far = {"body": mesh(((-0.1, -0.1, 0), (0.1 + 2 * OWN_PIECE_M, 0.1, 0.02)))}
    complete = Hull("body", BOARD.vertices_m, complete=True)
    assert reaching_meshes([complete], far, plain) == (complete,)
    assert reaching_meshes([BOARD], far, tray(plain, 0.5)) == (BOARD,)
    assert reach(reaching_meshes([BOARD], far, plain)) > 0.12


def tray(plain: Asset, z_m: float) -> Asset:
    ring = ((-0.09, -0.09), (0.09, -0.09), (0.09, 0.09), (-0.09, 0.09))
    support = Support(name="top", part="body", z_m=z_m, polygon_m=ring)
    return plain.model_copy(update={"supports": (support,)})


def test_a_piece_just_below_a_support_is_raised_to_it(plain: Asset) -> None:
    drawn = {"body": mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.026)))}
    (raised,) = reaching_meshes([BOARD], drawn, tray(plain, 0.026))
    assert sorted(set(raised.vertices_m[:, 2].tolist())) == [0.0, 0.026]
    for z_m in (0.02, 0.004, 0.07):
        assert reaching_meshes([BOARD], drawn, tray(plain, z_m)) == (BOARD,)


def test_a_piece_all_over_a_support_is_lowered_to_it(plain: Asset) -> None:
    drawn = {"body": mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.014)))}
    (lowered,) = reaching_meshes([BOARD], drawn, tray(plain, 0.014))
    assert sorted(set(lowered.vertices_m[:, 2].tolist())) == [0.0, 0.014]
    rim = Hull("body", np.array(box_corners((-0.1, -0.1, 0.0), (-0.06, 0.1, 0.02))))
    assert reaching_meshes([rim], drawn, tray(plain, 0.014)) == (rim,)


def test_a_piece_that_carries_one_support_is_not_raised_to_the_next(plain: Asset) -> None:
    """Compartments stand on the top of a desk: their floor is 14 mm higher."""
    drawn = {"body": mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.034)))}
    top = tray(plain, 0.02).supports[0]
    floor = top.model_copy(update={"name": "floor", "z_m": 0.034})
    asset = plain.model_copy(update={"supports": (floor, top)})
    assert reaching_meshes([BOARD], drawn, asset) == (BOARD,)


def test_a_cushion_on_a_piece_gets_a_piece_of_its_own(plain: Asset) -> None:
    drawn = {"body": mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.05)))}
    board, cushion = reaching_meshes([BOARD], drawn, tray(plain, 0.05))
    assert np.array_equal(board.vertices_m, BOARD.vertices_m)
    low, high = cushion.vertices_m.min(axis=0), cushion.vertices_m.max(axis=0)
    assert (low, high) == (pytest.approx((-0.09, -0.09, 0.02)), pytest.approx((0.09, 0.09, 0.05)))


def test_of_what_is_stood_on_the_feet_are_reached_for(plain: Asset) -> None:
    foot, rim = ((-0.05, -0.05, -0.01), (0.05, 0.05, 0.0)), ((0.08, -0.1, 0.0), (0.1, 0.1, 0.03))
    drawn = {"body": mesh(((-0.1, -0.1, 0), (0.1, 0.1, 0.02)), foot, rim)}
    (found,) = reaching_meshes([BOARD], drawn, tray(plain, 0.02))
    assert found.vertices_m[:, 2].min() == pytest.approx(-0.01)
    assert found.vertices_m[:, 2].max() == pytest.approx(0.02)


def test_pieces_reach_the_supports_of_shipped_furniture(library: Library) -> None:
    for asset in (*library.by_category("freezer"), *library.by_category("bed")):
        tops = {round(float(h.vertices_m[:, 2].max()), 4) for h in library.hulls(asset.id)}
        short = [s.z_m for s in asset.supports if any(0.001 < s.z_m - top < 0.01 for top in tops)]
        assert not [z for z in short if z not in tops], asset.id


@pytest.mark.parametrize("category", ["apple", "orange", "cutting_board", "keyboard", "handbag"])
def test_shipped_models_do_not_stand_out_of_their_pieces(library: Library, category: str) -> None:
    for asset in library.by_category(category):
        if asset.supports or asset.containers or any(h.complete for h in library.hulls(asset.id)):
            continue
        parts = asset.variants["default"]
        pieces = [h.vertices_m for h in library.hulls(asset.id) if h.part in parts]
        drawn = corners_of([library.mesh(asset.id)[part] for part in parts])
        points, _ = surface_points(drawn, 300)
        assert outside_share(points, pieces, 0.006) < 0.1, asset.id
