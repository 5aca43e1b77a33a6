"""What opens can open: nothing stands where the leaves, lids and drawers of furniture go, nor where
somebody stands who opens them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.home.blocks import Block, Table, blocks_at
from sdgen.library import Library
from sdgen.library.above import box_from_above
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import FLAT_M

#: Who opens a piece stands so far before it: a body is 0.5 m across with the arms at its sides. It
#: takes the middle of the front, this share of it, and reaches to the ends from there (by eye).
STAND_M, STAND_SHARE = 0.5, 0.5
#: What hangs higher than this leaves room to stand before something: a shoulder's height.
SHOULDER_M = 1.2


@dataclass(frozen=True)
class Ways:
    """The ways of all that opens in a home, where people stand to open it, and the frames of its
    doors and windows, which stand out of the walls."""

    ways: Table = field(default_factory=Table)
    stands: Table = field(default_factory=Table)
    frames: Table = field(default_factory=Table)

    def with_ways(self, blocks: Iterable[Block]) -> Ways:
        """These and more ways."""
        return replace(self, ways=self.ways.more(blocks))

    def with_stands(self, blocks: Iterable[Block]) -> Ways:
        """These, and more places to stand."""
        return replace(self, stands=self.stands.more(blocks))

    def with_frame(self, item: ObjectInstance, library: Library) -> Ways:
        """These, and the frame and the leaf's way of an opening."""
        x, y, z = library.info(item.asset).extents_m
        box = box_from_above((-x / 2, -y / 2, 0.0), (x / 2, y / 2, z))
        frame = blocks_at(item.id, box, item.pose.matrix())
        return replace(self, frames=self.frames.more(frame)).with_ways(way_of(item, library))

    def crossed(self, blocks: Sequence[Block]) -> Iterable[int]:
        """Ids of the objects whose ways, or places to stand, these blocks of an object are in."""
        yield from self.ways.entered(blocks)
        yield from self.stands.entered(blocks)

    def clear(self, way: Sequence[Block], room: Polygon, height_m: float) -> bool:
        """True when a way lies in the room, clear of frames."""
        return (
            max(block.high_m for block in way) <= height_m
            and bool(shapely.covers(room, [block.shape for block in way]).all())
            and not any(True for _ in self.frames.entered(way))
        )


def way_of(item: ObjectInstance, library: Library) -> list[Block]:
    """Where the leaves, lids and drawers of an object go as they open."""
    way = library.way(item.asset)
    return [] if way is None else list(blocks_at(item.id, way, item.pose.matrix()))


def stand_of(item: ObjectInstance, library: Library) -> list[Block]:
    """Where somebody stands who opens a piece of furniture: before the middle of what opens, which
    is most of its front, but of a corner unit a narrow leaf in its notch.

    Nowhere for what does not open, and for what hangs: one stands before what is below it.
    """
    info = library.info(item.asset)
    moving = [part.name for part in info.parts if part.joint is not None]
    if not moving or item.pose.position_m[2] > FLAT_M:
        return []
    bounds = library.bounds(item.asset)
    low = np.min([bounds[name][0] for name in moving], axis=0)
    high = np.max([bounds[name][1] for name in moving], axis=0)
    middle = float(low[1] + high[1]) / 2
    half = float(high[1] - low[1]) / 2 * STAND_SHARE
    points = np.concatenate(
        [np.array(piece) for pieces in info.outlines_m.values() for piece in pieces]
    )
    before = np.abs(points[:, 1] - middle) <= float(high[1] - low[1]) / 2
    front = float(max(high[0], points[before, 0].max(initial=-np.inf)))
    box = box_from_above(
        (front, middle - half, FLAT_M), (front + STAND_M, middle + half, SHOULDER_M)
    )
    return list(blocks_at(item.id, box, item.pose.matrix()))
