"""Which object a box means: by the boxes and masks of the data set, never by another model."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.scene import VisibleObject

#: x, y, width, height in pixels of the picture as it is stored.
Box = tuple[float, float, float, float]

#: A box means an object whose own box it overlaps by so much (intersection over union): a model
#: need not be exact, and half is too strict for small things.
IOU_NEEDED = 0.3
#: Boxes that overlap nearly as well as the best are told apart by the mask.
IOU_TIE = 0.05
#: Else the object that fills the middle of the box to this share of its pixels.
MIDDLE_NEEDED = 0.5


@dataclass(frozen=True)
class Pointed:
    """The object that a box means, and how well (IoU, or its share of the middle)."""

    object_id: int
    fit: float


def iou(a: Box, b: Box) -> float:
    """Intersection over union of two boxes; 0 for empty ones."""
    wide = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    high = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    if wide <= 0 or high <= 0:
        return 0.0
    both = wide * high
    return both / (a[2] * a[3] + b[2] * b[3] - both)


def meant(
    box: Box,
    visible: Sequence[VisibleObject],
    ids: Collection[int],
    instance: npt.NDArray[np.uint16] | None,
) -> Pointed | None:
    """The object of ``ids`` that a box in a view means; None where it is on nothing of the kind.

    It is the one whose box overlaps best, by 0.3 at least; of those within 0.05 of the best the
    one with most pixels in the box. Where none overlaps so well, it is the object that has half of
    the pixels in the middle of the box (half as wide and as high). ``instance``: the view's mask,
    (H, W) node ids; None: there is none, and boxes alone decide.
    """
    fits = {seen.object_id: iou(box, seen.bbox) for seen in visible if seen.object_id in ids}
    best = max(fits.values(), default=0.0)
    if best >= IOU_NEEDED:
        near = sorted(number for number, fit in fits.items() if fit >= best - IOU_TIE)
        inside = _pixels(box, instance)
        return max(
            (Pointed(number, fits[number]) for number in near),
            key=lambda one: (int(np.count_nonzero(inside == one.object_id)), one.fit),
        )
    x, y, w, h = box
    middle = _pixels((x + w / 4, y + h / 4, w / 2, h / 2), instance)
    if middle.size == 0:
        return None
    numbers, counts = np.unique(middle, return_counts=True)
    at = int(np.argmax(counts))
    share = float(counts[at]) / middle.size
    number = int(numbers[at])
    return Pointed(number, share) if number in ids and share >= MIDDLE_NEEDED else None


def _pixels(box: Box, instance: npt.NDArray[np.uint16] | None) -> npt.NDArray[np.uint16]:
    """The pixels of a mask in a box, as far as it is in the picture."""
    if instance is None:
        return np.zeros((0, 0), dtype=np.uint16)
    height, width = instance.shape
    left, top = (
        int(np.clip(np.floor(v), 0, end)) for v, end in zip(box[:2], (width, height), strict=True)
    )
    right = int(np.clip(np.ceil(box[0] + box[2]), 0, width))
    bottom = int(np.clip(np.ceil(box[1] + box[3]), 0, height))
    return instance[top:bottom, left:right]
