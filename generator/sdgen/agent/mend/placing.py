"""What becomes of the thing in the hand: put on or into something, aside, down, thrown away."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from shapely.geometry import Point

from sdgen.agent.mend.leaves import is_open, shut_in
from sdgen.agent.mend.state import Held, Setting, State, called, lost, with_facts
from sdgen.cameras.lens import Gaze
from sdgen.facts import Facts, bodies_of
from sdgen.hazards.certify import facts_of
from sdgen.hazards.remedies import Remedies
from sdgen.hazards.twin import PUT
from sdgen.home.context import KEEP_CLEAR
from sdgen.home.ground import Ground
from sdgen.home.layout import at_spot
from sdgen.pipeline.putting import come_to_rest, facts_after, stands_there, stays
from sdgen.pipeline.undoing import check_standing
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: Spots drawn on or in a thing, and how many within reach are tried in Bullet: some hundredths of a
#: second each.
SPOTS_DRAWN = 32
SPOTS_TRIED = 6


def put(
    setting: Setting, state: State, held: Held, action: str, target: int, part: str | None, rng: Rng
) -> State | str:
    """What is held on or in a target, at the first spot within reach where it stands."""
    facts = state.facts
    body = facts.bodies[target]
    around = shut_in(facts, target)
    if around is not None:
        return f"{called(facts, target)} is shut in by {called(facts, around)}: open it first"
    takes = _takes(setting, state, held.item, target, part) if PUT[action] == "INSIDE" else _any
    if isinstance(takes, str):
        return takes
    remedies = Remedies(facts, state.layout, setting.context, (), rng)
    spots = remedies.put_at(
        action, held.item, body.item, takes, state.layout, SPOTS_DRAWN, SPOTS_DRAWN
    )
    word = "in" if PUT[action] == "INSIDE" else "on"
    near = (spot for spot in spots if _in_reach(setting, state.place, spot))
    found = _first(setting, state, held, near, PUT[action], target, action == "throw_away")
    if found is None:
        return f"no spot {word} {called(facts, target)} within reach takes it"
    return found


def aside(setting: Setting, state: State, held: Held, rng: Rng) -> State | str:
    """What is held at a wall of the room one is in, out of people's way; one walks there."""
    room_id = setting.arms.floor.room_at(state.place.point)
    ground = setting.context.ground(room_id, KEEP_CLEAR)
    for item in _on_ground(setting, state, held.item, ground, room_id, rng):
        (body,) = bodies_of([item], setting.library.infos)
        there = setting.arms.beside(state.place, body.footprint, room_id)
        way_m = None if there is None else setting.arms.way_m(state.place, there)
        if there is None or way_m is None:
            continue
        gone = replace(state, place=there, walked_m=state.walked_m + way_m)
        floor = setting.context.floor_id(room_id)
        found = _first(setting, gone, held, iter([item]), "ON", floor, False)
        if found is not None:
            return found
    return f"there is no room for it at a wall of room {room_id}"


def down(setting: Setting, state: State, held: Held, rng: Rng) -> State | str:
    """What is held on the floor, anywhere within reach."""
    room_id = setting.arms.floor.room_at(state.place.point)
    area = setting.context.floor(room_id)
    ground = Ground(area, area.intersection(Point(state.place.point).buffer(setting.arms.reach_m)))
    items = _on_ground(setting, state, held.item, ground, room_id, rng)
    floor = setting.context.floor_id(room_id)
    found = _first(setting, state, held, items, "ON", floor, False)
    return f"there is no free floor within reach in room {room_id}" if found is None else found


