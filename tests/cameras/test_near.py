import math

import numpy as np
import pytest
from sdgen.cameras.near import PIXELS_NEEDED, Target, best_near_pose
from sdgen.cameras.overview import room_views
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.pinhole import intrinsics, project
from sdgen.cameras.sight import estimate_pixels
from sdgen.cameras.view import View, to_cameras
from sdgen.geometry import look_at
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames
from sdgen.scene import Scene
from sdgen.seeding import lane

from tests.fakes import box_room, thing


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


def eye_of(pose: np.ndarray) -> np.ndarray:
    return pose[:3, 3]


def promise(library: Library, scene: Scene, world: RayWorld, view: View, number: int) -> float:
    """Pixels of an object that rays promise in a view."""
    item = scene.object(number)
    points, parts = part_points(library, item, ()), part_numbers(library, item, ())
    return float(estimate_pixels(world.cast, [view.world_from_camera], points, number, parts)[0])


@pytest.mark.parametrize("number", [11, 13, 14])
def test_a_near_view_stands_free_and_promises_what_the_picture_shows(
    library: Library, scene: Scene, number: int
) -> None:
    with RayWorld(library, scene) as world:
        view = best_near_pose(library, scene, world.cast, Target(number), lane(1, 2, f"a{number}"))
        assert view is not None
        promised = promise(library, scene, world, view, number)
    assert promised >= PIXELS_NEEDED
    x, y, z = eye_of(view.world_from_camera)
    assert -1.0 <= x <= 1.6
    assert -1.6 <= y <= 0.2
    assert z == pytest.approx(1.2, abs=0.11)
    where = scene.object(number).pose.position_m
    assert 0.75 < math.hypot(x - where[0], y - where[1]) < 2.3
    (camera,) = to_cameras([view], (640, 480), lane(1, 2, "order"))
    with open_renderer("auto") as renderer:
        (frame,) = render_frames(renderer, library, scene, [camera])
    assert (frame.instance == number).sum() == pytest.approx(promised, rel=0.15)


def test_a_view_from_a_doorway_is_of_the_room_on_whose_side_it_stands(
    library: Library, scene: Scene
) -> None:
    """Between two rooms, 2 cm nearer to the one that the target is not in."""
    (room,) = scene.home.rooms
    here, there = (
        room.model_copy(update={"id": number, "polygon_m": polygon})
        for number, polygon in (
            (1, ((0, -2), (2, -2), (2, 2), (0, 2))),
            (40, ((-2, -2), (-0.12, -2), (-0.12, 2), (-2, 2))),
        )
    )
    gap = ((-0.08, -1.0), (-0.07, -1.0), (-0.07, 1.5), (-0.08, 1.5))
    home = scene.home.model_copy(update={"rooms": (here, there)})
    made = scene.model_copy(update={"home": home, "free_space": (gap,)})
    with RayWorld(library, made) as world:
        view = best_near_pose(library, made, world.cast, Target(11), lane(1, 2, "door"))
    assert made.object(11).room_id == 1
    assert view is not None
    assert view.room_id == 40


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


def test_what_is_hidden_has_no_near_view(library: Library, scene: Scene) -> None:
    """A cube shut in a cabinet cannot be seen from anywhere."""
    things = [o for o in scene.objects if o.id != 12]
    things.append(thing(12, "cabinet_01", (-1.6, 0.5, 0)))
    walls = [thing(20, "cabinet_01", (-1.6, 0.5, 0), (0, 0, math.sin(a / 2), math.cos(a / 2)))
             for a in (math.pi / 2,)]  # fmt: skip
    lid = [thing(21 + k, "table_01", (-1.6, 0.5, 0.1 - k * 0.01)) for k in range(1)]
    shut = scene.model_copy(update={"objects": tuple(things + walls + lid)})
    with RayWorld(library, shut) as world:
        assert best_near_pose(library, shut, world.cast, Target(13), lane(1, 2, "x")) is None


def test_the_target_is_in_the_picture_but_not_always_in_its_middle(
    library: Library, scene: Scene
) -> None:
    spots = []
    with RayWorld(library, scene) as world:
        for k in range(12):
            view = best_near_pose(library, scene, world.cast, Target(11), lane(k, 0, "near"))
            assert view is not None
            (camera,) = to_cameras([view], (640, 480), lane(0, 0, "order"))
            pixels, _ = project(camera, np.array([[0.8, 0.8, 0.84]]))
            spots.append(pixels[0])
    away = np.abs(np.array(spots) - [319.5, 239.5])
    assert (away < [220, 160]).all()
    assert away.max() > 30


def test_cameras_are_numbered_in_a_drawn_order(library: Library, scene: Scene) -> None:
    with RayWorld(library, scene) as world:
        near = best_near_pose(library, scene, world.cast, Target(11), lane(3, 0, "views"))
        assert near is not None
        views = [near, *room_views(scene, world.cast, 5, lane(3, 0, "rooms"))]
    cameras = to_cameras(views, (320, 200), lane(3, 0, "order"))
    assert cameras == to_cameras(views, (320, 200), lane(3, 0, "order"))
    places = {
        [c.kind for c in to_cameras(views, (320, 200), lane(k, 0, "order"))].index("near")
        for k in range(20)
    }
    assert len(places) > 2
    assert [camera.index for camera in cameras] == list(range(6))
    assert sorted(camera.kind for camera in cameras) == ["near"] + ["room"] * 5
    assert all(intrinsics(320, 200) == camera.K for camera in cameras)


def test_overviews_look_into_the_room(library: Library, scene: Scene) -> None:
    with RayWorld(library, scene) as world:
        views = room_views(scene, world.cast, 3, lane(5, 0, "views"))
    for view in views:
        forward = view.world_from_camera[:3, 2]
        assert abs(forward[2]) < 0.6
        right = view.world_from_camera[:3, 0]
        assert right[2] == pytest.approx(0, abs=1e-9)
    assert len({tuple(eye_of(view.world_from_camera)) for view in views}) == 3


def test_no_free_floor_no_views(library: Library, scene: Scene) -> None:
    bare = scene.model_copy(update={"free_space": ()})
    with RayWorld(library, bare) as world:
        assert room_views(bare, world.cast, 3, lane(5, 0, "views")) == ()
        assert best_near_pose(library, bare, world.cast, Target(11), lane(5, 0, "n")) is None


def test_more_rounds_find_what_one_round_missed(library: Library, scene: Scene) -> None:
    """What the first round finds, it finds the same with more rounds to come."""
    needed = 3550.0

    def found(seed: int, rounds: int) -> View | None:
        rng = lane(seed, 0, "near")
        return best_near_pose(
            library, scene, world.cast, Target(13), rng, pixels_needed=needed, rounds=rounds
        )

    with RayWorld(library, scene) as world:
        one, three = ([found(seed, rounds) for seed in range(16)] for rounds in (1, 3))
        late = [view for first, view in zip(one, three, strict=True) if first is None and view]
        assert late
        assert all(promise(library, scene, world, view, 13) >= needed for view in late)
    for first, view in zip(one, three, strict=True):
        if first is not None:
            assert view is not None
            assert np.array_equal(first.world_from_camera, view.world_from_camera)


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
