"""Which object a box means."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.detectors.matching import Box, iou, meant
from sdgen.scene import VisibleObject

#: A table (1) with a mug (2) on it, on a floor (9).
MASK = np.full((100, 100), 9, dtype=np.uint16)
MASK[40:90, 10:90] = 1
MASK[40:50, 50:60] = 2


def seen(number: int, *box: int) -> VisibleObject:
    return VisibleObject(object_id=number, bbox=box, pixels=1, fraction=1.0, parts={})  # type: ignore[arg-type]


VISIBLE = (seen(1, 10, 40, 80, 50), seen(2, 50, 40, 10, 10), seen(9, 0, 0, 100, 100))
IDS = {1, 2}


def test_overlap() -> None:
    assert iou((0, 0, 10, 10), (0, 0, 10, 10)) == 1.0
    assert iou((0, 0, 10, 10), (5, 0, 10, 10)) == pytest.approx(1 / 3)
    assert iou((0, 0, 10, 10), (10, 0, 10, 10)) == 0.0
    assert iou((0, 0, 0, 0), (0, 0, 0, 0)) == 0.0


@pytest.mark.parametrize(
    ("box", "number"),
    [
        ((12, 42, 76, 46), 1),  # about the table
        ((48, 38, 13, 13), 2),  # about the mug
        ((15, 60, 20, 20), 1),  # a part of the table, by its mask
        ((0, 0, 100, 100), 1),  # the whole picture: 0.4 of it is the table's box
        ((0, 0, 30, 30), None),  # floor, which is no thing
        ((200, 200, 20, 20), None),  # beside the picture
        ((-50, -50, 20, 20), None),
        ((50, 60, 0.0, 0.0), None),
    ],
)
def test_a_box_means_what_it_is_around_or_on(box: Box, number: int | None) -> None:
    found = meant(box, VISIBLE, IDS, MASK)
    assert (found.object_id if found else None) == number


def test_of_two_that_fit_alike_the_mask_decides() -> None:
    # A cushion's box is its sofa's; most of the pixels are the cushion's.
    mask = np.full((20, 20), 7, dtype=np.uint16)
    mask[:5] = 5
    visible = (seen(5, 0, 0, 20, 20), seen(7, 0, 0, 20, 20))
    found = meant((0, 0, 20, 20), visible, {5, 7}, mask)
    assert found is not None
    assert found.object_id == 7


def test_what_may_not_be_reported_is_not_meant() -> None:
    assert meant((48, 38, 13, 13), VISIBLE, {1}, MASK) is None


def test_without_masks_boxes_decide() -> None:
    found = meant((48, 38, 13, 13), VISIBLE, IDS, None)
    assert found is not None
    assert found.object_id == 2
    assert meant((15, 60, 20, 20), VISIBLE, IDS, None) is None
