"""Openings of a home, and the furniture of one drawn by hand: which model stands where."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from shapely.geometry import Point, Polygon

from sdgen.actions import at_rest, in_state, settled_states
from sdgen.catalog.home_shape import frame_size
from sdgen.catalog.records import Catalog, Category, FurnitureItem, HomeSpec, RoomSpec
from sdgen.facts import bodies_of
from sdgen.geometry import Vec3, apply, quat_from_yaw, round_position, round_quat
from sdgen.home.anchors import BACK_GAP_M
from sdgen.home.blocks import Block
from sdgen.home.context import HomeContext, Models
from sdgen.home.hoods import underside_of
from sdgen.home.layout import Intent, Layout, room_to_change, within_room
from sdgen.home.style import HomeStyle
from sdgen.home.ways import stand_of, way_of
from sdgen.library import Library
from sdgen.library.records import Asset, AssetInfo
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import DOORS, FLAT_M, INNER_DOORS, ON_BARE_WALLS, OPENINGS, PRESSED_M
from sdgen.zones import swing_blocked

#: Of the pieces a drawn home marks optional, so many stand: chosen by eye, for variety.
OPTIONAL_SHARE = 0.75
#: Of interior doors, so many stand open: most, as in homes. Here and not in YAML, as it is one
#: number of one category, not a field that others would have.
DOOR_OPEN_SHARE = 0.8
#: How far an open leaf is turned, in shares of what its hinge lets it: at the least, a leaf of
#: 0.9 m leaves 0.5 m to walk through; few lean on the wall.
DOOR_OPEN = (0.6, 0.98)
#: A model fits a hole of its size to so much: frames differ by a moulding.
HOLE_FITS_M = 0.06


def fill_openings(
    spec: HomeSpec, home: Home, layout: Layout, style: HomeStyle, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with doors and windows in their holes, those of one size of one model; rejected
    when no model has the size."""
    chosen: dict[tuple[str, float], AssetInfo] = {}
    for source, opening in zip(spec.openings, home.openings, strict=True):
        width, _ = frame_size(source)
        fitting = [m for m in models(opening.kind) if abs(m.extents_m[1] - width) < HOLE_FITS_M]
        if not fitting:
            return reject("home", "no_model_fits", category=opening.kind)
        fitting = list(style.matching(fitting))
        drawn = fitting[int(rng.integers(len(fitting)))]
        asset = chosen.setdefault((opening.kind, width), drawn)
        named = [m for m in layout.library.by_category(opening.kind) if m.id == source.model]
        asset = named[0] if named else asset
        item = ObjectInstance(
            id=opening.object_id,
            category=opening.kind,
            asset=asset.id,
            pose=Pose(position_m=opening.center_m, quat_xyzw=round_quat(_inwards(opening, home))),
            room_id=opening.room_ids[0],
            fixed=True,
        )
        item = at_rest(item, asset)
        if source.joints:
            item = _standing(item, asset, source.joints)
        elif spec.as_drawn:
            pass
        elif opening.kind in INNER_DOORS and rng.random() < DOOR_OPEN_SHARE:
            # Beside a corner a leaf turns no further than along the other wall.
            turned = float(rng.uniform(*DOOR_OPEN))
            wide = _opened(item, asset, turned, math.inf)
            square = _opened(item, asset, turned, math.pi / 2)
            fits = within_room(layout.blocks_of(wide), home, opening.room_ids[0], opening)
            item = wide if fits else square
        layout.put(item)
        layout.ways = layout.ways.with_frame(item, layout.library)
    return layout


def _standing(
    item: ObjectInstance, asset: AssetInfo, joints: Mapping[str, float], variant: str = "default"
) -> ObjectInstance:
    """A piece with its joints (those that it has) and variant as a drawing says."""
    limits = {joint.name: (joint.lower, joint.upper) for joint in asset.joints}
    given = {
        name: round(min(max(value, limits[name][0]), limits[name][1]), 4)
        for name, value in joints.items()
        if name in limits
    }
    variant = variant if variant in asset.variants else "default"
    joints_now = {**item.joints, **given}
    return settled_states(item.model_copy(update={"joints": joints_now, "variant": variant}), asset)


