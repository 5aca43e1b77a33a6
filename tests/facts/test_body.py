"""Bodies are what is drawn: their variant's meshes, where their joints put them."""

from __future__ import annotations

import pytest
from sdgen.actions import settled_states
from sdgen.facts import Body
from sdgen.library import Library
from sdgen.scene import ObjectInstance, Pose
from sdgen.zones import floor_obstacles
from shapely.geometry import Point

from tests.shipped import shipped_library


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


def body(library: Library, asset_id: str, variant: str = "default", **joints: float) -> Body:
    info = library.info(asset_id)
    item = ObjectInstance(
        id=1,
        category=info.category,
        asset=asset_id,
        pose=Pose(position_m=(2.0, 3.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0)),
        room_id=9,
        variant=variant,
        joints={joint.name: joints.get(joint.name, 0.0) for joint in info.joints},
        fixed=True,
    )
    return Body(settled_states(item, info), info)


def test_an_open_leaf_is_part_of_the_body_and_the_floor_behind_it_is_not(library: Library) -> None:
    asset = next(a for a in library.by_category("fridge") if a.joints)
    joint = asset.joints[0]
    shut, wide = body(library, asset.id), body(library, asset.id, **{joint.name: joint.upper})
    assert wide.high[0] > shut.high[0] + 0.3
    hull = wide.footprint.convex_hull
    assert shut.footprint.area < wide.footprint.area < 0.8 * hull.area
    assert wide.trunk.symmetric_difference(shut.footprint).area < 0.02
    assert tuple(wide.center) == tuple(shut.center)
    # What a walker can pass beside an open door: its corner's other side.
    assert floor_obstacles([wide])[0].area == pytest.approx(wide.footprint.area)


def test_shards_are_where_they_lie(library: Library) -> None:
    asset = next(a for a in library.by_category("wine_glass") if "broken" in a.variants)
    whole, broken = body(library, asset.id), body(library, asset.id, "broken")
    assert broken.high[2] < whole.high[2] / 2
    assert broken.center[2] == pytest.approx(broken.high[2] / 2, abs=2e-3)
    assert len(broken.pieces) > 1
    assert broken.footprint.area < 0.8 * broken.footprint.convex_hull.area
    gap = broken.footprint.convex_hull.difference(broken.footprint).representative_point()
    assert broken.covered_by(Point(gap).buffer(1e-4)) == 0.0
