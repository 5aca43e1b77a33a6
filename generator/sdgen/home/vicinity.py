"""What is near a piece of furniture or an opening, and before it."""

from __future__ import annotations

from shapely.geometry import Polygon

from sdgen.geometry import apply
from sdgen.home.layout import Layout
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import OPENINGS


def strip_before(item: ObjectInstance, deep_m: float, layout: Layout) -> Polygon:
    """The floor before a thing's front, as wide as it is; of a door or a window, on both sides."""
    (low, high) = layout.box_of(item)
    x = (low[0] - deep_m if item.category in OPENINGS else high[0], high[0] + deep_m)
    corners = [(x[0], low[1], 0.0), (x[1], low[1], 0.0), (x[1], high[1], 0.0), (x[0], high[1], 0.0)]
    return Polygon(apply(item.pose.matrix(), corners)[:, :2])
