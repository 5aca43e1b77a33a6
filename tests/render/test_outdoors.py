"""Nothing but background is painted: green below the horizon, blue above it."""

import numpy as np
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.render.outdoors import paint_outdoors
from sdgen.scene import Camera


def camera() -> Camera:
    return Camera(
        index=0,
        kind="room",
        room_id=1,
        width=64,
        height=48,
        K=intrinsics(64, 48),
        world_from_camera=matrix4(look_at((0.0, 0.0, 1.2), (5.0, 0.0, 1.2))),
        near_m=0.05,
        far_m=60.0,
    )


def test_background_is_sky_above_and_lawn_below():
    background = np.zeros((48, 64), dtype=bool)
    background[:, :32] = True
    before = np.full((48, 64, 3), 7, dtype=np.uint8)
    after = paint_outdoors(before, background, camera())
    assert np.all(before == 7)
    assert np.all(after[:, 32:] == 7)
    red, green, blue = (int(v) for v in after[2, 5])
    assert blue > green > red
    red, green, blue = (int(v) for v in after[30, 5])
    assert green > red > blue


def test_a_picture_without_background_stays_as_it_is():
    picture = np.zeros((48, 64, 3), dtype=np.uint8)
    assert paint_outdoors(picture, np.zeros((48, 64), dtype=bool), camera()) is picture
