"""The renderers there are, and which one a machine uses. A new one needs its line here."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

from sdgen.errors import RendererError, did_you_mean

if TYPE_CHECKING:
    from sdgen.render.protocol import Renderer

#: Name → module and class, imported when asked for. ``auto`` takes the first one that starts.
RENDERERS: Mapping[str, str] = {
    "egl": "sdgen.render.raster.renderer:GlRenderer",
    "cpu": "sdgen.render.tiny:TinyRenderer",
}
AUTO = "auto"


@dataclass(frozen=True)
class Choice:
    """The renderer that will be used, its string, and a line about those that do not start."""

    kind: str
    renderer_string: str
    note: str = ""


def renderer_type(kind: str) -> type[Renderer]:
    """The class of a renderer by its name. Raises RendererError for an unknown one."""
    if kind not in RENDERERS:
        hint = did_you_mean(kind, [AUTO, *RENDERERS])
        raise RendererError(f"no renderer {kind!r}{hint}")
    module, _, name = RENDERERS[kind].partition(":")
    found: type[Renderer] = getattr(import_module(module), name)
    return found


def choose_renderer(kind: str = AUTO) -> Choice:
    """Find out which renderer ``kind`` means on this machine (EGL: 0.5 s, one short process).

    Raises RendererError when the one asked for does not start, or none does.
    """
    refused: list[tuple[str, str, str]] = []
    for name in RENDERERS if kind == AUTO else (kind,):
        made_by = renderer_type(name)
        found = made_by.probe()
        if found.works:
            lines = [
                f"{what} does not start ({why}); going on with {made_by.name}. {hint}".rstrip()
                for what, why, hint in refused
            ]
            return Choice(name, found.renderer_string, " ".join(lines))
        refused.append((made_by.name, found.reason.rstrip("."), found.hint))
    raise RendererError(
        " ".join(f"{what} does not start: {why}. {hint}".rstrip() for what, why, hint in refused)
    )


def open_renderer(kind: str | Choice = AUTO) -> Renderer:
    """Start a renderer: by name, or as another process has chosen already.

    Raises RendererError when it does not start.
    """
    choice = kind if isinstance(kind, Choice) else choose_renderer(kind)
    return renderer_type(choice.kind)()
