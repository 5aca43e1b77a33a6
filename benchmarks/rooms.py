"""Rooms: how furniture stands in them, without pictures.

Run: ``python benchmarks/rooms.py [--seeds 40] [--homes procedural]``. Homes are planned and
furnished, nothing else. Prints Markdown: what stands in the way, what stands alone, how much of the
floor is bare.
"""

from __future__ import annotations

import argparse
import math
import statistics
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import shapely
from crowding import ahead, look_at_groups, look_at_openings
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog, FurnitureRule
from sdgen.facts import Body, bodies_of
from sdgen.freespace import opening_rectangle, polygons, union
from sdgen.geometry import Vec2, yaw_of
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.scene import HOME_ATTEMPTS, furnish_for
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Rejection
from sdgen.scene import Room
from sdgen.vocabulary import FLAT_M, HALF_WALL_M, OPENINGS, OVERHEAD_M
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry

#: A door's strip of floor, metres deep; what is taller keeps off its frame.
STRIP_M, TALL_M, OFF_FRAME_M = 0.8, 1.2, 0.15
#: How near a chair is to its table, a lamp to its seat, a rug to its group, a seat to anything.
AT_TABLE_M, BY_SEAT_M, COMPANY_M = 0.35, 0.6, 0.7
#: A room with so wide a circle of floor on which nothing stands or lies looks empty.
EMPTY_M = 2.4
TOUCH_M2 = 2e-3
#: What people reach into or pull out, and the floor before it.
REACHED = ("wardrobe", "dresser", "stove", "fridge", "freezer", "utility_cupboard")
FRONT_M = 0.6
UNITS = ("kitchen_counter", "corner_counter", "sink_cabinet", "stove", "dishwasher")
TABLES = ("dining_table", "kitchen_table")
SEATS = ("chair", "stool", "ottoman", "armchair", "bench")
RESTED_AT = ("sofa", "armchair", "desk", "bed", "child_bed")
GROUPS = (*RESTED_AT, *TABLES, "coffee_table", "toy_box", "bathtub")
HALL = ("shoe_rack", "coat_rack", "coat_hooks")
PARTNERS = (*GROUPS, *HALL, "side_table", "console_table", "bookshelf", "dresser", "wardrobe")
PARTNERS += ("washbasin",)


@dataclass
class Tally:
    """What was counted: of so many, how many are at fault; and shares by room type. In rooms of
    the types ``rugs_alone`` rugs lie by themselves."""

    of: Counter[str] = field(default_factory=Counter)
    bad: Counter[str] = field(default_factory=Counter)
    alone: Counter[str] = field(default_factory=Counter)
    bare: defaultdict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    circle: defaultdict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    pieces: defaultdict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    rugs_alone: frozenset[str] = frozenset()

    def note(self, what: str, fault: bool) -> None:
        """One more of a kind."""
        self.of[what] += 1
        self.bad[what] += fault


