"""The space of objects, and who enters whose."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.actions import in_state
from sdgen.geometry import apply, quat_from_yaw
from sdgen.home.blocks import TOUCH_M, Block, Table, blocks_of
from sdgen.library.above import LEFT_OUT_M
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane
from shapely.geometry import MultiPoint

from tests.shipped import shipped_library

LIBRARY = shipped_library()


def thing(category, x=1.0, y=2.0, yaw=0.4, **changes):
    asset = LIBRARY.by_category(category)[0]
    pose = Pose(position_m=(x, y, 0.3), quat_xyzw=quat_from_yaw(yaw))
    item = ObjectInstance(id=5, category=category, asset=asset.id, pose=pose, room_id=1, fixed=True)
    return item.model_copy(update=changes)


def space(owner, x0, y0, low, x1, y1, high):
    outline = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], dtype=float)
    return Block(owner, outline, np.array([x0, y0, low, x1, y1, high], dtype=float))


@pytest.mark.parametrize("category", ["chair", "kitchen_table", "coffee_table"])
def test_open_framed_furniture_takes_the_space_of_its_pieces(category):
    item = thing(category)
    blocks = blocks_of(item, LIBRARY.info(item.asset), LIBRARY)
    hulls = LIBRARY.hulls(item.asset)
    assert len(blocks) == len(hulls) > 1
    for block, hull in zip(blocks, hulls, strict=True):
        local = object_from_part(LIBRARY.info(item.asset), hull.part, item.joints)
        corners = apply(item.pose.matrix() @ local, hull.vertices_m)
        drawn = MultiPoint(corners[:, :2]).convex_hull
        # Mouldings and cushions widen the pieces a little, and never narrow them.
        assert block.shape.buffer(1e-9).covers(drawn)
        assert drawn.buffer(LEFT_OUT_M).covers(block.shape)
        low, high = corners.min(axis=0), corners.max(axis=0)
        assert (np.abs(block.box - [*low, *high]) <= LEFT_OUT_M).all()
        assert (block.box[:3] <= low + 1e-9).all()
        assert (block.box[3:] >= high - 1e-9).all()
        assert block.shape.bounds == tuple(block.box[[0, 1, 3, 4]])


def test_a_part_that_moves_takes_other_space_and_the_rest_the_same():
    fridge = thing("fridge")
    info = LIBRARY.info(fridge.asset)
    opened = in_state(fridge, info, "OPEN", lane(0, 1, "blocks"))
    (body,), (same, leaf) = (blocks_of(one, info, LIBRARY) for one in (fridge, opened))
    assert body.same_space(same)
    assert not body.same_space(leaf)


def test_what_is_tilted_is_refused():
    tilt = (math.sin(0.1), 0.0, 0.0, math.cos(0.1))
    item = thing("desk", pose=Pose(position_m=(0, 0, 0), quat_xyzw=tilt))
    with pytest.raises(ValueError, match="upright"):
        blocks_of(item, LIBRARY.info(item.asset), LIBRARY)


def test_a_thing_that_lies_on_its_side_takes_what_it_covers():
    side = (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))  # turned about x: what was up is along -y
    item = thing("book", pose=Pose(position_m=(1, 2, 0.5), quat_xyzw=side), fixed=False)
    (block,) = blocks_of(item, LIBRARY.info(item.asset), LIBRARY)
    deep, wide, high = LIBRARY.info(item.asset).extents_m
    low, top = block.box[:3], block.box[3:]
    assert np.allclose(top - low, (deep, high, wide), atol=0.004)
    assert np.allclose((low + top) / 2, (1, 2 - high / 2, 0.5), atol=0.004)


def test_spaces_are_entered_by_outline_and_height():
    table = Table().more([space(1, 0, 0, 0, 1, 1, 0.5), space(2, 2, 0, 0, 3, 1, 0.5)])
    assert list(table.entered([])) == []
    assert list(table.entered([space(9, 0.5, 0.5, 0.2, 2.5, 0.8, 0.4)])) == [1, 2]
    assert list(table.entered([space(2, 0.5, 0.5, 0.2, 2.5, 0.8, 0.4)])) == [1]
    for low, found in ((0.5 - TOUCH_M / 2, []), (0.5 - 2 * TOUCH_M, [1])):
        assert list(table.entered([space(9, 0.2, 0.2, low, 0.8, 0.8, 1.0)])) == found
    # A diamond beside a corner: boxes meet, outlines do not.
    diamond = np.array([(1.0, 1.2), (1.2, 1.0), (1.4, 1.2), (1.2, 1.4)]) - 0.05
    lone = Block(9, diamond, np.array([0.95, 0.95, 0.0, 1.35, 1.35, 0.5]))
    assert list(table.entered([lone])) == []
    # Two blocks of one thing, of which the second enters.
    pair = [space(9, 5, 5, 0, 6, 6, 1), space(9, 2.5, 0.5, 0, 4, 0.6, 1)]
    assert list(table.entered(pair)) == [2]
