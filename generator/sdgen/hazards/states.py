"""A thing of the home brought into a state in a way that its views show."""

from __future__ import annotations

from sdgen.actions import in_state
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng


def changed(
    before: ObjectInstance, state: str, layout: Layout, context: HomeContext, rng: Rng
) -> ObjectInstance | None:
    """The object brought into a state in a way that some view shows: by another leaf, or opened
    less far, it might show in none."""
    ways = context.shows.set_to(before.id, state)
    if ways is None:
        return in_state(before, layout.info(before.id), state, rng)
    return ways[int(rng.integers(len(ways)))] if ways else None
