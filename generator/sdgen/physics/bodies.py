"""Turns objects and structures of a scene into Bullet bodies."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array, apply, vec3
from sdgen.library import Library
from sdgen.library.shape import centre_of_mass
from sdgen.library.states import object_from_part
from sdgen.physics.client import Client, convex_obj
from sdgen.scene import Box, ObjectInstance

#: Friction of floors and walls: with a thing's 0.6 it makes 0.48 (Bullet multiplies the two). Eight
#: scenes (seed 7) came to rest in as many steps with 1.2; with 0.3 one of 581 things kept sliding.
STRUCTURE_FRICTION = 0.8
#: Collision geometry kept a library, 10 kB each: the first 60 scenes have 2,000, as drawn joint
#: values are many.
_KEPT = 4000


@dataclass(frozen=True)
class Collision:
    """What an object collides with, joints applied.

    ``obj`` holds its convex pieces around ``com``, the centre of mass in the object's frame;
    ``points`` (N, 3) are all their corners in the object's frame.
    """

    obj: str
    com: Array
    points: Array


_Key = tuple[str, str, tuple[tuple[str, float], ...]]
_known: WeakKeyDictionary[Library, OrderedDict[_Key, Collision]] = WeakKeyDictionary()


def collision_of(library: Library, item: ObjectInstance) -> Collision:
    """Collision geometry of an object, made once for each model, variant and joint values.

    Raises AssetError when no drawn part has a piece.
    """
    kept = _known.setdefault(library, OrderedDict())
    key = (item.asset, item.variant, tuple(sorted(item.joints.items())))
    if key not in kept:
        if len(kept) >= _KEPT:
            kept.popitem(last=False)
        pieces = object_pieces(library, item)
        com = centre_of_mass(pieces)
        obj = convex_obj([piece - com for piece in pieces])
        kept[key] = Collision(obj, com, np.concatenate(pieces))
    kept.move_to_end(key)
    return kept[key]


def object_pieces(library: Library, item: ObjectInstance) -> list[Array]:
    """Convex pieces (N, 3) of the drawn parts in the object's frame, joints applied.

    Raises AssetError when no drawn part has a piece.
    """
    info = library.info(item.asset)
    drawn = set(info.variants[item.variant])
    moved = {name: object_from_part(info, name, item.joints) for name in drawn}
    pieces = [
        apply(moved[hull.part], hull.vertices_m)
        for hull in library.hulls(item.asset)
        if hull.part in drawn
    ]
    if not pieces:
        raise AssetError(
            [f"{item.asset}: variant {item.variant!r} has no collision piece in its hulls"]
        )
    return pieces


def add_piece(client: Client, piece: Box) -> int:
    """One static box of a structure."""
    return client.body(client.box(piece.size_m), piece.center_m, friction=STRUCTURE_FRICTION)


def add_object(
    client: Client, library: Library, item: ObjectInstance, dynamic: bool
) -> tuple[int, Array]:
    """The object as one body; returns it and its centre of mass in the object's frame."""
    info = library.info(item.asset)
    made = collision_of(library, item)
    world_from_object = item.pose.matrix()
    body = client.body(
        # Shapes are made around the centre of mass, so that no inertial frame is needed.
        client.convex(made.obj),
        vec3(apply(world_from_object, made.com)[0]),
        item.pose.quat_xyzw,
        mass_kg=info.mass_kg if dynamic else 0.0,
        friction=info.friction,
    )
    return body, made.com
