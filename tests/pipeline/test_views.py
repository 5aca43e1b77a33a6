"""A made scene's cameras stand where a robot can, look at places, and decide nothing but once."""

from dataclasses import replace

import numpy as np
import pytest
from sdgen.cameras.choice import Marked, shows
from sdgen.cameras.cover import CANONICAL
from sdgen.cameras.seen import Seen
from sdgen.cameras.spots import spots_of
from sdgen.facts import room_at
from sdgen.hazards.candidates import candidates, weighted_order
from sdgen.hazards.placing import inject_candidate
from sdgen.library.states import state_parts
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline import make_scene, overlook
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.overlook import out_of_view, overlooked
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import draw_spec
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union

OPTIONS = BuildOptions(n=9, seed=7)


@pytest.fixture(scope="module")
def furnished(catalog, library):
    return furnish_for(draw_spec(3, catalog, OPTIONS), 0, catalog, library)


def lane():
    return np.random.default_rng(5)


def poses(home, count):
    return [view.world_from_camera.tolist() for view in home.views[:count]]


def test_views_follow_from_the_furnished_home_and_their_own_lane(furnished):
    """More of them begin with the same, and the home is left as it was."""
    with Client() as client:
        first, second = (overlooked(furnished, count, client, lane()) for count in (8, 11))
        other = overlooked(furnished, 8, client, np.random.default_rng(6))
    assert furnished.views == ()
    assert first.layout is furnished.layout
    assert len(first.views) == CANONICAL
    assert len(second.views) == 11
    assert poses(first, 8) == poses(second, 8) != poses(other, 8)
    assert isinstance(first.context.shows, Seen)


def test_near_misses_out_of_reach_have_a_place_that_views_show(catalog, library):
    """Of each class by reach in most homes, so that what it names is seen harmless, too: of forty
    homes in five of six."""
    by_reach = [hazard for hazard in catalog.hazards if hazard.concerns.by_reach]
    found = []
    with Client() as client:
        for index in range(12):
            spec = draw_spec(index, catalog, OPTIONS)
            tried = (furnish_for(spec, attempt, catalog, library) for attempt in range(5))
            furnished = next(home for home in tried if isinstance(home, FurnishedHome))
            home = overlooked(furnished, 8, client, spec.lane("views:0"))
            for hazard in by_reach:
                high = [one for one in hazard.lookalikes if getattr(one, "min_height_m", None)]
                tried = candidates(hazard.id, high, home.layout, home.context)
                layout = home.layout.copy(iter(range(10**6, 10**6 + 1000)))
                made = (
                    inject_candidate(one, layout, home.context, (), lane(), benign=True)
                    for one in weighted_order(tried, lane())
                )
                found.append(any(one is not None for one in made))
    assert len(found) == 48
    assert sum(found) >= 34


def test_a_hazard_that_no_view_can_show_is_not_tried_for(furnished):
    class Nothing:
        def thing(self, corners_m):
            return False

        def set_to(self, object_id, state):
            return ()

        def anything_on(self, target_id):
            return False

        def floor(self, shape):
            return shape

    with Client() as client:
        home = overlooked(furnished, 8, client, lane())
    object.__setattr__(home.context, "shows", Nothing())
    hidden = out_of_view(home, ("spill", "front_door_open"))
    assert hidden.cause[:3] == ("views", "unseen", "front_door_open")
    assert out_of_view(home, ("spill", "sharp_object")) is None
    object.__setattr__(home.context, "shows", furnished.context.shows)
    assert out_of_view(home, ("spill", "front_door_open")) is None


def test_near_misses_are_marked_by_what_would_show_the_hazard(catalog, library, monkeypatch):
    """A knife on a shelf whose handle alone shows is a near miss no more than it would be a hazard
    on a table."""
    asked = {}

    def record(library, scene, cast, views, marked):
        items = {item.id: item for item in scene.objects}
        asked.update({(one.object_id, items[one.object_id].parts): one for one in marked})
        return shows(library, scene, cast, views, marked)

    monkeypatch.setattr(overlook, "shows", record)
    held_to = set()
    for index in range(60):
        asked.clear()
        made = make_scene(index, catalog, library, OPTIONS)
        near = {one.object_id for one in made.anomalies.lookalikes if "sharp" in one.near_miss_of}
        bladed = {one.object_id: one for (_, parts), one in asked.items() if "blade" in parts}
        held_to |= {(bladed[key].parts, bladed[key].pixels) for key in near & set(bladed)}
        if held_to:
            break
    assert held_to == {(("blade",), catalog.hazard("sharp_object").evidence_pixels)}


def test_nothing_opens_so_far_that_a_room_cannot_be_got_to(furnished, library):
    """Where only a leaf's own sweep is left free, it is opened less far or not at all."""
    context, layout = furnished.context, furnished.layout

    def opened(context):
        found = spots_of(context, layout, lane()).states
        return {
            one.item.id
            for one in found
            if one.state == "OPEN"
            and one.item.category in ("wardrobe", "fridge")
            and "OPEN" not in layout.items[one.item.id].states  # left open by habit
        }

    assert opened(context)
    for one in spots_of(context, layout, lane()).states:
        assert not context.cuts_off(one.item, library.info(one.item.asset))
    # As if the whole home were so narrow that nothing were left beside an open leaf.
    tight = replace(context, free=Polygon())

    assert not opened(tight)
    assert opened(replace(context, free=None)) == opened(context)


@pytest.mark.parametrize("index", [1, 5])
def test_a_state_that_views_are_said_to_show_is_seen_once_it_is_set(catalog, library, index):
    """Alone, with every other door as it stands: of each leaf that is opened, and as far; of a
    front door, by what is seen through it."""
    spec = draw_spec(index, catalog, BuildOptions(seed=960))
    home = furnish_for(spec, 0, catalog, library)
    with Client() as client:
        home = overlooked(home, 8, client, spec.lane("views:0"))
        items = home.layout.items
        tried = 0
        for item in items.values():
            if item.category not in ("fridge", "stove", "front_door"):
                continue
            state = "ON" if item.category == "stove" else "OPEN"
            outdoors = 0
            if item.category == "front_door":
                outdoors = catalog.hazard("front_door_open").evidence_outdoors
                assert outdoors > 0
            for changed in home.context.shows.set_to(item.id, state):
                parts = state_parts(
                    library.info(item.asset), state, changed.variant, changed.joints
                )
                scene = home.scene(0, {**items, item.id: changed})
                with RayWorld(library, scene, client.still) as world:
                    marked = [Marked(item.id, parts, outdoors=outdoors)]
                    assert shows(library, scene, world.cast, home.views, marked).any()
                tried += 1
    assert tried


@pytest.mark.slow
def test_cameras_stand_on_free_floor_at_eye_height(catalog, library):
    for index in (0, 1):
        bundle = make_scene(index, catalog, library, BuildOptions(n=9, seed=7, eye_height_m=1.0))
        kinds = [camera.kind for camera in bundle.cameras]
        assert len(kinds) == 8
        assert kinds.count("near") == 5
        free = unary_union([Polygon(ring) for ring in bundle.scene.free_space]).buffer(0.02)
        for camera in bundle.cameras:
            x, y, z = (row[3] for row in camera.world_from_camera[:3])
            assert free.contains(Point(x, y))
            # Near views of high places are taken from lifted eyes.
            assert -0.2 <= z - 1.0 <= (0.7 if camera.kind == "near" else 0.2)
            room = room_at(bundle.scene.home.rooms, x, y)
            assert room is not None
            assert room.id == camera.room_id
