"""What a home's views show of a scene, and which of them its pictures are; by rays alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from sdgen.cameras.counted import shows_pixels
from sdgen.cameras.cover import CANONICAL, near_count
from sdgen.cameras.framing import RAYS_SHARE, Bools, glance_pixels, uncut
from sdgen.cameras.outdoors import looks_out, outer_opening
from sdgen.cameras.parts import part_area, part_points
from sdgen.cameras.sight import Cast
from sdgen.cameras.view import View, poses_of
from sdgen.library import Library
from sdgen.scene import Scene
from sdgen.seeding import Rng
from sdgen.vocabulary import EVIDENCE_PIXELS


@dataclass(frozen=True)
class Marked:
    """An anomaly or a near miss: its object, the parts that show it (empty = all), and how many
    pixels of these, and of the outdoors through the opening that it fills, do at the reference
    size; of each object ``beside`` a glance is to be seen with it."""

    object_id: int
    parts: tuple[str, ...] = ()
    pixels: int = EVIDENCE_PIXELS
    outdoors: int = 0
    beside: tuple[int, ...] = ()


def shows(
    library: Library, scene: Scene, cast: Cast, views: Sequence[View], marked: Sequence[Marked]
) -> Bools:
    """Which view shows which marked thing, all contents in place, (views, marked)."""
    poses = poses_of(views)
    out = np.zeros((len(views), len(marked)), dtype=np.bool_)
    for k, one in enumerate(marked):
        item = scene.object(one.object_id)
        whole, telling = (part_points(library, item, parts) for parts in ((), one.parts))
        out[:, k] = uncut(poses, whole, telling)
        for parts, share in _asked(one):
            among = np.flatnonzero(out[:, k])
            needed = share * glance_pixels(part_area(library, item, parts))
            out[among, k] = shows_pixels(library, item, cast, poses[among], parts, needed)
        for key in one.beside:
            among, other = np.flatnonzero(out[:, k]), scene.object(key)
            needed = glance_pixels(part_area(library, other, ()))
            out[among, k] = shows_pixels(library, other, cast, poses[among], (), needed)
        if one.outdoors:
            among = np.flatnonzero(out[:, k])
            opening = outer_opening(scene.home, item.id)
            out[among, k] = looks_out(cast, list(poses[among]), opening, RAYS_SHARE * one.outdoors)
    return out


def _asked(one: Marked) -> Iterator[tuple[tuple[str, ...], float]]:
    """The parts that a view must show, and what of a glance's pixels: of few pixels of a part
    alone nobody could say what it belongs to."""
    yield one.parts, one.pixels / EVIDENCE_PIXELS
    if one.pixels < EVIDENCE_PIXELS:
        yield (), 1.0


def pick(
    views: Sequence[View], shown: Bools, anomalies: Sequence[bool], count: int, rng: Rng
) -> list[View]:
    """``count`` of the views: the canonical ones and as many of the rest, or fewer.

    ``shown`` says which canonical view shows which marked thing, ``anomalies`` which of these are
    anomalies. Fewer views show as many marked things as they can, whatever these are; but where
    one view more than there are anomalies is asked for, no anomaly is left out.
    """
    if count >= min(CANONICAL, len(views)):
        return list(views[:count])
    canonical = views[:CANONICAL]
    must = np.array(anomalies, dtype=np.bool_)
    must &= count > must.sum()
    best: tuple[float, ...] = ()
    chosen: tuple[int, ...] = ()
    for among in combinations(range(len(canonical)), count):
        seen = shown[list(among)].any(axis=0)
        near = sum(canonical[k].kind == "near" for k in among)
        value = (
            -float((must & ~seen).sum()),
            -abs(near - near_count(count)),
            float(seen.sum()),
            float(rng.random()),
        )
        if not best or value > best:
            best, chosen = value, among
    return [canonical[k] for k in chosen]