def look(made: FurnishedHome, catalog: Catalog, tally: Tally) -> None:
    """Count the faults of a home."""
    home = made.context.home
    fitted = {fitting.category for fitting in catalog.fittings}
    bodies = bodies_of(made.layout.items.values(), made.layout.library.infos)
    pieces = [b for b in bodies if b.item.category not in OPENINGS and b.low[2] < OVERHEAD_M]
    standing = [b for b in pieces if b.high[2] > FLAT_M]
    for opening in home.openings:
        if opening.kind == "window":
            continue
        strip = opening_rectangle(opening, HALF_WALL_M + STRIP_M)
        frame = opening_rectangle(opening, HALF_WALL_M + 0.5).buffer(OFF_FRAME_M)
        tall = [b for b in standing if b.high[2] > TALL_M and b.low[2] < FLAT_M]
        tally.note("doors with furniture before them", _any_in(strip, standing))
        tally.note("doors with tall furniture at the frame", _any_in(frame, tall))
        if opening.kind == "front_door":
            types = {r.type for r in home.rooms if r.id in opening.room_ids}
            tally.note("front doors into a living room", "living_room" in types)
    for room in home.rooms:
        here = [b for b in pieces if b.item.room_id == room.id]
        _look_at_room(room, here, tally)
        mine = [o for o in home.openings if room.id in o.room_ids]
        filled = {o.object_id for o in mine}
        doors = [b for b in bodies if b.item.id in filled]
        within = [b for b in bodies if b.item.room_id == room.id]
        loose = [b for b in within if b.item.category not in fitted and b.item.id not in filled]
        look_at_openings(room, mine, loose, doors, tally.note)
        look_at_groups(loose, _all(within, "radiator"), TABLES, tally.note)
        windows = [o for o in mine if o.kind == "window"]
        walls = Polygon(room.polygon_m).exterior
        for plant in _all(here, "plant_pot"):
            at = Point(plant.center[:2])
            corner = min(Point(p).distance(at) for p in room.polygon_m) < 1.0
            window = any(Point(o.center_m[:2]).distance(at) < 1.3 for o in windows)
            if plant.low[2] < FLAT_M:
                astray = walls.distance(plant.footprint) > 0.3 or not (corner or window)
                tally.note("plants away from corners and windows", astray)


def _look_at_room(room: Room, here: Sequence[Body], tally: Tally) -> None:
    standing = [b for b in here if b.high[2] > FLAT_M]
    taken = union([b.footprint for b in standing])
    outline = Polygon(room.polygon_m)
    tally.bare[room.type].append(1 - taken.intersection(outline).area / outline.area)
    free = polygons(outline.difference(union([b.footprint for b in here])))
    widest = max(shapely.maximum_inscribed_circle(p, tolerance=0.05).length for p in free)
    tally.circle[room.type].append(widest)
    tally.pieces[room.type].append(len(standing))
    for body in standing:
        if body.item.category in REACHED:
            before = ahead(body, FRONT_M)
            others = [b for b in standing if b is not body]
            blocked = _any_in(before, others) or before.difference(outline).area > 0.02
            tally.note("fronts of wardrobes, drawers and ovens that are not free", blocked)
            tally.alone[f"{body.item.category} in {room.type}, front"] += blocked
    for table in [b for b in here if b.item.category in TABLES]:
        seats = [b for b in here if b.item.category in ("chair", "bench", "stool")]
        near = sum(b.footprint.distance(table.footprint) < AT_TABLE_M for b in seats)
        at_wall = outline.exterior.distance(table.footprint) < 0.15
        wanted = 2 if max(table.info.extents_m[:2]) < 1.2 else 3 if at_wall else 4
        tally.note("tables with too few chairs", near < wanted)
        tally.note("tables without chairs", near == 0)
    for desk in _all(here, "desk"):
        seats = [b for b in here if b.item.category in ("chair", "office_chair")]
        tally.note("desks without a chair", not _near(desk, seats, AT_TABLE_M))
    groups = [b for b in here if b.item.category in GROUPS]
    for rug in [] if room.type in tally.rugs_alone else _all(here, "rug"):
        tally.note("rugs of no group", not _near(rug, groups, 0.3))
    rest = [b for b in here if b.item.category in RESTED_AT]
    for lamp in _all(here, "floor_lamp"):
        tally.note("floor lamps by no seat or desk", not _near(lamp, rest, BY_SEAT_M))
    tables = _all(here, "coffee_table")
    for chair in _all(here, "armchair"):
        if tables:
            at = _seen_from(chair, tables[0])
            away = abs(math.degrees(math.atan2(at[1], at[0]))) > 75
            tally.note("armchairs that look away from the sofa's table", away)
    partners = [b for b in here if b.item.category in PARTNERS]
    for seat in [b for b in here if b.item.category in SEATS]:
        others = [b for b in partners if b is not seat]
        # A seat at a wall by nothing else stands alone, too.
        alone = not _near(seat, others, COMPANY_M)
        tally.note("seats that stand alone", alone)
        tally.alone[f"{seat.item.category} in {room.type}"] += alone
    for sofa, tv in zip(_all(here, "sofa"), _all(here, "tv"), strict=False):
        tally.note("televisions 0.3 m off the sofa's middle", abs(_seen_from(sofa, tv)[1]) > 0.3)
    if room.type == "bathroom":
        tally.note("bathrooms without a bath", not _all(here, "bathtub"))
    if room.type == "kitchen":
        corners = len(_all(here, "corner_counter"))
        tally.note("kitchens of a U", corners == 2)
        tally.note("kitchens of an L", corners == 1)
        units = [b for b in here if b.item.category in UNITS]
        off = [b for b in units if not _near(b, [u for u in units if u is not b], 0.05)]
        tally.note("kitchens with a unit that stands alone", bool(off))
        fridge = [b for b in _all(here, "fridge") if not _near(b, units, 0.15)]
        tally.note("kitchens with the fridge apart", bool(fridge))


