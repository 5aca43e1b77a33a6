"""Draws what cameras see: colour, depth, and whose every pixel is. Decides nothing."""

from sdgen.render.registry import AUTO, RENDERERS, Choice, choose_renderer, open_renderer

__all__ = ["AUTO", "RENDERERS", "Choice", "choose_renderer", "open_renderer"]
