"""The space objects take: outlines seen from above, each with a range of heights."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.geometry import Array, apply, box_corners
from sdgen.library import Library
from sdgen.library.above import Above, box_from_above, seen_from_above
from sdgen.library.drawn import shut
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import OPENINGS

#: Heights that meet by less than this do not: things stand on each other.
TOUCH_M = 1e-4
#: A leaf or drawer that is open by less, radians or metres, takes no space of its own.
AJAR = 0.05
#: Owner of the space of a thing that is not placed yet.
NOBODY = -1


@dataclass(frozen=True, eq=False)
class Block:
    """Space an object takes: a convex outline (N, 2) and a range of heights.

    ``box`` holds its lowest and its highest corner (x, y, z).
    """

    owner: int
    outline: Array
    box: Array

    @property
    def high_m(self) -> float:
        """How high it reaches."""
        return float(self.box[5])

    @cached_property
    def shape(self) -> Polygon:
        """The outline as a polygon: only computed for what comes near something."""
        return shapely.polygons(self.outline)

    def same_space(self, other: Block) -> bool:
        """True when both take the very same space."""
        return np.array_equal(self.box, other.box) and np.array_equal(self.outline, other.outline)


def blocks_of(item: ObjectInstance, info: AssetInfo, library: Library) -> list[Block]:
    """Space of an object's body, and of each part that a joint holds open.

    Open-framed furniture (tables, chairs, desks) takes the space of its collision pieces, so that
    a chair goes under a table; everything else takes its box, and a loose thing that lies aslant
    what its box covers, up to where it ends. Raises ValueError for furniture that is tilted.
    """
    world = item.pose.matrix()
    if world[2, 2] != 1.0:
        if item.fixed:
            raise ValueError(f"{item.category} {item.id} does not stand upright")
        return _aslant(item, info, library, world)
    drawn = info.variants[item.variant]
    # Openings sit in walls: only an open leaf takes space in a room.
    if item.fixed and _open_framed(info) and item.category not in OPENINGS:
        pieces = list(_framed(item, info, library, drawn))
    else:
        pieces = []
    if not pieces:
        pieces = list(_boxed(item, info, library, drawn))
    return [block for piece in pieces for block in blocks_at(item.id, piece, world)]


def _aslant(item: ObjectInstance, info: AssetInfo, library: Library, world: Array) -> list[Block]:
    """Space of what came to rest: the parts' boxes, as they lie."""
    lying = []
    for name in info.variants[item.variant]:
        low, high = library.bounds(item.asset)[name].tolist()
        lying.append(
            apply(world @ object_from_part(info, name, item.joints), box_corners(low, high))
        )
    return list(blocks_at(item.id, seen_from_above([np.concatenate(lying)]), np.eye(4)))


def _open_framed(info: AssetInfo) -> bool:
    """Whether nothing but drawers is hollow in a piece: what one reaches into is a box."""
    slides = {joint.name for joint in info.joints if joint.type == "prismatic"}
    return all(hollow.closed_by in slides for hollow in info.containers)


def _framed(
    item: ObjectInstance, info: AssetInfo, library: Library, drawn: Sequence[str]
) -> Iterator[Above]:
    """The collision pieces of the parts at rest, and those of each part that moved."""
    moved = {part for part in drawn if item.joints.get(info.part(part).joint or "", 0.0)}
    still = library.above(item.asset, tuple(part for part in drawn if part not in moved))
    if still is not None:
        yield still
    for part in drawn:
        hulls = [h for h in library.hulls(item.asset) if h.part == part] if part in moved else []
        if hulls:
            local = object_from_part(info, part, item.joints)
            yield seen_from_above([apply(local, hull.vertices_m) for hull in hulls])


def _boxed(
    item: ObjectInstance, info: AssetInfo, library: Library, drawn: Sequence[str]
) -> Iterator[Above]:
    """The object's box, and that of each part that stands open."""
    if item.category not in OPENINGS:
        yield box_from_above(*shut(info, item.variant).box_m.tolist())
    for name in drawn:
        joint = info.part(name).joint
        if joint is None or abs(item.joints.get(joint, 0.0)) < AJAR:
            continue
        low, high = library.bounds(item.asset)[name].tolist()
        local = object_from_part(info, name, item.joints)
        yield seen_from_above([apply(local, box_corners(low, high))])


def blocks_at(owner: int, pieces: Above, world: Array) -> Iterator[Block]:
    """The pieces of an upright object as they lie in the world, ``world`` its 4x4."""
    x, y = pieces.points_m.T
    # One product after another, so that a point comes out the same in whatever company.
    points = np.empty_like(pieces.points_m)
    points[:, 0] = world[0, 0] * x + world[0, 1] * y + world[0, 3]
    points[:, 1] = world[1, 0] * x + world[1, 1] * y + world[1, 3]
    boxes = np.empty((len(pieces.starts), 6))
    boxes[:, 0:2] = np.minimum.reduceat(points, pieces.starts)
    boxes[:, 2] = pieces.low_m + world[2, 3]
    boxes[:, 3:5] = np.maximum.reduceat(points, pieces.starts)
    boxes[:, 5] = pieces.high_m + world[2, 3]
    ends = [*pieces.starts[1:].tolist(), len(points)]
    for start, end, box in zip(pieces.starts.tolist(), ends, boxes, strict=True):
        yield Block(owner, points[start:end], box)


@dataclass(frozen=True)
class Table:
    """Blocks in the order they were put, and their boxes (6, N): a row for each side, as that
    is what they are searched by."""

    blocks: tuple[Block, ...] = ()
    boxes: Array = field(default_factory=lambda: np.empty((6, 0)))

    def more(self, blocks: Iterable[Block]) -> Table:
        """The table with these blocks at its end."""
        added = tuple(blocks)
        if not added:
            return self
        boxes = np.concatenate([self.boxes, _sides(added)], axis=1)
        return Table(self.blocks + added, boxes)

    def entered(self, blocks: Sequence[Block]) -> Iterator[int]:
        """Ids of the other objects whose space these blocks enter, once for every pair."""
        if not blocks:
            return
        if len(blocks) == 1:
            # Most are one thing's box: it meets what is near in one look.
            (block,) = blocks
            for k in _meet(block.box, self.boxes).nonzero()[0].tolist():
                other = self.blocks[k]
                if other.owner != block.owner and block.shape.intersects(other.shape):
                    yield other.owner
            return
        boxes = _sides(blocks)
        whole = np.concatenate([boxes[:3].min(axis=1), boxes[3:].max(axis=1)])
        near = _meet(whole, self.boxes).nonzero()[0]
        if len(near) == 0:
            return
        pairs = _meet(self.boxes[:, near, None], boxes[:, None])
        for its, mine in np.argwhere(pairs).tolist():
            other, block = self.blocks[near[its]], blocks[mine]
            if other.owner != block.owner and block.shape.intersects(other.shape):
                yield other.owner


def _sides(blocks: Sequence[Block]) -> Array:
    """The boxes of blocks, (6, N)."""
    return np.column_stack([block.box for block in blocks])


def _meet(box: Array, others: Array) -> npt.NDArray[np.bool_]:
    """Whether a box (6,) shares space with others (6, N), or (6, M, 1) with (6, 1, N)."""
    x0, y0, low, x1, y1, high = box
    found: npt.NDArray[np.bool_] = (others[3] > x0) & (others[0] < x1)
    found &= (others[4] > y0) & (others[1] < y1)
    found &= (others[5] > low + TOUCH_M) & (others[2] < high - TOUCH_M)
    return found
