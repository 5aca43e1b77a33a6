"""Plausibility checks: nothing penetrates, nothing floats. Scene in, violations out."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from sdgen.geometry import Array, apply
from sdgen.library import Library
from sdgen.physics.bodies import add_object, add_piece, collision_of
from sdgen.physics.client import Client, ContactPoint
from sdgen.scene import ObjectInstance, Scene, Violation
from sdgen.vocabulary import FLAT_M, OPENINGS

PENETRATION_LIMIT_M = 0.004
GAP_LIMIT_M = 0.01


@dataclass(frozen=True)
class _Body:
    """One body, whose it is, its box in the world, (2, 3), and what adds it to a client.

    ``shell`` bodies are floors, walls and ceilings; ``covering`` ones lie flat and give way under
    furniture, which are the ``heavy`` ones.
    """

    owner: int
    shell: bool
    covering: bool
    heavy: bool
    bounds: Array
    add: Callable[[], int]


def penetrations(
    library: Library,
    scene: Scene,
    ids: Collection[int] | None = None,
    limit_m: float = PENETRATION_LIMIT_M,
    client: Client | None = None,
) -> list[Violation]:
    """Pairs that overlap by more than ``limit_m``, deepest of each pair, sorted by ids.

    Everything is tested against everything, furniture against furniture, walls, doors and windows
    too, by the convex pieces of what is drawn, joints applied. Two exceptions: floors, walls and
    ceilings are not tested against one another, and furniture presses into the rug it stands on
    (a fixed thing no thicker than ``FLAT_M``); the leaf of a door does not. ``ids`` restricts to
    pairs with one of these objects.
    """
    if client is None:
        with Client() as own:
            return penetrations(library, scene, ids, limit_m, own)
    deepest: dict[tuple[int, int], float] = {}
    # No overlap is deeper than that of the boxes; Bullet's skin may add a fraction of a millimetre.
    for a, b, points in _closest(client, library, scene, ids, -limit_m / 2, 0.0):
        for point in points:
            key = (min(a.owner, b.owner), max(a.owner, b.owner))
            deepest[key] = max(deepest.get(key, 0.0), -point.distance_m)
    return [
        Violation(check="penetration", objects=pair, measured=round(depth, 6), limit=limit_m)
        for pair, depth in sorted(deepest.items())
        if depth > limit_m
    ]


def unsupported(
    library: Library,
    scene: Scene,
    ids: Collection[int] | None = None,
    gap_m: float = GAP_LIMIT_M,
    client: Client | None = None,
) -> list[Violation]:
    """Objects with nothing under them within ``gap_m``; ``fixed`` ones hang on walls and pass.

    ``measured`` is the smallest upward gap found, or 1.0 when there is none near.
    """
    if client is None:
        with Client() as own:
            return unsupported(library, scene, ids, gap_m, own)
    best: dict[int, float] = {}
    for a, b, points in _closest(client, library, scene, ids, gap_m, gap_m):
        for point in points:
            held = _held(a, b, point)
            if held is not None:
                best[held] = min(best.get(held, 1.0), point.distance_m)
    checked = {o.id for o in scene.objects if not o.fixed and (ids is None or o.id in ids)}
    return [
        Violation(check="unsupported", objects=(key,), measured=1.0, limit=gap_m)
        for key in sorted(checked - best.keys())
    ]


def _held(a: _Body, b: _Body, point: ContactPoint) -> int | None:
    """The one of the two that rests on the other, if the contact is a level one."""
    up = point.normal_on_b[2]
    if up > 0.5:
        return a.owner
    if up < -0.5:
        return b.owner
    return None


def _closest(
    client: Client,
    library: Library,
    scene: Scene,
    ids: Collection[int] | None,
    near_m: float,
    reach_m: float,
) -> Iterator[tuple[_Body, _Body, Sequence[ContactPoint]]]:
    """Closest points within ``reach_m`` of every pair whose boxes come within ``near_m``.

    Only bodies of such pairs are made: most of a home is near nothing that matters.
    """
    client.reset()
    pairs = _near_pairs(_bodies(client, library, scene), ids, near_m)
    made: dict[int, int] = {}
    for body in {id(body): body for pair in pairs for body in pair}.values():
        made[id(body)] = body.add()
    for a, b in pairs:
        yield a, b, client.closest(made[id(a)], made[id(b)], reach_m)


def _bodies(client: Client, library: Library, scene: Scene) -> list[_Body]:
    out: list[_Body] = []
    for structure in scene.home.structures:
        for piece in structure.pieces:
            half = np.asarray(piece.size_m) / 2
            bounds = np.array([piece.center_m - half, piece.center_m + half])
            add = partial(add_piece, client, piece)
            out.append(_Body(structure.id, True, False, False, bounds, add))
    for item in sorted(scene.objects, key=lambda o: o.id):
        pose = item.pose.matrix()
        points = apply(pose, collision_of(library, item).points)
        bounds = np.array([points.min(axis=0), points.max(axis=0)])
        add = partial(_add_static, client, library, item)
        covering = item.fixed and library.info(item.asset).extents_m[2] <= FLAT_M
        heavy = item.fixed and not covering and item.category not in OPENINGS
        out.append(_Body(item.id, False, covering, heavy, bounds, add))
    return out


def _add_static(client: Client, library: Library, item: ObjectInstance) -> int:
    body, _ = add_object(client, library, item, dynamic=False)
    return body


def _near_pairs(
    bodies: list[_Body], ids: Collection[int] | None, gap_m: float
) -> list[tuple[_Body, _Body]]:
    """Pairs of different owners whose boxes come within ``gap_m`` (negative: overlap by more), in
    a fixed order; none of the shell alone, and no furniture with the rug under it."""
    if not bodies:
        return []
    low = np.array([b.bounds[0] for b in bodies]) - gap_m
    high = np.array([b.bounds[1] for b in bodies])
    owner = np.array([b.owner for b in bodies])
    shell = np.array([b.shell for b in bodies])
    covering = np.array([b.covering for b in bodies])
    heavy = np.array([b.heavy for b in bodies])
    pressed = covering[:, None] & heavy
    wanted = np.isin(owner, np.array(sorted(ids if ids is not None else set(owner.tolist()))))
    near = (owner[:, None] != owner) & (wanted[:, None] | wanted)
    near &= ~(shell[:, None] & shell) & ~(pressed | pressed.T)
    for axis in range(3):
        near &= low[:, None, axis] <= high[None, :, axis]
        near &= low[None, :, axis] <= high[:, None, axis]
    return [(bodies[i], bodies[j]) for i, j in np.argwhere(np.triu(near, 1)).tolist()]
