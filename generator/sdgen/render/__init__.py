"""Cameras and pictures: where to look from, and what a camera there sees."""

from sdgen.render.backend import choose_renderer
from sdgen.render.frames import Renderer
from sdgen.render.projection import intrinsics, project

__all__ = ["Renderer", "choose_renderer", "intrinsics", "project"]