def _opened(item: ObjectInstance, asset: AssetInfo, share: float, most: float) -> ObjectInstance:
    """A door with its leaves turned by a share of what they can, but no further than ``most``."""
    joints = {j.name: round(min(share * j.upper, most), 4) for j in asset.joints}
    return settled_states(item.model_copy(update={"joints": joints}), asset)


def _inwards(opening: Opening, home: Home) -> tuple[float, float, float, float]:
    """Heading of an opening: +X points into its first room."""
    room = next(r for r in home.rooms if r.id == opening.room_ids[0])
    outline = Polygon(room.polygon_m)
    x, y, _ = opening.center_m
    steps = ((0.0, 1.0), (0.0, -1.0)) if opening.along == "x" else ((1.0, 0.0), (-1.0, 0.0))

    def inside(step: tuple[float, float]) -> float:
        probe = Polygon(
            [
                (x + step[0] * 0.2 + dx, y + step[1] * 0.2 + dy)
                for dx, dy in ((-0.05, -0.05), (0.05, -0.05), (0.05, 0.05), (-0.05, 0.05))
            ]
        )
        return float(outline.intersection(probe).area)

    dx, dy = max(steps, key=inside)
    return quat_from_yaw(math.atan2(dy, dx))


def furnish_as_drawn(
    spec: HomeSpec,
    home: Home,
    layout: Layout,
    catalog: Catalog,
    style: HomeStyle,
    models: Models,
    theirs: Models,
    rng: Rng,
) -> Layout | Rejection:
    """The layout with the furniture of every room where the base home has it; of optional pieces
    only what is ``theirs`` who live there."""
    for source, room in zip(spec.rooms, home.rooms, strict=True):
        furnished = _furnish_room(
            source, room, layout, catalog, style, models, theirs, rng, spec.as_drawn
        )
        if isinstance(furnished, Rejection):
            return furnished
        layout = furnished
    return layout


def _furnish_room(
    source: RoomSpec,
    room: Room,
    layout: Layout,
    catalog: Catalog,
    style: HomeStyle,
    models: Models,
    theirs: Models,
    rng: Rng,
    as_drawn: bool,
) -> Layout | Rejection:
    placed: dict[str, list[int]] = {}
    hung = {fitting.category for fitting in catalog.fittings if fitting.where in ON_BARE_WALLS}
    for piece in source.furniture:
        skip = rng.random() >= OPTIONAL_SHARE
        # What belongs to somebody stands wherever they live: an infant's cot.
        if piece.optional and skip and not catalog.category(piece.category).belongs_to:
            continue
        among = theirs if piece.optional else models
        wide = candidates_for(piece, among, layout.library)
        order = [wide[k] for k in rng.permutation(len(wide)).tolist()] if wide else []
        # Of the home's style first. Chairs round a table, and tables beside a bed, are of one model
        # where it fits; of pictures nobody hangs one twice.
        there = {layout.items[k].asset for k in placed.get(piece.category, ())}
        matching = {model.id for model in style.matching(wide)}
        alike = piece.category not in hung
        order.sort(key=lambda m: ((m.id in there) != alike, m.id not in matching))
        done = False
        for model in order:
            done = _try_piece(piece, model, room, layout, catalog, placed, rng, as_drawn)
            if done:
                break
        if not done and not piece.optional:
            return reject("home", "no_place", category=piece.category)
    return layout


def candidates_for(piece: FurnitureItem, models: Models, library: Library) -> list[Asset]:
    """The models that a piece of a drawing may be; the one it names, whatever ``models`` has: who
    draws it wants that one, in every split."""
    if piece.model is not None:
        return [m for m in library.by_category(piece.category) if m.id == piece.model]
    found = models(piece.category)
    if piece.width_m is None:
        return list(found)
    least, most = piece.width_m
    return [m for m in found if least <= m.extents_m[1] <= most]


def _try_piece(
    piece: FurnitureItem,
    asset: AssetInfo,
    room: Room,
    layout: Layout,
    catalog: Catalog,
    placed: dict[str, list[int]],
    rng: Rng,
    as_drawn: bool,
) -> bool:
    drawn = drawn_at(piece, asset, room, layout, placed, rng)
    if drawn is None:
        return False
    item = drawn[0] if as_drawn else stand_in(drawn[0], asset, catalog, rng)
    if not put_piece(item, asset, layout, drawn[1], room, catalog):
        return False
    if piece.joints or piece.variant != "default":
        # Opened where it stands: what opens of it was seen to have room.
        layout.put(_standing(item, asset, piece.joints, piece.variant), drawn[1])
    placed.setdefault(piece.category, []).append(item.id)
    return True


