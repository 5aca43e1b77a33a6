"""Hoods over stoves: what has a chimney hangs where that ends at the ceiling, or not at all."""

from __future__ import annotations

from sdgen.home.anchors import HUNG_GAP_M
from sdgen.library.records import AssetInfo

HOOD = "range_hood"
#: A hood so high has a chimney: the others end in a lid.
CHIMNEY_M = 0.6
#: Where the underside of a hood with a chimney may be: 0.65 m above a hob, as gas asks for, and as
#: low as one still sees below it.
LOWEST_M, HIGHEST_M = 1.53, 1.78


def underside_of(model: AssetInfo, z_m: float, ceiling_m: float) -> float | None:
    """How high a model hangs that should at ``z_m`` under a ceiling; None where a chimney would be
    cut off below it, or the hood be too low or too high."""
    if model.category != HOOD or model.extents_m[2] < CHIMNEY_M:
        return z_m
    z = ceiling_m - HUNG_GAP_M - model.extents_m[2]
    return z if LOWEST_M <= z <= HIGHEST_M else None
