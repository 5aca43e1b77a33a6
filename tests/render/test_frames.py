import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from sdgen.cameras.nearest import drawn_boxes, with_near_planes
from sdgen.cameras.pinhole import project
from sdgen.geometry import Vec3, apply
from sdgen.library import Library
from sdgen.render import choose_renderer, open_renderer
from sdgen.render.frames import render_frames
from sdgen.render.protocol import Renderer
from sdgen.scene import Camera, Frame, Scene

from tests.fakes import GREEN, RED, box_room, camera_at, thing, write_library

EGL = choose_renderer("auto").kind == "egl"
KINDS = ["egl", "cpu"] if EGL else ["cpu"]


@pytest.fixture(scope="module", params=KINDS)
def renderer(request: pytest.FixtureRequest) -> Iterator[Renderer]:
    with open_renderer(request.param) as made:
        yield made


def camera(eye: Vec3, target: Vec3, size: tuple[int, int] = (320, 240)) -> Camera:
    return camera_at(eye, target, size)


def one(renderer: Renderer, library: Library, scene: Scene, view: Camera, scale: int = 1) -> Frame:
    (frame,) = render_frames(renderer, library, scene, [view], supersample=scale)
    return frame


def test_a_wall_at_a_known_distance(renderer: Renderer, library: Library) -> None:
    """Depth is planar: the same all over a wall that faces the camera."""
    frame = one(renderer, library, box_room(), camera((0, 0, 1.25), (1, 0, 1.25)))
    wall = frame.depth_mm[frame.instance == 4]
    assert wall.size > 10000
    assert wall.min() >= 1998
    assert wall.max() <= 2002


def test_floor_and_ceiling_have_the_depth_of_their_planes(
    renderer: Renderer, library: Library
) -> None:
    view = camera((-1.5, 0.3, 1.25), (1, 0, 1.4))
    frame = one(renderer, library, box_room(), view)
    pose = np.asarray(view.world_from_camera)
    for number, level in ((2, 0.0), (3, 2.5)):
        rows, columns = np.nonzero(frame.instance == number)
        assert len(rows) > 1000
        depth = frame.depth_mm[rows, columns] / 1000.0
        k = np.asarray(view.K)
        x = (columns - k[0, 2]) / k[0, 0] * depth
        y = (rows - k[1, 2]) / k[1, 1] * depth
        height = apply(pose, np.column_stack([x, y, depth]))[:, 2]
        assert np.percentile(np.abs(height - level), 95) < 0.02


@pytest.mark.skipif(not EGL, reason="EGL does not start here")
def test_depth_is_a_matter_of_millimetres_at_the_end_of_a_room(library: Library) -> None:
    room = box_room(size_m=(8.0, 4.0))
    views = [camera((-3.4, 0, 1.25), (4, 1, 1.25))]
    (view,) = with_near_planes(views, drawn_boxes(library, room))
    with open_renderer("egl") as egl:
        frame = one(egl, library, room, view)
    rows, columns = np.nonzero(frame.instance == 4)
    assert len(rows) > 1000
    k, depth = np.asarray(view.K), frame.depth_mm[rows, columns] / 1000.0
    x, y = (columns - k[0, 2]) / k[0, 0] * depth, (rows - k[1, 2]) / k[1, 1] * depth
    wall = apply(np.asarray(view.world_from_camera), np.column_stack([x, y, depth]))[:, 0]
    assert np.abs(wall - 4.0).max() < 0.0025


def test_a_projected_point_is_found_in_mask_and_depth(renderer: Renderer, library: Library) -> None:
    scene = box_room([thing(1234, "cube_01", (0.4, -0.3, 0.0)), thing(77, "cube_02", (1, 1, 0))])
    view = camera((-1.2, -0.9, 1.4), (0.2, 0, 0.3))
    frame = one(renderer, library, scene, view)
    pixels, depth = project(view, np.array([[0.4, -0.3, 0.2]]))  # the middle of the cube's top
    column, row = (int(v) for v in np.rint(pixels[0]))
    assert frame.instance[row, column] == 1234
    assert frame.part[row, column] == 1
    assert frame.depth_mm[row, column] / 1000 == pytest.approx(depth[0], abs=0.006)
    rows, columns = np.nonzero(frame.instance == 1234)
    corners = [[0.4 + a, -0.3 + b, c] for a in (-0.1, 0.1) for b in (-0.1, 0.1) for c in (0, 0.2)]
    box, _ = project(view, np.array(corners))
    low, high = box.min(axis=0), box.max(axis=0)
    assert [columns.min(), rows.min()] == pytest.approx(np.ceil(low), abs=1)
    assert [columns.max(), rows.max()] == pytest.approx(np.floor(high), abs=1)


