"""Where things stand on a model: not where a drawer is, nor where no room is left."""

from __future__ import annotations

import numpy as np
import trimesh
from sdgen.importing.receptacles import behind_doors, open_hollow, supports_of
from sdgen.importing.scan import Box
from sdgen.library.meshes import MeshData
from sdgen.library.records import Joint


def mesh(*boxes: tuple[tuple[float, float, float], tuple[float, float, float]]) -> MeshData:
    """Boxes by sizes and middles as one mesh."""
    parts = [
        trimesh.creation.box(size, trimesh.transformations.translation_matrix(at))
        for size, at in boxes
    ]
    one = trimesh.util.concatenate(parts)
    return MeshData(
        np.asarray(one.vertices, float),
        np.asarray(one.vertex_normals, float),
        np.zeros((len(one.vertices), 2)),
        np.asarray(one.faces),
    )


#: Open to +X: bottom, a board in the middle, top, back and two sides; 0.4 x 0.6 x 0.8 m.
CARCASS = mesh(
    ((0.4, 0.6, 0.02), (0, 0, 0.01)),
    ((0.4, 0.6, 0.02), (0, 0, 0.4)),
    ((0.4, 0.6, 0.02), (0, 0, 0.79)),
    ((0.02, 0.6, 0.8), (-0.19, 0, 0.4)),
    ((0.4, 0.02, 0.8), (0, -0.29, 0.4)),
    ((0.4, 0.02, 0.8), (0, 0.29, 0.4)),
)
DRAWER = mesh(((0.34, 0.5, 0.01), (0.02, 0, 0.05)), ((0.02, 0.56, 0.3), (0.19, 0, 0.2)))
LEAF = mesh(((0.02, 0.56, 0.36), (0.21, 0, 0.6)))
SLIDE = Joint(
    name="slide", type="prismatic", origin_m=(0, 0, 0.05), axis=(1, 0, 0), lower=0, upper=0.3
)
HINGE = Joint(
    name="hinge", type="revolute", origin_m=(0.21, 0.28, 0.6), axis=(0, 0, 1), lower=0, upper=1.5
)


def levels(meshes: dict[str, MeshData], *boxes: Box) -> list[float]:
    return [round(s.z_m, 2) for s in supports_of(meshes, boxes, ["body"])]


def test_boards_carry_but_not_where_a_drawer_is() -> None:
    assert levels({"body": CARCASS}) == [0.02, 0.41, 0.8]
    assert levels({"body": CARCASS, "slide": DRAWER}) == [0.41, 0.8]


def test_a_shelf_over_which_a_drawer_hangs_keeps_the_room_below_it() -> None:
    high = mesh(((0.34, 0.5, 0.1), (0, 0, 0.3)))
    (low, *_) = supports_of({"body": CARCASS, "slide": high}, (), ["body"])
    assert low.z_m == 0.02
    assert low.headroom_m is not None
    assert 0.2 <= low.headroom_m <= 0.23 + 1e-9


def test_a_box_of_the_source_says_where_things_stand() -> None:
    box = Box(np.array([0, 0, 0.95]), np.array([0.2, 0.3, 0.3]))
    tops = [s for s in supports_of({"body": CARCASS}, (box,), ["body"]) if s.z_m > 0.7]
    assert len(tops) == 1
    corners = np.array(tops[0].polygon_m)
    assert (np.abs(corners) <= (0.1, 0.15)).all()
    # A box in the air says nothing.
    air = Box(np.array([0, 0, 1.5]), np.array([0.2, 0.3, 0.3]))
    assert levels({"body": CARCASS}, air) == levels({"body": CARCASS})


def test_what_a_leaf_shuts_is_inside() -> None:
    meshes = {"body": CARCASS, "hinge": LEAF, "slide": DRAWER}
    supports = supports_of(meshes, (), ["body"])
    joint_of = {"body": None, "hinge": "hinge", "slide": "slide"}
    found, (inside,) = behind_doors(supports, meshes, [HINGE, SLIDE], joint_of)
    assert inside.closed_by == "hinge"
    assert [(round(s.z_m, 2), s.container) for s in found] == [(0.41, "inside"), (0.8, None)]


def test_a_bowl_is_hollow_and_a_block_is_not() -> None:
    walls = ((0.2, 0.01, 0.1), (0, 0.1, 0.05)), ((0.2, 0.01, 0.1), (0, -0.1, 0.05))
    sides = ((0.01, 0.2, 0.1), (0.1, 0, 0.05)), ((0.01, 0.2, 0.1), (-0.1, 0, 0.05))
    bowl = open_hollow([mesh(((0.2, 0.2, 0.01), (0, 0, 0.005)), *walls, *sides)], "body")
    assert bowl is not None
    assert np.allclose(bowl.size_m[2], 0.09, atol=0.01)
    assert open_hollow([mesh(((0.2, 0.2, 0.1), (0, 0, 0.05)))], "body") is None
