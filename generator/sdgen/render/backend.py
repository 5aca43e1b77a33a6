"""Starts Bullet's renderers: EGL where it works, else the CPU's TinyRenderer."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from dataclasses import dataclass
from typing import Literal

from sdgen.errors import RendererError
from sdgen.physics.bullet import pb, quiet

Kind = Literal["auto", "egl", "cpu"]

DEBIAN_PACKAGES = ("libegl1", "libgl1-mesa-dri", "libgl1")
CPU_RENDERER = "TinyRenderer"

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


@dataclass(frozen=True)
class Choice:
    """The renderer that will be used, its string, and why it is not EGL if it is not."""

    kind: Literal["egl", "cpu"]
    renderer_string: str
    reason: str = ""


def choose_renderer(kind: Kind) -> Choice:
    """Find out which renderer ``kind`` means on this machine (0.5 s: one short process).

    Raises RendererError when EGL was asked for and does not start.
    """
    if kind == "cpu":
        return Choice("cpu", CPU_RENDERER)
    found = probe_egl()
    if found.works:
        return Choice("egl", found.renderer_string)
    if kind == "egl":
        raise RendererError(
            f"the EGL renderer does not start: {found.reason.rstrip('.')}. {install_hint()}"
        )
    return Choice("cpu", CPU_RENDERER, found.reason)


def install_hint() -> str:
    """What to install so that EGL starts."""
    return f"On Debian or Ubuntu: apt-get install {' '.join(DEBIAN_PACKAGES)}"


@dataclass(frozen=True)
class EglProbe:
    """Whether EGL starts, on what, and the first sign of what is wrong."""

    works: bool
    renderer_string: str = ""
    reason: str = ""


def probe_egl() -> EglProbe:
    """Start EGL in a process of its own, which may die of it."""
    plugin = plugin_path()
    if plugin is None:
        return EglProbe(False, reason="this PyBullet has no EGL plugin (eglRenderer)")
    try:
        done = subprocess.run(
            [sys.executable, "-c", _PROBE, plugin],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=60,
            check=False,
        )
    except (OSError, subprocess.SubprocessError) as error:
        return EglProbe(False, reason=f"the test process failed: {error}")
    if done.returncode == 0:
        return EglProbe(True, _renderer_in(done.stdout))
    return EglProbe(False, reason=_first_complaint(done.stdout + done.stderr, done.returncode))


def plugin_path() -> str | None:
    """File of the EGL plugin that comes with PyBullet, if it does."""
    found = importlib.util.find_spec("eglRenderer")
    return found.origin if found is not None else None


def _first_complaint(text: str, code: int) -> str:
    for line in text.splitlines():
        if re.search(r"fail|error|cannot|could not|not found", line, re.IGNORECASE):
            return line.strip()[:160]
    return f"the test process ended with code {code}"


def _renderer_in(text: str) -> str:
    values = dict(re.findall(r"^(GL_\w+)=(.*)$", text, re.MULTILINE))
    parts = [values.get("GL_RENDERER", "").strip(), values.get("GL_VERSION", "").strip()]
    return "EGL " + " ".join(part for part in parts if part)


def start_egl(client: int) -> str:
    """Load the plugin into ``client``; returns the renderer string.

    Call only after :func:`choose_renderer` said EGL works. Raises RendererError.
    """
    plugin = plugin_path()
    with quiet() as caught:
        handle = (
            -1
            if plugin is None
            else pb.loadPlugin(plugin, "_eglRendererPlugin", physicsClientId=client)
        )
    if handle < 0:
        raise RendererError(f"the EGL plugin could not be loaded. {install_hint()}")
    return _renderer_in(caught.text)
