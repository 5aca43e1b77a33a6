"""What Bullet's EGL plugin leaves undone in OpenGL: it frees no textures, and clears its whole
window for every picture."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any


class PluginTextures:
    """Textures made in the current OpenGL context since this was made.

    ``resetSimulation`` has the plugin upload every texture again and never delete the old ones:
    0.6 MB for 256 x 256 pixels, some 700 MB after each time. Without functions to delete them
    (another loader of OpenGL) they stay, and the worker is replaced when it holds too much.
    """

    def __init__(self) -> None:
        self._gen = gl_function("glGenTextures", None, ctypes.c_int, _NAMES)
        self._delete = gl_function("glDeleteTextures", None, ctypes.c_int, _NAMES)
        self._is_texture = gl_function("glIsTexture", ctypes.c_ubyte, ctypes.c_uint)
        # The plugin's own (the white one, the shadow map) are older, and stay.
        self._first = self._last = self._next()

    def free(self) -> None:
        """Delete them all. Nothing that is still drawn may wear one."""
        self._last = max(self._last, self._next())
        names = [k for k in range(self._first, self._last) if self._is_texture(k)]
        if names:
            self._delete(len(names), (ctypes.c_uint * len(names))(*names))

    def _next(self) -> int:
        """The name that OpenGL gives next: names rise, and may be given again when deleted."""
        name = (ctypes.c_uint * 1)()
        self._gen(1, name)
        self._delete(1, name)
        return int(name[0])


class Clip:
    """Confines clearing and drawing to the corner of the window that a picture is read from.

    For every picture the plugin clears its whole window (2560 x 2048), twice, and draws the shadows
    of the scene anew, whose map is larger still: 10 ms on a CPU. The map stays in OpenGL, and is
    the same for all cameras: only a scene's first picture needs all of it.
    """

    def __init__(self) -> None:
        self._box = gl_function("glScissor", None, *[ctypes.c_int] * 4)
        self._enable = gl_function("glEnable", None, ctypes.c_uint)
        self._disable = gl_function("glDisable", None, ctypes.c_uint)
        self._first = True

    def scene_changed(self) -> None:
        """The next picture is the first of another scene."""
        self._first = True

    def __call__(self, width: int, height: int) -> None:
        """The next picture is this large."""
        if self._first:
            self._disable(_SCISSOR_TEST)
            self._first = False
        else:
            self._enable(_SCISSOR_TEST)
            self._box(0, 0, width, height)


_SCISSOR_TEST = 0x0C11
_NAMES = ctypes.POINTER(ctypes.c_uint)


def gl_function(name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    """A function of the OpenGL whose context is current; one that does nothing if there is none."""
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError:
        return lambda *_: 0
    find = egl.eglGetProcAddress
    find.restype, find.argtypes = ctypes.c_void_p, [ctypes.c_char_p]
    address = find(name.encode("ascii"))
    if not address:
        return lambda *_: 0
    return ctypes.CFUNCTYPE(result, *arguments)(address)