def test_parts_are_told_apart_and_move_with_their_joints(
    renderer: Renderer, library: Library
) -> None:
    view = camera((1.7, 0.2, 0.6), (0, 0, 0.4))
    shut = one(renderer, library, box_room([thing(9, "cabinet_01", (0, 0, 0))]), view)
    turned = thing(9, "cabinet_01", (0, 0, 0), joints={"door": -1.5})
    opened = one(renderer, library, box_room([turned]), view)
    assert (shut.part == 3).sum() > 5 * (opened.part == 3).sum() > 0
    assert (opened.part == 1).sum() > 1000
    assert (shut.part == 1).sum() < 100
    assert ((shut.part > 0) == (shut.instance == 9)).all()


def test_pixels_alone_count_what_is_hidden_too(renderer: Renderer, library: Library) -> None:
    scene = box_room([thing(10, "cube_01", (0.5, 0, 0)), thing(11, "cube_02", (0.1, 0.06, 0))])
    view = camera((-1.5, 0, 0.25), (1, 0, 0.1))
    frame = one(renderer, library, scene, view)
    only = one(renderer, library, box_room([thing(10, "cube_01", (0.5, 0, 0))]), view)
    visible = {k: int((frame.instance == k).sum()) for k in (10, 11)}
    assert visible[10] < 0.8 * frame.alone_pixels[10]
    assert frame.alone_pixels[10] == pytest.approx(int((only.instance == 10).sum()), rel=0.03)
    assert visible[11] == pytest.approx(frame.alone_pixels[11], rel=0.03)
    assert all(visible[k] <= frame.alone_pixels[k] for k in visible)
    assert set(frame.alone_pixels) == {10, 11}


def test_a_scene_may_have_more_parts_than_a_body_of_bullet_has_links(
    renderer: Renderer, library: Library
) -> None:
    """Everything is drawn where it stands, and keeps its number."""
    places = [(0.22 * k - 1.32, 0.22 * j - 1.1, 0.0) for k in range(13) for j in range(11)]
    scene = box_room([thing(100 + n, "cube_01", place) for n, place in enumerate(places)])
    view = camera((0.0, 0.0, 2.4), (0.001, 0.0, 0.0), (640, 640))
    frame = one(renderer, library, scene, view)
    pixels, _ = project(view, np.array([(x, y, 0.2) for x, y, _ in places]))
    columns, rows = np.rint(pixels).astype(int).T
    assert frame.instance[rows, columns].tolist() == list(range(100, 243))
    assert (frame.part[rows, columns] == 1).all()


def test_no_sensors_no_frames(renderer: Renderer, library: Library) -> None:
    view = camera((0, 0, 1.25), (1, 0, 1.25))
    assert list(render_frames(renderer, library, box_room(), [view], sensors=())) == []


def test_supersampling_changes_colours_only(renderer: Renderer, library: Library) -> None:
    scene = box_room([thing(10, "table_01", (0.3, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74))])
    view = camera((-1.5, 0.7, 1.5), (0.3, 0, 0.5))
    plain, smooth = one(renderer, library, scene, view), one(renderer, library, scene, view, 2)
    assert np.array_equal(plain.instance, smooth.instance)
    assert np.array_equal(plain.depth_mm, smooth.depth_mm)
    apart = np.abs(plain.rgb.astype(int) - smooth.rgb.astype(int)).max(axis=2)
    assert 0 < (apart > 8).mean() < 0.1


