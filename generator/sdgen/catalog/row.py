"""How people fill a shelf: one entry of ``rows`` of a piece of furniture."""

from __future__ import annotations

from typing import Annotated

from sdgen.catalog.words import (
    PAIR,
    Categories,
    OptionalCategories,
    RoomNames,
    between,
    span,
)
from sdgen.scene import Record


class Row(Record):
    """Things ``of`` these categories side by side, as far as they live there, over this share of a
    shelf's length; so done on this ``chance`` of the shelves in rooms of these types (none: all).
    A ``top`` under the open air takes no row unless it is said to.

    ``same``: all are of one model, as glasses of a set are. ``pile``: so many of one model lie on
    each other. ``over_m``: how far they may reach over the shelf's edge, as shoes do. ``wide``:
    wide models stand there more often than narrow ones. ``at_back``: at the back of the shelf, as
    on a chest, not at its front edge. In what the row leaves over stands one
    thing of ``beside``, where it is wide enough.
    """

    of: Categories
    rooms: RoomNames = ()
    chance: Annotated[float, between(0.0, 1.0)] = 1.0
    filled: Annotated[tuple[float, float], span(0.0, 1.0), PAIR] = (0.6, 0.9)
    top: bool = False
    same: bool = False
    # Higher ones creep in the simulation.
    pile: Annotated[tuple[int, int], span(1, 3, whole=True), PAIR] = (1, 1)
    # Past half of a thing it would tip.
    over_m: Annotated[float, between(0.0, 0.1)] = 0.0
    wide: bool = False
    at_back: bool = False
    beside: OptionalCategories = ()
