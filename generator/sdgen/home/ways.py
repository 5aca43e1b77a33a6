"""What opens can open: nothing stands where the leaves, lids and drawers of furniture go."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import shapely
from shapely.geometry import Polygon

from sdgen.home.blocks import Block, Table, blocks_at
from sdgen.library import Library
from sdgen.library.above import box_from_above
from sdgen.scene import ObjectInstance


@dataclass(frozen=True)
class Ways:
    """The ways of all that opens in a home, and the frames of its doors and windows, which stand
    out of the walls."""

    ways: Table = field(default_factory=Table)
    frames: Table = field(default_factory=Table)

    def with_ways(self, blocks: Iterable[Block]) -> Ways:
        """These and more ways."""
        return replace(self, ways=self.ways.more(blocks))

    def with_frame(self, item: ObjectInstance, library: Library) -> Ways:
        """These, and the frame and the leaf's way of an opening."""
        x, y, z = library.info(item.asset).extents_m
        box = box_from_above((-x / 2, -y / 2, 0.0), (x / 2, y / 2, z))
        frame = blocks_at(item.id, box, item.pose.matrix())
        return replace(self, frames=self.frames.more(frame)).with_ways(way_of(item, library))

    def crossed(self, blocks: Sequence[Block]) -> Iterable[int]:
        """Ids of the objects whose ways these blocks of an object stand in."""
        return self.ways.entered(blocks)

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
