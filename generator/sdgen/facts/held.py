"""What holds a thing: what it is on or in; a fixed one also the wall or ceiling it hangs on."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sdgen.facts.body import gaps, rows
from sdgen.facts.measured import Measured
from sdgen.facts.thresholds import HUNG_M
from sdgen.scene import Violation
from sdgen.vocabulary import OPENINGS


def unheld(measured: Measured) -> Iterator[int]:
    """Things that are not fixed and are surely ON or INSIDE nothing."""
    for key, body in measured.bodies.items():
        if not body.item.fixed and not any(
            held.holds and held.sure for held in (*measured.on(key), *measured.inside(key))
        ):
            yield key


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
