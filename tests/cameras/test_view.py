import numpy as np
import pytest
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.pinhole import intrinsics
from sdgen.cameras.sight import estimate_pixels
from sdgen.cameras.view import View, clear, to_cameras
from sdgen.geometry import look_at
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames
from sdgen.scene import Scene
from sdgen.seeding import lane

from tests.fakes import box_room, thing

EYES = [(0.5, -0.5, 1.2), (0.0, -1.5, 1.1), (1.5, 0.0, 1.3), (-0.8, -1.2, 1.25)]


@pytest.fixture(scope="module")
def scene() -> Scene:
    """A room whose floor is free but for a table's and a cabinet's surroundings."""
    made = box_room(
        [
            thing(10, "table_01", (0.9, 0.9, 0)),
            thing(11, "cube_01", (0.8, 0.8, 0.74)),
            thing(12, "cabinet_01", (-1.6, 0.5, 0), joints={"door": -1.5}),
            thing(13, "cube_02", (-1.75, 0.5, 0.04)),
            thing(14, "plank_01", (1.2, -1.2, 0)),
        ]
    )
    free = ((-1.0, -1.6), (1.6, -1.6), (1.6, 0.2), (-1.0, 0.2))
    return made.model_copy(update={"free_space": (free,)})


def promise(library: Library, scene: Scene, world: RayWorld, view: View, number: int) -> float:
    """Pixels of an object that rays promise in a view."""
    item = scene.object(number)
    points, parts = part_points(library, item, ()), part_numbers(library, item, ())
    return float(estimate_pixels(world.cast, [view.world_from_camera], points, number, parts)[0])


def view(eye: tuple[float, float, float], aim: tuple[float, float, float], kind="near") -> View:
    return View(kind, np.array(eye), np.array(aim))


@pytest.mark.parametrize("number", [11, 13, 14])
def test_rays_promise_what_the_picture_shows(library: Library, scene: Scene, number: int) -> None:
    """Within what 256 rays can tell; from the doorway's side of the cabinet the cube shows."""
    aim = scene.object(number).pose.position_m
    views = [view(eye, aim) for eye in EYES]
    with RayWorld(library, scene) as world:
        promised = [promise(library, scene, world, one, number) for one in views]
    best = int(np.argmax(promised))
    assert promised[best] > 150
    (camera,) = to_cameras([views[best]], scene.home, (640, 480), lane(1, 2, "order"))
    with open_renderer("auto") as renderer:
        (frame,) = render_frames(renderer, library, scene, [camera])
    assert (frame.instance == number).sum() == pytest.approx(promised[best], rel=0.15)


def test_a_camera_in_a_doorway_is_of_the_room_on_whose_side_it_stands(scene: Scene) -> None:
    """Between two rooms, 2 cm nearer to one of them."""
    (room,) = scene.home.rooms
    rooms = [
        room.model_copy(update={"id": number, "polygon_m": polygon})
        for number, polygon in (
            (1, ((0, -2), (2, -2), (2, 2), (0, 2))),
            (40, ((-2, -2), (-0.12, -2), (-0.12, 2), (-2, 2))),
        )
    ]
    home = box_room().home.model_copy(update={"rooms": tuple(rooms)})
    for x, number in ((-0.07, 40), (-0.05, 1), (1.0, 1), (-1.0, 40)):
        (camera,) = to_cameras(
            [view((x, 0, 1.2), (1.5, 0.2, 0.4))], home, (64, 48), lane(1, 2, "d")
        )
        assert camera.room_id == number


def test_another_eye_height_looks_at_the_same_point(scene: Scene) -> None:
    usual = view((0.5, -0.5, 1.15), (0.9, 0.9, 0.7))
    low = usual.at(0.7)
    assert low.world_from_camera[:3, 3] == pytest.approx([0.5, -0.5, 0.65])
    assert np.allclose(
        low.world_from_camera[:3, 2] @ (low.aim_m - low.eye_m),
        np.linalg.norm(low.aim_m - low.eye_m),
    )
    assert np.array_equal(usual.at(1.2).world_from_camera, usual.world_from_camera)


