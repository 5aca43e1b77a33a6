"""Plausibility checks: nothing penetrates, nothing floats. Scene in, violations out."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sdgen.geometry import Array, apply, matrix, vec3
from sdgen.library import Library
from sdgen.physics.bodies import add_structures, centre_of_mass, object_pieces
from sdgen.physics.client import Client, ContactPoint
from sdgen.scene import Scene, Violation

PENETRATION_LIMIT_M = 0.004
GAP_LIMIT_M = 0.01


@dataclass(frozen=True)
class _Body:
    """One body, whose it is, and its box in the world, (2, 3)."""

    owner: int
    body: int
    fixed: bool
    bounds: Array


def penetrations(
    library: Library,
    scene: Scene,
    ids: Collection[int] | None = None,
    limit_m: float = PENETRATION_LIMIT_M,
    client: Client | None = None,
) -> list[Violation]:
    """Pairs that overlap by more than ``limit_m``, deepest of each pair, sorted by ids.

    Furniture is tested against furniture and walls too. ``ids`` restricts to pairs with one of
    these objects. Things built in (``fixed``) may touch the shell and one another.
    """
    if client is None:
        with Client() as own:
            return penetrations(library, scene, ids, limit_m, own)
    bodies = _build(client, library, scene)
    deepest: dict[tuple[int, int], float] = {}
    for a, b in _near_pairs(bodies, ids, 0.0):
        if a.fixed and b.fixed:
            continue
        for point in client.closest(a.body, b.body, 0.0):
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
    bodies = _build(client, library, scene)
    best: dict[int, float] = {}
    for a, b in _near_pairs(bodies, ids, gap_m):
        for point in client.closest(a.body, b.body, gap_m):
            held = _held(a, b, point)
            if held is not None:
                best[held] = min(best.get(held, 1.0), point.distance_m)
    checked = {b.owner for b in bodies if not b.fixed and (ids is None or b.owner in ids)}
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


def _build(client: Client, library: Library, scene: Scene) -> list[_Body]:
    client.reset()
    pieces_of = {s.id: s.pieces for s in scene.home.structures}
    counts: dict[int, int] = {}
    out: list[_Body] = []
    for body, owner in add_structures(client, scene).items():
        piece = pieces_of[owner][counts.get(owner, 0)]
        counts[owner] = counts.get(owner, 0) + 1
        half = np.asarray(piece.size_m) / 2
        bounds = np.array([piece.center_m - half, piece.center_m + half])
        out.append(_Body(owner, body, True, bounds))
    for item in sorted(scene.objects, key=lambda o: o.id):
        pieces = object_pieces(library, item)
        com = centre_of_mass(pieces)
        shape = client.compound([piece - com for piece in pieces])
        pose = matrix(item.pose.position_m, item.pose.quat_xyzw)
        body = client.body(shape, vec3(apply(pose, com)[0]), item.pose.quat_xyzw)
        points = apply(pose, np.concatenate(pieces))
        bounds = np.array([points.min(axis=0), points.max(axis=0)])
        out.append(_Body(item.id, body, item.fixed, bounds))
    return out


def _near_pairs(
    bodies: list[_Body], ids: Collection[int] | None, gap_m: float
) -> list[tuple[_Body, _Body]]:
    """Pairs of different owners whose boxes come within ``gap_m``, in a fixed order."""
    if not bodies:
        return []
    low = np.array([b.bounds[0] for b in bodies]) - gap_m
    high = np.array([b.bounds[1] for b in bodies])
    overlap = np.ones((len(bodies), len(bodies)), dtype=bool)
    for axis in range(3):
        overlap &= low[:, None, axis] <= high[None, :, axis]
        overlap &= low[None, :, axis] <= high[:, None, axis]
    first, second = np.nonzero(np.triu(overlap, 1))
    pairs = [(bodies[i], bodies[j]) for i, j in zip(first, second, strict=True)]
    return [
        (a, b)
        for a, b in pairs
        if a.owner != b.owner and (ids is None or a.owner in ids or b.owner in ids)
    ]
