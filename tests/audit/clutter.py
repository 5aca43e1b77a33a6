"""Everyday things: as many, as various and where people keep them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from tests.audit.dataset import MATS, Finding, Scene

#: People own these in sets, and lay them out so.
SETS = {
    "plate",
    "bowl",
    "mug",
    "drinking_glass",
    "wine_glass",
    "fork",
    "spoon",
    "knife",
    "placemat",
    "coaster",
    "cushion",
    "toilet_paper",
    "shoe",
    "soda_can",
    "beer_bottle",
    "water_bottle",
    "soda_bottle",
    "candle",
    "tea_light",
    "egg_carton",
    "yogurt_cup",
    "pudding_cup",
    "towel",
    "chair",
    "canned_food",
    "storage_bin",
}
#: Identical neighbours nearer than this are seen as copies, metres.
SIDE_BY_SIDE_M = 0.25
#: One at each basin or sink, and a spare.
SPARE_SOAPS = 1
FROZEN = {"ice_cream_tub", "frozen_pizza", "frozen_vegetables", "fish_sticks"}
#: What people freeze besides.
FREEZABLE = {"raw_meat", "fish_fillet", "bread", "leftovers_box", "sausage_pack", "strawberries"}


def copies(scene: Scene) -> Iterator[Finding]:
    """The same model twice, side by side on one support."""
    for i, a in enumerate(scene.small):
        for b in scene.small[i + 1 :]:
            if a.asset != b.asset or a.category in SETS or a.states != b.states:
                continue
            if not set(scene.on.get(a.id, [])) & set(scene.on.get(b.id, [])):
                continue
            gap = a.footprint.distance(b.footprint)
            if gap < SIDE_BY_SIDE_M and abs(a.bottom - b.bottom) < 0.05:
                yield scene.found(a, f"beside its copy {b.id}", gap)


def soaps(scene: Scene) -> Iterator[Finding]:
    """More soap dispensers than places to wash and one."""
    count = Counter(thing.category for thing in scene.things.values())
    places = count["washbasin"] + count["sink_cabinet"]
    if count["soap_dispenser"] > places + SPARE_SOAPS:
        yield scene.found(
            None, f"soap dispensers, {places} places to wash", count["soap_dispenser"]
        )


def knife_blocks(scene: Scene) -> Iterator[Finding]:
    """Two knife blocks in one kitchen."""
    rooms = Counter(t.room for t in scene.things.values() if t.category == "knife_block")
    for room, many in rooms.items():
        if many > 1:
            yield scene.found(None, f"knife blocks in {scene.rooms[room]['type']} {room}", many)


def freezer_for(scene: Scene, id: int) -> str | None:
    """The hollow of a freezer (or freezer compartment) that a thing lies in, or None."""
    thing = scene.things[id]
    middle = (thing.box[0] + thing.box[1]) / 2
    for b in scene.inside.get(id, []):
        holder = scene.things[b]
        if holder.category not in {"freezer", "fridge"}:
            continue
        for hollow in holder.record["containers"]:
            part = next((p for p in holder.parts if p.name == hollow["part"]), None)
            if part is None:
                continue
            away = abs(part.local(middle[None])[0] - hollow["center_m"])
            if (away <= [side / 2 + 0.005 for side in hollow["size_m"]]).all():
                return "freezer" if "freez" in f"{holder.category} {hollow['name']}" else "fridge"
    return None


def in_the_freezer(scene: Scene) -> Iterator[Finding]:
    """Things in a freezer that people do not freeze."""
    for thing in scene.small:
        if thing.category not in FROZEN | FREEZABLE and freezer_for(scene, thing.id) == "freezer":
            yield scene.found(thing, "in a freezer")


#: A cleaner or a food on a shelf of these rooms: nobody keeps it there.
ODD_ROOMS = {"living_room", "bedroom", "child_room", "office", "dining_room"}


def odd_places(scene: Scene) -> Iterator[Finding]:
    """Cleaning products kept (not as an anomaly) in rooms where nobody keeps them."""
    cleaning = scene.catalogue.categories_of("poison_cleaning")
    for thing in scene.small:
        odd = thing.category in cleaning and scene.room_type(thing) in ODD_ROOMS
        if odd and thing.id not in scene.hazards_of:
            yield scene.found(thing, "nobody keeps it here", thing.bottom)


#: Whole, it stands on no floor: whoever sees one there asks who dropped it.
OFF_FLOORS = {
    *("plate", "bowl", "mug", "drinking_glass", "wine_glass", "glass_jar", "jam_jar", "teapot"),
    *("pitcher", "water_bottle", "soda_bottle", "soda_can", "juice_carton", "shampoo_bottle"),
    *("soap_dispenser", "tissue_box", "laptop", "phone", "hammer", "pliers", "hairbrush", "spoon"),
    *("fork", "headphones", "game_controller", "keyboard", "pen_cup"),
}
TOYS = {
    *("toy_ball", "toy_car", "toy_train", "teddy_bear", "doll", "dinosaur", "stacking_rings"),
    *("rocking_horse", "puzzle_box"),
}
#: Toys lie about where children play; nobody plays in the others.
NO_PLAY = {"bathroom", "laundry", "kitchen"}


def odd_floors(scene: Scene) -> Iterator[Finding]:
    """What nobody puts on a floor, or not in this room, and that is no label."""
    floors = scene.nodes.keys() - scene.things.keys()
    floors |= {t.id for t in scene.furniture if t.category in MATS}
    for thing in scene.small:
        if thing.id in scene.hazards_of or not set(scene.on.get(thing.id, [])) & floors:
            continue
        if thing.category in OFF_FLOORS:
            yield scene.found(thing, "lies on the floor")
        elif thing.category in TOYS and scene.room_type(thing) in NO_PLAY:
            yield scene.found(thing, "a toy on the floor where nobody plays")
