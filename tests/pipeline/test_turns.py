"""Turns and looks change views alone, and twins have their scene's."""

import numpy as np
import pytest
from sdgen.cameras.turn import ROOM_TURN, rings
from sdgen.cameras.view import CLEARANCE_M
from sdgen.facts import room_at
from sdgen.looks import PRESETS
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline import make_scene

from tests.made import OPTIONS

INDEX = 2
TURNS = OPTIONS.model_copy(update={"views_mode": "panorama", "equirect": True})
LOOKED = {"look": PRESETS["robot"], "twins": True}


@pytest.fixture(scope="module")
def turned(shared, catalog, library):
    return shared.values(
        ["turned"], lambda _: make_scene(INDEX, catalog, library, TURNS.model_copy(update=LOOKED))
    )[0]


@pytest.fixture(scope="module")
def looked(shared, catalog, library):
    options = OPTIONS.model_copy(update=LOOKED)
    return shared.values(["looked"], lambda _: make_scene(INDEX, catalog, library, options))[0]


@pytest.mark.slow
def test_the_scene_is_the_same_with_any_views(scene_bundle, turned, looked):
    usual = scene_bundle(INDEX)
    for other in (turned, looked):
        for name in ("scene", "graph", "anomalies", "household", "physics", "split"):
            assert getattr(other, name) == getattr(usual, name)
    assert turned.twin.scene == looked.twin.scene
    assert turned.twin.anomalies == looked.twin.anomalies
    # Looks are drawn apart from all else.
    plain = tuple(camera.model_copy(update={"look": None}) for camera in looked.cameras)
    assert plain == usual.cameras
    assert all(camera.look is None for camera in usual.cameras)


@pytest.mark.slow
def test_each_room_has_a_whole_turn_from_one_clear_place(library, turned):
    rooms = turned.scene.home.rooms
    found = rings(turned.cameras)
    assert [camera.index for camera in turned.cameras] == list(range(len(found) * ROOM_TURN))
    assert 1 < len(found) <= len(rooms)
    assert len({ring[0].room_id for ring in found}) == len(found)
    assert len(found) == len(turned.panoramas)
    heights = set()
    with Client() as client, RayWorld(library, turned.scene, client.still) as world:
        for ring in found:
            x, y, z = np.asarray(ring[0].world_from_camera)[:3, 3].tolist()
            heights.add(round(z, 6))
            assert room_at(rooms, x, y).id == ring[0].room_id
            around = np.linspace(0, 2 * np.pi, 8, endpoint=False)
            ends = (x, y, z) + CLEARANCE_M * np.column_stack(
                [np.cos(around), np.sin(around), 0 * around]
            )
            hits = world.cast(np.repeat([[x, y, z]], 8, axis=0), ends)
            assert (hits.object_id == 0).all()
    # One robot looks around.
    assert len(heights) == 1
    assert abs(heights.pop() - OPTIONS.eye_height_m) <= 0.1


@pytest.mark.slow
def test_a_twin_is_seen_by_the_same_cameras(turned, looked):
    for bundle in (turned, looked):
        assert bundle.twin.cameras == bundle.cameras
        assert bundle.twin.panoramas == bundle.panoramas
        looks = [one.look for one in (*bundle.cameras, *bundle.panoramas)]
        assert None not in looks
        assert len({look.noise_seed for look in looks}) == len(looks)
    assert all(one.look.vignetting == 0 for one in turned.panoramas)
    # A view's look follows from the seed, the scene and its number alone.
    for one, other in zip(turned.cameras, looked.cameras, strict=False):
        assert one.look == other.look


@pytest.mark.slow
def test_another_height_raises_the_turns(catalog, library, turned):
    options = TURNS.model_copy(update={"eye_height_m": 0.8})
    low = make_scene(INDEX, catalog, library, options)
    assert low.scene == turned.scene
    for one, other in zip(low.cameras, turned.cameras, strict=True):
        offset = np.asarray(one.world_from_camera) - np.asarray(other.world_from_camera)
        assert offset[2, 3] == pytest.approx(-0.4)
        assert np.abs(np.delete(offset.ravel(), 11)).max() < 1e-9
