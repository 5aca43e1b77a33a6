"""What a person would say of an overview of a room: by a grid of rays, before it is drawn."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.cameras.sight import HEIGHT, WIDTH, Cast, Ints, pixel_rays
from sdgen.cameras.view import View
from sdgen.geometry import Array
from sdgen.scene import Home

#: Rays across and down an overview, and how far they go: no room is longer.
_RAYS, _FAR_M = (20, 15), 12.0
#: No one thing (a leaf, a bed or a rug, too) takes a quarter of the picture, and nothing is nearer
#: than 0.6 m: a grid is rough, and what is put into the home later takes some more.
MOST_OF_PICTURE, NEAREST_M = 0.23, 0.65
#: What a piece of furniture must take of the picture to be one that is seen, and how many are many.
_PIECE, _MANY = 0.006, 10.0
#: So much of a picture is enough of furniture, and so little enough of a ceiling; so far away is
#: what one sees of a large room, in the mean of logarithms.
_FURNITURE, _CEILING, _WIDE_M = 0.4, 0.03, 4.0


@dataclass(frozen=True, eq=False)
class Judged:
    """Of overviews, (N,) each: how far they miss what must hold (0: all of it holds), and what they
    are worth, up to 1."""

    flaw: Array
    worth: Array


@dataclass(frozen=True)
class Inventory:
    """What the ids of a home at rest are: the room of each thing and structure, ``furniture`` that
    an overview is to show, and ``shell``, floors, walls and ceilings."""

    room_of: Mapping[int, int]
    furniture: Collection[int]
    shell: Mapping[int, str]

    @staticmethod
    def of(home: Home, room_of: Mapping[int, int], furniture: Collection[int]) -> Inventory:
        """The inventory of a home with these things, by id their rooms."""
        shell = {one.id: one.category for one in home.structures}
        rooms = {one.id: one.room_id for one in home.structures}
        return Inventory({**room_of, **rooms}, frozenset(furniture), shell)


def judge(views: Sequence[View], inventory: Inventory, cast: Cast) -> Judged:
    """What each of the overviews is like."""
    columns, rows = _RAYS
    u, v = np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    pixels = np.column_stack([u.ravel() * WIDTH, v.ravel() * HEIGHT]) - 0.5
    rays = [pixel_rays(view.world_from_camera, pixels, _FAR_M) for view in views]
    origins, ends = (np.concatenate(side) for side in zip(*rays, strict=True))
    hits = cast(origins, ends)
    # A ray's share of its length is its planar depth's share of how deep it ends.
    reached = np.minimum(hits.distance_m / np.linalg.norm(ends - origins, axis=1), 1.0) * _FAR_M
    met, depth = (values.reshape(len(views), -1) for values in (hits.object_id, reached))
    flaw, worth = np.zeros(len(views)), np.zeros(len(views))
    for k, view in enumerate(views):
        flaw[k] = _flaw(met[k], depth[k], inventory)
        worth[k] = _worth(met[k], depth[k], view.overview_of, inventory)
    return Judged(flaw, worth)


def _shares(met: Ints) -> dict[int, float]:
    """What share of the rays met what, by id."""
    ids, counts = np.unique(met, return_counts=True)
    return dict(zip(ids.tolist(), (counts / len(met)).tolist(), strict=True))


def _flaw(met: Ints, depth: Array, inventory: Inventory) -> float:
    """How much larger than allowed the largest thing is, and how much nearer the nearest."""
    things = [share for key, share in _shares(met).items() if key and key not in inventory.shell]
    largest = max(things, default=0.0)
    too_large = max(largest / MOST_OF_PICTURE - 1.0, 0.0)
    too_near = max(1.0 - float(depth.min()) / NEAREST_M, 0.0)
    return too_large + too_near


def _worth(met: Ints, depth: Array, room_id: int | None, inventory: Inventory) -> float:
    """Many pieces of the room's furniture, much of it, far walls and where they end above: 1 in
    all."""
    shares = _shares(met)
    own = {key: share for key, share in shares.items() if inventory.room_of.get(key) == room_id}
    pieces = [share for key, share in own.items() if key in inventory.furniture]
    many = sum(share >= _PIECE for share in pieces) / _MANY
    much = sum(pieces) / _FURNITURE
    above = sum(share for key, share in own.items() if inventory.shell.get(key) == "ceiling")
    far = float(np.log(np.minimum(depth, _FAR_M)).mean()) / math.log(_WIDE_M)
    weighed = (
        (0.3, many),
        (0.25, much),
        (0.25, far),
        (0.1, above / _CEILING),
        (0.1, sum(own.values())),
    )
    return sum(weight * min(value, 1.0) for weight, value in weighed)
