"""Outlines as rectangles."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.importing.scenes.rectangles import joined, main_turn, merged, rectangles_of, turned
from shapely import box, union_all
from shapely.geometry import Polygon

side = st.integers(1, 40).map(lambda value: value / 10)
corner = st.integers(-50, 50).map(lambda value: value / 10)
boxes = st.lists(st.tuples(corner, corner, side, side), min_size=1, max_size=6)


@given(boxes)
def test_unions_of_boxes_come_back_exactly(drawn: list[tuple[float, float, float, float]]) -> None:
    shape = union_all([box(x, y, x + a, y + b) for x, y, a, b in drawn])
    found = rectangles_of(shape)
    assert joined(found).symmetric_difference(shape).area < 1e-6
    for k, one in enumerate(found):
        assert all(box(*one).intersection(box(*other)).area < 1e-9 for other in found[:k])


@given(st.floats(-0.7, 0.7), boxes)
def test_a_turn_is_found(angle: float, drawn: list[tuple[float, float, float, float]]) -> None:
    shape = union_all([box(x, y, x + a, y + b) for x, y, a, b in drawn])
    found = main_turn([turned(shape, angle)])
    # Square on themselves: a quarter circle more or less is the same.
    assert abs(math.remainder(found - angle, math.pi / 2)) < 2e-4


def test_an_aslant_side_becomes_stairs_of_about_its_area() -> None:
    shape = Polygon([(0, 0), (4, 0), (4, 2), (2, 4), (0, 4)])
    found = joined(rectangles_of(shape))
    assert found.area == pytest.approx(shape.area, rel=0.2)


def test_lines_near_each_other_are_one() -> None:
    assert np.allclose(merged([3.0, 1.0, 1.01, 2.99], 0.02), [1.005, 2.995])


def test_nothing_has_no_rectangles() -> None:
    assert rectangles_of(Polygon()) == ()
