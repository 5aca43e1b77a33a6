"""Plain arithmetic on surfaces says what polygons say."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.freespace import random_point
from sdgen.home.layout import corners_of
from sdgen.home.surfaces import CARRIED_SHARE, PlacingSurface, placing_surfaces
from sdgen.library.records import Support
from sdgen.scene import ObjectInstance, Pose
from shapely.geometry import Polygon

from tests.shipped import shipped_library

MUG = shipped_library().by_category("mug")[0]
TURN = np.array([[math.cos(0.3), -math.sin(0.3)], [math.sin(0.3), math.cos(0.3)]])
SQUARE = np.array([(0.0, 0.0), (0.4, 0.0), (0.4, 0.3), (0.0, 0.3)])
ROUND = np.array([(0.2 * math.cos(a), 0.2 * math.sin(a)) for a in np.arange(12) * math.pi / 6])
ELL = np.array([(0, 0), (0.4, 0), (0.4, 0.15), (0.15, 0.15), (0.15, 0.4), (0, 0.4)])


def surface(corners, z=0.7, walled=False):
    turned = corners @ TURN.T + (3.0, -1.0)
    polygon = tuple((float(x), float(y)) for x, y in corners)
    support = Support(name="top", part="body", z_m=z, polygon_m=polygon)
    return PlacingSurface(support, np.column_stack([turned, np.full(len(turned), z)]), walled)


@pytest.mark.parametrize("corners", [SQUARE, ROUND, ELL], ids=["square", "round", "ell"])
def test_a_surface_carries_what_its_polygon_covers(corners):
    there = surface(corners)
    rng = np.random.default_rng(1)
    answers = []
    for _ in range(600):
        x, y = rng.uniform((2.5, -1.5), (3.6, -0.4))
        yaw = float(rng.uniform(-4, 4))
        print_ = Polygon(corners_of(MUG, x, y, yaw))
        covered = print_.intersection(there.shape).area / print_.area
        answers.append(there.carries(MUG.extents_m, (x, y), yaw))
        assert answers[-1] is (covered >= CARRIED_SHARE)
    assert {True, False} == set(answers)


def test_what_reaches_over_an_edge_is_carried_up_to_a_share():
    w, d, _ = MUG.extents_m
    there = surface(np.array([(0.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 1.0)]))
    for over, carried in ((0.02, True), (0.04, False)):
        local = np.array([w * (0.5 - over), 0.1])
        x, y = TURN @ local + (3.0, -1.0)
        assert there.carries((w, d, 0.1), (float(x), float(y)), 0.3) is carried


@pytest.mark.parametrize("corners", [SQUARE, ELL], ids=["square", "ell"])
def test_in_a_hollow_all_of_a_thing_is_within(corners):
    """What reaches over the edge there is in the wall of the fridge."""
    there = surface(corners, walled=True)
    rng = np.random.default_rng(1)
    carried = 0
    for _ in range(1200):
        x, y = rng.uniform((2.5, -1.5), (3.6, -0.4))
        yaw = float(rng.uniform(-4, 4))
        if there.carries(MUG.extents_m, (x, y), yaw):
            carried += 1
            assert there.shape.buffer(1e-6).covers(Polygon(corners_of(MUG, x, y, yaw)))
    assert carried > 10


@pytest.mark.parametrize("corners", [SQUARE, ROUND, ELL], ids=["square", "round", "ell"])
def test_points_are_those_drawn_from_the_polygon(corners):
    there = surface(corners)
    for seed in range(50):
        mine, its = np.random.default_rng(seed), np.random.default_rng(seed)
        assert there.random_point(mine) == random_point(there.shape, its)
        assert mine.random() == its.random()


def test_no_point_is_drawn_from_a_sliver():
    there = surface(SQUARE * (1.0, 0.0005))
    rng = np.random.default_rng(0)
    assert there.random_point(rng) is None
    assert rng.random() == np.random.default_rng(0).random()
    assert Polygon(SQUARE * (1.0, 0.0005)).area > 0


def test_nothing_is_put_on_a_lid_held_open():
    info = shipped_library().infos["freezer_03"]
    pose = Pose(position_m=(1, 1, 0), quat_xyzw=(0, 0, 0, 1))

    def tops(lid):
        item = ObjectInstance(
            id=1, category="freezer", asset=info.id, pose=pose, joints={"lid": lid}, room_id=1
        )
        return [s.support.name for s in placing_surfaces(item, info) if not s.support.container]

    assert tops(0.0) == ["top"]
    assert tops(1.0) == []


@pytest.mark.parametrize(
    ("asset", "reaches_over"), [("sofa_07", False), ("bed_01", False), ("coffee_table_01", True)]
)
def test_nothing_reaches_into_a_back_or_arms(asset, reaches_over):
    """Beside a sofa's seat are its arms and back, beside a table's top is air."""
    info = shipped_library().info(asset)
    still = Pose(position_m=(0.0, 0.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0))
    item = ObjectInstance(
        id=1, category=info.category, asset=asset, pose=still, room_id=2, fixed=True
    )
    top = max(placing_surfaces(item, info), key=lambda surface: surface.z_m)
    w, d, h = 0.2, 0.2, 0.1
    x0, _, _, y1 = top.shape.bounds
    middle = (x0 + top.shape.bounds[2]) / 2
    over = y1 - d / 2 + 0.02 * d
    assert top.carries((w, d, h), (middle, y1 - d / 2 - 0.001), 0.0)
    assert top.carries((w, d, h), (middle, over), 0.0) is reaches_over
