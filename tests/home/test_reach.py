"""Everyday things that a child must not get lie where it does not, not even by climbing."""

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.facts import bodies_of
from sdgen.geometry import quat_from_yaw
from sdgen.home.reach import Reach
from sdgen.scene import ObjectInstance, Pose

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()


def beside(category, x, model=0):
    """What children reach beside a piece of furniture at ``x`` of room 2."""
    asset = LIBRARY.by_category(category)[model]
    pose = Pose(position_m=(x, 0.0, 0.0), quat_xyzw=quat_from_yaw(0.0))
    item = ObjectInstance(id=5, category=category, asset=asset.id, pose=pose, room_id=2, fixed=True)
    return Reach(CATALOG, bodies_of([item], LIBRARY.infos))


def spot(x, z):
    return (x, 0.0, z), 0.0


def test_how_high_a_thing_must_lie_follows_from_the_hazards():
    reach = beside("plant_pot", 0.0)
    assert reach.needed_m(LIBRARY.by_category("knife")[0]) == pytest.approx(1.48)
    assert reach.needed_m(LIBRARY.by_category("marbles")[0]) == pytest.approx(1.08)
    assert reach.needed_m(LIBRARY.by_category("book")[0]) is None
    for glass in LIBRARY.by_category("wine_glass"):
        full = "with wine" in glass.title
        assert reach.needed_m(glass) == (pytest.approx(1.33) if full else None)


@pytest.mark.parametrize(
    ("category", "x", "z", "beyond"),
    [
        ("chair", 3.0, 1.2, False),  # too low, wherever the chair stands
        ("chair", 3.0, 1.6, True),
        ("chair", 0.3, 1.6, False),
        ("chair", 0.3, 2.0, True),
        ("plant_pot", 0.3, 1.6, True),
    ],
)
def test_a_shelf_beside_a_chair_is_within_reach(category, x, z, beyond):
    knife = LIBRARY.by_category("knife")[0]
    assert beside(category, x).beyond(knife, spot(0.0, z), 2) is beyond
    assert beside(category, x).beyond(LIBRARY.by_category("book")[0], spot(0.0, z), 2)


def test_a_chair_in_the_next_room_is_no_help():
    knife = LIBRARY.by_category("knife")[0]
    assert beside("chair", 0.3).beyond(knife, spot(0.0, 1.6), 3)


def test_a_higher_stool_lifts_higher():
    """The second stool's seat is at 0.64 m, those of most at 0.45 m."""
    knife = LIBRARY.by_category("knife")[0]
    beyond = [beside("stool", 0.3, model).beyond(knife, spot(0.0, 2.0), 2) for model in (0, 1)]
    assert beyond == [True, False]


def test_all_that_is_sat_or_lain_on_is_climbed_on():
    lain = {c.name for c in CATALOG.categories if {"SITTABLE", "LIEABLE"} & set(c.properties)}
    assert lain <= CATALOG.climbs.keys()


#: Furniture that is low and yet no step: it lies flat, or stands on other furniture.
NO_STEP = {"rug", "bath_mat", "microwave"}


def test_all_whose_models_have_a_low_top_are_climbed_on():
    """Nightstands and television stands are as low as beds."""
    low = set()
    for category in CATALOG.categories:
        models = LIBRARY.by_category(category.name) if category.kind == "furniture" else ()
        tops = [max((s.z_m for s in m.supports if s.container is None), default=9) for m in models]
        if tops and sum(top <= 0.6 for top in tops) > len(tops) / 2:
            low.add(category.name)
    hung = {c.name for c in CATALOG.categories if "HANGABLE" in c.properties}
    assert {"nightstand", "side_table", "tv_stand"} <= low
    assert low - NO_STEP - hung <= CATALOG.climbs.keys()


@pytest.mark.parametrize(("category", "lifts_m"), [("nightstand", 0.6), ("tv_stand", 0.44)])
def test_one_stands_on_the_top_not_on_a_shelf_or_in_a_drawer_below(category, lifts_m):
    model = next(
        k
        for k, m in enumerate(LIBRARY.by_category(category))
        if m.extents_m[2] == pytest.approx(lifts_m, abs=0.01)
    )
    knife = LIBRARY.by_category("knife")[0]
    near = beside(category, 0.3, model)
    assert not near.beyond(knife, spot(0.0, 1.44 + lifts_m), 2)
    assert near.beyond(knife, spot(0.0, 1.5 + lifts_m), 2)
