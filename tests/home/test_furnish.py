"""Homes drawn by hand: their furniture stands clear of the shell, of doors and of itself."""

import itertools
import math

import pytest
from sdgen.actions import at_rest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import FurnitureItem
from sdgen.facts import Body, bodies_of
from sdgen.freespace import free_shape, opening_rectangle, unreachable_rooms
from sdgen.geometry import quat_from_yaw
from sdgen.hazards.splits import SplitModels
from sdgen.home.furnish import put_piece, stand_in
from sdgen.home.layout import IN_WALL_M, Layout, within_room
from sdgen.home.tenants import Tenants
from sdgen.library.records import AssetInfo
from sdgen.physics.checks import penetrations
from sdgen.physics.world import standing
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.rejection import Cause, Rejection
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane
from sdgen.vocabulary import FLAT_M, OPENINGS, OVERHEAD_M
from sdgen.zones import floor_obstacles, swing_blocked
from shapely.geometry import Polygon

from tests.fakes import box_room, fake_library, thing
from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
(ROOM,) = box_room().home.rooms


def stage(home, number: int, catalog=CATALOG) -> FurnishedHome:
    ids = iter((lane(3, number, "ids").permutation(65535) + 1).tolist())
    models = SplitModels(LIBRARY, "train")
    made = furnished_home(home, catalog, LIBRARY, models, ids, lane(3, number, "furnish"))
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


@pytest.mark.parametrize("home", CATALOG.homes, ids=lambda home: home.id)
@pytest.mark.parametrize("group", ["infant", "toddler"])
def test_an_infant_has_a_cot_and_nobody_else(home, group):
    models = SplitModels(LIBRARY, "train")
    for number in range(3):
        ids = iter((lane(3, number, "ids").permutation(65535) + 1).tolist())
        tenants = Tenants(frozenset({group, "child"}), beds=2)
        made = furnished_home(
            home, CATALOG, LIBRARY, models, ids, lane(3, number, "furnish"), tenants
        )
        assert isinstance(made, FurnishedHome), made
        cots = sum(item.category == "crib" for item in made.layout.items.values())
        assert cots == (group == "infant")


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


def test_what_is_drawn_open_takes_no_way():
    """As in the home that was exported, whose pieces were opened when its ways were known."""
    home = next(home for home in CATALOG.homes if home.id == "apartment_1")
    fridge = next(m for m in LIBRARY.by_category("fridge") if m.extents_m[1] < 0.65)
    joints = {joint.name: joint.upper for joint in fridge.joints}

    def made(**more):
        rooms = [
            room.model_copy(
                update={
                    "furniture": tuple(
                        piece.model_copy(update={"model": fridge.id, **more})
                        if piece.category == "fridge"
                        else piece
                        for piece in room.furniture
                    )
                }
            )
            for room in home.rooms
        ]
        drawn = home.model_copy(update={"rooms": tuple(rooms), "as_drawn": True})
        ids, rng = iter(range(1, 65536)), lane(3, 0, "furnish")
        models = SplitModels(LIBRARY, "train")
        return furnished_home(drawn, CATALOG, LIBRARY, models, ids, rng)

    shut, opened = made(), made(joints=joints)
    assert isinstance(shut, FurnishedHome)
    assert isinstance(opened, FurnishedHome)
    assert any(i.joints == joints for i in opened.layout.items.values() if i.asset == fridge.id)
    assert opened.free_space == shut.free_space
    assert opened.context.zones == shut.context.zones
    # Nothing is put where the door is, all the same.
    assert opened.context.free.area < shut.context.free.area


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


def left_open(share: float):
    """The catalogue, with this share of all that opens left open."""
    categories = tuple(
        c.model_copy(update={"stands_open": share})
        if c.kind == "furniture" and "CAN_OPEN" in c.properties
        else c
        for c in CATALOG.categories
    )
    return CATALOG.model_copy(update={"categories": categories})


@pytest.mark.parametrize("home", CATALOG.homes[:3], ids=lambda home: home.id)
def test_what_is_left_open_has_room_to_and_leaves_a_way(home):
    shut, made = stage(home, 0, left_open(0.0)), stage(home, 0, left_open(1.0))
    items = made.layout.items
    opened = {k for k, item in items.items() if item.joints != shut.layout.items[k].joints}
    assert len(opened) >= 5
    assert all("OPEN" in items[k].states and items[k].fixed for k in opened)
    with standing(LIBRARY, made.scene(0, items)) as world:
        assert penetrations(world) == []
    bodies = bodies_of(items.values(), LIBRARY.infos)
    assert not unreachable_rooms(
        made.context.home, free_shape(shut.context.home, floor_obstacles(bodies))
    )
    assert swing_blocked(bodies) == ()
    rooms = {room.id: Polygon(room.polygon_m).buffer(IN_WALL_M) for room in made.context.home.rooms}
    assert all(rooms[b.item.room_id].covers(b.footprint) for b in bodies if b.item.id in opened)
    # As nobody left it: what follows from the home does not tell what stands open.
    assert made.free_space == shut.free_space
    assert made.context.zones == shut.context.zones


def test_the_catalogue_says_how_often_furniture_is_left_open():
    def opened(catalog):
        made = [stage(home, 1, catalog).layout.items.values() for home in CATALOG.homes]
        names = {c.name for c in catalog.categories if c.kind == "furniture"}
        return [
            i.category
            for items in made
            for i in items
            if i.category in names and "OPEN" in i.states
        ]

    found = [len(opened(left_open(share))) for share in (0.0, 0.3, 1.0)]
    assert found[0] == 0 < found[1] < found[2]
    # What is a hazard when it stands open never does by habit.
    assert {"fridge", "freezer", "stove"}.isdisjoint(
        c.name for c in CATALOG.categories if c.stands_open
    )


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
        placed = put_piece(item, fakes.assets[item.asset], layout, None, ROOM, CATALOG)
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


