"""The camera of an agent or a robot: chosen by whoever looks, and carried from place to place."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from pydantic import Field

from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.geometry import Array, Vec2, look_at
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Camera, Record


class Lens(Record):
    """Pixels, horizontal field of view, and height above the floor."""

    width: int = Field(default=128, ge=8, le=2048)
    height: int = Field(default=128, ge=8, le=2048)
    fov_x_deg: float = Field(default=90.0, ge=10.0, le=150.0)
    height_m: float = Field(default=EYE_HEIGHT_M, ge=0.1, le=2.2)

    @property
    def focal_px(self) -> float:
        """Its focal length."""
        return self.width / (2.0 * math.tan(math.radians(self.fov_x_deg) / 2.0))


class Gaze(NamedTuple):
    """Where one stands, metres, and looks: yaw counter-clockwise from x, pitch up, radians."""

    x_m: float
    y_m: float
    yaw_rad: float
    pitch_rad: float = 0.0

    @property
    def point(self) -> Vec2:
        """Where one stands."""
        return self.x_m, self.y_m


def camera_at(gaze: Gaze, room_id: int, lens: Lens) -> Camera:
    """What one looks through who stands and looks so, in this room."""
    return Camera(
        index=0,
        kind="near",
        room_id=room_id,
        width=lens.width,
        height=lens.height,
        K=intrinsics(lens.width, lens.height, math.radians(lens.fov_x_deg)),
        world_from_camera=matrix4(pose_at(gaze, lens.height_m)),
        near_m=NEAR_M,
        far_m=FAR_M,
    )


def pose_at(gaze: Gaze, height_m: float) -> Array:
    """``world_from_camera`` (4, 4) of a lens at this height."""
    eye = (gaze.x_m, gaze.y_m, height_m)
    level = math.cos(gaze.pitch_rad)
    ahead = (
        level * math.cos(gaze.yaw_rad),
        level * math.sin(gaze.yaw_rad),
        math.sin(gaze.pitch_rad),
    )
    return look_at(eye, (eye[0] + ahead[0], eye[1] + ahead[1], eye[2] + ahead[2]))


def toward(eye_m: Array, target_m: Array) -> tuple[float, float]:
    """Yaw and pitch, radians, in which a point lies from an eye, both (3,)."""
    dx, dy, dz = (np.asarray(target_m) - np.asarray(eye_m)).tolist()
    return math.atan2(dy, dx), math.atan2(dz, math.hypot(dx, dy))
