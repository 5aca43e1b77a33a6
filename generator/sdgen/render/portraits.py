"""Pictures of single models, drawn as scenes are: for contact sheets and blind naming."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.cameras.parts import world_triangles
from sdgen.cameras.pinhole import FAR_M, intrinsics, matrix4
from sdgen.geometry import Array, look_at
from sdgen.library import Library
from sdgen.library.alone import MODEL_ID, alone_on_floor
from sdgen.library.records import AssetInfo
from sdgen.render.frames import render_frames
from sdgen.render.protocol import Renderer
from sdgen.scene import Camera

#: The floor that portraits are taken on: light, and without a pattern things could be lost in.
STUDIO_FLOOR = "carpet_grey"
FOV_RAD = math.radians(28.0)
YAW_RAD = math.radians(30.0)
#: Flat things are looked at from further above.
_PITCH_RAD, _PITCH_FLAT_RAD = math.radians(25.0), math.radians(50.0)
#: By eye: lower than this share of its length or width a thing is flat; room left around it.
_FLAT = 0.35
_MARGIN = 1.13
#: How far the joints of a look that shows them open are turned, as a share of their travel.
_OPEN = 0.8


@dataclass(frozen=True)
class Look:
    """One way a model can look: a name to print, its variant and joint values."""

    name: str
    variant: str
    joints: Mapping[str, float]


def looks_of(info: AssetInfo) -> tuple[Look, ...]:
    """The default, every other variant, and the default with all joints open."""
    shut = {joint.name: min(max(0.0, joint.lower), joint.upper) for joint in info.joints}
    out = [Look("default", "default", shut)]
    out += [Look(name, name, shut) for name in info.variants if name != "default"]
    if info.joints:
        opened = {joint.name: _OPEN * joint.upper for joint in info.joints}
        out.append(Look("open", "default", opened))
    return tuple(out)


def look_in_state(info: AssetInfo, state: str) -> Look | None:
    """A look in which ``state`` holds, plain to see; None when the model cannot be in it."""
    shut = {joint.name: min(max(0.0, joint.lower), joint.upper) for joint in info.joints}
    for rule in info.states:
        if rule.state != state:
            continue
        variant = rule.variants[0] if rule.variants else "default"
        joints = dict(shut)
        if rule.joint is not None and rule.min is not None:
            # A double door is open when both its leaves are.
            for other in info.states:
                if other.state == state and other.joint is not None:
                    joints[other.joint] = _OPEN * info.joint(other.joint).upper
        return Look(state.lower(), variant, joints)
    return None


def portrait(
    renderer: Renderer, library: Library, asset_id: str, look: Look, size: int = 256
) -> npt.NDArray[np.uint8]:
    """The model alone on a floor, filling the picture: (size, size, 3) uint8.

    Drawn at twice the size and averaged. Raises KeyError for an unknown model or variant.
    """
    surface = STUDIO_FLOOR if STUDIO_FLOOR in library.surfaces else None
    scene = alone_on_floor(library, asset_id, look.variant, look.joints, surface)
    points = world_triangles(library, scene.object(MODEL_ID)).reshape(-1, 3)
    camera = portrait_camera(points, size)
    (frame,) = render_frames(renderer, library, scene, [camera], ("rgb",), supersample=2)
    return frame.rgb


def portrait_camera(points_m: Array, size: int, yaw_rad: float = YAW_RAD) -> Camera:
    """A camera in front, to the side (by ``yaw_rad``) and above, that shows all of ``points_m``
    (N, 3)."""
    low, high = points_m.min(axis=0), points_m.max(axis=0)
    extents = high - low
    flat = extents[2] < _FLAT * max(extents[0], extents[1])
    pitch = _PITCH_FLAT_RAD if flat else _PITCH_RAD
    back = np.array(
        [
            math.cos(yaw_rad) * math.cos(pitch),
            math.sin(yaw_rad) * math.cos(pitch),
            math.sin(pitch),
        ]
    )
    right = np.cross((0.0, 0.0, 1.0), back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    # The middle of what is seen, not of the box: tall thin things sit in the centre then.
    middle = sum(
        axis * ((points_m @ axis).min() + (points_m @ axis).max()) / 2 for axis in (back, right, up)
    )
    offsets = points_m - middle
    tangent = math.tan(FOV_RAD / 2) / _MARGIN
    reach = np.maximum(np.abs(offsets @ right), np.abs(offsets @ up)) / tangent
    distance = float((reach + offsets @ back).max())
    eye = middle + back * distance
    nearest = float(distance - (offsets @ back).max())
    return Camera(
        index=0,
        kind="near",
        room_id=1,
        width=size,
        height=size,
        K=intrinsics(size, size, FOV_RAD),
        world_from_camera=matrix4(look_at(eye.tolist(), middle.tolist())),
        near_m=max(0.005, nearest * 0.5),
        far_m=FAR_M,
    )
