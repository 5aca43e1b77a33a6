"""Boxes of what a view shows, with labels that do not lie on each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sdgen.dataset import SceneItem
from sdgen.gallery.words import plain

#: Heights of letters and of labels, as shares of the picture's width; a letter's width of its
#: height. The page stretches each text to the width reckoned here, whatever the font.
_LETTER, _LABEL, _ASPECT = 1 / 36, 1 / 25, 0.55
_ORDER = ("anomaly", "lookalike", "object")

_Area = tuple[float, float, float, float]


@dataclass(frozen=True)
class Tag:
    """A label on a picture: its corner, size and text, in the picture's pixels."""

    x: float
    y: float
    width: float
    height: float
    text: str


@dataclass(frozen=True)
class BoxOnView:
    """A rectangle over a picture, in its pixels. ``kind``: anomaly, lookalike or object. ``tag`` is
    None where there is no room for an object's name."""

    kind: str
    object_id: int
    x: int
    y: int
    width: int
    height: int
    text: str
    tag: Tag | None


def boxes_of(item: SceneItem, view: int) -> tuple[BoxOnView, ...]:
    """Boxes of what a view shows, the marked ones last (on top)."""
    camera = item.cameras[view]
    wrong: dict[int, list[str]] = {}
    for anomaly in item.anomalies.anomalies:
        wrong.setdefault(anomaly.object_id, []).append(anomaly.hazard)
    near = {a.object_id: a.near_miss_of for a in item.anomalies.lookalikes}
    category = {thing.id: thing.category for thing in item.scene.objects}
    found = []
    for shown in (v for v in item.visibility.views if v.view == view):
        for thing in shown.objects:
            key = thing.object_id
            kind, text = "object", category.get(key, "?")
            if key in near:
                kind, text = "lookalike", f"{text}: no {near[key]}"
            if key in wrong:
                kind, text = "anomaly", f"{text}: {', '.join(wrong[key])}"
            found.append((_ORDER.index(kind), -thing.bbox[2] * thing.bbox[3], thing, plain(text)))
    # Names are given to anomalies first, and to large things before small ones.
    found.sort(key=lambda one: (*one[:2], one[2].object_id))
    taken: list[_Area] = []
    out = []
    for rank, _, thing, text in found:
        tag = _tag(thing.bbox, text, (camera.width, camera.height), taken, rank < 2)
        if tag is not None:
            taken.append((tag.x, tag.y, tag.x + tag.width, tag.y + tag.height))
        out.append(BoxOnView(_ORDER[rank], thing.object_id, *thing.bbox, text, tag))
    return tuple(sorted(out, key=lambda box: (-_ORDER.index(box.kind), -box.width * box.height)))


def _tag(
    box: tuple[int, int, int, int],
    text: str,
    size: tuple[int, int],
    taken: list[_Area],
    wanted: bool,
) -> Tag | None:
    """A label's place: at a corner of its box or, of one that is ``wanted``, in the nearest free
    row above or below; None where there is none."""
    letter, high = _LETTER * size[0], _LABEL * size[0]
    wide = min(len(text) * letter * _ASPECT + letter, float(size[0]))
    for x, y in _places(box, wide, high, wanted, size[1]):
        x, y = min(max(x, 0.0), size[0] - wide), min(max(y, 0.0), size[1] - high)
        area = (x, y, x + wide, y + high)
        if not any(_meet(area, other) for other in taken):
            return Tag(round(x, 1), round(y, 1), round(wide, 1), round(high, 1), text)
    return None


def _places(
    box: tuple[int, int, int, int], wide: float, high: float, wanted: bool, tall: int
) -> Iterator[tuple[float, float]]:
    x, y, w, h = box
    for top in (y - high, y + h, y, y + h - high):
        yield x, top
        yield x + w - wide, top
    if wanted:
        for k in range(1, int(2 * tall / high)):
            for top in (y - high - k * high / 2, y + h + k * high / 2):
                yield x, top
                yield x + w - wide, top


def _meet(a: _Area, b: _Area) -> bool:
    return a[0] < b[2] - 0.1 and b[0] < a[2] - 0.1 and a[1] < b[3] - 0.1 and b[1] < a[3] - 0.1
