"""Behind the front door of a home upstairs is no garden but a landing: a bare box of a room with
the neighbour's door, found by the rays that leave through the doorway."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, Vec2, Vec3
from sdgen.scene import Home, Opening, Room

#: How deep and how high a landing is, and how far it goes to the left and right of the doorway's
#: middle, metres.
_DEEP_M, _HIGH_M, _LEFT_M, _RIGHT_M = 1.7, 2.55, -1.3, 2.1
#: The neighbour's door, opposite: from where to where, how high, and its frame, metres.
_DOOR_M, _DOOR_HIGH_M, _FRAME_M = (-0.35, 0.55), 2.02, 0.07
#: Its knob, from its edge and the floor, and half a plate with a name.
_KNOB_M, _KNOB_RADIUS_M, _PLATE_M, _PLATE_Z_M = (0.08, 1.02), 0.03, (0.06, 0.03), 1.5
_BRASS = (196, 164, 96)
_SKIRTING_M, _TILE_M, _JOINT_M = 0.1, 0.3, 0.006
#: Colours of walls and of the neighbour's door, by the variant of the world outside.
_WALLS = ((226, 219, 200), (208, 215, 206), (222, 212, 204))
_DOORS = ((112, 74, 48), (70, 92, 84), (96, 62, 52))
_SKIRTING, _FRAME, _TILES, _JOINTS = (
    (128, 122, 114),
    (238, 236, 230),
    (172, 168, 160),
    (132, 128, 122),
)
_CEILING = (240, 239, 235)
#: How bright faces are that look down the landing, across it, up and down.
_BACK, _SIDE, _FLOOR, _OVERHEAD = 0.92, 0.8, 0.78, 0.86


class Landing(NamedTuple):
    """A doorway, and which way is out: ``right`` lies to the right of who leaves."""

    middle_m: Vec3
    outward: Vec2
    right: Vec2
    width_m: float
    height_m: float
    variant: int


def landings(home: Home) -> tuple[Landing, ...]:
    """What lies behind the front doors of a home: nothing of its own at the ground."""
    if home.outdoors.storey == 0:
        return ()
    rooms = {room.id: room for room in home.rooms}
    return tuple(
        _landing(opening, rooms[opening.room_ids[0]], home.outdoors.variant)
        for opening in home.openings
        if opening.kind == "front_door"
    )


def _landing(opening: Opening, room: Room, variant: int) -> Landing:
    x, y, _ = opening.center_m
    axis = 1 if opening.along == "x" else 0
    inside = float(np.mean([point[axis] for point in room.polygon_m]))
    sign = 1.0 if opening.center_m[axis] > inside else -1.0
    outward = (0.0, sign) if axis == 1 else (sign, 0.0)
    right = (outward[1], -outward[0])
    size = opening.width_m, opening.height_m
    return Landing((x, y, 0.0), outward, right, *size, variant % len(_WALLS))


def seen_on(
    landing: Landing, eye_m: Array, rays: Array
) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.float64]]:
    """Which of some rays (N, 3) from an eye leave through the doorway, and the colours (M, 3) that
    these M meet on the landing."""
    # Along the wall, out of the door, up.
    frame = np.array([(*landing.right, 0.0), (*landing.outward, 0.0), (0.0, 0.0, 1.0)])
    eye = frame @ (np.asarray(eye_m) - landing.middle_m)
    along = rays @ frame.T
    with np.errstate(divide="ignore", invalid="ignore"):
        at = eye + along * (-eye[1] / along[:, 1])[:, None]
        out = (along[:, 1] > 0) & (eye[1] < 0)
        out &= (np.abs(at[:, 0]) <= landing.width_m / 2) & (at[:, 2] <= landing.height_m)
        along = along[out]
        # How far it is to the end, to the side and to the floor or ceiling that each ray goes to.
        low, high = np.array((_LEFT_M, 0.0, 0.0)), np.array((_RIGHT_M, _DEEP_M, _HIGH_M))
        far = np.where(along > 0, high - eye, low - eye) / along
    far = np.where(np.isfinite(far) & (far > 0), far, np.inf)
    face = far.argmin(axis=1)
    met = eye + along * far.min(axis=1)[:, None]
    return out, _colours(met, face, along[:, 2] > 0, landing.variant)


def _colours(
    met: Array, face: npt.NDArray[np.intp], up: npt.NDArray[np.bool_], variant: int
) -> Array:
    """Colours (N, 3) of points (N, 3) on the side walls, the back wall, floor and ceiling (faces 0
    to 2)."""
    u, v, z = met.T
    colours = np.tile(np.array(_WALLS[variant], dtype=np.float64), (len(met), 1))
    colours[(face < 2) & (z < _SKIRTING_M)] = _SKIRTING
    (low, high), back = _DOOR_M, face == 1
    around = (u > low - _FRAME_M) & (u < high + _FRAME_M) & (z < _DOOR_HIGH_M + _FRAME_M)
    colours[back & around] = _FRAME
    leaf = (u > low) & (u < high) & (z < _DOOR_HIGH_M)
    colours[back & leaf] = _DOORS[variant]
    knob = np.hypot(u - low - _KNOB_M[0], z - _KNOB_M[1]) < _KNOB_RADIUS_M
    plate = (np.abs(u - (low + high) / 2) < _PLATE_M[0]) & (np.abs(z - _PLATE_Z_M) < _PLATE_M[1])
    colours[back & (knob | plate)] = _BRASS
    floor = (face == 2) & ~up
    joint = (u % _TILE_M < _JOINT_M) | (v % _TILE_M < _JOINT_M)
    colours[floor] = _TILES
    colours[floor & joint] = _JOINTS
    colours[(face == 2) & up] = _CEILING
    light = np.choose(face, (_SIDE, _BACK, _FLOOR)) * 1.0
    light[(face == 2) & up] = _OVERHEAD
    # A lamp hangs in the middle: corners are darker.
    light *= 1.0 - 0.06 * np.abs(u - (_LEFT_M + _RIGHT_M) / 2) - 0.05 * np.abs(v - _DEEP_M / 2)
    return np.asarray(colours * light[:, None])
