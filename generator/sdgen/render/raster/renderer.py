"""Draws scenes by OpenGL: whose every pixel is, then its light."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import ClassVar

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.render.light.home_light import light_of_home
from sdgen.render.opengl import projection_matrix, scaled, view_matrix
from sdgen.render.outdoors import Outside
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.raster.buffers import PLACES, Buffers
from sdgen.render.raster.context import give, open_context, string_of
from sdgen.render.raster.drawn import drawn_parts
from sdgen.render.raster.geometry import Geometry, Programs
from sdgen.render.raster.lighting import Box, Lighting, Passes, Targets
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
#: Buffers of so many picture sizes are kept.
_SIZES = 3


@dataclass(frozen=True, eq=False)
class _Loaded:
    """A scene on the renderer."""

    geometry: Geometry
    lighting: Lighting
    outside: Outside

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
        self._sizes: dict[tuple[int, int, bool], tuple[Buffers, Targets]] = {}
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
            self._scene = _Loaded(geometry, Lighting(self._context, light), outside)

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

    def _draw(self, camera: Camera, factor: int, colours: bool = True) -> _Drawn:
        geometry = self._loaded().geometry
        fine = factor == 1
        buffers, targets = self._sized(camera.width * factor, camera.height * factor, fine)
        clip = _clip(camera, factor)
        for program in self._programs.values():
            give(program, "clip_from_world", tuple(clip.T.ravel()))
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
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

    def _lit(self, drawn: _Drawn, camera: Camera, smooth: bool) -> npt.NDArray[np.uint8]:
        scene = self._loaded()
        return self._passes.picture(
            drawn.buffers,
            drawn.targets,
            camera,
            drawn.clip_from_world,
            scene.lighting,
            scene.outside.seen(drawn.instance, drawn.part, camera, wider=True),
            drawn.veiled,
            smooth,
        )

    def _sized(self, width: int, height: int, fine: bool) -> tuple[Buffers, Targets]:
        size = (width, height, fine)
        if size not in self._sizes:
            if len(self._sizes) >= _SIZES:
                for one in self._sizes.pop(next(iter(self._sizes))):
                    one.release()
            buffers = Buffers(self._context, *size)
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
