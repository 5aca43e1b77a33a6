"""A twin in Bullet: what travelled with a part that was shut must stand where it came to."""

from dataclasses import replace

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.facts import Facts
from sdgen.hazards.twin import undone
from sdgen.physics.client import Client
from sdgen.pipeline.undoing import around, check_standing, check_undone
from sdgen.rejection import Cause, Rejection

from tests import toy
from tests.hazards.test_twin import anomaly, drawer_scene
from tests.shipped import shipped_library


@pytest.fixture(scope="module")
def client():
    with Client() as one:
        yield one


def standing_of(twin, client):
    library = shipped_library()
    return check_standing(drawer_scene(), Facts(twin, library.infos), library, client)


def shut():
    fridge = [anomaly(10, "fridge")]
    return undone(drawer_scene(), fridge, load_catalog(), shipped_library().infos)


def put(scene, key, by_m):
    """The scene with one thing moved."""
    items = []
    for item in scene.objects:
        if item.id == key:
            at = [a + b for a, b in zip(item.pose.position_m, by_m, strict=True)]
            item = item.model_copy(
                update={"pose": item.pose.model_copy(update={"position_m": tuple(at)})}
            )
        items.append(item)
    return scene.model_copy(update={"objects": tuple(items)})


def test_a_shut_drawer_with_what_is_in_it_stands(client):
    assert standing_of(shut(), client) is None


@pytest.mark.parametrize(
    ("by_m", "check"), [((0, 0, 0.05), "unsupported"), ((0.3, 0, 0), "penetrates")]
)
def test_what_travelled_and_cannot_stand_rejects_the_try(by_m, check, client):
    rejection = standing_of(put(shut(), 20, by_m), client)
    assert rejection.cause == Cause("twin", check, None, "milk_carton")
    assert 20 in rejection.objects


def test_what_travelled_into_a_wall_rejects_the_try(client):
    scene = shut()
    wall = next(s for s in scene.home.structures if s.category == "wall")
    at = scene.object(20).pose.position_m
    by_m = [a - b for a, b in zip(wall.pieces[0].center_m, at, strict=True)]
    rejection = standing_of(put(scene, 20, by_m), client)
    assert rejection.cause == Cause("twin", "penetrates", None, "milk_carton")
    assert set(rejection.objects) == {20, wall.id}


def test_bullet_is_told_what_moved_things_could_touch_alone():
    scene = shut()
    facts = Facts(scene, shipped_library().infos)
    there = around({20}, facts)
    assert {10, 20} <= {item.id for item in there.objects} <= {10, 20, 21, 22}
    assert not there.home.structures
    assert around(set(facts.bodies), facts).objects == scene.objects


def test_a_twin_that_takes_a_support_away_rejects_the_try():
    made = toy.bundle(3)
    loose = [  # furniture is never taken away
        item.model_copy(update={"fixed": item.fixed and item.id != 30})
        for item in made.scene.objects
    ]
    made = replace(made, scene=made.scene.model_copy(update={"objects": tuple(loose)}))
    shelf = made.anomalies.anomalies[1].model_copy(update={"object_id": 30})
    records = made.anomalies.model_copy(update={"anomalies": (*made.anomalies.anomalies, shelf)})
    rejection = check_undone(made.scene, records.anomalies, toy.catalog(), toy.infos())
    assert isinstance(rejection, Rejection)
    assert rejection.cause == Cause("twin", "lost_its_support", None, "knife")
    assert rejection.objects == (512,)
