"""The outline of what is drawn: by variant, piece by piece, moved by joints."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from sdgen.library import Library
from sdgen.library.drawn import drawn, shut
from sdgen.library.meshes import MeshData
from sdgen.library.outlines import joined, outline, outlines_of
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part

from tests.shipped import shipped_library


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


def boxes(*middles: tuple[float, float, float]) -> MeshData:
    """Cubes of 2 cm as one mesh, each corner repeated for every face, as files have it."""
    cubes = [trimesh.creation.box((0.02, 0.02, 0.02)).apply_translation(at) for at in middles]
    triangles = np.concatenate([cube.triangles for cube in cubes]).reshape(-1, 3)
    count = len(triangles)
    faces = np.arange(count).reshape(-1, 3)
    return MeshData(triangles, np.zeros((count, 3)), np.zeros((count, 2)), faces)


def test_pieces_that_lie_apart_have_outlines_of_their_own() -> None:
    assert len(outlines_of(boxes((0, 0, 0), (0.03, 0, 0), (0, 0.05, 0)))) == 3
    # One above the other, as a bulb and its shade, and as good as touching.
    assert len(outlines_of(boxes((0, 0, 0), (0, 0, 0.1)))) == 1
    assert len(outlines_of(boxes((0, 0, 0), (0.021, 0, 0)))) == 1


def test_the_outline_of_a_box_is_its_corners() -> None:
    (points,) = outlines_of(boxes((0.5, 0, 0.01)))
    assert len(points) == 8
    assert np.ptp(np.array(points), axis=0) == pytest.approx([0.02] * 3)


@pytest.mark.parametrize("turned", np.linspace(0.0, 1.5, 7))
def test_an_arm_is_in_the_box_however_the_thing_is_turned(turned: float) -> None:
    """A doll 0.3 m high whose arm ends 6 cm beside its body."""
    mesh = trimesh.creation.icosphere(subdivisions=3, radius=0.1).vertices * (1, 1, 1.5)
    arm = np.array([(0.16, y, z) for y in (-0.01, 0.01) for z in (0.04, 0.06)])
    arm[:, :2] = arm[:, :2] @ trimesh.transformations.rotation_matrix(-turned, (0, 0, 1))[:2, :2]
    vertices = np.concatenate([mesh, arm])
    points = np.array(outline(vertices))
    yaw = np.linspace(0, 2 * np.pi, 180)
    across = np.stack([np.cos(yaw), np.sin(yaw), 0 * yaw])
    missed = (vertices @ across).max(axis=0) - (points @ across).max(axis=0)
    assert missed.max() < 0.004


def test_components_are_found_along_chains() -> None:
    chain = np.array([(k, k + 1) for k in range(0, 98) if k != 49])
    assert joined(chain, 100).tolist() == [0] * 50 + [1] * 49 + [2]


@pytest.mark.parametrize("category", ["wine_glass", "plate", "mug"])
def test_shards_lie_apart_and_not_where_the_whole_thing_stood(
    library: Library, category: str
) -> None:
    broken = [a for a in library.by_category(category) if "broken" in a.variants]
    for asset in broken:
        info = library.info(asset.id)
        shards = drawn(info, "broken", {})
        mesh = library.mesh(asset.id)
        meshes = np.concatenate([mesh[part].vertices for part in info.variants["broken"]])
        ends = [meshes.min(axis=0), meshes.max(axis=0)]
        assert shards.box_m == pytest.approx(np.array(ends), abs=2e-4)
        assert np.ptp(shut(info, "default").box_m, axis=0) == pytest.approx(
            info.extents_m, abs=3e-3
        )
        assert shards.box_m[1, 0] > shut(info, "default").box_m[1, 0]
    assert max(len(drawn(library.info(a.id), "broken", {}).starts) for a in broken) >= 3


def test_a_leaf_goes_where_its_joint_puts_it(library: Library) -> None:
    asset = next(a for a in library.by_category("fridge") if a.joints)
    info, joint = library.info(asset.id), asset.joints[0]
    closed, wide = drawn(info, "default", {}), drawn(info, "default", {joint.name: joint.upper})
    assert closed.still == len(closed.starts) == 1
    moved = [p for p in info.variants["default"] if info.part(p).joint == joint.name]
    assert len(wide.starts) == wide.still + len(moved)
    leaf = wide.points_m[wide.starts[wide.still] :]
    mesh = library.mesh(asset.id)
    where = [
        mesh[part].vertices @ turn[:3, :3].T + turn[:3, 3]
        for part in moved
        for turn in [object_from_part(info, part, {joint.name: joint.upper})]
    ]
    points = np.concatenate(where)
    assert leaf.min(axis=0) == pytest.approx(points.min(axis=0), abs=0.01)
    assert leaf.max(axis=0) == pytest.approx(points.max(axis=0), abs=0.01)
    assert wide.box_m[1, 0] > closed.box_m[1, 0] + 0.3


def test_a_record_without_outlines_takes_its_box(library: Library) -> None:
    shipped = library.info(library.by_category("fridge")[0].id)
    # Not a copy: that would come with the outlines found of it before.
    info = AssetInfo.model_validate(shipped.model_dump() | {"outlines_m": {}})
    x, y, z = info.extents_m
    joints = {joint.name: joint.upper for joint in info.joints}
    expected = np.array([(-x / 2, -y / 2, 0), (x / 2, y / 2, z)])
    assert drawn(info, "default", joints).box_m == pytest.approx(expected)
