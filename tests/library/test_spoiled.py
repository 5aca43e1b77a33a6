"""Food that has gone bad looks so from all around: labels are held to no more than its pixels."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.cameras.parts import part_numbers, world_triangles
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.library.alone import MODEL_ID, alone_on_floor
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames
from sdgen.scene import Camera

from tests.shipped import shipped_library

#: So much of what is seen of it differs plainly from its fresh self, on the worst side.
LEAST = 0.05
SIDES, PIXELS, PITCH, FOV = 8, 128, math.radians(25.0), math.radians(28.0)
#: Sum of the differences of red, green and blue (0 to 255 each): brown on yellow, grey on brown.
PLAIN = 75
SHARES = 8


def spoiled() -> list[tuple[str, str, frozenset[str]]]:
    """Model, variant and the parts that show it."""
    found = []
    for asset_id, info in sorted(shipped_library().infos.items()):
        for rule in info.states:
            if rule.state == "EXPIRED":
                found.append((asset_id, rule.variants[0], frozenset(rule.parts)))
    return found


def around(points_m: np.ndarray) -> list[Camera]:
    """Cameras about a thing with these corners (N, 3), looking somewhat down on all of it."""
    middle = (points_m.min(axis=0) + points_m.max(axis=0)) / 2
    radius = float(np.linalg.norm(points_m - middle, axis=1).max())
    cameras = []
    for k in range(SIDES):
        yaw = math.tau * (k + 0.25) / SIDES
        back = np.array([math.cos(yaw), math.sin(yaw), math.tan(PITCH)]) * math.cos(PITCH)
        eye = middle + back * radius / math.sin(FOV / 2)
        camera = Camera(
            index=k,
            kind="near",
            room_id=1,
            width=PIXELS,
            height=PIXELS,
            K=intrinsics(PIXELS, PIXELS, FOV),
            world_from_camera=matrix4(look_at(eye.tolist(), middle.tolist())),
            near_m=0.01,
            far_m=20.0,
        )
        cameras.append(camera)
    return cameras


@pytest.mark.library
@pytest.mark.parametrize("share", range(SHARES))
def test_spoiled_food_looks_so_from_all_around(share: int) -> None:
    library = shipped_library()
    least = {}
    with open_renderer("auto") as renderer:
        for asset_id, variant, parts in spoiled()[share::SHARES]:
            scenes = [
                alone_on_floor(library, asset_id, look, {}, None) for look in ("default", variant)
            ]
            bad = scenes[1].object(MODEL_ID)
            cameras = around(world_triangles(library, bad).reshape(-1, 3))
            fresh, rotten = (
                list(render_frames(renderer, library, scene, cameras, ("rgb", "instance")))
                for scene in scenes
            )
            numbers = part_numbers(library, bad, tuple(parts))
            for before, after in zip(fresh, rotten, strict=True):
                shown = (after.instance == MODEL_ID) & np.isin(after.part, list(numbers))
                changed = np.abs(before.rgb.astype(int) - after.rgb.astype(int)).sum(axis=2)
                if shown.any():
                    told = float((changed[shown] > PLAIN).mean())
                    least[asset_id] = min(told, least.get(asset_id, 1.0))
    assert {asset_id: told for asset_id, told in least.items() if told < LEAST} == {}
