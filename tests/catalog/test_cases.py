"""What recipes make."""

from __future__ import annotations

import pytest
from pydantic import ValidationError
from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.records import PlaceRecipe, SetRecipe, UniqueAnomaly


def test_each_category_meets_each_target_in_the_order_written() -> None:
    recipe = PlaceRecipe(
        categories=("vase", "mug"),
        state="BROKEN",
        relation="ON",
        targets=("desk", "floor"),
        rooms=("kitchen",),
        avoid_zones=("doorway",),
        max_height_m=1.0,
    )
    found = cases(recipe)
    assert [(case.category, case.target) for case in found] == [
        ("vase", "desk"),
        ("vase", "floor"),
        ("mug", "desk"),
        ("mug", "floor"),
    ]
    shared = {(c.state, c.relation, c.rooms, c.avoid_zones, c.max_height_m) for c in found}
    assert shared == {("BROKEN", "ON", ("kitchen",), ("doorway",), 1.0)}
    assert unique_anomaly("spill", found[1]) == UniqueAnomaly(
        hazard="spill",
        category="vase",
        state="BROKEN",
        relation="ON",
        target="floor",
        room="kitchen",
    )


def test_what_is_set_has_no_target() -> None:
    (case,) = cases(SetRecipe(categories=("stove",), state="ON"))
    assert (case.category, case.state, case.relation, case.target) == ("stove", "ON", None, None)


def test_a_recipe_has_a_weight() -> None:
    """It is divided by."""
    with pytest.raises(ValidationError, match="greater than 0"):
        SetRecipe(categories=("stove",), state="ON", weight=0.0)
