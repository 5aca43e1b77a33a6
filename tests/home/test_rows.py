"""Rows on shelves: what they are of, where they stand, that they stay."""

from __future__ import annotations

from collections import Counter
from functools import cache
from itertools import pairwise

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.row import Row
from sdgen.geometry import Array, apply, inverse
from sdgen.hazards.splits import SplitModels
from sdgen.home.layout import Intent, Layout
from sdgen.home.rows import SIGHT_M, fill_rows
from sdgen.home.stock import Abodes, Stock
from sdgen.library.records import Asset
from sdgen.physics.client import Client
from sdgen.physics.settle import settle
from sdgen.physics.world import World
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
BOOKS = Row(of=("book_row",))


@cache
def _home() -> FurnishedHome:
    base = next(h for h in CATALOG.homes if h.id == "apartment_1")
    models = SplitModels(shipped_library(), "train")
    stage = furnished_home(
        base, CATALOG, shipped_library(), models, iter(range(1, 60000)), lane(4, 0, "furnish")
    )
    assert isinstance(stage, FurnishedHome)
    return stage


def _asset(name: str) -> Asset:
    return shipped_library().assets[name]


def _shelved(
    model: str, row: Row, seed: int, before: str = "", room_type: str = "living_room"
) -> tuple[Layout, ObjectInstance, list[ObjectInstance]]:
    """A shelf of a model as the home's only furniture, its rows, and what stands in them;
    ``before`` stood in the middle of its lowest board."""
    context, library = _home().context, shipped_library()
    room = next(r for r in context.home.rooms if r.type == room_type)
    x, y = context.ground(room.id).outline.representative_point().coords[0]
    layout = Layout(library, iter(range(70000, 80000)))
    shelf = layout.new_item(_asset(model), ((x, y, 0.0), 0.7), room.id, lift_m=0.0)
    shelf = shelf.model_copy(update={"fixed": True})
    layout.put(shelf)
    if before:
        board = min(layout.surfaces_of(shelf.id), key=lambda surface: surface.z_m)
        middle = board.shape.centroid
        spot = (middle.x, middle.y, board.z_m), 0.7
        layout.put(layout.new_item(_asset(before), spot, room.id), Intent("ON", shelf.id))
    rng = lane(seed, 0, "rows")
    stock = Stock(layout)
    many = fill_rows(layout, shelf, room, [row], Abodes(context), stock, context, rng)
    things = [item for item in layout.items.values() if not item.fixed]
    assert many == len(things) - bool(before)
    return layout, shelf, things[bool(before) :]


def _local(item: ObjectInstance, shelf: ObjectInstance) -> Array:
    return apply(inverse(shelf.pose.matrix()), [item.pose.position_m])[0]


def _ends(item: ObjectInstance, shelf: ObjectInstance) -> tuple[float, float]:
    """From where to where a thing that looks the way of its shelf reaches along it."""
    middle, wide = float(_local(item, shelf)[1]), _asset(item.asset).extents_m[1]
    return middle - wide / 2, middle + wide / 2


def _boards(shelf: ObjectInstance, things: list[ObjectInstance]) -> list[list[ObjectInstance]]:
    levels = _level(things).values()
    return [sorted(row, key=lambda item: _ends(item, shelf)) for row in levels]


def test_books_fill_most_of_each_shelf_and_neither_overlap_nor_stick_out() -> None:
    shares = []
    for seed in range(6):
        layout, shelf, things = _shelved("bookshelf_03", BOOKS, seed)
        boards = [s for s in layout.surfaces_of(shelf.id) if s.support.headroom_m is not None]
        rows = _boards(shelf, things)
        assert len(rows) == len(boards)
        for row in rows:
            ends = [_ends(item, shelf) for item in row]
            assert all(before[1] < after[0] for before, after in pairwise(ends))
            assert ends[0][0] > -0.45
            assert ends[-1][1] < 0.45
            assert len({item.asset for item in row}) == len(row)  # no twins on a board
            shares.append(sum(end - start for start, end in ends) / 0.88)
    assert 0.6 < sum(shares) / len(shares) < 0.9
    assert sum(0.5 < share < 0.95 for share in shares) > 0.8 * len(shares)


def test_a_row_has_no_twin_of_what_stood_there() -> None:
    """Lookalikes are there before the rows are."""
    for seed in range(12):
        _, _, things = _shelved("bookshelf_03", BOOKS, seed)
        # What the lowest board would have.
        lowest, (first, *_) = min(_level(things).items())
        _, _, again = _shelved("bookshelf_03", BOOKS, seed, before=first.asset)
        assert first.asset not in {item.asset for item in _level(again).get(lowest, ())}


def _level(things: list[ObjectInstance]) -> dict[float, list[ObjectInstance]]:
    by_height: dict[float, list[ObjectInstance]] = {}
    for item in things:
        by_height.setdefault(round(item.pose.position_m[2], 2), []).append(item)
    return by_height


def test_a_row_keeps_off_what_stood_there_and_the_sight_of_it() -> None:
    for seed in range(6):
        layout, shelf, things = _shelved("bookshelf_03", BOOKS, seed, before="mug_01")
        mug = next(item for item in layout.items.values() if item.category == "mug")
        low, high = _ends(mug, shelf)
        for item in things:
            if abs(item.pose.position_m[2] - mug.pose.position_m[2]) < 0.1:
                start, end = _ends(item, shelf)
                assert end < low - SIGHT_M + 0.02 or start > high + SIGHT_M - 0.02


