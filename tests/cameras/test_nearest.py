import numpy as np
import pytest
from sdgen.cameras.nearest import cut_by_near_planes, drawn_boxes, with_near_planes
from sdgen.geometry import quat_from_yaw
from sdgen.library import Library
from sdgen.scene import Camera

from tests.fakes import box_room, camera_at, thing


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> np.ndarray:
    return np.array([[low, high]], dtype=float)


def near_m(camera: Camera, boxes: np.ndarray) -> float:
    (begun,) = with_near_planes([camera], boxes)
    assert not cut_by_near_planes([begun], boxes)
    return begun.near_m


@pytest.mark.parametrize(("gap", "depth"), [(0.41, 0.4), (0.35, 0.3), (0.12, 0.1), (0.06, 0.05)])
def test_drawing_begins_before_the_first_box_ahead(gap: float, depth: float) -> None:
    camera = camera_at((0, 0, 1), (1, 0, 1))
    assert camera.near_m == 0.05
    assert near_m(camera, box((gap, -2, 0), (gap + 1, 2, 2))) == depth


def test_what_lies_behind_or_beside_the_view_is_no_hindrance() -> None:
    camera = camera_at((0, 0, 1), (1, 0, 1))
    behind, beside = box((-1, -2, 0), (-0.01, 2, 2)), box((0.1, 0.5, 0), (0.3, 1, 2))
    assert near_m(camera, np.concatenate([behind, beside])) == 0.4
    assert near_m(camera, box((0.1, 0.05, 0), (0.3, 1, 2))) == 0.05


def test_what_comes_nearer_than_a_picture_begins_would_be_cut() -> None:
    camera = camera_at((0, 0, 1), (1, 0, 1))
    begun = with_near_planes([camera], box((0.35, -2, 0), (1.35, 2, 2)))
    assert not cut_by_near_planes(begun, box((0.31, -2, 0), (1, 2, 2)))
    assert cut_by_near_planes(begun, box((0.29, -2, 0), (1, 2, 2)))


def test_a_turned_thing_lies_in_its_box_and_walls_have_theirs(library: Library) -> None:
    scene = box_room([thing(1234, "cube_01", (0.4, -0.3, 0.0), quat_from_yaw(np.pi / 4))])
    boxes = drawn_boxes(library, scene)
    assert len(boxes) == sum(len(s.pieces) for s in scene.home.structures) + 1
    low, high = boxes[-1]
    assert high - low == pytest.approx([0.2 * np.sqrt(2), 0.2 * np.sqrt(2), 0.2], abs=1e-3)
    assert (low + high) / 2 == pytest.approx([0.4, -0.3, 0.1], abs=1e-3)
