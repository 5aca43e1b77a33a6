"""OpenGL without a display: by a GPU, or by Mesa on the CPU."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from typing import Any, Protocol

import moderngl

from sdgen.errors import RendererError
from sdgen.render.light import HAS_RAYS


class Held(Protocol):
    """Something that takes memory of the renderer's."""

    def release(self) -> None:
        """Let go of it."""


def open_context() -> moderngl.Context:
    """OpenGL without a display. Raises RendererError where none starts."""
    settings: dict[str, Any] = {"backend": "egl"} if sys.platform == "linux" else {}
    try:
        return moderngl.create_standalone_context(require=330, **settings)
    except Exception as error:  # glcontext raises nothing more special
        raise RendererError(f"OpenGL does not start: {error}") from None


def string_of(context: moderngl.Context) -> str:
    """What draws, for ``dataset.json``."""
    light = "" if HAS_RAYS else ", even light"
    return f"EGL {context.info['GL_RENDERER']} {context.info['GL_VERSION']}{light}"


def give(program: moderngl.Program, name: str, value: Any) -> None:
    """Set a uniform. Programs do not have those that they do not use."""
    found = program.get(name, None)
    if isinstance(found, moderngl.Uniform):
        found.value = value


def release_all(held: Iterable[Held]) -> None:
    """Let go of all of these."""
    for one in held:
        one.release()
