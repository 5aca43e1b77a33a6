"""A table with a box on it before a camera, drawn by hand, and toy scenes perceived."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from sdgen.perception import Kinds, Perceived, Perception, View, perceive
from sdgen.scene import Scene

from tests import toy


@lru_cache
def kinds() -> Kinds:
    """What is known of classes, from the toy models."""
    return Kinds(toy.catalog(), toy.infos().values())


def views_of(made: Scene, size: tuple[int, int] = (320, 240), count: int = 2) -> list[View]:
    """The toy cameras' pictures of a toy scene."""
    options = toy.small(width=size[0], height=size[1], views=count)
    bundle = toy.bundle(made.index, options)
    drawn = (
        toy.toy_pictures.frame(made, toy.camera(k, options), toy.infos()) for k in range(count)
    )
    assert bundle.scene.home == made.home
    return [View(f.camera, f.instance, f.depth_mm, f.part) for f in drawn]


def perceived(made: Scene, views: Sequence[View] | None = None, **how: Any) -> Perceived:
    """A toy scene perceived."""
    views = views_of(made) if views is None else views
    return perceive(made, toy.infos(), kinds(), views, Perception(**how))


def without_part(view: View) -> View:
    """The same picture, all of every object one part."""
    part = (np.asarray(view.instance) > 0).astype(np.uint8)
    return View(view.camera, view.instance, view.depth_mm, part)


def facts_about(graph: Any, ids: set[int]) -> set[tuple[int, int, str]]:
    """Edges of a graph between these nodes."""
    return {
        (e.from_id, e.to_id, e.relation_type)
        for e in graph.edges
        if e.from_id in ids and e.to_id in ids
    }
