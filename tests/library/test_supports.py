"""Where things can stand, found on meshes."""

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.library.meshes import MeshData
from sdgen.library.records import Support
from sdgen.library.shape import corners_of
from sdgen.library.supports import carried_share, find_supports, headroom_m
from shapely import union_all
from shapely.geometry import Polygon, box

from tests.shipped import shipped_library

length = st.floats(0.1, 2.0)


def mesh_of(*bounds: tuple[tuple[float, float, float], tuple[float, float, float]]) -> MeshData:
    boxes = [trimesh.creation.box(bounds=b) for b in bounds]
    whole = trimesh.util.concatenate(boxes)
    count = len(whole.vertices)
    return MeshData(
        np.asarray(whole.vertices, dtype=np.float64),
        np.zeros((count, 3)),
        np.zeros((count, 2)),
        np.asarray(whole.faces, dtype=np.int64),
    )


@settings(max_examples=40, deadline=None)
@given(length, length, length)
def test_a_box_carries_on_its_top(x: float, y: float, z: float) -> None:
    (top,) = find_supports({"body": mesh_of(((0, 0, 0), (x, y, z)))})
    assert top.z_m == pytest.approx(z, abs=1e-4)
    assert top.headroom_m is None
    assert Polygon(top.polygon_m).equals_exact(box(0.01, 0.01, x - 0.01, y - 0.01), 0.02) or (
        Polygon(top.polygon_m).area == pytest.approx((x - 0.02) * (y - 0.02), rel=0.02)
    )


@settings(max_examples=30, deadline=None)
@given(st.floats(0.1, 1.0), st.floats(0.06, 1.0))
def test_the_headroom_of_a_shelf_reaches_to_the_board_above(low: float, gap: float) -> None:
    board = 0.02
    shelf = mesh_of(
        ((0, 0, low - board), (1, 0.4, low)), ((0, 0, low + gap), (1, 0.4, low + gap + board))
    )
    lower, upper = find_supports({"body": shelf})
    assert lower.z_m == pytest.approx(low, abs=1e-4)
    assert lower.headroom_m == pytest.approx(gap, abs=1e-4)
    assert upper.headroom_m is None
    assert [lower.name, upper.name] == ["surface_1", "surface_2"]


def test_slopes_slivers_and_low_gaps_carry_nothing() -> None:
    slope = np.array([[(0, 0, 0), (1, 0, 0.5), (1, 1, 0.5)], [(0, 0, 0), (1, 1, 0.5), (0, 1, 0)]])
    vertices = slope.reshape(-1, 3).astype(float)
    ramp = MeshData(vertices, vertices * 0, vertices[:, :2] * 0, np.arange(6).reshape(2, 3))
    assert find_supports({"body": ramp}) == ()
    assert find_supports({"body": mesh_of(((0, 0, 0), (1, 0.03, 1)))}) == ()
    gap = mesh_of(((0, 0, 0), (1, 1, 0.1)), ((0, 0, 0.13), (1, 1, 0.2)))
    assert [s.z_m for s in find_supports({"body": gap})] == [pytest.approx(0.2)]


def test_headroom_and_carrying_of_a_given_polygon() -> None:
    table = corners_of([mesh_of(((0, 0, 0.7), (1, 1, 0.74)), ((0, 0, 1.5), (1, 1, 1.6)))])
    assert headroom_m(table, box(0.1, 0.1, 0.9, 0.9), 0.74) == pytest.approx(0.76)
    assert headroom_m(table, box(0.1, 0.1, 0.9, 0.9), 1.6) is None
    assert carried_share(table, box(0.1, 0.1, 0.9, 0.9), 0.74) == 1.0
    assert carried_share(table, box(0.5, 0.1, 1.5, 0.9), 0.74) == pytest.approx(0.5, abs=0.1)
    assert carried_share(table, box(0.1, 0.1, 0.9, 0.9), 0.9) == 0.0


@pytest.mark.parametrize("category", ["bookshelf", "fridge", "dining_table", "tv_stand"])
def test_what_our_models_say_is_found_on_their_meshes(category: str) -> None:
    library = shipped_library()
    for asset in library.by_category(category):
        meshes = library.mesh(asset.id)
        found = find_supports({part: meshes[part] for part in asset.variants["default"]})
        for support in asset.supports:
            polygon = Polygon(support.polygon_m)
            level = [
                Polygon(other.polygon_m).buffer(0.011, join_style="mitre")
                for other in found
                if abs(other.z_m - support.z_m) < 0.015
            ]
            # (a top of planks is found as planks)
            share = union_all(level).intersection(polygon).area / polygon.area
            assert share > 0.5, f"{asset.id}: {support.name}"


def test_supports_are_the_same_whatever_was_asked_of_them() -> None:
    one, two = _square(), _square()
    assert one.area_m2 > 0
    assert len(one.edge_m) == len(two.edge_m) == 4
    assert one == two
    assert hash(one) == hash(two)
    assert one != two.model_copy(update={"z_m": 0.5})
    assert one != "top"


def _square() -> Support:
    return Support(name="top", part="body", z_m=0.7, polygon_m=((0, 0), (1, 0), (1, 1), (0, 1)))
