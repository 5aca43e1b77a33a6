"""Near views are as many in every scene and fall on benign things too."""

import pytest
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.pipeline.views import glance_pixels, high_count, near_count
from sdgen.relations import room_at
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union


@pytest.mark.parametrize(
    ("views", "most", "near"), [(8, 5, 5), (12, 5, 8), (4, 5, 3), (1, 5, 0), (0, 5, 0), (6, 1, 4)]
)
def test_the_number_of_near_views_follows_from_the_options_alone(views, most, near):
    options = BuildOptions(views=views, hazards_max=most)
    assert near_count(options) == near
    assert high_count(options) == (1 if views - near > 2 else 0)


def test_large_things_must_show_more_than_small_ones():
    sizes = [glance_pixels(d) for d in (0.01, 0.08, 0.3, 1.0, 5.0)]
    assert sizes == sorted(sizes)
    assert sizes[0] == sizes[1] >= 200


@pytest.mark.slow
def test_cameras_stand_on_free_floor_at_eye_height(catalog, library):
    for index in (0, 1):
        bundle = make_scene(index, catalog, library, BuildOptions(n=9, seed=7, eye_height_m=1.0))
        kinds = [camera.kind for camera in bundle.cameras]
        assert len(kinds) == 8
        assert kinds.count("near") == 6
        free = unary_union([Polygon(ring) for ring in bundle.scene.free_space]).buffer(0.02)
        for camera in bundle.cameras:
            x, y, z = (row[3] for row in camera.world_from_camera[:3])
            assert free.contains(Point(x, y))
            assert abs(z - 1.0) <= 0.2
            room = room_at(bundle.scene.home.rooms, x, y)
            assert room is not None
            assert room.id == camera.room_id
