"""Light of one scene on the renderer, and pictures by it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import moderngl
import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.geometry import Array
from sdgen.render.light.rooms import RoomLight
from sdgen.render.light.sunlight import SunMap
from sdgen.render.raster.buffers import Buffers
from sdgen.render.raster.light_shaders import LIGHT, ROOMS, SHADE, SMOOTH
from sdgen.render.raster.shaders import FULL_VERTEX
from sdgen.scene import Camera

#: Cells of the map that says which room a point of the plan is in, metres; rooms reach as far as
#: the middle of their walls.
_PLAN_M, _WALL_M = 0.04, 0.06
_BESIDE_M = 0.5
#: How bright the middle of a room is to be, and how far dark rooms are brought up to it.
_KEY, _ADAPTS = 1.5, 0.85
#: At least so much light is reckoned with, or a dark store room would be noise.
_DARKEST = 0.08


class Passes:
    """The programs that light and smooth a picture, and what they draw into."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], dtype=np.float32).tobytes())
        self._programs = {
            name: context.program(FULL_VERTEX, pixel)
            for name, pixel in (("shade", SHADE), ("light", LIGHT), ("smooth", SMOOTH))
        }
        self._arrays = {
            name: context.vertex_array(program, [(corners, "2f", "at")])
            for name, program in self._programs.items()
        }
        self._targets: dict[tuple[int, int], dict[str, moderngl.Framebuffer]] = {}

    def picture(
        self, buffers: Buffers, camera: Camera, clip: Array, light: Lighting
    ) -> npt.NDArray[np.uint8]:
        """Colours of what is in the buffers, by this light, (H, W, 3)."""
        targets = self._sized(buffers.size)
        pose = np.asarray(camera.world_from_camera)
        k = np.asarray(camera.K)
        # Rows of textures go up, rows of pictures go down.
        wide, high = camera.width / k[0, 0], camera.height / k[1, 1]
        lens = (-(k[0, 2] + 0.5) / k[0, 0], (camera.height - k[1, 2] - 0.5) / k[1, 1], wide, -high)
        place = {
            "normal_map": buffers.normal,
            "depth_map": buffers.depth,
            "world_from_camera": pose,
            "lens": lens,
            "eye": tuple(pose[:3, 3]),
        }
        pixel = (1 / buffers.size[0], 1 / buffers.size[1])
        self._context.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._run("shade", targets["shade"], {**place, "clip_from_world": clip})
        self._run(
            "light",
            targets["light"],
            {
                **place,
                **light.uniforms,
                "albedo_map": buffers.albedo,
                "shade_map": targets["shade"].color_attachments[0],
                "pixel": pixel,
                "exposure": light.exposure(camera.room_id),
            },
        )
        lit = targets["light"].color_attachments[0]
        self._run("smooth", targets["smooth"], {"picture": lit, "pixel": pixel})
        raw = np.frombuffer(targets["smooth"].read(components=3, alignment=1), dtype=np.uint8)
        return np.ascontiguousarray(raw.reshape(*buffers.size[::-1], 3)[::-1])

    def _run(self, name: str, target: moderngl.Framebuffer, values: dict[str, Any]) -> None:
        target.use()
        program, unit = self._programs[name], 0
        for key, value in values.items():
            if key not in program:
                continue
            member = program[key]
            if isinstance(value, moderngl.Texture | moderngl.Texture3D):
                value.use(unit)
                member.value = unit
                unit += 1
            elif isinstance(value, np.ndarray) and value.ndim == 2 and value.shape == (4, 4):
                member.write(value.T.astype(np.float32).tobytes())
            elif isinstance(value, np.ndarray):
                member.write(value.astype(np.float32).tobytes())
            else:
                member.value = value
        self._arrays[name].render()

    def _sized(self, size: tuple[int, int]) -> dict[str, moderngl.Framebuffer]:
        if size not in self._targets:
            if len(self._targets) >= 3:
                for frame in self._targets.pop(next(iter(self._targets))).values():
                    frame.color_attachments[0].release()
                    frame.release()
            shade = self._context.texture(size, 2, dtype="f2")
            shade.filter = (moderngl.NEAREST, moderngl.NEAREST)
            self._targets[size] = {
                "shade": self._context.framebuffer([shade]),
                "light": self._context.framebuffer([self._context.texture(size, 4)]),
                "smooth": self._context.framebuffer([self._context.texture(size, 4)]),
            }
        return self._targets[size]