@pytest.mark.parametrize("height_m", [0.3, 1.2, 1.6, 2.2])
def test_an_overview_stays_level_at_every_eye_height(height_m: float) -> None:
    """The same point while that is within ten degrees, and the point above or below it else."""
    usual = View("room", np.array([-1.5, -1.5, 1.3]), np.array([1.5, 1.5, 0.8]), 1)
    other = usual.at(height_m)
    ahead = other.world_from_camera[:3, 2]
    assert abs(np.degrees(np.arcsin(ahead[2]))) < 10.001
    assert other.eye_m[2] == pytest.approx(height_m + 0.1)
    assert other.aim_m[:2].tolist() == [1.5, 1.5]
    assert (other.aim_m[2] == 0.8) == (height_m in (0.3, 1.2))


def test_nothing_stands_before_a_clear_eye(library: Library, scene: Scene) -> None:
    aim = (0.0, 0.0, 0.5)
    views = [view(eye, aim) for eye in [(0.3, -0.5, 1.2), (0.9, 0.6, 0.72), (1.85, -1.0, 1.2)]]
    with RayWorld(library, scene) as world:
        assert clear(world.cast, views).tolist() == [True, False, False]
        assert clear(world.cast, []).tolist() == []
        # Beside a table, at the height of its top and of what would stand on it.
        over = [view((0.9, 0.2, 0.8), aim)]
        assert clear(world.cast, over).tolist() == [True]
        assert clear(world.cast, over, 0.08).tolist() == [False]


def test_cameras_are_numbered_in_a_drawn_order(scene: Scene) -> None:
    views = [view(EYES[0], (0.9, 0.9, 0.7))]
    views += [view(EYES[k % 4], (0.1 * k, 0.2, 0.6), "room") for k in range(5)]
    home = scene.home
    cameras = to_cameras(views, home, (320, 200), lane(3, 0, "order"))
    assert cameras == to_cameras(views, home, (320, 200), lane(3, 0, "order"))
    places = {
        [c.kind for c in to_cameras(views, home, (320, 200), lane(k, 0, "order"))].index("near")
        for k in range(20)
    }
    assert len(places) > 2
    assert [camera.index for camera in cameras] == list(range(6))
    assert sorted(camera.kind for camera in cameras) == ["near"] + ["room"] * 5
    assert all(intrinsics(320, 200) == camera.K for camera in cameras)


def test_parts_are_asked_for_by_name(library: Library, scene: Scene) -> None:
    """The pixels of the parts add up to those of the whole."""
    item = scene.object(12)
    every = part_numbers(library, item, ())
    door = part_numbers(library, item, ("door",))
    assert (every.tolist(), door.tolist()) == ([1, 2, 3], [3])
    pose = look_at((0.5, -0.5, 1.2), (-1.6, 0.5, 0.4))
    points = part_points(library, item, ())
    with RayWorld(library, scene) as world:
        whole, front, rest = (
            estimate_pixels(world.cast, [pose], points, 12, numbers)[0]
            for numbers in (every, door, every[:2])
        )
    assert front > 1000
    assert rest > 1000
    assert whole == pytest.approx(front + rest)


def test_poses_together_count_as_each_alone(library: Library, scene: Scene) -> None:
    """One that looks away, and one with some of the points behind it, among them."""
    eyes = [(0.5, -0.5, 1.2), (0.0, -1.5, 1.1), (0.5, -0.5, 1.2), (0.9, 0.8, 1.0), (1.5, 0, 1.3)]
    aims = [(0.9, 0.9, 0.7), (0.9, 0.9, 0.7), (0.5, -1.5, 1.2), (0.9, 1.4, 0.7), (0.5, 1.2, 0.9)]
    poses = [look_at(eye, aim) for eye, aim in zip(eyes, aims, strict=True)]
    item = scene.object(10)
    points, numbers = part_points(library, item, ()), part_numbers(library, item, ())
    with RayWorld(library, scene) as world:
        together = estimate_pixels(world.cast, poses, points, 10, numbers)
        alone = [estimate_pixels(world.cast, [p], points, 10, numbers)[0] for p in poses]
        nothing = estimate_pixels(world.cast, [poses[2]], points, 10, numbers)
        ahead = points[(points - eyes[3]) @ poses[3][:3, 2] > 0.05]
        (of_those,) = estimate_pixels(world.cast, [poses[3]], ahead, 10, numbers)
    assert together.tolist() == alone
    assert [count > 0 for count in alone] == [True, True, False, True, True]
    assert nothing.tolist() == [0.0]
    assert 0 < len(ahead) < len(points)
    assert of_those == alone[3]