def drawn_at(
    piece: FurnitureItem,
    asset: AssetInfo,
    room: Room,
    layout: Layout,
    placed: Mapping[str, Sequence[int]],
    rng: Rng,
) -> tuple[ObjectInstance, Intent | None] | None:
    """A model where a piece of the drawing says, at rest, and what it stands on; None when that is
    not there, or for a hood whose chimney cannot end at the ceiling: where no model is named, it
    hangs where it does. ``placed`` are the pieces of the room so far, by category."""
    yaw = math.radians(piece.yaw_deg)
    x, y, z = piece.position_m
    if piece.model is None:
        under = underside_of(asset, z, room.height_m)
        if under is None:
            return None
        z = under
    intent = None
    if piece.on is not None:
        target = _nearest(layout, placed.get(piece.on, ()), x, y)
        if target is None:
            return None
        z = top_of(layout, target)
        intent = Intent("ON", target)
    if piece.against_wall:
        # The given point is where the back touches; the centre lies half a depth in front, and
        # further where a lid tilts back over more than the gap that is drawn.
        reach = layout.library.reach(asset.id)
        away = asset.extents_m[0] / 2 + max(0.0, reach.back_m - BACK_GAP_M)
        x += math.cos(yaw) * away
        y += math.sin(yaw) * away
    if piece.jitter_m:
        x += float(rng.uniform(-piece.jitter_m, piece.jitter_m))
        y += float(rng.uniform(-piece.jitter_m, piece.jitter_m))
    item = ObjectInstance(
        id=next(layout.ids),
        category=asset.category,
        asset=asset.id,
        pose=Pose(position_m=round_position((x, y, z)), quat_xyzw=round_quat(quat_from_yaw(yaw))),
        room_id=room.id,
        fixed=True,
    )
    return at_rest(item, asset), intent


def stand_in(item: ObjectInstance, asset: AssetInfo, catalog: Catalog, rng: Rng) -> ObjectInstance:
    """A piece as it stands in homes: at rest, what its category says switched on now and then."""
    item = at_rest(item, asset)
    share = catalog.category(item.category).switched_on
    if share and rng.random() < share:
        item = in_state(item, asset, "ON", rng) or item
    return item


def may_stand(
    item: ObjectInstance, asset: AssetInfo, category: Category
) -> Iterator[tuple[str, ...]]:
    """The states that homes leave an opening or a piece in: see :func:`fill_openings`,
    :func:`stand_in` and :func:`leave_open`."""
    states = at_rest(item, asset).states
    yield states
    left_open = category.stands_open or (DOOR_OPEN_SHARE and category.name in INNER_DOORS)
    opened = {"CLOSED": "OPEN"} if left_open else {}
    lit = {"OFF": "ON"} if category.switched_on else {}
    for changed in (opened, lit, opened | lit):
        if changed:
            yield tuple(sorted(changed.get(state, state) for state in states))


def leave_open(layout: Layout, context: HomeContext, rng: Rng) -> HomeContext:
    """Open what people left open of a furnished home, as often as its category says, where it has
    room to and a way past it is left; the context with the floor that is free then.

    Zones and free space stay those of the home as nobody left it.
    """
    doors = bodies_of(
        [item for item in layout.items.values() if item.category in DOORS], layout.library.infos
    )
    for item in list(layout.items.values()):
        share = context.catalog.category(item.category).stands_open
        if not share or rng.random() >= share:
            continue
        info = layout.info(item.id)
        opened = in_state(item, info, "OPEN", rng)
        if opened is None or not room_to_change(layout, context.home, item, opened):
            continue
        if context.cuts_off(opened, info):
            continue
        if not swing_blocked([*doors, *bodies_of([opened], layout.library.infos)]):
            layout.put(opened)
            context = replace(context, free=context.leaves_free(opened, info))
    return context


