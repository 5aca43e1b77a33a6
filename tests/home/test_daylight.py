"""When a home is seen: from a lane of its own, that knows nothing of what lies in it."""

from collections import Counter

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.home.daylight import TIMES, daylight_random
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Rejection
from sdgen.seeding import lane
from sdgen.vocabulary import SEASONS


def test_hours_come_as_often_as_they_should_and_the_sun_from_everywhere() -> None:
    found = [daylight_random("summer", lane(1, k, "daylight")) for k in range(600)]
    times = Counter(one.time for one in found)
    for time, share in TIMES.items():
        assert times[time] / 600 == pytest.approx(share, abs=0.06)
    quarters = Counter(int(one.sun_azimuth_deg // 90) for one in found)
    assert min(quarters.values()) > 100
    by_day = [one.sun_elevation_deg for one in found if one.time == "day"]
    evenings = [one.sun_elevation_deg for one in found if one.time == "evening"]
    assert max(evenings) <= 14 <= min(by_day)


def test_the_sun_stands_higher_in_summer() -> None:
    highest = {
        season: max(
            daylight_random(season, lane(1, k, "daylight")).sun_elevation_deg for k in range(200)
        )
        for season in SEASONS
    }
    assert highest["summer"] > highest["spring"] > highest["winter"]


def test_it_depends_on_neither_hazards_nor_tries() -> None:
    catalog, library = load_catalog(), load_library()
    options = BuildOptions(seed=5, homes="procedural")
    bare = options.model_copy(update={"hazards_min": 0, "hazards_max": 0})
    seen = set()
    for one in (options, bare):
        spec = draw_spec(3, catalog, one)
        for home_attempt in range(3):
            home = furnish_for(spec, home_attempt, catalog, library)
            if not isinstance(home, Rejection):
                daylight = home.context.home.daylight
                seen.add((daylight.time, daylight.sun_azimuth_deg))
    assert len(seen) == 1


def test_a_scene_its_twin_and_their_views_are_of_one_hour() -> None:
    options = BuildOptions(seed=5, hazards_min=1, twins=True)
    bundle = make_scene(2, load_catalog(), load_library(), options)
    assert bundle.twin is not None
    hour = bundle.scene.home.daylight
    assert bundle.twin.scene.home.daylight == hour
    assert {camera.daylight == hour for camera in (*bundle.cameras, *bundle.twin.cameras)} == {True}
