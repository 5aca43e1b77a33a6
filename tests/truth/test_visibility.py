"""visibility.json: boxes, pixels and evidence, against masks small enough to count by hand."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.scene import Anomaly, Camera, Opening, ViewVisibility, VisibleObject
from sdgen.truth.visibility import (
    all_visible,
    evidence_pixels_needed,
    measure_masks,
    outdoors_seen,
    shows,
    visibility_of,
)
from sdgen.vocabulary import REFERENCE_SIZE

from tests import toy


@pytest.mark.parametrize(
    ("width", "height", "pixels"), [(640, 480, 100), (320, 240, 25), (16, 16, 1), (641, 480, 101)]
)
def test_needed_pixels_follow_the_picture_size(width: int, height: int, pixels: int) -> None:
    assert evidence_pixels_needed(width, height) == pixels
    assert evidence_pixels_needed(320, 240, 15) == 4


def test_box_pixels_and_parts_of_a_mask_counted_by_hand() -> None:
    instance = np.zeros((4, 5), dtype=np.uint16)
    part = np.zeros((4, 5), dtype=np.uint8)
    instance[1:3, 2:5] = 65535
    part[1:3, 2:5] = 1
    part[1, 4] = 2
    instance[3, 0] = 9
    found = measure_masks(instance, part, {65535: ("body", "door"), 9: ("body",)})
    assert found == {
        9: ((0, 3, 1, 1), 1, {}),
        65535: ((2, 1, 3, 2), 6, {"body": 5, "door": 1}),
    }


@given(
    hnp.arrays(
        np.uint16,
        hnp.array_shapes(min_dims=2, max_dims=2, max_side=7),
        elements=st.sampled_from([0, 1, 300, 65535]),
    )
)
def test_masks_are_measured_as_slow_code_would(instance: npt.NDArray[np.uint16]) -> None:
    found = measure_masks(instance, None, {})
    assert set(found) == set(np.unique(instance).tolist()) - {0}
    for node_id, ((x, y, w, h), pixels, _) in found.items():
        mask = instance == node_id
        assert pixels == mask.sum() == mask[y : y + h, x : x + w].sum()
        assert mask[y].any()
        assert mask[y + h - 1].any()
        assert mask[:, x].any()
        assert mask[:, x + w - 1].any()


def test_structures_are_left_out_and_fraction_is_visible_over_alone() -> None:
    made = toy.bundle(3)
    frame = toy.frame(made, 0)
    view = toy.visibility(made, [frame]).views[0]
    shown = {item.id for item in made.scene.objects} & set(np.unique(frame.instance).tolist())
    assert len(shown) > 4
    assert [item.object_id for item in view.objects] == sorted(shown)
    for item in view.objects:
        assert item.fraction == round(item.pixels / frame.alone_pixels[item.object_id], 4)


def test_a_sliver_of_something_large_is_more_than_nothing() -> None:
    made = toy.bundle(3)
    frame = toy.frame(made, 0)
    one = min(frame.alone_pixels)
    huge = replace(frame, alone_pixels={**frame.alone_pixels, one: 10**9})
    view = toy.visibility(made, [huge]).views[0]
    assert {item.object_id: item.fraction for item in view.objects}[one] == 1e-4


def test_evidence_counts_the_evidence_parts_only() -> None:
    made = toy.bundle(1)
    shown = toy.visibility(made, toy.frames(made))
    stove = {item.object_id: item for item in shown.views[0].objects}[11]
    assert made.anomalies.anomalies[0].evidence_parts == ("glow",)
    assert shown.anomalies[0].evidence_pixels[0] == stove.parts["glow"] < stove.pixels


def anomaly(object_id: int, parts: tuple[str, ...] = ("body",), needed: int = 100) -> Anomaly:
    of = toy.bundle(1).anomalies.anomalies[0]
    changes = {
        "object_id": object_id,
        "evidence_parts": parts,
        "evidence_pixels_needed": needed,
    }
    return of.model_copy(update=changes)


DOORWAY = Opening(
    object_id=42,
    kind="front_door",
    room_ids=(100,),
    center_m=(1.0, 4.0, 0.0),
    along="x",
    width_m=1.0,
    height_m=2.0,
)


def looking_north(eye: tuple[float, float, float], size: tuple[int, int] = (640, 480)) -> Camera:
    pose = look_at(eye, (eye[0], eye[1] + 1.0, eye[2]))
    return (
        toy.bundle(0)
        .cameras[0]
        .model_copy(
            update={
                "width": size[0],
                "height": size[1],
                "K": intrinsics(*size),
                "world_from_camera": matrix4(pose),
            }
        )
    )


def test_outdoors_counts_what_is_nothing_within_the_opening_alone() -> None:
    """A doorway of 1 m by 2 m, 4 m away, seen square on, with half of it shut by a leaf."""
    camera = looking_north((1.0, 0.0, 1.0))
    focal = camera.K[0][0]
    nothing = np.zeros((480, 640), dtype=np.uint16)
    seen = outdoors_seen(nothing, camera, [DOORWAY])
    assert seen == {42: pytest.approx(focal / 4 * focal / 2, rel=0.02)}
    half = nothing.copy()
    half[:, :320] = 42
    assert outdoors_seen(half, camera, [DOORWAY])[42] == pytest.approx(seen[42] / 2, rel=0.02)
    # A pixel of nothing beside the doorway is a window's, and one behind the camera nobody's.
    half[:, 320:420] = 42
    assert (half == 0).any()
    assert outdoors_seen(half, camera, [DOORWAY]) == {}
    assert outdoors_seen(nothing, looking_north((1.0, 5.0, 1.0)), [DOORWAY]) == {}


def test_outdoors_are_only_seen_through_openings_of_outer_walls() -> None:
    made = toy.bundle(0)
    frame = toy.frame(made, 0)
    gone = replace(frame, instance=np.zeros_like(frame.instance))
    inner = made.scene.home.openings[0]
    outer = inner.model_copy(update={"room_ids": inner.room_ids[:1]})

    def seen(opening: Opening) -> dict[int, int] | None:
        home = made.scene.home.model_copy(update={"openings": (opening,)})
        scene = made.scene.model_copy(update={"home": home})
        size = frame.instance.shape[::-1]
        return visibility_of(scene, (), [gone], *size).views[0].outdoors

    assert seen(inner) == {}
    assert list(seen(outer) or ()) == [inner.object_id]


@pytest.mark.parametrize(
    ("leaf", "outdoors", "size", "shown"),
    [
        (900, {1: 499}, (640, 480), False),
        (900, {1: 500}, (640, 480), True),
        (99, {1: 500}, (640, 480), False),
        (900, {1: 125}, (320, 240), True),
        (900, {1: 124}, (320, 240), False),
        # Through another door, and of a data set that does not tell.
        (900, {2: 900}, (640, 480), False),
        (900, None, (640, 480), False),
    ],
)
def test_an_open_door_shows_by_what_is_seen_through_it(
    leaf: int, outdoors: dict[int, int] | None, size: tuple[int, int], shown: bool
) -> None:
    door = anomaly(1).model_copy(update={"evidence_outdoors_needed": 500})
    seen = view({"body": leaf}).model_copy(update={"outdoors": outdoors})
    assert shows(seen, door, *size) is shown


def view(*parts: dict[str, int]) -> ViewVisibility:
    """A view of objects 1, 2 ... with these pixels of their parts."""
    objects = tuple(
        VisibleObject(
            object_id=k, bbox=(0, 0, 9, 9), pixels=sum(one.values()), fraction=1.0, parts=one
        )
        for k, one in enumerate(parts, start=1)
    )
    return ViewVisibility(view=0, objects=objects)


def test_all_visible_needs_one_good_view_of_each() -> None:
    def seen(*pixels: tuple[int, int]) -> bool:
        views = [view({"body": a}, {"body": b}) for a, b in pixels]
        return all_visible(views, [anomaly(1), anomaly(2)], *REFERENCE_SIZE)

    assert seen((0, 100), (100, 0))
    assert not seen((0, 99), (100, 99))
    assert not seen()
    assert all_visible([], [], *REFERENCE_SIZE)


@pytest.mark.parametrize(
    ("flame", "wax", "size", "shown"),
    [
        (0, 900, (640, 480), False),
        (19, 900, (640, 480), False),
        (20, 80, (640, 480), True),
        # A flame alone, over the rim of a shelf, could be anything.
        (20, 79, (640, 480), False),
        (5, 20, (320, 240), True),
        (4, 96, (320, 240), False),
    ],
)
def test_a_candle_shows_by_some_of_its_flame_and_enough_of_all(
    flame: int, wax: int, size: tuple[int, int], shown: bool
) -> None:
    burning = anomaly(1, ("flame",), 20)
    assert shows(view({"flame": flame, "wax": wax}), burning, *size) is shown
    # Part by part from two views is not seen.
    halves = [view({"flame": flame}), view({"wax": wax})]
    assert not all_visible(halves, [burning], *size)
