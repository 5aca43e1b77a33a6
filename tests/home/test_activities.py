"""Living traces: groups stand where people do things, whole, out of the way."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import pytest
from sdgen.catalog.activity import Activity, Member
from sdgen.catalog.load import load_catalog
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.activities import add_activities
from sdgen.home.frames import Frame, beside, half_reach
from sdgen.home.layout import Layout
from sdgen.home.stock import Stock
from sdgen.home.tenants import Tenants
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
HOMES = ("three_room_flat_2", "apartment_1", "country_house_3")


@cache
def _stage(home: str, tidiness: float, *own: Activity) -> FurnishedHome:
    catalog = CATALOG.model_copy(update={"activities": own}) if own else CATALOG
    base = next(h for h in CATALOG.homes if h.id == home)
    models, ids = SplitModels(shipped_library(), "test"), iter(range(1, 60000))
    tenants = Tenants(frozenset({"child"}), 2, tidiness=tidiness)
    rng = lane(3, 0, "furnish")
    stage = furnished_home(base, catalog, shipped_library(), models, ids, rng, tenants)
    assert isinstance(stage, FurnishedHome)
    return stage


def _lived_in(home: str, tidiness: float, *own: Activity) -> tuple[FurnishedHome, Layout]:
    stage = _stage(home, tidiness, *own)
    layout = stage.layout.copy(iter(range(60000, 65000)))
    add_activities(layout, stage.context, Stock(layout), lane(3, 0, "place"))
    return stage, layout


def _loose(layout: Layout, category: str = "") -> list[ObjectInstance]:
    things = (item for item in layout.items.values() if not item.fixed)
    return [item for item in things if category in ("", item.category)]


LAID = Activity(
    name="laid",
    at=("dining_table", "kitchen_table"),
    where="seat",
    places=(8, 8),
    members=(
        Member(thing=("plate",), at=(0.17, 0.0), needed=True),
        Member(thing=("fork",), beside="plate", side="left"),
    ),
)


@pytest.mark.parametrize("home", HOMES)
def test_every_home_shows_what_is_done_in_it(home: str) -> None:
    _, layout = _lived_in(home, 0.5)
    assert len(_loose(layout)) >= 12


def test_the_same_draw_leaves_the_same_traces() -> None:
    first, second = (_lived_in(HOMES[0], 0.3)[1] for _ in range(2))
    assert first.items == second.items


def test_a_table_is_laid_before_its_chairs_with_plates_of_one_kind() -> None:
    laid = 0
    for home in HOMES:
        _, layout = _lived_in(home, 1.0, LAID)
        plates = _loose(layout, "plate")
        by_table: dict[int, set[str]] = {}
        for plate in plates:
            by_table.setdefault(layout.intents[plate.id].target_id, set()).add(plate.asset)
            seats = [
                math.dist(seat.pose.position_m[:2], plate.pose.position_m[:2])
                for seat in layout.items.values()
                if seat.category in ("chair", "bench", "stool", "high_chair")
            ]
            assert min(seats) < 0.9
        assert all(len(models) == 1 for models in by_table.values())
        laid += len(plates)
    assert laid >= 4


def test_a_fork_lies_to_the_left_of_its_plate_as_it_is_seen_from_the_seat() -> None:
    forks = 0
    for home in HOMES:
        _, layout = _lived_in(home, 1.0, LAID)
        things = _loose(layout)
        for plate, fork in pairwise(things):
            if (plate.category, fork.category) != ("plate", "fork"):
                continue
            # Fronts look at the person: what is on their left is on the plate's right.
            view = Frame(plate.pose.position_m[:2], yaw_of(plate.pose.quat_xyzw) + math.pi)
            left = view.point((0.0, 0.1))
            right = view.point((0.0, -0.1))
            at = fork.pose.position_m[:2]
            assert math.dist(at, left) < math.dist(at, right)
            forks += 1
    assert forks >= 3


def test_nothing_needed_is_missing() -> None:
    impossible = LAID.model_copy(
        update={"members": (*LAID.members, Member(thing=("bed",), at=(0.2, 0.0), needed=True))}
    )
    _, layout = _lived_in(HOMES[0], 1.0, impossible)
    assert _loose(layout) == []


def test_what_belongs_to_messy_homes_is_in_no_tidy_one() -> None:
    messy = LAID.model_copy(update={"tidiness": (0.0, 0.5)})
    assert _loose(_lived_in(HOMES[0], 0.2, messy)[1])
    assert not _loose(_lived_in(HOMES[0], 0.9, messy)[1])


def test_a_place_ahead_and_to_the_left() -> None:
    x, y = Frame((1.0, 2.0), math.pi / 2).point((0.3, 0.1))
    assert (x, y) == pytest.approx((0.9, 2.3))


def test_what_stands_beside_touches_neither() -> None:
    half, own = half_reach((0.2, 0.4, 0.1), 0.0), half_reach((0.2, 0.4, 0.1), math.pi / 2)
    assert own == pytest.approx((0.2, 0.1))
    middle = beside((0.0, 0.0), half, own, "left", 0.05, Frame((0.0, 0.0), 0.0))
    assert middle == pytest.approx((0.0, 0.35))
