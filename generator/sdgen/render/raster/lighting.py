"""Light of one scene on the renderer, and pictures by it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import moderngl
import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.geometry import Array, Vec3, vec3
from sdgen.render.light.floors import STEP_M
from sdgen.render.light.home_light import HomeLight
from sdgen.render.light.rooms import RoomLight
from sdgen.render.outdoors import SeenOutside
from sdgen.render.raster.buffers import PLACES, Buffers
from sdgen.render.raster.context import give, release_all
from sdgen.render.raster.light_shaders import (
    BLUR,
    EDGE,
    EDGE_SUNLESS,
    LIGHT,
    LIGHT_SUNLESS,
    SHADE,
    SMOOTH,
    VEIL,
)
from sdgen.render.raster.shaders import FULL_VERTEX
from sdgen.scene import Camera
from sdgen.vocabulary import DayTime

#: Cells of the map that says which room a point of the plan is in, metres; rooms reach as far as
#: the middle of their walls. It counts to 255.
_PLAN_M, _WALL_M = 0.04, 0.06
_BESIDE_M = 0.5
_MOST_ROOMS = 255
#: How bright the middle of a room is to be by the time of day, how far dark rooms are brought up to
#: it, and how far the colour of their light is taken out, as a camera does.
_KEY: dict[DayTime, float] = {"day": 1.25, "evening": 1.1, "night": 0.9}
_ADAPTS, _WHITENS = 0.9, 0.6
#: Rooms that are seen through a doorway are brought so far to a brightness of their own, as by the
#: eye: no hall in the sun burns out beyond the door of a dim room.
_ADAPTS_BEYOND = 0.65
#: At least so much light is reckoned with: it takes some to see anything.
_DARKEST = 0.02
#: How bright red, green and blue look (Rec. 709).
_LUMINANCE = np.array((0.2126, 0.7152, 0.0722))
#: Shade is found once for so many pixels along each side.
_COARSE = 2
_PASSES = {
    "shade": SHADE,
    "blur": BLUR,
    "light": LIGHT,
    "light_sunless": LIGHT_SUNLESS,
    "edge": EDGE,
    "edge_sunless": EDGE_SUNLESS,
    "veil": VEIL,
    "smooth": SMOOTH,
}

#: Left, bottom, width and height in pixels of a picture.
Box = tuple[int, int, int, int]


class Targets:
    """What the passes over pictures of one size draw into."""

    def __init__(self, context: moderngl.Context, size: tuple[int, int], fine: bool) -> None:
        self.pixel = (1 / size[0], 1 / size[1])
        small = (max(1, size[0] // _COARSE), max(1, size[1] // _COARSE))
        self.size, self.coarse = size, small
        self.shade, self.blurred = (context.texture(small, 2, dtype="f2") for _ in range(2))
        self.light, self.smooth, self.world = (context.texture(size, 4) for _ in range(3))
        self.light.repeat_x = self.light.repeat_y = False
        # Pixels with edges, side by side: where they lie, and their colours.
        edges = size if fine else (1, 1)
        self.spots, self.edges = context.texture(edges, 2, dtype="f4"), context.texture(edges, 4)
        self.frames = {
            "shade": context.framebuffer([self.shade]),
            "blur": context.framebuffer([self.blurred]),
            "light": context.framebuffer([self.light]),
            "edge": context.framebuffer([self.edges]),
            "smooth": context.framebuffer([self.smooth]),
        }

    def release(self) -> None:
        """Let go of all of it."""
        textures = (self.shade, self.blurred, self.light, self.smooth, self.world)
        release_all([*self.frames.values(), *textures, self.spots, self.edges])


class Passes:
    """The programs that light and smooth a picture."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], dtype=np.float32).tobytes())
        self._programs = {
            name: context.program(FULL_VERTEX, pixel) for name, pixel in _PASSES.items()
        }
        self._arrays = {
            name: context.vertex_array(program, [(corners, "2f", "at")])
            for name, program in self._programs.items()
        }

    def picture(
        self,
        buffers: Buffers,
        targets: Targets,
        camera: Camera,
        clip_from_world: Array,
        light: Lighting,
        seen: SeenOutside,
        veiled: Box | None,
        smooth: bool,
    ) -> npt.NDArray[np.uint8]:
        """Colours of what is in the buffers, by this light, (H, W, 3). ``seen`` is painted in;
        ``veiled``: left, bottom, width and height of the pixels of what is seen through."""
        place = {**_place(camera), "exposure": light.expose(camera.room_id)}
        self._context.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        clip = tuple(clip_from_world.T.ravel())
        solid = {"normal_map": buffers.normal, "depth_map": buffers.depth}
        shade = {**place, "clip_from_world": clip, "size": targets.size}
        self._run("shade", targets.frames["shade"], shade, solid)
        last = (targets.coarse[0] - 1, targets.coarse[1] - 1)
        self._run("blur", targets.frames["blur"], {"last": last}, {"shade_map": targets.shade})
        outdoors = len(seen.rows) > 0
        if outdoors:
            targets.world.write(_world(buffers.size, seen), alignment=1)
        values = {
            **place,
            **light.uniforms,
            "coarse": targets.coarse,
            "apart": buffers.apart,
            "outdoors": outdoors,
            "range": (camera.near_m, camera.far_m),
            "size": targets.size,
            "clip_from_world": clip,
            "samples": PLACES,
        }
        textures = {
            "depth_map": buffers.depth,
            "normal_map": buffers.fine_normal,
            "albedo_map": buffers.albedo,
            "fine_depth_map": buffers.fine_depth,
            "shade_map": targets.blurred,
            "world_map": targets.world,
            **light.textures,
        }
        kind = "" if light.sunny else "_sunless"
        self._run(f"light{kind}", targets.frames["light"], values, textures)
        if buffers.fine:
            self._edges(f"edge{kind}", targets, values, {**textures, "spots": targets.spots})
        if veiled is not None:
            self._veil(buffers, targets, place, light, veiled)
        if smooth:
            edge = {"pixel": targets.pixel, "last": (targets.size[0] - 1, targets.size[1] - 1)}
            self._run("smooth", targets.frames["smooth"], edge, {"picture": targets.light})
        done = targets.frames["smooth" if smooth else "light"]
        raw = np.frombuffer(done.read(components=3, alignment=1), dtype=np.uint8)
        return np.ascontiguousarray(raw.reshape(*buffers.size[::-1], 3)[::-1])

    def _edges(
        self,
        program: str,
        targets: Targets,
        values: Mapping[str, Any],
        textures: Mapping[str, moderngl.Texture | moderngl.Texture3D],
    ) -> None:
        """Light once more the pixels whose samples differ, sample by sample. They are gathered
        first: a CPU that draws would light all others, too."""
        width = targets.size[0]
        raw = targets.frames["light"].read(components=4, alignment=1)
        colours = np.frombuffer(raw, dtype=np.uint32).copy()
        edges = np.flatnonzero(colours >> 24)
        if len(edges) == 0:
            return
        rows = -(-len(edges) // width)
        spots = np.zeros((rows * width, 2), dtype=np.float32)
        spots[: len(edges)] = np.stack([edges % width, edges // width], axis=1)
        box, frame = (0, 0, width, rows), targets.frames["edge"]
        targets.spots.write(spots.tobytes(), viewport=box, alignment=1)
        frame.viewport = box
        self._run(program, frame, values, textures)
        found = np.frombuffer(frame.read(viewport=box, components=4, alignment=1), dtype=np.uint32)
        colours[edges] = found[: len(edges)]
        targets.light.write(colours.tobytes(), alignment=1)

    def _veil(
        self,
        buffers: Buffers,
        targets: Targets,
        place: Mapping[str, Any],
        light: Lighting,
        box: Box,
    ) -> None:
        veils = {
            "normal_map": buffers.veil_normal,
            "depth_map": buffers.veil_depth,
            "veil_map": buffers.veil,
        }
        frame = targets.frames["light"]
        frame.scissor = box
        self._context.enable(moderngl.BLEND)
        self._run("veil", frame, {**place, **light.uniforms}, {**veils, **light.textures})
        self._context.disable(moderngl.BLEND)
        # Not all of it: that would stay for what is drawn next, which may be larger.
        frame.scissor = None  # type: ignore[assignment]  # moderngl forgets to say so

    def _run(
        self,
        name: str,
        target: moderngl.Framebuffer,
        values: Mapping[str, Any],
        textures: Mapping[str, moderngl.Texture | moderngl.Texture3D],
    ) -> None:
        """Draw all of a target; a program takes those values and textures that it has."""
        target.use()
        program, unit = self._programs[name], 0
        for key, value in values.items():
            give(program, key, value)
        for key, texture in textures.items():
            if key in program:
                texture.use(unit)
                give(program, key, unit)
                unit += 1
        self._arrays[name].render()


def _place(camera: Camera) -> dict[str, Any]:
    """Where a camera is, and which rays its picture's corners are."""
    pose, k = np.asarray(camera.world_from_camera), np.asarray(camera.K)
    # Rows of textures go up, rows of pictures go down.
    left, low = -(k[0, 2] + 0.5) / k[0, 0], (camera.height - k[1, 2] - 0.5) / k[1, 1]
    return {
        "world_from_camera": tuple(pose.T.ravel()),
        "lens": (left, low, camera.width / k[0, 0], -camera.height / k[1, 1]),
        "eye": tuple(pose[:3, 3]),
    }


class Lighting:
    """A scene's light as the passes take it."""

    def __init__(self, context: moderngl.Context, light: HomeLight) -> None:
        rooms, sun = light.rooms[:_MOST_ROOMS], light.sun
        counts = np.array([room.cube.shape[:3] for room in rooms])
        offsets = np.concatenate([[0], np.cumsum(counts[:, 0])])
        size = (int(offsets[-1]), int(counts[:, 1].max()), int(counts[:, 2].max()))
        volumes = np.zeros((6, size[2], size[1], size[0], 3), dtype=np.float16)
        table = np.zeros((len(rooms), 4, 4), dtype=np.float32)
        for k, (room, first) in enumerate(zip(rooms, offsets.tolist(), strict=False)):
            x, y, z = room.cube.shape[:3]
            volumes[:, :z, :y, first : first + x] = room.cube.transpose(3, 2, 1, 0, 4)
            table[k, 0, :3], table[k, 1, :3] = room.corner_m, room.cell_m
            table[k, 2] = (x, y, z, first)
        deep = 6 * size[2]
        sides = context.texture3d(
            (size[0], size[1], deep), 3, volumes.tobytes(), alignment=1, dtype="f2"
        )
        room_map, plan = _room_map(context, rooms)
        self.textures: dict[str, moderngl.Texture | moderngl.Texture3D] = {
            "sides": sides,
            "room_map": room_map,
            "rooms": _plain(context, table),
        }
        self.uniforms: dict[str, Any] = {
            "plan": plan,
            "cells": (size[0], size[1], deep),
            "side": size[2],
        }
        shade, corner = np.ones((1, 1), dtype=np.float32), np.zeros(2)
        if light.floor is not None:
            corner, shade = light.floor
        self.textures["floor_map"] = _floor_map(context, shade)
        self.uniforms["floor_plan"] = (*corner, STEP_M * shade.shape[1], STEP_M * shade.shape[0])
        self.sunny = sun is not None
        if sun is not None:
            self.textures["sun_map"] = _plain(context, sun.depth_m[..., None])
            self.uniforms |= {
                "sun_right": tuple(sun.axes[0]),
                "sun_up": tuple(sun.axes[1]),
                "sun_along": tuple(sun.axes[2]),
                "sun_corner": tuple(sun.corner_m),
                "sun": tuple(sun.towards),
                "sun_light": tuple(light.sky.sun),
                "sun_step": sun.step_m,
                "sun_highest": min(sun.highest_m, 1e6),
            }
        self._exposures = {room.room.id: _exposure(room, light.time) for room in rooms}
        self._table = table

    def expose(self, room_id: int) -> Vec3:
        """Expose pictures for a room: by how much red, green and blue are multiplied there, which
        is returned, and in the rooms beyond its doors."""
        here = self._exposures.get(room_id, (1.0, 1.0, 1.0))
        own = np.array([*self._exposures.values()]).reshape(-1, 3)
        self._table[:, 3, :3] = np.array(here) ** (1 - _ADAPTS_BEYOND) * own**_ADAPTS_BEYOND
        self.textures["rooms"].write(self._table.tobytes(), alignment=1)
        return here

    def release(self) -> None:
        """Let go of it."""
        for texture in self.textures.values():
            texture.release()


def _exposure(room: RoomLight, time: DayTime) -> Vec3:
    colour = np.maximum(np.median(room.cube.reshape(-1, 3), axis=0), 1e-6)
    light = float(colour @ _LUMINANCE)
    gain = _KEY[time] / max(_DARKEST, light) ** _ADAPTS * (light / colour) ** _WHITENS
    return vec3(gain)


def _world(size: tuple[int, int], seen: SeenOutside) -> bytes:
    """Colours of what is seen outside and how much of it is, (H, W, 4), rows going up."""
    out = np.zeros((size[1], size[0], 4), dtype=np.uint8)
    colours = np.concatenate([seen.colours, 255.0 * seen.share[:, None]], axis=1)
    out[size[1] - 1 - seen.rows, seen.columns] = np.rint(colours)
    return out.tobytes()


def _plain(context: moderngl.Context, values: npt.NDArray[np.float32]) -> moderngl.Texture:
    """Numbers (H, W, N) to be fetched one by one."""
    height, width, channels = values.shape
    texture = context.texture((width, height), channels, values.tobytes(), alignment=1, dtype="f4")
    texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
    return texture


def _floor_map(context: moderngl.Context, share: npt.NDArray[np.float32]) -> moderngl.Texture:
    """Shares (H, W) of light, 0 to 1, to be looked up between points."""
    height, width = share.shape
    values = np.rint(np.clip(share, 0.0, 1.0) * 255).astype(np.uint8)
    texture = context.texture((width, height), 1, values.tobytes(), alignment=1)
    texture.repeat_x = texture.repeat_y = False
    return texture


def _room_map(
    context: moderngl.Context, rooms: Sequence[RoomLight]
) -> tuple[moderngl.Texture, tuple[float, float, float, float]]:
    """Which room, from 1, each cell of the plan is in, and its corner and cells a metre."""
    outlines = [Polygon(room.room.polygon_m) for room in rooms]
    x0, y0, x1, y1 = shapely.union_all(outlines).buffer(_BESIDE_M).bounds
    columns, rows = int((x1 - x0) / _PLAN_M), int((y1 - y0) / _PLAN_M)
    found = np.zeros((rows, columns), dtype=np.uint8)
    for number, outline in enumerate(outlines, start=1):
        wide = outline.buffer(_WALL_M + _PLAN_M / 2, join_style="mitre")
        low, high = np.array(wide.bounds[:2]) - (x0, y0), np.array(wide.bounds[2:]) - (x0, y0)
        (i0, j0), (i1, j1) = (low / _PLAN_M).astype(int), (high / _PLAN_M).astype(int) + 1
        x, y = np.meshgrid(
            x0 + (np.arange(i0, i1) + 0.5) * _PLAN_M, y0 + (np.arange(j0, j1) + 0.5) * _PLAN_M
        )
        found[j0:j1, i0:i1][shapely.contains_xy(wide, x, y)] = number
    texture = context.texture((columns, rows), 1, found.tobytes(), alignment=1)
    texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
    texture.repeat_x = texture.repeat_y = False
    return texture, (x0, y0, 1 / (columns * _PLAN_M), 1 / (rows * _PLAN_M))