def taken_out(setting: Setting, state: State, held: Held) -> State | str:
    """What is held carried out of the home: rubbish alone, and from the front door."""
    rubbish = any(
        rule.action == "throw_away"
        for _, hazard in held.pairs
        for rule in setting.catalog.hazard(hazard).remedy
    )
    if not rubbish:
        return f"the {held.item.category.replace('_', ' ')} {held.item.id} is no rubbish"
    doors = [one.object_id for one in setting.context.home.openings if one.kind == "front_door"]
    bodies = [state.facts.bodies[key] for key in doors if key in state.facts.bodies]
    if not any(
        setting.arms.reaches(state.place.point, body.footprint, body.item.id) for body in bodies
    ):
        return "no front door is within reach: go there first, or to a bin"
    return replace(state, held=None)


def _takes(
    setting: Setting, state: State, item: ObjectInstance, target: int, part: str | None
) -> Callable[[str], bool] | str:
    """Into which hollows of a target a thing goes, by name: those that are open, and that are for
    such things where none is named."""
    owner = state.facts.bodies[target].item
    info, words = setting.library.info(owner.asset), called(state.facts, target)
    leaf = {hollow.name: hollow.closed_by for hollow in info.containers}
    if not leaf:
        return f"{words} has no hollow"
    if part is not None and part not in leaf:
        return f"{words} has no hollow {part!r} (there is: {', '.join(leaf)})"
    may = setting.context.may_hold
    fit = [name for name in leaf if part == name or part is None]
    fit = [name for name in fit if part or may(item.category, owner.category, name)]
    if not fit:
        return f"{words} has no hollow for such things"
    free = {name for name in fit if is_open(owner, info, leaf[name])}
    return free.__contains__ if free else f"{words} is shut: open it first"


def _in_reach(setting: Setting, place: Gaze, item: ObjectInstance) -> bool:
    (body,) = bodies_of([item], setting.library.infos)
    return bool(body.footprint.distance(Point(place.point)) <= setting.arms.reach_m)


def _on_ground(
    setting: Setting, state: State, item: ObjectInstance, ground: Ground, room_id: int, rng: Rng
) -> Iterator[ObjectInstance]:
    info, bulk = setting.library.info(item.asset), state.layout.bulk_of(item)
    for _ in range(SPOTS_TRIED):
        spot = state.layout.spot_on_floor(info, ground, rng, bulk)
        if spot is not None:
            yield at_spot(item, spot, room_id)


def _first(
    setting: Setting,
    state: State,
    held: Held,
    items: Iterator[ObjectInstance],
    relation: str,
    target: int,
    anyhow: bool,
) -> State | None:
    """The first of these ways that stands, of those in which no hazard is in doubt before others;
    at most so many are tried."""
    objects = sorted((*state.facts.scene.objects, held.item), key=lambda one: one.id)
    scene = state.facts.scene.model_copy(update={"objects": tuple(objects)})
    full = facts_of(scene, setting.library.infos, setting.catalog, state.facts)
    doubtful: State | None = None
    for number, item in enumerate(items):
        if number == SPOTS_TRIED:
            break
        facts = _stood(setting, state, full, item, relation, target, anyhow)
        if facts is None:
            continue
        found = replace(with_facts(setting, state, facts), held=None)
        if found.sure:
            return found
        doubtful = doubtful or found
    return doubtful


def _stood(
    setting: Setting,
    state: State,
    full: Facts,
    item: ObjectInstance,
    relation: str,
    target: int,
    anyhow: bool,
) -> Facts | None:
    """Facts of the scene with a thing come to rest there; None where it does not, cuts into
    something, or does not stay. ``full``: with the thing where it was grabbed."""
    library, client = setting.library, setting.client
    rested = come_to_rest(item, {}, full, anyhow, library, client)
    if rested is None:
        return None
    facts = facts_after(full, {item.id: rested[0]}, library.infos, setting.catalog)
    if not stands_there(item.id, relation, target, facts) or lost(state.facts, facts) is not None:
        return None
    if check_standing(full.scene, facts, library, client) is not None:
        return None
    return facts if stays(item.id, facts, library, client) else None


def _any(_name: str) -> bool:
    return True
