"""The agent's camera at a pose, as a camera like any other."""

from __future__ import annotations

import math

from sdgen.agent.options import AgentCamera
from sdgen.agent.walk import Place
from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.scene import Camera


def camera_at(place: Place, pitch_rad: float, room_id: int, lens: AgentCamera) -> Camera:
    """What an agent looks through that stands at ``place`` and looks up by ``pitch_rad``."""
    eye = (place.x_m, place.y_m, lens.height_m)
    level = math.cos(pitch_rad)
    aim = (
        eye[0] + level * math.cos(place.yaw_rad),
        eye[1] + level * math.sin(place.yaw_rad),
        eye[2] + math.sin(pitch_rad),
    )
    return Camera(
        index=0,
        kind="near",
        room_id=room_id,
        width=lens.width,
        height=lens.height,
        K=intrinsics(lens.width, lens.height, math.radians(lens.fov_x_deg)),
        world_from_camera=matrix4(look_at(eye, aim)),
        near_m=NEAR_M,
        far_m=FAR_M,
    )
