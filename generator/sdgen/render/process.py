"""The one renderer of a process, shared by all who draw in it."""

from __future__ import annotations

import os
from collections.abc import Collection

from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.render.protocol import Picture, Renderer
from sdgen.render.registry import AUTO, Choice, choose_renderer, open_renderer
from sdgen.scene import Camera, Scene


class ProcessRenderer:
    """A renderer that several hold in turn: who draws must be the ``holder``, or load first.

    It starts with the first load, and is closed when the last who loaded something gave it back.
    """

    def __init__(self, kind: str | Choice = AUTO) -> None:
        self.kind = kind
        self.holder: object | None = None
        self._users: set[int] = set()
        self._renderer: Renderer | None = None

    @property
    def renderer_string(self) -> str:
        """What draws; empty before it started."""
        return self._renderer.renderer_string if self._renderer is not None else ""

    def load(self, holder: object, library: Library, scene: Scene) -> None:
        """Put a scene in place of what was loaded before, for this holder. Raises RendererError
        where no renderer starts, or where a process that had one was forked."""
        if self._renderer is None or os.getpid() not in _STARTED:
            if _STARTED and os.getpid() not in _STARTED:
                raise RendererError(
                    "this process was forked from one that draws, and cannot: start processes "
                    "with multiprocessing's 'spawn' or 'forkserver' (AsyncVectorEnv: context=)"
                )
            _STARTED.add(os.getpid())
            self._renderer = open_renderer(self.kind)
        self._users.add(id(holder))
        self.holder = holder
        self._renderer.load(library, scene)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of what was loaded these nodes alone, by id; None: all."""
        self._started().show_only(node_ids)

    def draw(self, camera: Camera, colours: bool = True) -> Picture:
        """What a camera sees of what was loaded; without ``colours``, ``rgb`` is black.
        RendererError where nothing was."""
        return self._started().draw(camera, colours)

    def _started(self) -> Renderer:
        if self._renderer is None:
            raise RendererError("nothing is loaded")
        return self._renderer

    def release(self, holder: object) -> None:
        """What this holder has loaded is of no use any more."""
        if self.holder is holder:
            self.holder = None

    def give_back(self, holder: object) -> None:
        """This holder draws no more; a second call does nothing."""
        self.release(holder)
        self._users.discard(id(holder))
        if not self._users and self._renderer is not None:
            self._renderer.close()
            self._renderer = None


#: One context a process is enough, so whoever draws in one shares it: by process, since one that
#: was forked has none.
_SHARED: dict[tuple[int, str], ProcessRenderer] = {}
#: Processes in which OpenGL was started. One that is forked from them would hang in it.
_STARTED: set[int] = set()


def process_renderer(kind: str = AUTO) -> ProcessRenderer:
    """The renderer of this process of a kind (``auto``: as this machine has it)."""
    if kind == AUTO:
        kind = choose_renderer().kind
    key = os.getpid(), kind
    if key not in _SHARED:
        _SHARED[key] = ProcessRenderer(kind)
    return _SHARED[key]