def test_a_set_is_of_one_model_and_piles_are_as_high_as_the_row_says() -> None:
    row = Row(of=("towel",), same=True, pile=(2, 3))
    piles = Counter[int]()
    for seed in range(4):
        layout, shelf, things = _shelved("wardrobe_01", row, seed, room_type="bedroom")
        below = Counter(_down(layout, item)[-1] for item in things)
        for item in things:
            assert item.asset == layout.items[_down(layout, item)[-1]].asset
        piles.update(below.values())
    # Of what has no flat top (a rolled towel) there are no piles.
    assert max(piles) == 3
    assert piles[2] > 2 or piles[3] > 2
    glasses = Row(of=("drinking_glass", "wine_glass"), same=True)
    for seed in range(4):
        _, shelf, things = _shelved("wall_cabinet_01", glasses, seed, room_type="kitchen")
        assert all(len({item.asset for item in row}) == 1 for row in _boards(shelf, things))


def _down(layout: Layout, item: ObjectInstance) -> list[int]:
    """The ids of a pile from a thing in it down."""
    ids = [item.id]
    while not layout.items[layout.intents[ids[-1]].target_id].fixed:
        ids.append(layout.intents[ids[-1]].target_id)
    return ids


def test_a_board_under_the_open_air_takes_rows_only_when_the_row_says_so() -> None:
    assert not _shelved("wall_shelf_01", BOOKS, 1)[2]
    assert _shelved("wall_shelf_01", Row(of=("book_row",), top=True), 1)[2]


def test_shoes_reach_over_the_edge_of_their_rack() -> None:
    assert not any(
        item.asset == "shoe_01" for item in _shelved("shoe_rack_01", Row(of=("shoe",)), 1)[2]
    )
    pairs = _shelved("shoe_rack_01", Row(of=("shoe",), filled=(1.0, 1.0), over_m=0.05), 1)[2]
    assert len(pairs) >= 3


def test_only_what_lives_there_and_only_in_rooms_of_the_row_s() -> None:
    assert not _shelved("bookshelf_03", Row(of=("frying_pan",)), 1)[2]
    assert not _shelved("bookshelf_03", Row(of=("book_row",), rooms=("office",)), 1)[2]
    assert not _shelved("bookshelf_03", Row(of=("book_row",), chance=0.0), 1)[2]


@pytest.mark.parametrize(
    ("model", "row", "room_type"),
    [
        ("bookshelf_03", BOOKS, "living_room"),
        ("wardrobe_01", Row(of=("towel", "clothes_pile"), pile=(2, 3)), "bedroom"),
        ("wall_cabinet_01", Row(of=("drinking_glass",), same=True), "kitchen"),
        ("shoe_rack_01", Row(of=("shoe",), filled=(1.0, 1.0), over_m=0.05), "living_room"),
    ],
)
def test_rows_and_piles_rest_where_they_were_put(model: str, row: Row, room_type: str) -> None:
    layout, _, things = _shelved(model, row, 3, room_type=room_type)
    loose = {item.id for item in things}
    with Client() as client:
        world = World(shipped_library(), client)
        world.become(_home().scene(0, layout.items), loose)
        settled = settle(world)
    assert len(things) > 2
    assert max(settled.drift_m.values()) < 0.01
    assert not settled.unstable


def test_wide_rows_are_of_fewer_things_and_one_thing_stands_beside_them() -> None:
    wide = Row(of=("book_row",), wide=True)
    many = [
        sum(len(_shelved("bookshelf_03", row, s)[2]) for s in range(6)) for row in (BOOKS, wide)
    ]
    assert many[1] < 0.85 * many[0]
    row = Row(of=("book_row",), filled=(0.4, 0.5), wide=True, beside=("vase", "speaker"))
    beside = 0
    for seed in range(6):
        _, shelf, things = _shelved("bookshelf_03", row, seed)
        for board in _boards(shelf, things):
            others = [item for item in board if item.category != "book_row"]
            assert len(others) <= 1
            beside += len(others)
            ends = [_ends(item, shelf) for item in board]
            assert all(before[1] < after[0] for before, after in pairwise(ends))
    assert beside > 3


def test_boards_one_above_the_other_show_no_twins_where_there_are_others() -> None:
    twins = pairs = 0
    for seed in range(16):
        rows = [
            models for _, models in sorted(_level(_shelved("bookshelf_08", BOOKS, seed)[2]).items())
        ]
        for lower, upper in pairwise([{item.asset for item in row} for row in rows]):
            pairs += len(upper)
            twins += len(lower & upper)
    assert pairs > 20
    assert twins < 0.1 * pairs


def test_a_pile_of_books_is_of_different_ones_and_of_towels_of_one() -> None:
    piles = {"book": 0, "towel": 0}
    for name, room_type in (("book", "living_room"), ("towel", "bedroom")):
        model = "bookshelf_03" if name == "book" else "wardrobe_01"
        for seed in range(4):
            row = Row(of=(name,), pile=(2, 3))
            layout, _, things = _shelved(model, row, seed, room_type=room_type)
            for item in things:
                below = layout.items[layout.intents[item.id].target_id]
                if below.category == name:
                    piles[name] += 1
                    assert (below.asset == item.asset) == (name == "towel")
    assert min(piles.values()) > 3


def test_most_narrow_compartments_hold_something() -> None:
    row = Row(of=("book_row", "photo_frame"), filled=(0.6, 0.8))
    layout, shelf, things = _shelved("bookshelf_05", row, 2)
    boards = [s for s in layout.surfaces_of(shelf.id) if s.support.headroom_m is not None]
    assert len(things) >= 0.7 * len(boards)
