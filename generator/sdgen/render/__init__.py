"""Draws what cameras see: colour, depth, and whose every pixel is. Decides nothing."""

from sdgen.render.backend import choose_renderer
from sdgen.render.frames import Renderer

__all__ = ["Renderer", "choose_renderer"]
