"""A scene in Bullet, loaded once: things come to rest in it, go from it and are checked in it."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sdgen.geometry import Array, Vec3, apply, lowest_highest, rotation_matrix, vec3
from sdgen.library import Library
from sdgen.physics.bodies import add_object, add_piece, collision_of
from sdgen.physics.client import Client
from sdgen.scene import ObjectInstance, Pose, Scene
from sdgen.vocabulary import OPENINGS, PRESSED_M

#: A loose thing that is put back by less than this (the rounding of its pose) sleeps on.
NUDGE_M = 1e-4


@dataclass(frozen=True)
class Placed:
    """One body: whose it is, its corners (N, 3) in its owner's frame, and what it counts as.

    ``shell`` bodies are floors, walls and ceilings; ``covering`` ones are fixed, thin and give
    way under furniture, which are the ``heavy`` ones. ``com_m`` is the body's origin in the
    object's frame, (3,).
    """

    body: int
    owner: int
    corners_m: Array
    com_m: Array
    item: ObjectInstance | None = None
    loose: bool = False
    covering: bool = False
    heavy: bool = False

    @cached_property
    def bounds(self) -> Array:
        """Its box in the world, (2, 3): only computed for what is asked for it."""
        frame = np.eye(4) if self.item is None else self.item.pose.matrix()
        return np.array(lowest_highest(apply(frame, self.corners_m)))

    @property
    def origin_m(self) -> Vec3:
        """Where its item's pose has its origin."""
        frame = np.eye(4) if self.item is None else self.item.pose.matrix()
        return vec3(apply(frame, self.com_m)[0])

    @property
    def shell(self) -> bool:
        """True for a piece of a floor, a wall or a ceiling."""
        return self.item is None


class World:
    """The bodies of one scene in a client of its own for as long as it is used.

    Starts empty; :meth:`become` loads a scene, and changes to another one of the same home with
    no more work than there are changes. What happens in it follows from these calls alone.
    """

    def __init__(self, library: Library, client: Client) -> None:
        client.reset()
        self.client = client
        self._library = library
        self._shell: list[Placed] = []
        self._things: dict[int, Placed] = {}

    @property
    def placed(self) -> list[Placed]:
        """Every body, the shell's first, then by object id."""
        return [*self._shell, *(self._things[key] for key in sorted(self._things))]

    @property
    def loose(self) -> Mapping[int, Placed]:
        """What moves, by object id, sorted."""
        return {key: self._things[key] for key in sorted(self._things) if self._things[key].loose}

    def become(self, scene: Scene, loose: Collection[int]) -> None:
        """Be this scene, with ``loose`` things free to move and all others fixed.

        Things that are not in it go, changed ones are made anew, loose ones are put to their
        poses. What touched something that went or changed wakes up; what slept and is put back to
        within ``NUDGE_M`` sleeps on. Raises AssetError for an object without collision pieces and
        KeyError for a loose id that the scene has not.
        """
        if not self._shell:
            self._add_shell(scene)
        items = {item.id: item for item in scene.objects}
        for key in loose:
            if key not in items:
                raise KeyError(key)
        self._drop([key for key, one in self._things.items() if _differs(one, items, loose)])
        for key in sorted(items):
            item, before = items[key], self._things.get(key)
            if before is None:
                self._things[key] = self._add(item, key in loose)
            elif before.item is not None and before.item.pose != item.pose:
                self._put_back(before, item)

    def start_anew(self) -> None:
        """Have all stand as in the scene that this is, awake, and nothing touch anything yet: what
        loading it again would do, in a thirtieth of the time."""
        for one in self.placed:
            if one.item is not None and one.loose:
                self.client.place(one.body, one.origin_m, one.item.pose.quat_xyzw)
                self.client.wake(one.body)
            # In the order in which they are loaded, by which Bullet sorts what meets.
            self.client.forget(one.body, one.loose)

    def _add_shell(self, scene: Scene) -> None:
        for structure in sorted(scene.home.structures, key=lambda s: s.id):
            for piece in structure.pieces:
                half = np.asarray(piece.size_m) / 2
                ends = np.array([piece.center_m - half, piece.center_m + half])
                body = add_piece(self.client, piece)
                self._shell.append(Placed(body, structure.id, ends, np.zeros(3)))

    def _add(self, item: ObjectInstance, loose: bool) -> Placed:
        body, com = add_object(self.client, self._library, item, loose)
        thin = item.fixed and self._library.assets[item.asset].extents_m[2] <= PRESSED_M
        return Placed(
            body=body,
            owner=item.id,
            corners_m=collision_of(self._library, item).points,
            com_m=com,
            item=item,
            loose=loose,
            covering=thin,
            heavy=item.fixed and not thin and item.category not in OPENINGS,
        )

    def _drop(self, going: Collection[int]) -> None:
        bodies = {self._things[key].body for key in going}
        if not bodies:
            return
        touched = {
            body
            for point in self.client.contacts()
            for body in (point.a, point.b)
            if (point.a in bodies) != (point.b in bodies)
        }
        for key in sorted(going):
            self.client.remove(self._things.pop(key).body)
        for one in self.loose.values():
            if one.body in touched:
                self.client.wake(one.body)

    def _put_back(self, before: Placed, item: ObjectInstance) -> None:
        after = replace(before, item=item)
        apart = math.dist(after.origin_m, self.client.pose(before.body).position_m)
        self.client.place(before.body, after.origin_m, item.pose.quat_xyzw)
        if apart > NUDGE_M:
            self.client.wake(before.body)
        self._things[item.id] = after

    def pose(self, key: int) -> Pose:
        """Where an object's frame is now, not rounded."""
        one = self._things[key]
        at = self.client.pose(one.body)
        offset = rotation_matrix(at.quat_xyzw) @ one.com_m
        return Pose(position_m=vec3(np.asarray(at.position_m) - offset), quat_xyzw=at.quat_xyzw)


def _differs(one: Placed, items: Mapping[int, ObjectInstance], loose: Collection[int]) -> bool:
    """True when the body is of no use for the new item of its id; a loose one may just move."""
    before, after = one.item, items.get(one.owner)
    if before is None or after is None or one.loose != (one.owner in loose):
        return True
    if not one.loose and before.pose != after.pose:
        return True
    return (before.asset, before.variant, before.joints, before.fixed) != (
        after.asset,
        after.variant,
        after.joints,
        after.fixed,
    )


@contextmanager
def standing(library: Library, scene: Scene, client: Client | None = None) -> Iterator[World]:
    """A scene as it stands, nothing of it loose; a client is made unless one is lent."""
    if client is None:
        with Client() as own, standing(library, scene, own) as world:
            yield world
        return
    world = World(library, client)
    world.become(scene, ())
    yield world
