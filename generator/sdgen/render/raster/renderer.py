"""Draws scenes by OpenGL: whose every pixel is, then its light."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.render.light.home_light import light_of_home
from sdgen.render.opengl import projection_matrix, scaled, view_matrix
from sdgen.render.outdoors import Outside, SeenOutside, widened
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.raster.buffers import PLACES, Buffers
from sdgen.render.raster.context import give, open_context, string_of
from sdgen.render.raster.drawn import drawn_parts
from sdgen.render.raster.geometry import Geometry, Programs
from sdgen.render.raster.lighting import Box, Lighting, Passes, Targets
from sdgen.render.raster.mirrors import DULL, Mirror, largest, looked_into, mirrors_of
from sdgen.render.raster.shaders import (
    ALBEDO_PIXEL,
    GEOMETRY_VERTEX,
    SOLID_PIXEL,
    VEIL_PIXEL,
)
from sdgen.render.raster.textures import Textures
from sdgen.scene import Camera, Scene

DEBIAN_PACKAGES = ("libegl1", "libgl1-mesa-dri", "libgl1")
INSTALL_HINT = f"On Debian or Ubuntu: apt-get install {' '.join(DEBIAN_PACKAGES)}"
#: Starting takes half a second; a driver that hangs would hang for ever.
_PROBE_S = 60.0
_PROBE = """
from sdgen.render.raster.context import open_context, string_of
print(string_of(open_context()))
"""
#: Buffers of so many picture sizes are kept, and as many of what is in mirrors.
_SIZES = 3
#: OpenGL's name of what leaves out what lies behind a plane.
_CLIP = 0x3000
#: A mirror gives back so much of what it shows.
_GIVES = 0.94


@dataclass(frozen=True, eq=False)
class _Loaded:
    """A scene on the renderer."""

    geometry: Geometry
    lighting: Lighting
    outside: Outside
    mirrors: list[Mirror]

    def release(self) -> None:
        self.geometry.release()
        self.lighting.release()


@dataclass(frozen=True, eq=False)
class _Drawn:
    """What a camera's first pass drew: node and part of each pixel, and where things are that one
    sees through."""

    buffers: Buffers
    targets: Targets
    clip_from_world: npt.NDArray[np.float64]
    instance: npt.NDArray[np.uint16]
    part: npt.NDArray[np.uint8]
    veiled: Box | None


class GlRenderer(Renderer):
    """Draws what each pixel shows in one pass, and lights it in others. Several may draw in turn.
    Raises RendererError where no OpenGL 3.3 starts."""

    name: ClassVar[str] = "EGL"

    def __init__(self) -> None:
        self._context = open_context()
        self.renderer_string = string_of(self._context)
        self._programs: Programs = {
            "solid": self._context.program(GEOMETRY_VERTEX, SOLID_PIXEL),
            "colours": self._context.program(GEOMETRY_VERTEX, ALBEDO_PIXEL),
            "veils": self._context.program(GEOMETRY_VERTEX, VEIL_PIXEL),
        }
        self._textures = Textures(self._context)
        self._passes = Passes(self._context)
        self._sizes: dict[tuple[int, int, bool, bool], tuple[Buffers, Targets]] = {}
        self._scene: _Loaded | None = None
        self._closed = False

    @staticmethod
    def probe() -> Probe:
        """Start OpenGL in a process of its own: a driver may end it, or hang."""
        try:
            done = subprocess.run(
                [sys.executable, "-c", _PROBE],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=_PROBE_S,
                check=False,
            )
        except (OSError, subprocess.SubprocessError) as error:
            return Probe(False, reason=f"the test process failed: {error}", hint=INSTALL_HINT)
        said = (done.stdout + done.stderr).strip().splitlines()
        if done.returncode == 0 and said:
            return Probe(True, said[0])
        why = said[-1][:160] if said else f"the test process ended with code {done.returncode}"
        return Probe(False, reason=why, hint=INSTALL_HINT)

    def load(self, library: Library, scene: Scene) -> None:
        """Put ``scene`` in place of what was loaded before."""
        parts = drawn_parts(library, scene)
        light, outside = light_of_home(library, scene, parts), Outside(library, scene)
        with self._context:
            self._forget()
            geometry = Geometry(self._context, self._programs, parts, self._textures)
            lighting = Lighting(self._context, light)
            self._scene = _Loaded(geometry, lighting, outside, mirrors_of(parts))

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        self._loaded().geometry.show_only(node_ids)

    def draw(self, camera: Camera, colours: bool = True) -> Picture:
        """What ``camera`` sees of the loaded scene; without ``colours``, ``rgb`` is black."""
        with self._context:
            drawn = self._draw(camera, 1, colours)
            black = np.zeros((*drawn.instance.shape, 3), dtype=np.uint8)
            return Picture(
                rgb=self._lit(drawn, camera, smooth=True) if colours else black,
                depth_m=drawn.buffers.depth_m(drawn.veiled is not None),
                instance=drawn.instance,
                part=drawn.part,
            )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        with self._context:
            return self._lit(self._draw(camera, factor), camera, smooth=False)

    def close(self) -> None:
        """Let go of OpenGL; a second call does nothing."""
        if self._closed:
            return
        self._closed = True
        with self._context:
            self._forget()
            for held in self._sizes.values():
                for one in held:
                    one.release()
            self._sizes = {}
            self._textures.clear()
        self._context.release()

    def _forget(self) -> None:
        if self._scene is not None:
            self._scene.release()
            self._scene = None

    def _loaded(self) -> _Loaded:
        if self._scene is None:
            raise RendererError("nothing is loaded")
        return self._scene

    def _draw(
        self,
        camera: Camera,
        factor: int,
        colours: bool = True,
        keep: tuple[float, float, float, float] | None = None,
    ) -> _Drawn:
        """``keep``: what a camera that is turned over at a mirror sees before this plane."""
        geometry = self._loaded().geometry
        fine = factor == 1
        size = (camera.width * factor, camera.height * factor)
        buffers, targets = self._sized(*size, fine, keep is not None)
        clip = _clip(camera, factor)
        for program in self._programs.values():
            give(program, "clip_from_world", tuple(clip.T.ravel()))
            give(program, "keep", keep or (0.0, 0.0, 0.0, 1.0))
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self._context.front_face = "ccw" if keep is None else "cw"
        (self._context.disable_direct if keep is None else self._context.enable_direct)(_CLIP)
        buffers.clear()
        solid, veils = geometry.seen(clip)
        if colours:
            self._draw_colours(geometry, buffers, solid, clip, PLACES if fine else ())
        buffers.solid.use()
        geometry.draw(solid, "solid")
        if veils.any():
            buffers.veils.use()
            geometry.draw(veils, "veils")
        ids = buffers.ids()
        instance, part = geometry.nodes[ids], geometry.numbers[ids]
        veiled = _box(geometry.veils[ids]) if veils.any() else None
        return _Drawn(buffers, targets, clip, instance, part, veiled)

    def _draw_colours(
        self,
        geometry: Geometry,
        buffers: Buffers,
        wanted: npt.NDArray[np.bool_],
        clip: npt.NDArray[np.float64],
        places: Sequence[tuple[float, float]],
    ) -> None:
        """Colours and normals at each of these places of the pixels; none: at their middles."""
        width, height = buffers.size
        buffers.colours.use()
        give(self._programs["colours"], "finer", 0.5 * math.log2(max(1, len(places))))
        for k, (x, y) in enumerate(places or [(0.0, 0.0)]):
            shift = np.eye(4)
            shift[:2, 3] = -2 * x / width, -2 * y / height
            give(self._programs["colours"], "clip_from_world", tuple((shift @ clip).T.ravel()))
            buffers.colours.viewport = (k % 2 * width, k // 2 * height, width, height)
            geometry.draw(wanted, "colours")

    def _lit(
        self, drawn: _Drawn, camera: Camera, smooth: bool, deep: bool = True
    ) -> npt.NDArray[np.uint8]:
        """``deep``: with what is in mirrors."""
        scene = self._loaded()
        outside = scene.outside.seen(drawn.instance, drawn.part, camera, wider=True)
        seen = [outside, *self._in_mirrors(drawn, camera, deep)]
        return self._passes.picture(
            drawn.buffers,
            drawn.targets,
            camera,
            drawn.clip_from_world,
            scene.lighting,
            SeenOutside(*(np.concatenate(one) for one in zip(*seen, strict=True))),
            drawn.veiled,
            smooth,
        )

    def _in_mirrors(self, drawn: _Drawn, camera: Camera, deep: bool) -> Iterator[SeenOutside]:
        """What is seen in the mirrors of a picture."""
        mirrors = self._loaded().mirrors
        factor = drawn.instance.shape[1] // camera.width
        masks = [(drawn.instance == m.node_id) & (drawn.part == m.number) for m in mirrors]
        into = largest([int(mask.sum()) for mask in masks]) if deep else []
        for k, (mirror, mask) in enumerate(zip(mirrors, masks, strict=True)):
            if not mask.any():
                continue
            mask = widened(mask)
            rows, columns = np.nonzero(mask)
            colours = np.tile(DULL, (len(rows), 1))
            once = mask[::factor, ::factor] | mask[factor - 1 :: factor, factor - 1 :: factor]
            looked = looked_into(mirror, camera, once) if k in into and once.any() else None
            if looked is not None:
                behind = self._draw(looked.camera, 1, keep=looked.keep)
                picture = self._lit(behind, looked.camera, smooth=False, deep=False)
                last = np.array(picture.shape[:2]) - 1
                row = np.clip(rows // factor - looked.at[1], 0, last[0])
                column = np.clip(columns // factor - looked.at[0], 0, last[1])
                colours = _GIVES * picture[row, column] + (1 - _GIVES) * colours
            yield SeenOutside(rows, columns, colours, np.ones(len(rows)))

    def _sized(
        self, width: int, height: int, fine: bool, mirrored: bool
    ) -> tuple[Buffers, Targets]:
        size = (width, height, fine, mirrored)
        if size not in self._sizes:
            # Not those of the picture that a mirror is in: it is not done yet.
            alike = [one for one in self._sizes if one[3] == mirrored]
            if len(alike) >= _SIZES:
                for held in self._sizes.pop(alike[0]):
                    held.release()
            buffers = Buffers(self._context, width, height, fine)
            self._sizes[size] = buffers, Targets(self._context, buffers.size, fine)
        return self._sizes[size]


def _box(mask: npt.NDArray[np.bool_]) -> Box | None:
    """Left, bottom, width and height of what is marked in a picture; None: nothing is."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if len(rows) == 0:
        return None
    left, top = int(columns[0]), int(rows[0])
    bottom = mask.shape[0] - 1 - int(rows[-1])
    return left, bottom, int(columns[-1]) + 1 - left, int(rows[-1]) + 1 - top


def _clip(camera: Camera, factor: int) -> npt.NDArray[np.float64]:
    """4x4 that brings points of the world to OpenGL's clip space."""
    k = scaled(np.asarray(camera.K), factor)
    size = (camera.width * factor, camera.height * factor)
    lens = projection_matrix(k, 0, 0, *size, camera.near_m, camera.far_m)
    view = view_matrix(np.asarray(camera.world_from_camera))
    return np.asarray(np.array(lens).reshape(4, 4).T @ np.array(view).reshape(4, 4).T)
