"""Hazards that an only home has nothing for are not drawn in it; elsewhere all are."""

from __future__ import annotations

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import HomeSpec
from sdgen.errors import UsageError
from sdgen.hazards.hosting import check_named, hosted, hosts
from sdgen.options import BuildOptions
from sdgen.pipeline.spec import draw_spec

CATALOG = load_catalog()
EVERY = tuple(hazard.id for hazard in CATALOG.hazards)


def without(home: HomeSpec, *gone: str) -> HomeSpec:
    rooms = tuple(
        room.model_copy(
            update={"furniture": tuple(p for p in room.furniture if p.category not in gone)}
        )
        for room in home.rooms
    )
    return home.model_copy(update={"rooms": rooms})


def test_shipped_homes_host_every_hazard() -> None:
    for home in CATALOG.homes:
        assert hosted(CATALOG, [home], generated=False) == EVERY


def test_no_fridge_no_fridge_open() -> None:
    bare = without(CATALOG.homes[0], "fridge", "freezer")
    assert not hosts(bare, CATALOG.hazard("fridge_open"), CATALOG)
    left = hosted(CATALOG, [bare], generated=False)
    assert left == tuple(name for name in EVERY if name != "fridge_open")
    # In company a hazard without a place is a mistake in the catalogue, and told.
    assert hosted(CATALOG, [bare, CATALOG.homes[1]], generated=False) == EVERY
    assert hosted(CATALOG, [bare], generated=True) == EVERY


def test_it_is_never_drawn() -> None:
    bare = without(CATALOG.homes[0], "fridge", "freezer")
    alone = CATALOG.model_copy(update={"homes": (bare,)})
    options = BuildOptions(n=40, seed=5, homes="base")
    drawn = {name for k in range(40) for name in draw_spec(k, alone, options).hazards}
    assert drawn == set(EVERY) - {"fridge_open"}


def test_only_the_named_ones_are_drawn_wherever() -> None:
    assert hosted(CATALOG, [], generated=True, only=("spill", "stove_on")) == ("spill", "stove_on")
    bare = CATALOG.homes[0]
    assert hosted(CATALOG, [bare], generated=False, only=("spill",)) == ("spill",)


def test_unknown_names_are_told_all_at_once() -> None:
    check_named(("spill",), CATALOG)
    with pytest.raises(UsageError, match=r"'spil' \(did you mean 'spill'\?\), 'xyzzy'"):
        check_named(("spil", "spill", "xyzzy"), CATALOG)
