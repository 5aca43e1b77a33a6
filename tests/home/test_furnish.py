"""Homes drawn by hand: their furniture stands clear of the shell, of doors and of itself."""

import itertools

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import FurnitureItem
from sdgen.facts import Body
from sdgen.freespace import opening_rectangle
from sdgen.geometry import quat_from_yaw
from sdgen.hazards.splits import SplitModels
from sdgen.home.furnish import put_piece, stand_in
from sdgen.home.layout import IN_WALL_M, Layout, within_room
from sdgen.physics.checks import penetrations
from sdgen.physics.world import standing
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.rejection import Cause, Rejection
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane
from sdgen.vocabulary import FLAT_M, OPENINGS, OVERHEAD_M

from tests.fakes import box_room, fake_library, thing
from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()


def stage(home, number: int) -> FurnishedHome:
    ids = iter((lane(3, number, "ids").permutation(65535) + 1).tolist())
    models = SplitModels(LIBRARY, "train")
    made = furnished_home(home, CATALOG, LIBRARY, models, ids, lane(3, number, "furnish"))
    assert isinstance(made, FurnishedHome), made
    return made


@pytest.mark.parametrize("home", CATALOG.homes, ids=lambda home: home.id)
def test_base_homes_hold_no_furniture_that_cuts_or_blocks_a_doorway(home):
    for number in range(3):
        made = stage(home, number)
        with standing(LIBRARY, made.scene(0, made.layout.items)) as world:
            assert penetrations(world) == []
        doorways = [
            opening_rectangle(opening, 0.6)
            for opening in made.context.home.openings
            if opening.kind != "window"
        ]
        for item in made.layout.items.values():
            body = Body(item, made.layout.info(item.id))
            flat = body.high[2] <= FLAT_M or body.low[2] >= OVERHEAD_M
            if item.category not in OPENINGS and not flat:
                assert not any(body.footprint.intersects(d) for d in doorways), item.category


def test_a_home_with_a_piece_in_a_doorway_is_rejected():
    """Beside the way through, clear of the leaf: the hall can be reached all the same."""
    home = next(home for home in CATALOG.homes if home.id == "apartment_1")
    bin_ = FurnitureItem(category="trash_bin", position_m=(5.1, 4.9, 0.0))
    rooms = [
        room.model_copy(update={"furniture": (*room.furniture, bin_)})
        if room.name == "hall"
        else room
        for room in home.rooms
    ]
    home = home.model_copy(update={"rooms": tuple(rooms)})
    ids = iter(range(1, 65536))
    rejection = furnished_home(
        home, CATALOG, LIBRARY, SplitModels(LIBRARY, "train"), ids, lane(3, 0, "furnish")
    )
    assert isinstance(rejection, Rejection)
    assert rejection.cause == Cause("home", "in_doorway", category="trash_bin")


@pytest.mark.parametrize("name", ["floor_lamp", "tv"])
def test_the_catalogue_says_how_often_furniture_is_switched_on(name):
    asset = next(a for a in LIBRARY.assets.values() if a.category == name)
    piece = ObjectInstance(
        id=1,
        category=name,
        asset=asset.id,
        pose=Pose(position_m=(0.0, 0.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0)),
        room_id=1,
        fixed=True,
    )

    def share_on(switched_on: float) -> float:
        categories = tuple(
            c.model_copy(update={"switched_on": switched_on}) if c.name == name else c
            for c in CATALOG.categories
        )
        catalog = CATALOG.model_copy(update={"categories": categories})
        rng = lane(1, 2, "stand")
        return sum("ON" in stand_in(piece, asset, catalog, rng).states for _ in range(300)) / 300

    assert share_on(0.0) == 0.0
    assert share_on(1.0) == 1.0
    # Three standard deviations of 300 draws.
    assert share_on(0.35) == pytest.approx(0.35, abs=0.083)


@pytest.fixture
def fakes(tmp_path):
    return fake_library(tmp_path / "assets")


def test_a_leaf_that_opens_into_a_wall_is_not_within_the_room(fakes):
    layout = Layout(fakes, itertools.count(1))
    home = box_room().home
    for joint, inside in ((0.0, True), (-1.5, False)):
        cabinet = thing(10, "cabinet_01", (1.6, 0, 0), joints={"door": joint}, fixed=True)
        assert within_room(layout.blocks_of(cabinet), home, 1) is inside
    for z, inside in ((1.7, True), (1.71, False)):
        hung = thing(10, "cabinet_01", (0, 0, z), fixed=True)
        assert within_room(layout.blocks_of(hung), home, 1) is inside
    near = thing(10, "cube_01", (1.9 + IN_WALL_M, 0, 0), fixed=True)
    assert within_room(layout.blocks_of(near), home, 1)


def test_a_thin_rug_lies_under_furniture_and_a_thick_one_clear_of_it(fakes):
    layout = Layout(fakes, itertools.count(1))

    def rug(model: str, y: float = 0.0) -> ObjectInstance:
        pose = Pose(position_m=(0.0, y, 0.0), quat_xyzw=quat_from_yaw(0.0))
        return ObjectInstance(id=20, category="rug", asset=model, pose=pose, room_id=1, fixed=True)

    def lies(item: ObjectInstance) -> bool:
        placed = put_piece(item, fakes.assets[item.asset], layout, None)
        if placed:
            layout.drop(item.id)
        return placed

    layout.put(thing(10, "table_01", (0, 0, 0), fixed=True))
    assert lies(rug("sheet_01"))
    assert not lies(rug("plank_01"))
    assert lies(rug("plank_01", 0.2)), "beside the leg, under the top"
    layout.put(thing(12, "plank_01", (0, 0.2, 0), fixed=True))
    assert not lies(rug("sheet_01", 0.2)), "over another rug"
    leaf = thing(11, "cabinet_01", (-0.5, 0, 0), joints={"door": -1.5}, fixed=True)
    layout.put(leaf.model_copy(update={"category": "door"}))
    assert not lies(rug("sheet_01", 0.3)), "under an open leaf"
