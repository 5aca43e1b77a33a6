"""A made scene's cameras stand where a robot can."""

import pytest
from sdgen.facts import room_at
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union


@pytest.mark.slow
def test_cameras_stand_on_free_floor_at_eye_height(catalog, library):
    for index in (0, 1):
        bundle = make_scene(index, catalog, library, BuildOptions(n=9, seed=7, eye_height_m=1.0))
        kinds = [camera.kind for camera in bundle.cameras]
        assert len(kinds) == 8
        assert kinds.count("near") == 5
        free = unary_union([Polygon(ring) for ring in bundle.scene.free_space]).buffer(0.02)
        for camera in bundle.cameras:
            x, y, z = (row[3] for row in camera.world_from_camera[:3])
            assert free.contains(Point(x, y))
            assert abs(z - 1.0) <= 0.2
            room = room_at(bundle.scene.home.rooms, x, y)
            assert room is not None
            assert room.id == camera.room_id
