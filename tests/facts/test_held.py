"""Fixed things stand, lie in something or hang; what does not is found."""

import pytest
from sdgen.facts import Facts, in_the_air
from sdgen.facts.thresholds import HUNG_M, ON_GAP_M
from sdgen.scene import Box, Structure

from tests.facts.scenes import INFOS, ROOM, scene, thing

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
