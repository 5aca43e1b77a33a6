"""Sizes: as large as such things are, in any yaw, and in which unit they would be."""

from __future__ import annotations

from itertools import permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.load import load_catalog
from sdgen.importing.sizes import (
    PLAUSIBLE,
    UNITS,
    difference,
    fits,
    misfit,
    scaled,
    turned,
    unit_suspected,
)

CATALOG = load_catalog()
MUG, SOFA, KNIFE = (CATALOG.category(name) for name in ("mug", "sofa", "knife"))
#: Of things with sides of their own; a tenth of a puddle is a puddle.
CATEGORIES = [c for c in CATALOG.categories if c.kind in ("small", "furniture")]


def middle(name: str) -> tuple[float, float, float]:
    category = CATALOG.category(name)
    sides = zip(category.extents_min_m, category.extents_max_m, strict=True)
    deep, wide, high = ((low * high) ** 0.5 for low, high in sides)
    return deep, wide, high


@pytest.mark.parametrize("category", CATEGORIES, ids=lambda category: category.name)
def test_what_is_in_the_middle_of_a_range_fits_in_any_yaw(category) -> None:  # type: ignore[no-untyped-def]
    deep, wide, high = middle(category.name)
    for extents in ((deep, wide, high), (wide, deep, high)):
        assert misfit(extents, category) == 1.0
        assert fits(extents, category)
        assert not turned(extents, category)
        assert difference(extents, category) == ""
        assert unit_suspected(extents, category) is None


@pytest.mark.parametrize("unit", UNITS)
def test_a_mug_in_the_wrong_unit_is_seen_to_be_one(unit: float) -> None:
    extents = scaled((0.12, 0.09, 0.1), 1 / unit)
    assert not fits(extents, MUG)
    assert unit_suspected(extents, MUG) == unit
    assert difference(extents, MUG).endswith(f"scaled by {unit:g} it would fit")


def test_a_mug_of_40_m_would_be_one_in_centimetres_or_so() -> None:
    # 8 to 15 cm high: 40 m are no centimetres of that, they are in half-millimetres.
    assert unit_suspected((40.0, 40.0, 40.0), MUG) is None
    assert unit_suspected((12.0, 9.0, 10.0), MUG) == 0.01


def test_what_is_a_little_large_is_large_and_in_no_other_unit() -> None:
    wide = (0.9, 2.6, 0.8)
    assert fits(wide, SOFA)
    assert difference(wide, SOFA) == "2.6 m wide (sofa: 1.3 to 2.5 m)"
    wider = (0.9, 4.0, 0.8)
    assert not fits(wider, SOFA)
    assert unit_suspected(wider, SOFA) is None


def test_what_stands_on_its_tip_would_fit_on_another_side() -> None:
    upright = (0.023, 0.009, 0.228)
    assert turned(upright, KNIFE)
    assert not fits(upright, KNIFE)
    assert difference(upright, KNIFE).endswith("with another side up it would fit")
    assert unit_suspected(upright, KNIFE) is None


SIDE = st.floats(1e-4, 100.0)


@given(SIDE, SIDE, SIDE, st.sampled_from(CATEGORIES))
def test_yaw_does_not_matter_and_what_fits_is_suspected_of_nothing(
    deep: float, wide: float, high: float, category: object
) -> None:
    here = CATALOG.category(category.name)  # type: ignore[attr-defined]
    size = (deep, wide, high)
    assert misfit(size, here) == misfit((wide, deep, high), here) >= 1.0
    assert (difference(size, here) == "") is (misfit(size, here) == 1.0)
    unit = unit_suspected(size, here)
    if unit is not None:
        assert not fits(size, here)
        assert fits(scaled(size, unit), here)
    if turned(size, here):
        assert any(fits((a, b, c), here, PLAUSIBLE) for a, b, c in permutations(size))


@pytest.mark.parametrize("bad", [(0.0, 0.0, 0.0), (float("nan"),) * 3, (float("inf"),) * 3])
def test_no_size_at_all_fits_nothing(bad: tuple[float, float, float]) -> None:
    assert not fits(bad, SOFA)
    assert unit_suspected(bad, SOFA) is None
