"""Boxes on a view, and names that can be read."""

from itertools import combinations
from pathlib import Path

from sdgen.dataset import Dataset, SceneItem
from sdgen.gallery.boxes import BoxOnView, Tag, boxes_of
from sdgen.scene import VisibleObject

from tests import toy


def crowded(item: SceneItem, count: int) -> SceneItem:
    """The scene with the boxes of so many things, all in one corner of its first view."""
    first = item.visibility.views[0]
    ids = [thing.id for thing in item.scene.objects]
    things = [
        VisibleObject(object_id=key, bbox=(2 * k, 3 * k, 9, 7), pixels=9, fraction=1.0, parts={})
        for k, key in enumerate(ids[:count])
    ]
    views = (first.model_copy(update={"objects": tuple(things)}), *item.visibility.views[1:])
    vars(item)["visibility"] = item.visibility.model_copy(update={"views": views})
    return item


def apart(a: Tag, b: Tag) -> bool:
    beside = a.x + a.width <= b.x + 0.2 or b.x + b.width <= a.x + 0.2
    return beside or a.y + a.height <= b.y + 0.2 or b.y + b.height <= a.y + 0.2


def tags(boxes: tuple[BoxOnView, ...]) -> list[Tag]:
    return [box.tag for box in boxes if box.tag is not None]


def test_names_never_lie_on_each_other_and_stay_in_the_picture(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    for item in (*Dataset(path), crowded(Dataset(path)[3], 8)):
        for view in range(item.entry.views):
            found = tags(boxes_of(item, view))
            assert all(apart(a, b) for a, b in combinations(found, 2))
            for tag in found:
                assert tag.x >= 0
                assert tag.y >= 0
                assert tag.x + tag.width <= 160.1
                assert tag.y + tag.height <= 120.1


def test_what_is_labelled_always_has_its_name(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    boxes = boxes_of(crowded(Dataset(path)[3], 8), 0)
    marked = [box for box in boxes if box.kind != "object"]
    assert {box.object_id for box in marked} == {11, 512, 600, 4000}
    assert all(box.tag is not None for box in marked)
    assert [box.kind for box in boxes] == sorted((box.kind for box in boxes), reverse=True)
    assert {box.text for box in marked} >= {"knife: no sharp object", "stove: stove on"}
