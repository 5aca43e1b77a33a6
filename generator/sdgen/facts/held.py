"""What holds a thing: what it is on or in; a fixed one also the wall or ceiling it hangs on."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sdgen.facts.body import Body, gaps, rows
from sdgen.facts.measured import Measured
from sdgen.facts.thresholds import HUNG_M, ON_GAP_M, ON_SHARE
from sdgen.kleene import NO, YES
from sdgen.scene import Violation
from sdgen.vocabulary import OPENINGS

#: A piece lies at the bottom when it begins within so much of it, metres: higher ones are held by
#: what is too thin to be drawn as touching (an aerial, a leaf). Meshes are rounded to less.
BOTTOM_M = 0.005


def unheld(measured: Measured) -> Iterator[int]:
    """Things that are not fixed and surely rest on nothing: ON and INSIDE nothing, or in the air
    inside of something that has surfaces for what it holds, or with a piece in the air."""
    for key, body in measured.bodies.items():
        if body.item.fixed:
            continue
        on = any(held.holds and held.sure for held in measured.on(key))
        inside = [held.target_id for held in measured.inside(key) if held.holds and held.sure]
        if inside:
            held = on or not all(_floats(measured, body, owner) for owner in inside)
        else:
            held = on and not any(True for _ in hanging_pieces(measured, body))
        if not held:
            yield key


def hanging_pieces(measured: Measured, body: Body) -> Iterator[int]:
    """Pieces of a body, that lie apart from the rest and at its bottom, with less than half of
    their outline on anything: shards beyond the edge of a table."""
    outline = body.outline
    if len(outline.starts) < 2:
        return
    bottom = outline.box_m[0, 2] + BOTTOM_M
    for piece in range(outline.still):
        low = float(outline.within(body.corners, piece)[:, 2].min())
        if (
            outline.within(outline.points_m, piece)[:, 2].min() < bottom
            and ON_SHARE.less(
                measured.supports.carried_share(body.pieces[piece], low, body.item.id)
            )
            == YES
        ):
            yield piece


def _floats(measured: Measured, body: Body, owner: int) -> bool:
    """Nothing is near below a thing in a hollow whose owner has surfaces for such."""
    if not any(s.container is not None for s in measured.bodies[owner].info.supports):
        return False
    low = float(body.low[2])
    surfaces = measured.supports.of(owner)
    if any(ON_GAP_M.at_most(abs(low - surface.z_m)) != NO for surface in surfaces):
        return False
    ids, lows, highs = measured.boxes
    below = (lows[:, :2] <= body.high[:2]).all(axis=1) & (highs[:, :2] >= body.low[:2]).all(axis=1)
    below &= (lows[:, 2] < low) & (highs[:, 2] > low - ON_GAP_M.above)
    return all(ids[k] in (owner, body.item.id) for k in np.flatnonzero(below).tolist())


def in_the_air(measured: Measured) -> Iterator[Violation]:
    """Fixed things ON and INSIDE nothing, and further than ``HUNG_M`` from walls and ceilings.

    ``measured`` of a violation is that distance. Doors and windows fill their openings.
    """
    pieces = [
        piece
        for structure in measured.structures.values()
        if structure.category in ("wall", "ceiling")
        for piece in structure.pieces
    ]
    centers, sizes = rows([p.center_m for p in pieces], 3), rows([p.size_m for p in pieces], 3)
    for key, body in sorted(measured.bodies.items()):
        if not body.item.fixed or body.item.category in OPENINGS:
            continue
        if any(held.holds for held in (*measured.on(key), *measured.inside(key))):
            continue
        apart = gaps(body.low, body.high, centers - sizes / 2, centers + sizes / 2)
        gap = float(apart.min(initial=np.inf))
        if gap > HUNG_M:
            yield Violation(
                check="in_the_air", objects=(key,), measured=round(gap, 6), limit=HUNG_M
            )
