"""Fixed things stand, lie in something or hang; what does not is found."""

import pytest
from sdgen.facts import Facts, entered_structures, in_the_air, unheld
from sdgen.facts.thresholds import HUNG_M, ON_GAP_M
from sdgen.scene import Box, Structure

from tests.facts.scenes import FLOOR, HALL_FLOOR, INFOS, ROOM, asset, scene, thing

WALL_FACE_M, CEILING_M = 0.0, 2.6
SHELL = (
    Structure(
        id=90,
        category="wall",
        room_id=ROOM,
        surface="s",
        pieces=(Box(center_m=(WALL_FACE_M - 0.03, 2, 1.3), size_m=(0.06, 4, 2.6)),),
    ),
    Structure(
        id=91,
        category="ceiling",
        room_id=ROOM,
        surface="s",
        pieces=(Box(center_m=(2, 2, CEILING_M + 0.025), size_m=(4, 4, 0.05)),),
    ),
)


def found(*objects):
    base = scene(*objects)
    home = base.home.model_copy(update={"structures": (*base.home.structures, *SHELL)})
    facts = Facts(base.model_copy(update={"home": home}), INFOS)
    return {violation.objects: violation for violation in in_the_air(facts)}


@pytest.mark.parametrize(
    "held",
    [
        thing(1, "sofa", 2, 2),
        thing(1, "sofa", 2, 2, ON_GAP_M.limit - 0.001),
        thing(1, "tv", WALL_FACE_M + 0.05 + HUNG_M - 0.001, 2, 1.2),
        thing(1, "tv", 2, 2, CEILING_M - 0.6 - HUNG_M + 0.001),
        thing(1, "apple", 2, 2, 1.5),  # loose: physics lets it fall
        thing(14, "door", 4.06, 2, 0.5),
    ],
    ids=["stands", "stands nearly", "on the wall", "on the ceiling", "loose", "opening"],
)
def test_what_is_held_is_no_violation(held):
    assert found(held) == {}


def test_what_stands_on_furniture_or_in_it_is_held():
    assert found(thing(1, "table", 2, 2), thing(2, "tv", 2, 2, 0.75)) == {}
    small = thing(2, "box", 2, 2, 0.5).model_copy(update={"fixed": True})
    assert found(thing(1, "fridge", 2, 2), small) == {}


@pytest.mark.parametrize(
    ("item", "gap_m"),
    [
        (thing(1, "sofa", WALL_FACE_M + 0.45 + 0.03, 2, 0.03), 0.03),
        (thing(1, "tv", WALL_FACE_M + 0.05 + HUNG_M + 0.001, 2, 1.2), HUNG_M + 0.001),
        (thing(1, "tv", 2, 2, CEILING_M - 0.6 - 0.1), 0.1),
    ],
    ids=["lifted along its wall", "off the wall", "below the ceiling"],
)
def test_what_is_in_the_air_is_found_with_its_distance(item, gap_m):
    (violation,) = found(item).values()
    assert violation.check == "in_the_air"
    assert violation.measured == pytest.approx(gap_m, abs=1e-6)
    assert violation.limit == HUNG_M


def test_the_table_below_does_not_hold_what_is_above_it():
    assert list(found(thing(1, "table", 2, 2), thing(2, "tv", 2, 2, 0.8))) == [(2,)]


def cube(x, y, z=0.0):
    """Corners of a cube of 4 cm whose base has its middle there."""
    return [(x + a, y + b, z + c) for a in (-0.02, 0.02) for b in (-0.02, 0.02) for c in (0, 0.04)]


SHARDS = asset(
    "shards",
    (0.3, 0.04, 0.04),
    outlines_m={"body": [cube(-0.13, 0), cube(0, 0), cube(0.13, 0)]},
)
AERIAL = asset(
    "aerial",
    (0.3, 0.04, 0.1),
    outlines_m={"body": [cube(-0.13, 0), cube(0, 0), cube(0.13, 0, 0.05)]},
)
LEAF = asset(
    "leaf",
    (0.4, 0.4, 0.4),
    outlines_m={"body": [cube(0, 0)], "door": [[(0, y, z) for y in (0, 0.9) for z in (0, 2)]]},
)
BROKEN = {**INFOS, **{a.id: a for a in (SHARDS, AERIAL, LEAF)}}


def loose(name, x, y, z, **more):
    return thing(2, name, x, y, z, **more)


@pytest.mark.parametrize(
    ("item", "held"),
    [
        (loose("shards", 2, 2, 0.75), True),
        (loose("shards", 2.36, 2, 0.75), True),  # all but a centimetre of its last piece
        (loose("shards", 2.4, 2, 0.75), False),  # two of three are on the table: ON it
        (loose("shards", 2.4, 2, 0.0), True),
        (loose("aerial", 2.4, 2, 0.75), True),  # what is not at its bottom is held by the rest
        (loose("shards", 2, 2, 0.78), False),
    ],
    ids=["on", "nearly", "over the edge", "on the floor", "held by the rest", "above"],
)
def test_every_piece_at_the_bottom_of_a_thing_rests_on_something(item, held):
    facts = Facts(scene(thing(1, "table", 2, 2), item), BROKEN)
    assert list(unheld(facts)) == ([] if held else [2])


@pytest.mark.parametrize(
    ("z", "held"), [(0.5, True), (0.508, True), (0.58, False)], ids=["on", "nearly", "above"]
)
def test_what_floats_over_the_shelf_of_a_fridge_is_held_by_nothing(z, held):
    facts = Facts(scene(thing(1, "fridge", 2, 2), thing(2, "apple", 2, 2, z)), INFOS)
    assert facts.inside(2)
    assert list(unheld(facts)) == ([] if held else [2])
    stacked = scene(
        thing(1, "fridge", 2, 2), thing(2, "apple", 2, 2, 0.58), thing(3, "apple", 2, 2, 0.5)
    )
    assert list(unheld(Facts(stacked, INFOS))) == []


@pytest.mark.parametrize(
    ("item", "into"),
    [
        (thing(2, "apple", 0.05, 2), []),
        (thing(2, "apple", 0.02, 2), [90]),
        (thing(2, "apple", 2, 2, -0.02), [FLOOR, HALL_FLOOR]),
        (loose("leaf", 0.4, 2, 0, joints={"door": 0.0}), []),
        # Its free edge is beyond the wall, where no point of it shows that it went through.
        (loose("leaf", 0.4, 2, 0, joints={"door": 1.57}), [90]),
        (loose("leaf", 1.0, 2, 0, joints={"door": 1.57}), []),
    ],
    ids=["beside", "in the wall", "in the floor", "shut", "open through the wall", "open"],
)
def test_what_reaches_into_the_shell_is_found(item, into):
    base = scene(item)
    home = base.home.model_copy(update={"structures": (*base.home.structures, *SHELL)})
    facts = Facts(base.model_copy(update={"home": home}), BROKEN)
    assert [violation.objects for violation in entered_structures(facts)] == [(2, k) for k in into]
