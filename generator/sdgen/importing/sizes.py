"""Whether a thing is as large as a category's are, and in which unit it would be."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from sdgen.catalog.records import Category
from sdgen.geometry import Vec3

#: A model is as large as a category's things when no side is off by more than this factor: our
#: ranges are of what shops sell, and scans come in any yaw.
PLAUSIBLE = 1.25
#: Metres; of flat things a factor says nothing.
_FLAT_M = 0.003
#: What files are measured in, in place of metres: centimetres, millimetres, inches, decimetres; and
#: what was divided by 10 or 100 too often.
UNITS = (0.01, 0.001, 0.0254, 0.1, 10.0, 100.0)
#: By less than this a thing is rather large or small; no unit is wrong by so little.
_UNIT_OFF = 2.5
_SIDES = ("deep", "wide", "high")


def misfit(extents_m: Vec3, category: Category) -> float:
    """By which factor the worst side is outside the category's range, in the better of two yaws.

    1 when all are within. ``extents_m``: deep, wide, high, metres.
    """
    return min(misfit_as_it_stands(turned, category) for turned in _yaws(extents_m))


def fits(extents_m: Vec3, category: Category, factor: float = PLAUSIBLE) -> bool:
    """True when a thing this large may well be one of the category."""
    return misfit(extents_m, category) <= factor


def turned(extents_m: Vec3, category: Category, factor: float = PLAUSIBLE) -> bool:
    """True when it would be as large as such things are if another side were up."""
    sides = permutations(extents_m)
    return not fits(extents_m, category, factor) and any(
        misfit_as_it_stands((deep, wide, high), category) <= factor for deep, wide, high in sides
    )


def unit_suspected(extents_m: Vec3, category: Category) -> float | None:
    """The scale with which the thing would be as large as the category's are.

    None when it is so already or nearly, on whatever side, or with no scale that files are known
    to be wrong by.
    """
    if misfit(extents_m, category) < _UNIT_OFF or turned(extents_m, category):
        return None
    found = [(misfit(scaled(extents_m, unit), category), unit) for unit in UNITS]
    # The commoner unit, where two fit as well.
    best, unit = min(found, key=lambda item: item[0])
    return unit if best <= PLAUSIBLE else None


def scaled(extents_m: Vec3, by: float) -> Vec3:
    """The extents of a thing made larger."""
    return (extents_m[0] * by, extents_m[1] * by, extents_m[2] * by)


def difference(extents_m: Vec3, category: Category) -> str:
    """What is outside the category's range, and what would mend it; empty when nothing is."""
    best = min(_yaws(extents_m), key=lambda yaw: misfit_as_it_stands(yaw, category))
    sides = [
        f"{value:.3g} m {side} ({category.name}: {least:g} to {most:g} m)"
        for side, (value, least, most) in zip(_SIDES, _limits(best, category), strict=True)
        if _off(value, least, most) > 1.0
    ]
    mended = ""
    if turned(extents_m, category):
        mended = "; with another side up it would fit"
    elif (unit := unit_suspected(extents_m, category)) is not None:
        mended = f"; scaled by {unit:g} it would fit"
    return ", ".join(sides) + mended


def in_metres(extents_m: Vec3) -> str:
    """``0.12 x 0.09 x 0.1 m``."""
    return " x ".join(f"{value:.3g}" for value in extents_m) + " m"


def _yaws(extents_m: Vec3) -> tuple[Vec3, Vec3]:
    deep, wide, high = extents_m
    return extents_m, (wide, deep, high)


def _limits(extents_m: Vec3, category: Category) -> Iterator[tuple[float, float, float]]:
    return zip(extents_m, category.extents_min_m, category.extents_max_m, strict=True)


def misfit_as_it_stands(extents_m: Vec3, category: Category) -> float:
    return max(_off(value, least, most) for value, least, most in _limits(extents_m, category))


def _off(value: float, least: float, most: float) -> float:
    """By which factor a side is too long or too short; 1 when it is neither."""
    if least - _FLAT_M <= value <= most + _FLAT_M:
        return 1.0
    if value <= 0.0:
        return float("inf")
    return max(value / most, least / value)