class Lighting:
    """A scene's light as the passes take it."""

    def __init__(
        self,
        context: moderngl.Context,
        rooms: Sequence[RoomLight],
        sun: SunMap,
        sun_light: Array,
    ) -> None:
        counts = np.array([room.cube.shape[:3] for room in rooms])
        offsets = np.concatenate([[0], np.cumsum(counts[:, 0])])
        size = (int(offsets[-1]), int(counts[:, 1].max()), int(counts[:, 2].max()))
        volumes = np.zeros((6, size[2], size[1], size[0], 3), dtype=np.float16)
        for room, first in zip(rooms, offsets.tolist(), strict=False):
            x, y, z = room.cube.shape[:3]
            volumes[:, :z, :y, first : first + x] = room.cube.transpose(3, 2, 1, 0, 4)
        sides = [context.texture3d(size, 3, v.tobytes(), alignment=1, dtype="f2") for v in volumes]
        rows = np.zeros((3, ROOMS, 4), dtype=np.float32)
        for k, room in enumerate(rooms[:ROOMS]):
            rows[0, k, :3], rows[1, k, :3] = room.corner_m, room.cell_m
            rows[2, k] = (*counts[k], offsets[k])
        rooms_map, plan = _room_map(context, rooms)
        sun_map = context.texture(
            sun.depth_m.shape[::-1], 1, sun.depth_m.tobytes(), alignment=1, dtype="f4"
        )
        sun_map.filter = (moderngl.NEAREST, moderngl.NEAREST)
        self._textures = (*sides, rooms_map, sun_map)
        self._exposures = {
            room.room.id: _KEY / max(_DARKEST, float(np.median(room.cube))) ** _ADAPTS
            for room in rooms
        }
        self.uniforms: dict[str, Any] = {
            **{f"side_{k}": side for k, side in enumerate(sides)},
            "room_map": rooms_map,
            "sun_map": sun_map,
            "plan": plan,
            "corner": rows[0],
            "cell": rows[1],
            "count": rows[2],
            "cells": size,
            "sun_right": tuple(sun.axes[0]),
            "sun_up": tuple(sun.axes[1]),
            "sun_along": tuple(sun.axes[2]),
            "sun_corner": tuple(sun.corner_m),
            "sun": tuple(sun.towards),
            "sun_light": tuple(sun_light),
            "sun_step": sun.step_m,
        }

    def exposure(self, room_id: int) -> float:
        """By how much light is multiplied in pictures of a room."""
        return self._exposures.get(room_id, 1.0)

    def release(self) -> None:
        """Let go of it."""
        for texture in self._textures:
            texture.release()


def _room_map(
    context: moderngl.Context, rooms: Sequence[RoomLight]
) -> tuple[moderngl.Texture, tuple[float, float, float, float]]:
    """Which room, from 1, each cell of the plan is in, and its corner and cells a metre."""
    outlines = [Polygon(room.room.polygon_m) for room in rooms]
    x0, y0, x1, y1 = shapely.union_all(outlines).buffer(_BESIDE_M).bounds
    columns, rows = int((x1 - x0) / _PLAN_M), int((y1 - y0) / _PLAN_M)
    x, y = np.meshgrid(
        x0 + (np.arange(columns) + 0.5) * _PLAN_M, y0 + (np.arange(rows) + 0.5) * _PLAN_M
    )
    found = np.zeros((rows, columns), dtype=np.uint8)
    for number, outline in enumerate(outlines, start=1):
        wide = outline.buffer(_WALL_M + _PLAN_M / 2, join_style="mitre")
        found[shapely.contains_xy(wide, x, y)] = number
    texture = context.texture((columns, rows), 1, found.tobytes(), alignment=1)
    texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
    texture.repeat_x = texture.repeat_y = False
    return texture, (x0, y0, 1 / (columns * _PLAN_M), 1 / (rows * _PLAN_M))
