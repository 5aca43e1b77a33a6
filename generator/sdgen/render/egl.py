"""Bullet's EGL plugin: OpenGL without a display, by a GPU or by Mesa on the CPU."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from collections.abc import Collection
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.physics.bullet import pb, quiet
from sdgen.render.bullet import BulletGraphics
from sdgen.render.gl import Clip, PluginTextures
from sdgen.render.overhead import Solid, fill_ceilings, fill_overhead, overhead
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.shell import LIGHT_M
from sdgen.scene import Camera, Scene, Structure

DEBIAN_PACKAGES = ("libegl1", "libgl1-mesa-dri", "libgl1")
INSTALL_HINT = f"On Debian or Ubuntu: apt-get install {' '.join(DEBIAN_PACKAGES)}"
#: Starting takes half a second; a driver that hangs would hang for ever.
_PROBE_S = 60.0

# EGL calls exit() in the process it fails in, so it is tried in another one first.
_PROBE = """
import sys
import pybullet as pb
client = pb.connect(pb.DIRECT)
plugin = pb.loadPlugin(sys.argv[1], "_eglRendererPlugin", physicsClientId=client)
if plugin < 0:
    sys.exit(3)
pb.getCameraImage(16, 16, renderer=pb.ER_BULLET_HARDWARE_OPENGL, physicsClientId=client)
sys.stdout.flush()
"""


class EglRenderer(Renderer):
    """Draws with the plugin. Start it only where :meth:`probe` says it works: EGL ends the
    process it fails in. Raises RendererError when the plugin cannot be loaded."""

    name: ClassVar[str] = "EGL"

    def __init__(self) -> None:
        self._graphics = BulletGraphics(
            pb.ER_BULLET_HARDWARE_OPENGL,
            face_levels=True,
            on_reset=lambda: self._textures.free(),
            before_tile=lambda width, height: self._clip(width, height),
        )
        self.renderer_string = _load_plugin(self._graphics.client)
        self._ceilings: tuple[Structure, ...] = ()
        self._overhead: tuple[Solid, ...] = ()
        with quiet():
            _warm_up(self._graphics.client)
        self._textures = PluginTextures()
        self._clip = Clip()

    @staticmethod
    def probe() -> Probe:
        """Start EGL in a process of its own, which may die of it."""
        plugin = plugin_path()
        if plugin is None:
            return _refusal("this PyBullet has no EGL plugin (eglRenderer)")
        try:
            done = subprocess.run(
                [sys.executable, "-c", _PROBE, plugin],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=_PROBE_S,
                check=False,
            )
        except (OSError, subprocess.SubprocessError) as error:
            return _refusal(f"the test process failed: {error}")
        if done.returncode == 0:
            return Probe(True, _renderer_in(done.stdout))
        return _refusal(_first_complaint(done.stdout + done.stderr, done.returncode))

    def load(self, library: Library, scene: Scene) -> None:
        """Put ``scene`` in place of what was loaded before."""
        self._overhead = overhead(library, scene)
        self._clip.scene_changed()
        self._graphics.load(library, scene, {solid.node_id for solid in self._overhead})
        self._ceilings = tuple(s for s in scene.home.structures if s.category == "ceiling")

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        self._graphics.show_only(node_ids)

    def draw(self, camera: Camera) -> Picture:
        """What ``camera`` sees of the loaded scene."""
        picture = self._graphics.draw(camera)
        fill_ceilings(picture.depth_m, picture.instance, camera, self._ceilings)
        fill_overhead(picture.depth_m, picture.instance, camera, self._overhead)
        return picture

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        return self._graphics.draw_colours(camera, factor)

    def close(self) -> None:
        """Let go of the graphics; a second call does nothing."""
        with quiet():
            self._graphics.close()


def plugin_path() -> str | None:
    """File of the EGL plugin that comes with PyBullet, if it does."""
    found = importlib.util.find_spec("eglRenderer")
    return found.origin if found is not None else None


def _load_plugin(client: int) -> str:
    """Load the plugin into ``client``; returns the renderer string."""
    plugin = plugin_path()
    with quiet() as caught:
        handle = (
            -1
            if plugin is None
            else pb.loadPlugin(plugin, "_eglRendererPlugin", physicsClientId=client)
        )
    if handle < 0:
        raise RendererError(f"the EGL plugin could not be loaded. {INSTALL_HINT}")
    return _renderer_in(caught.text)


def _warm_up(client: int) -> None:
    """The first two frames of a process differ from all later ones by a rounding level."""
    view = pb.computeViewMatrix((3, 0, 1), (0, 0, 0), (0, 0, 1))
    lens = pb.computeProjectionMatrixFOV(60, 1.0, 0.1, 10.0)
    box = pb.createVisualShape(
        pb.GEOM_BOX,
        halfExtents=(0.5, 0.5, 0.5),
        rgbaColor=(1, 1, 1, 1),
        physicsClientId=client,
    )
    body = pb.createMultiBody(0, -1, box, physicsClientId=client)
    for _ in range(3):
        pb.getCameraImage(
            32,
            32,
            view,
            lens,
            lightDirection=LIGHT_M,
            renderer=pb.ER_BULLET_HARDWARE_OPENGL,
            physicsClientId=client,
        )
    pb.removeBody(body, physicsClientId=client)


def _refusal(reason: str) -> Probe:
    return Probe(False, reason=reason, hint=INSTALL_HINT)


def _first_complaint(text: str, code: int) -> str:
    for line in text.splitlines():
        if re.search(r"fail|error|cannot|could not|not found", line, re.IGNORECASE):
            return line.strip()[:160]
    return f"the test process ended with code {code}"


def _renderer_in(text: str) -> str:
    values = dict(re.findall(r"^(GL_\w+)=(.*)$", text, re.MULTILINE))
    parts = [values.get("GL_RENDERER", "").strip(), values.get("GL_VERSION", "").strip()]
    return "EGL " + " ".join(part for part in parts if part)