def _lies_alone(rule: FurnitureRule) -> bool:
    return rule.category == "rug" and rule.where == "middle"


def _all(here: Sequence[Body], category: str) -> list[Body]:
    return [b for b in here if b.item.category == category]


def _near(body: Body, others: Sequence[Body], far_m: float) -> bool:
    return any(body.footprint.distance(other.footprint) < far_m for other in others)


def _any_in(shape: BaseGeometry, bodies: Sequence[Body]) -> bool:
    """Whether any of them takes floor of a shape."""
    return any(shape.intersection(body.footprint).area > TOUCH_M2 for body in bodies)


def _seen_from(body: Body, other: Body) -> Vec2:
    """(ahead, to the left) of another's middle, seen from a body."""
    yaw = yaw_of(body.item.pose.quat_xyzw)
    dx, dy = (other.center - body.center)[:2].tolist()
    return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)


def rows(tally: Tally) -> Iterator[str]:
    """The table."""
    yield "| furniture | |\n|---|---|"
    for what in sorted(tally.of):
        yield f"| {what} | {tally.bad[what]} of {tally.of[what]} |"
    commonest = ", ".join(
        f"{what}: {count}" for what, count in tally.alone.most_common(12) if count
    )
    yield f"| of these seats | {commonest} |"
    yield "\n| room | rooms | pieces | bare floor | widest bare circle, m (90 %) | empty |"
    yield "|---|---|---|---|---|---|"
    for name in sorted(tally.bare):
        circles = sorted(tally.circle[name])
        most = 2 * circles[int(0.9 * (len(circles) - 1))]
        empty = statistics.mean(2 * circle >= EMPTY_M for circle in circles)
        yield (
            f"| {name} | {len(circles)} | {statistics.median(tally.pieces[name]):g} | "
            f"{statistics.median(tally.bare[name]):.0%} | "
            f"{2 * statistics.median(circles):.2f} ({most:.2f}) | {empty:.0%} |"
        )


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--homes", default="procedural")
    args = parser.parse_args()
    catalog, library = load_catalog(), load_library()
    alone = (t.name for t in catalog.room_types for r in t.furniture if _lies_alone(r))
    tally = Tally(rugs_alone=frozenset(alone))
    base = BuildOptions(homes=args.homes, sensors=(), views=0, hazards_min=0, hazards_max=0)
    causes: Counter[str] = Counter()
    tries, times = 0, []
    for seed in range(args.seeds):
        spec = draw_spec(0, catalog, base.model_copy(update={"seed": seed}))
        start = time.process_time()
        for attempt in range(HOME_ATTEMPTS):
            tries += 1
            made = furnish_for(spec, attempt, catalog, library)
            if not isinstance(made, Rejection):
                look(made, catalog, tally)
                break
            causes[str(made.cause)] += 1
        times.append(time.process_time() - start)
    for row in rows(tally):
        sys.stdout.write(row + "\n")
    sys.stdout.write(
        f"\nhomes {args.seeds}, tries {tries}, median s {statistics.median(times):.3f}, "
    )
    sys.stdout.write(f"mean s {statistics.mean(times):.3f}\n{causes.most_common()}\n")


if __name__ == "__main__":
    main()