def stand_open(layout: Layout, context: HomeContext) -> HomeContext:
    """The context with the floor that is free where pieces of a home that is as drawn stand open.

    Zones and free space stay those of the home as nobody left it.
    """
    for item in layout.items.values():
        if item.category not in OPENINGS and any(item.joints.values()):
            free = context.leaves_free(item, layout.info(item.id))
            context = replace(context, free=free)
    return context


def put_piece(
    item: ObjectInstance,
    asset: AssetInfo,
    layout: Layout,
    intent: Intent | None,
    room: Room,
    catalog: Catalog,
) -> bool:
    """Add a piece if there is room for it, what opens of it can open with room to stand before it,
    and it is in no other's way; False, and no change, otherwise."""
    blocks = layout.blocks_of(item)
    if not _has_room(blocks, asset, layout, intent):
        return False
    way = way_of(item, layout.library)
    opens = "CAN_OPEN" in catalog.category(item.category).properties
    stand = stand_of(item, layout.library) if opens else []
    if not _opens(item, blocks, way, stand, layout, room, catalog):
        return False
    layout.put(item, intent, blocks)
    layout.ways = layout.ways.with_ways(way).with_stands(stand)
    return True


def _opens(
    item: ObjectInstance,
    blocks: Sequence[Block],
    way: Sequence[Block],
    stand: Sequence[Block],
    layout: Layout,
    room: Room,
    catalog: Catalog,
) -> bool:
    """True when a piece stands in the way of no leaf, lid or drawer, nor of who opens it, nor
    anything in its own.

    A seat at a table or a desk is drawn back before its drawer is.
    """

    def drawn_back(other_id: int) -> bool:
        pair = (item.category, layout.items[other_id].category)
        found = [catalog.category(name) for name in pair]
        if any(category.sleeps for category in found):  # nobody draws back a bed
            return False
        traits = [category.properties for category in found]
        return any("SITTABLE" in a and "SAT_AT" in b for a, b in (traits, traits[::-1]))

    if not all(map(drawn_back, layout.ways.crossed(blocks))):
        return False
    outline = Polygon(room.polygon_m)
    if not all(outline.covers(block.shape) for block in stand):
        return False
    # The leaf of a door is pushed to before what is behind it is opened.
    beside = (k for k in layout.entered(stand) if layout.items[k].category not in OPENINGS)
    if not all(map(drawn_back, beside)):
        return False
    if not way:
        return True
    return layout.ways.clear(way, outline, room.height_m) and all(
        map(drawn_back, layout.entered(way))
    )


def _has_room(
    blocks: Sequence[Block], asset: AssetInfo, layout: Layout, intent: Intent | None
) -> bool:
    """True unless a piece clashes with another; what is thin (a flat-woven rug) lies under
    furniture, but neither under the open leaf of a door nor over another rug."""
    return not any(True for _ in clashing(blocks, asset, layout, intent))


def clashing(
    blocks: Sequence[Block], asset: AssetInfo, layout: Layout, intent: Intent | None
) -> Iterator[int]:
    """Ids of the objects that a piece would cut; some more than once."""
    thick_m = asset.extents_m[2]

    def passes(other_id: int) -> bool:
        if intent is not None and other_id == intent.target_id:
            return True
        other_m = layout.info(other_id).extents_m[2]
        if layout.items[other_id].category in OPENINGS or max(thick_m, other_m) <= FLAT_M:
            return False
        return min(thick_m, other_m) <= PRESSED_M

    return (k for k in layout.entered(blocks) if not passes(k))


def _nearest(layout: Layout, ids: Sequence[int], x: float, y: float) -> int | None:
    """Of these pieces the one below a point, or the nearest to it."""
    point = Point(x, y)

    def apart(object_id: int) -> tuple[float, float]:
        px, py, _ = layout.items[object_id].pose.position_m
        below = min(block.shape.distance(point) for block in layout.space_of(object_id))
        return float(below), math.hypot(px - x, py - y)

    return min(ids, key=apart, default=None)


def top_of(layout: Layout, object_id: int) -> float:
    """World height of the object's highest open support (its box's top without one)."""
    item, info = layout.items[object_id], layout.info(object_id)
    tops = [s.z_m for s in info.supports if s.container is None and s.headroom_m is None]
    local: Vec3 = (0.0, 0.0, max(tops) if tops else info.extents_m[2])
    world = item.pose.matrix()
    return float(apply(world, [local])[0][2])
