"""What does not stay of an imported home: furniture at once, things where no try keeps them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from itertools import count
from typing import Any

import pytest
from sdgen.catalog.records import FurnitureItem, HomeSpec, ThingItem
from sdgen.importing.scenes import prove
from sdgen.importing.scenes.prove import Key, unkept
from sdgen.importing.scenes.read import _with_carried, _without

from tests.importing.scenes.homes import CATALOG
from tests.shipped import shipped_library

LIBRARY = shipped_library()
MUG = ThingItem(category="mug", model="mug_03", position_m=(4.9, 6.2, 0.002))


def first_home(things: Collection[ThingItem] = ()) -> HomeSpec:
    """The first base home as it is drawn, with these things in its hall."""
    spec = next(home for home in CATALOG.homes if home.id == "apartment_1")
    rooms = [
        room.model_copy(update={"things": tuple(things)}) if room.name == "hall" else room
        for room in spec.rooms
    ]
    return spec.model_copy(update={"rooms": tuple(rooms), "as_drawn": True})


@pytest.mark.parametrize("trembling", [{1}, {0, 1, 2}], ids=["in_one_try", "in_every_try"])
def test_a_thing_that_trembles_now_and_then_is_kept(
    trembling: set[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a mug on a coaster does in one order of thirty of the simulator's bodies."""
    spec = first_home([MUG])
    tries, rest = count(), prove.come_to_rest

    def trembles_on(index: int, home: Any, contents: Any, *more: Any) -> Any:
        rested = rest(index, home, contents, *more)
        assert rested.offenders == {}
        if next(tries) not in trembling:
            return rested
        (mug,) = (key for key, item in contents.items.items() if not item.fixed)
        why = contents.objection(mug, "physics", "would_not_stand")
        return replace(rested, offenders={mug: why})

    monkeypatch.setattr(prove, "come_to_rest", trembles_on)
    found = unkept(spec, CATALOG, LIBRARY)
    hall = [room.name for room in spec.rooms].index("hall")
    if len(trembling) < 3:
        assert found.pieces == {}
        (line,) = found.told
        assert line.startswith("mug in hall: kept, but in 1 of 3 tries")
        assert "would not stand" in line
    else:
        assert found.pieces == {Key(hall, "things", 0): "would not stand"}
        assert found.told == ()


def test_what_stood_on_a_piece_that_goes_is_told_too() -> None:
    spec = first_home()
    hall = [room.name for room in spec.rooms].index("hall")
    stack = tuple(
        FurnitureItem(category=category, position_m=(5.0, 5.0, 0.0), on=on)
        for category, on in (("desk", None), ("shelf", "desk"), ("tv", "shelf"), ("bed", None))
    )
    room = spec.rooms[hall].model_copy(update={"furniture": stack})
    spec = spec.model_copy(update={"rooms": (*spec.rooms[:hall], room, *spec.rooms[hall + 1 :])})
    gone = _with_carried(spec, {Key(hall, "furniture", 0): "cuts into the bed"})
    assert gone == {
        Key(hall, "furniture", 0): "cuts into the bed",
        Key(hall, "furniture", 1): "the desk that carried it is left out",
        Key(hall, "furniture", 2): "the shelf that carried it is left out",
    }
    assert [item.category for item in _without(spec, gone).rooms[hall].furniture] == ["bed"]
