"""Hollows of one object that things can be inside of.

The state that counts for a thing inside is that of the very leaf that shuts its hollow: a thing
in the sink's basin is not shut in by the cupboard door below.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from sdgen.geometry import Array, apply, inverse
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part, rule_holds, rules_of
from sdgen.scene import ObjectInstance


class Hollow(NamedTuple):
    """A box in the world that things can be in, the part that has it, and the states of the leaf
    that shuts it."""

    owner: int
    category: str
    fixed: bool
    box_from_world: Array
    half: Array
    states: tuple[str, ...]
    undecided: tuple[str, ...]
    part: str


def hollows_of(item: ObjectInstance, info: AssetInfo, world_from_object: Array) -> Iterator[Hollow]:
    """The containers of an object."""
    drawn = info.variants[item.variant]
    for container in info.containers:
        if container.part in drawn:
            moved = world_from_object @ object_from_part(info, container.part, item.joints)
            moved[:3, 3] = apply(moved, [container.center_m])[0]
            half = np.asarray(container.size_m) / 2
            leaf = _leaf_states(item, info, container.closed_by)
            inner = inverse(moved)
            part = container.part
            yield Hollow(item.id, item.category, item.fixed, inner, half, *leaf, part)


def _leaf_states(
    item: ObjectInstance, info: AssetInfo, joint: str | None
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """States of the leaf that shuts one container, and those it is too near to call."""
    if joint is None:
        return (), ()
    rules = [rule for rule in rules_of(info, item.variant) if rule.joint == joint]
    holding = [r.state for r in rules if rule_holds(r, item.variant, item.joints)]
    return tuple(holding), () if holding else tuple(r.state for r in rules)