def turned(yaw_deg: float) -> tuple[float, float, float, float]:
    return quat_from_yaw(math.radians(yaw_deg))


def stands(layout: Layout, piece: ObjectInstance) -> bool:
    """Whether a piece finds room; it stays there if so."""
    asset = layout.library.assets[piece.asset]
    if piece.category not in {category.name for category in CATALOG.categories}:
        piece = piece.model_copy(update={"category": "stove"})
    return put_piece(piece, asset, layout, None, ROOM, CATALOG)


@pytest.mark.parametrize(("x", "y", "opens"), [(1.0, 0, True), (1.2, 0, False), (0, 1.68, False)])
def test_a_leaf_opens_clear_of_the_walls(fakes, x, y, opens):
    """The room ends at 2 m: the leaf goes 0.9 m before the cabinet and 3 cm to its left."""
    cabinet = thing(10, "cabinet_01", (x, y, 0), fixed=True)
    assert stands(Layout(fakes, itertools.count(1)), cabinet) is opens


def test_nothing_stands_where_a_leaf_goes_whichever_came_first(fakes):
    cabinet = thing(10, "cabinet_01", (0, 0, 0), fixed=True)
    for x, y, free in ((0.7, 0.0, False), (1.1, 0.0, True), (0.7, 0.6, True)):
        cube = thing(11, "cube_01", (x, y, 0), fixed=True)
        for pair in ((cabinet, cube), (cube, cabinet)):
            layout = Layout(fakes, itertools.count(1))
            assert stands(layout, pair[0])
            assert stands(layout.copy(), pair[1]) is free, (x, y)
    low = thing(11, "sheet_01", (0.7, 0.0, 0), fixed=True)
    assert stands(layout, low), "the leaf hangs clear of what is as thin as play"


def test_a_seat_is_drawn_back_before_the_drawer_of_its_desk(fakes):
    cabinet = thing(10, "cabinet_01", (0, 0, 0), fixed=True)
    cube = thing(11, "cube_01", (0.7, 0, 0), fixed=True)
    for desk, seat, free in (("desk", "chair", True), ("desk", "stove", False)):
        pieces = (
            cabinet.model_copy(update={"category": desk}),
            cube.model_copy(update={"category": seat}),
        )
        for pair in (pieces, pieces[::-1]):
            layout = Layout(fakes, itertools.count(1))
            assert stands(layout, pair[0])
            assert stands(layout, pair[1]) is free


def test_a_leaf_opens_clear_of_the_frame_of_a_window(fakes):
    layout = Layout(fakes, itertools.count(1))
    frame = thing(11, "cube_01", (0.8, 0, 0.3), fixed=True)
    layout.ways = layout.ways.with_frame(frame.model_copy(update={"category": "window"}), fakes)
    assert not stands(layout, thing(10, "cabinet_01", (0, 0, 0), fixed=True))
    assert stands(layout, thing(10, "cabinet_01", (0, 0, 0), turned(180), fixed=True))


@pytest.mark.parametrize(
    ("piece", "gap", "free"),
    [("coffee_table", 0.45, False), ("coffee_table", 0.55, True), (None, 0.45, False)],
)
def test_who_opens_a_piece_has_room_to_stand_before_it(piece, gap, free):
    """A chest whose lid swings up and back, before a table or a wall, whichever came first."""
    chest = LIBRARY.by_category("toy_box")[0]
    front = chest.extents_m[0] / 2
    if piece is None:
        assert stands(Layout(LIBRARY, itertools.count(1)), shipped(chest, 1.0)) is True
        assert stands(Layout(LIBRARY, itertools.count(1)), shipped(chest, 2 - front - gap)) is free
        return
    table = LIBRARY.by_category(piece)[0]
    pair = shipped(chest, -1.0), shipped(table, -1 + front + gap + table.extents_m[0] / 2, 2)
    for first, second in (pair, pair[::-1]):
        layout = Layout(LIBRARY, itertools.count(1))
        assert stands(layout, first)
        assert stands(layout, second) is free


def shipped(asset: AssetInfo, x: float, number: int = 1) -> ObjectInstance:
    pose = Pose(position_m=(x, 0.0, 0.0), quat_xyzw=quat_from_yaw(0.0))
    return at_rest(
        ObjectInstance(
            id=number, category=asset.category, asset=asset.id, pose=pose, room_id=1, fixed=True
        ),
        asset,
    )


def test_what_opens_over_its_back_stands_off_the_wall_it_is_drawn_at():
    home = next(home for home in CATALOG.homes if home.id == "apartment_1")
    box = FurnitureItem(
        category="toy_box", position_m=(5.29, 0.6, 0.0), yaw_deg=0, against_wall=True
    )
    room = next(r for r in home.rooms if r.name == "bedroom")
    room = room.model_copy(update={"furniture": (box,)})
    rooms = tuple(room if r.name == "bedroom" else r for r in home.rooms)
    made = stage(home.model_copy(update={"rooms": rooms}), 0)
    (item,) = (i for i in made.layout.items.values() if i.category == "toy_box")
    back = item.pose.position_m[0] - LIBRARY.info(item.asset).extents_m[0] / 2
    assert back - 5.26 == pytest.approx(max(0.03, LIBRARY.reach(item.asset).back_m), abs=1e-4)
