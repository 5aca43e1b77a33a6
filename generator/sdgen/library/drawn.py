"""Where the drawn parts of a model are: the outline of a variant, moved by its joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sdgen.geometry import Array, apply, box_corners
from sdgen.library.outlines import joined_from_above
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part


@dataclass(frozen=True, eq=False)
class Drawn:
    """Outermost points (N, 3) in the object's frame, piece after piece; a piece is convex.

    Piece k begins at ``starts[k]``. The first ``still`` pieces are where no joint has moved them;
    those that touch from above are one. Each moved part is a piece of its own.
    """

    points_m: Array
    starts: tuple[int, ...]
    still: int

    def within(self, points: Array, piece: int) -> Array:
        """Of as many points as the outline has, those of one piece."""
        return points[self.starts[piece] : (*self.starts, len(self.points_m))[piece + 1]]

    @cached_property
    def box_m(self) -> Array:
        """The lowest and the highest corner, (2, 3)."""
        return np.array([self.points_m.min(axis=0), self.points_m.max(axis=0)])

    @cached_property
    def middle_m(self) -> Array:
        """The middle of its box, (3,)."""
        return np.asarray(self.box_m.mean(axis=0))


def drawn(info: AssetInfo, variant: str, joints: Mapping[str, float]) -> Drawn:
    """The outline of a variant at these values of its joints."""
    moved: tuple[str, ...] = ()
    if any(joints.values()):
        parts = info.variants[variant]
        moved = tuple(part for part in parts if joints.get(info.part(part).joint or "", 0.0))
    rest = _still(info, variant, moved)
    leaves = [
        apply(object_from_part(info, part, joints), np.concatenate(pieces))
        for part in moved
        if (pieces := _pieces(info, part))
    ]
    if not leaves:
        return rest if rest.starts else _still(info, variant, ())
    return _chained([*np.split(rest.points_m, rest.starts[1:]), *leaves], rest.still)


def shut(info: AssetInfo, variant: str) -> Drawn:
    """The outline of a variant with its joints at 0."""
    return _still(info, variant, ())


def _still(info: AssetInfo, variant: str, moved: tuple[str, ...]) -> Drawn:
    """The pieces that no joint has moved, found once; none where all parts have."""
    known = info.known_outlines
    key = (variant, moved)
    if key not in known:
        parts = [part for part in info.variants[variant] if part not in moved]
        pieces = [piece for part in parts for piece in _pieces(info, part)]
        if not pieces and not moved:
            x, y, z = info.extents_m
            pieces = [np.array(box_corners((-x / 2, -y / 2, 0.0), (x / 2, y / 2, z)))]
        known[key] = _chained(_merged(pieces))
    found: Drawn = known[key]
    return found


def _merged(pieces: list[Array]) -> list[Array]:
    """The pieces, those that meet from above as one."""
    group = joined_from_above(pieces)
    return [
        np.concatenate([piece for piece, of in zip(pieces, group, strict=True) if of == k])
        for k in np.unique(group)
    ]


def _pieces(info: AssetInfo, part: str) -> list[Array]:
    return [np.array(points) for points in info.outlines_m.get(part, ()) if points]


def _chained(pieces: list[Array], still: int | None = None) -> Drawn:
    ends = np.cumsum([0, *(len(piece) for piece in pieces)]).tolist()
    points = np.concatenate(pieces) if pieces else np.zeros((0, 3))
    return Drawn(points, tuple(ends[:-1]), len(pieces) if still is None else still)