def test_textures_do_not_leak_from_scene_to_scene(renderer: Renderer, library: Library) -> None:
    """After several scenes in one process each cube still wears its own colour."""
    view = camera((0.0, 0.0, 1.5), (0.01, 0.0, 0.0))
    for round_ in range(4):
        names = ["cube_01", "cube_02"] if round_ % 2 else ["cube_02", "cube_01"]
        extra = [thing(50, "table_01", (1.4, 1.4, 0))] if round_ % 3 else []
        lamp = thing(60, "ceiling_lamp_91", (0, 1, 2.39), fixed=True)
        cubes = [thing(10, names[0], (-0.3, 0, 0)), thing(11, names[1], (0.3, 0, 0))]
        scene = box_room([*cubes, lamp, *extra])
        frame = one(renderer, library, scene, view)
        for number, name in ((10, names[0]), (11, names[1])):
            seen = frame.rgb[frame.instance == number].mean(axis=0)
            wanted = RED if name == "cube_01" else GREEN
            assert np.argsort(seen).tolist()[-1] == np.argmax(wanted)
            assert np.sort(seen)[1] < 0.6 * seen.max()
        red, green, blue = frame.rgb[frame.instance == 2].mean(axis=0)
        assert red > 1.1 * green > 1.1 * 1.1 * blue


def test_the_room_is_bright(renderer: Renderer, library: Library) -> None:
    """Neither ceiling nor walls may put the room in shadow, or shine."""
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)
    frame = one(renderer, library, box_room([lamp]), camera((-1.7, -1.7, 1.5), (1, 1, 0.9)))
    for number in set(np.unique(frame.instance).tolist()) - {2, 60}:
        values = frame.rgb[frame.instance == number].astype(float).mean(axis=1)
        assert values.mean() > 90
        assert np.percentile(values, 95) < 252
    floor = frame.rgb[frame.instance == 2].astype(float).mean(axis=1)
    assert (floor > 70).mean() > 0.7


_SCRIPT = """
import hashlib, sys
from pathlib import Path
from sdgen.library import Library
from sdgen.render import choose_renderer, open_renderer
from sdgen.render.frames import render_frames
from sdgen.render.protocol import Renderer
from tests.fakes import box_room, camera_at, thing
from tests.render.test_frames import camera

library = Library([Path(sys.argv[1])])
things = [thing(10, "table_01", (0.3, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74)),
          thing(12, "cabinet_01", (-1, 1.2, 0), joints={"door": -0.7}),
          thing(13, "cube_02", (1, 1, 0)), thing(14, "cube_02", (-0.4, 0.2, 0))]
things += [thing(50 + k, "cube_01", (0.6 * k, 0.4, 2.295), fixed=True) for k in range(2)]
things += [thing(20 + k, "flush_01", (-1.0 + 0.4 * k, -0.9 + 0.3 * k, 0)) for k in range(5)]
views = [camera((-1.5, 0.7, 1.5), (0.3, 0, 0.5)), camera((1.6, -1.2, 1.2), (0, 0, 0.5))]
with open_renderer(sys.argv[2]) as renderer:
    for number in range(int(sys.argv[3])):
        extra = [thing(400 - k, "flush_01", (0.3 * k % 1.2, 0.5, 0), variant="pane")
                 for k in range(1 + 70 * number)]
        cube = thing(5 + number, "cube_02", (0.1 * number, 0, 0))
        other = box_room([cube, *extra], (3.0 + number, 4.0))
        list(render_frames(renderer, library, other, views[:1], supersample=1 + number % 2))
    total = hashlib.sha256()
    for scale in (1, 2):
        for frame in render_frames(renderer, library, box_room(things), views, supersample=scale):
            for array in (frame.rgb, frame.depth_mm, frame.instance, frame.part):
                total.update(array.tobytes())
            total.update(str(sorted(frame.alone_pixels.items())).encode())
print("digest", total.hexdigest())
"""


@pytest.mark.parametrize("kind", KINDS)
def test_frames_are_the_same_bytes_in_every_process(kind: str, tmp_path: Path) -> None:
    """In two processes, and whatever either rendered before."""
    folder = write_library(tmp_path / "assets")
    root = str(Path(__file__).resolve().parents[2])
    digests = []
    for before in (0, 0, 3):
        done = subprocess.run(
            [sys.executable, "-c", _SCRIPT, str(folder), kind, str(before)],
            capture_output=True,
            text=True,
            check=False,
            cwd=root,
        )
        assert done.returncode == 0, done.stderr
        digests += [line for line in done.stdout.splitlines() if line.startswith("digest")]
    assert len(digests) == 3
    assert len(set(digests)) == 1
