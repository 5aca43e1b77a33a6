"""Our own OpenGL without a display: by a GPU, or by Mesa on the CPU."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Collection
from typing import ClassVar

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.render.light.home_light import light_of_home
from sdgen.render.opengl import projection_matrix, scaled, view_matrix
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.raster.buffers import Buffers
from sdgen.render.raster.drawn import drawn_parts
from sdgen.render.raster.geometry import Geometry
from sdgen.render.raster.lighting import Lighting, Passes
from sdgen.render.raster.shaders import GEOMETRY_PIXEL, GEOMETRY_VERTEX
from sdgen.render.raster.shelf import Shelf
from sdgen.scene import Camera, Scene

DEBIAN_PACKAGES = ("libegl1", "libgl1-mesa-dri", "libgl1")
INSTALL_HINT = f"On Debian or Ubuntu: apt-get install {' '.join(DEBIAN_PACKAGES)}"
#: Starting takes half a second; a driver that hangs would hang for ever.
_PROBE_S = 60.0
_PROBE = """
from sdgen.render.raster.renderer import open_context, string_of
print(string_of(open_context()))
"""
#: Buffers of so many picture sizes are kept.
_SIZES = 3


def open_context() -> moderngl.Context:
    """OpenGL without a display. Raises RendererError where none starts."""
    more = {"backend": "egl"} if sys.platform == "linux" else {}
    try:
        return moderngl.create_standalone_context(require=330, **more)
    except Exception as error:  # glcontext raises nothing more special
        raise RendererError(f"OpenGL does not start: {error}") from None


def string_of(context: moderngl.Context) -> str:
    """What draws, for ``dataset.json``."""
    return f"OpenGL {context.info['GL_RENDERER']} {context.info['GL_VERSION']}"


class GlRenderer(Renderer):
    """Draws in one pass. Raises RendererError where no OpenGL 3.3 starts."""

    name: ClassVar[str] = "OpenGL"

    def __init__(self) -> None:
        self._context = open_context()
        self.renderer_string = string_of(self._context)
        self._program = self._context.program(GEOMETRY_VERTEX, GEOMETRY_PIXEL)
        self._shelf = Shelf(self._context)
        self._geometry: Geometry | None = None
        self._buffers: dict[tuple[int, int], Buffers] = {}
        self._passes = Passes(self._context)
        self._lighting: Lighting | None = None

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
        if self._geometry is not None:
            self._geometry.release()
            self._geometry = None
        if self._lighting is not None:
            self._lighting.release()
        parts = drawn_parts(library, scene)
        light = light_of_home(scene, parts)
        self._lighting = Lighting(self._context, light.rooms, light.sun, light.sky.sun)
        self._geometry = Geometry(self._context, self._program, parts, self._shelf)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        self._loaded().show_only(node_ids)

    def draw(self, camera: Camera) -> Picture:
        """What ``camera`` sees of the loaded scene."""
        geometry, buffers = self._loaded(), self._drawn(camera, 1)
        ids = buffers.ids()
        assert self._lighting is not None
        return Picture(
            rgb=self._passes.picture(buffers, camera, _clip(camera, 1), self._lighting),
            depth_m=buffers.depth_m(),
            instance=geometry.nodes[ids],
            part=geometry.numbers[ids],
        )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        raw = np.frombuffer(self._drawn(camera, factor).albedo.read(alignment=1), dtype=np.uint8)
        return np.ascontiguousarray(
            raw.reshape(camera.height * factor, camera.width * factor, 4)[::-1, :, :3]
        )

    def close(self) -> None:
        """Let go of OpenGL; a second call does nothing."""
        if self._geometry is not None:
            self._geometry.release()
            self._geometry = None
        for buffers in self._buffers.values():
            buffers.release()
        self._buffers = {}
        self._shelf.clear()
        self._context.release()

    def _loaded(self) -> Geometry:
        if self._geometry is None:
            raise RendererError("nothing is loaded")
        return self._geometry

    def _drawn(self, camera: Camera, factor: int) -> Buffers:
        width, height = camera.width * factor, camera.height * factor
        buffers = self._sized(width, height)
        clip = _clip(camera, factor)
        buffers.frame.use()
        self._context.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        buffers.frame.clear(0.0, 0.0, 0.0, 0.0)
        self._program["clip_from_world"].write(clip.T.astype(np.float32).tobytes())
        self._loaded().draw(clip)
        return buffers

    def _sized(self, width: int, height: int) -> Buffers:
        if (width, height) not in self._buffers:
            if len(self._buffers) >= _SIZES:
                self._buffers.pop(next(iter(self._buffers))).release()
            self._buffers[width, height] = Buffers(self._context, width, height)
        return self._buffers[width, height]


def _clip(camera: Camera, factor: int) -> npt.NDArray[np.float64]:
    """4x4 that brings points of the world to OpenGL's clip space."""
    k = scaled(np.asarray(camera.K), factor)
    size = (camera.width * factor, camera.height * factor)
    lens = projection_matrix(k, 0, 0, *size, camera.near_m, camera.far_m)
    view = view_matrix(np.asarray(camera.world_from_camera))
    return np.asarray(np.array(lens).reshape(4, 4).T @ np.array(view).reshape(4, 4).T)
