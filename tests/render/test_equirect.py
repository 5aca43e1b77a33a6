"""A panorama shows in every direction what a camera that looks there sees."""

import math

import numpy as np
import pytest
from sdgen.cameras.turn import Post, panoramas_of, poles_of, turn_cameras
from sdgen.render.equirect import seen_by_turn, stitched_ids, stitched_rgb
from sdgen.render.stitching import Stitching
from sdgen.scene import Frame, Look

POST = Post(4, np.array([1.0, 2.0, 1.2]), 0.7)


def directions(camera):
    """Unit directions in the world of a pinhole camera's pixels, (H, W, 3)."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    u, v = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    local = np.stack([(u - k[0, 2]) / k[0, 0], (v - k[1, 2]) / k[1, 1], np.ones(u.shape)], axis=2)
    world = local @ pose[:3, :3].T
    return world / np.linalg.norm(world, axis=2, keepdims=True)


def around(panorama):
    """The same of a panorama, as its docstring says."""
    width, height = panorama.width, panorama.height
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    right = 2 * math.pi * (u - (width - 1) / 2) / width
    up = math.pi * ((height - 1) / 2 - v) / height
    local = [np.cos(up) * np.sin(right), -np.sin(up), np.cos(up) * np.cos(right)]
    return np.stack(local, axis=2) @ np.asarray(panorama.world_from_panorama)[:3, :3].T


def colours(world):
    return np.rint(127.5 + 127.5 * world).astype(np.uint8)


def ids(world):
    """Octants, each a node."""
    return ((world > 0) @ np.array([1, 2, 4]) + 1).astype(np.uint16)


def frame(camera):
    world = directions(camera)
    shape = world.shape[:2]
    nothing = np.zeros(shape, dtype=np.uint16)
    part = np.zeros(shape, dtype=np.uint8)
    return Frame(camera, colours(world), nothing, ids(world), part, {})


@pytest.fixture(scope="module", params=[(160, 120), (96, 72), (64, 96)])
def turn(request):
    ring = turn_cameras([POST], request.param)
    (panorama,) = panoramas_of(ring)
    return panorama, ring


def test_colours_and_ids_are_those_of_the_world(turn):
    panorama, ring = turn
    frames = [frame(camera) for camera in (*ring, *poles_of(panorama, ring[0]))]
    world = around(panorama)
    rgb = stitched_rgb(panorama, ring[0], [one.rgb for one in frames])
    off = np.abs(rgb.astype(int) - colours(world)).max(axis=2)
    step = 127.5 * 2 * math.pi / panorama.width
    assert off.max() <= 2 + step
    found = stitched_ids(panorama, ring[0], [one.instance for one in frames])
    assert found.min() > 0
    # Only within a pixel or two of where one thing ends may it be another.
    near = (np.abs(world) < 4 * math.pi / panorama.width).any(axis=2)
    assert np.array_equal(found[~near], ids(world)[~near])


def test_without_poles_only_what_the_turn_sees_is_there(turn):
    panorama, ring = turn
    seen = seen_by_turn(panorama, ring[0])
    masks = [frame(camera).instance for camera in ring]
    assert np.array_equal(stitched_ids(panorama, ring[0], masks) > 0, seen)
    middle = panorama.height // 2
    assert seen[middle].all()
    assert not seen[[0, -1]].any()


def test_very_wide_views_leave_a_black_gap_to_the_poles():
    ring = turn_cameras([POST], (640, 16))
    (panorama,) = panoramas_of(ring)
    frames = [frame(camera) for camera in (*ring, *poles_of(panorama, ring[0]))]
    found = stitched_ids(panorama, ring[0], [one.instance for one in frames])
    rgb = stitched_rgb(panorama, ring[0], [one.rgb for one in frames])
    assert 0 < (found == 0).mean() < 0.3
    assert (rgb[found == 0] == 0).all()


def test_a_stream_of_frames_becomes_panoramas(turn):
    _, ring = turn
    more = turn_cameras([POST, POST._replace(room_id=5, yaw_rad=2.0)], (64, 48))
    panoramas = panoramas_of(more)
    stitching = Stitching(panoramas, ("rgb", "instance"))
    frames = [frame(camera) for camera in stitching.cameras(more)]
    assert [stitching.wants_only(one) for one in frames] == ([False] * 6 + [True] * 2) * 2
    made = [stitching.add(one) for one in frames]
    assert [k for k, one in enumerate(made) if one is not None] == [7, 15]
    for k, panorama in ((7, panoramas[0]), (15, panoramas[1])):
        found, rgb, mask = made[k]
        assert found == panorama
        assert rgb.shape == (*mask.shape, 3) == (panorama.height, panorama.width, 3)
    assert list(Stitching((), ("rgb",)).cameras(ring)) == list(ring)
    assert Stitching((), ("rgb",)).add(frame(ring[0])) is None


def test_only_what_is_asked_for_is_stitched_and_looks_come_last():
    ring = turn_cameras([POST], (64, 48))
    look = Look(
        exposure_stops=-1.0,
        white_balance=(1.0, 1.0, 1.0),
        vignetting=0.0,
        focus_px=0.0,
        motion_px=0.0,
        shot_noise=0.0,
        read_noise=0.0,
        noise_seed=0,
    )
    (panorama,) = panoramas_of(ring)
    out = {}
    for name, one in (("plain", panorama), ("dark", panorama.model_copy(update={"look": look}))):
        stitching = Stitching([one], ("rgb",))
        *_, (_, rgb, mask) = [stitching.add(frame(c)) for c in stitching.cameras(ring)]
        assert mask is None
        out[name] = rgb.mean()
    assert out["dark"] < 0.8 * out["plain"]
