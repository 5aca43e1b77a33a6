"""The terms of a predicate, as `catalogue.json` has them, evaluated on what is measured here.

What each means is in `hazard_catalog/README.md`, *The predicate*.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from types import MappingProxyType
from typing import Any, NamedTuple

import shapely

from tests.audit.dataset import Json
from tests.audit.drops import drops
from tests.audit.outlines import Body, state_told
from tests.audit.told import NO, YES, Told, about, every, number, same, some
from tests.audit.world import Evidence, Related, World

#: Evidence is told to this many digits.
DIGITS = 4


class Answer(NamedTuple):
    """What a term says of an object, and what was measured of it where it holds."""

    told: Told
    evidence: Evidence = MappingProxyType({})


Term = Callable[[Json, World, int], Answer]


def answer(term: Json, world: World, id: int) -> Answer:
    """Whether a term holds of an object."""
    found = TERMS[term["kind"]](term, world, id)
    return found if found.told.holds else Answer(found.told)


def measured(term: Json, world: World, id: int) -> Evidence:
    """What a term measures of an object whether or not it holds: the evidence of near misses."""
    kind = term["kind"]
    if kind == "not":
        return {}
    if kind in ("all", "any"):
        found: dict[str, Any] = {}
        for part in term["terms"]:
            add(found, measured(part, world, id))
        return found
    if kind in MEASURED:
        return next(iter(MEASURED[kind](term, world, id)), {})
    return answer(term, world, id).evidence


def add(evidence: dict[str, Any], more: Evidence) -> None:
    """Merge evidence: names that say something else already get ``_2``."""
    clash = {key for key, value in more.items() if evidence.get(key, value) != value}
    n = 2
    while any(f"{key}_{n}" in evidence for key in clash):
        n += 1
    evidence.update({f"{k}_{n}" if k in clash else k: v for k, v in more.items()})


def told_digits(value: float) -> float:
    return round(value, DIGITS) + 0.0


def within(value: float, term: Json) -> Told:
    low, high = term["min_m"], term["max_m"]
    parts = [] if low is None else [about(low, term["margin_m"]).at_least(value)]
    parts += [] if high is None else [about(high, term["margin_m"]).at_most(value)]
    return every(parts)


def first_sure(answers: Iterable[Answer]) -> Answer:
    """Of several ways the first that surely holds, else the first that does."""
    found = list(answers)
    told = some(one.told for one in found)
    holding = [one for one in found if one.told.holds]
    best = next((one for one in holding if one.told.sure), next(iter(holding), Answer(NO)))
    return Answer(told, best.evidence)


def _category(term: Json, world: World, id: int) -> Answer:
    return Answer(Told(world.bodies[id].category in term["any_of"]))


def _state(term: Json, world: World, id: int) -> Answer:
    body = world.bodies[id]
    told = state_told(term["any_of"], body.states, body.undecided)
    return Answer(told, {"state": next((s for s in term["any_of"] if s in body.states), None)})


def _of_state(body: Body | None, state: str | None) -> Told:
    if state is None:
        return YES
    return NO if body is None else state_told([state], body.states, body.undecided)


def _room(term: Json, world: World, id: int) -> Answer:
    among = [kind in term["any_of"] for kind in world.room_types(id)]
    return Answer(Told(bool(among) and among[0], all(among) or not any(among)))


def _relation(term: Json, world: World, id: int) -> Answer:
    def to(one: Related) -> Answer:
        evidence = {
            "relation": term["relation"],
            "target_id": one.target,
            "target_category": one.category,
            **{key: told_digits(value) for key, value in one.evidence.items()},
        }
        wanted = term["target_state"]
        if wanted is None:
            return Answer(one.told, evidence)
        if one.leaf is None:
            state = _of_state(world.bodies.get(one.target), wanted)
        else:
            state = state_told([wanted], *one.leaf)
        return Answer(every([one.told, state]), evidence | {"target_state": wanted})

    return first_sure(
        to(one)
        for one in world.related(id, term["relation"])
        if not term["targets"] or one.category in term["targets"]
    )


def _height(term: Json, world: World, id: int) -> Answer:
    if term["evidence"] == "height_m":
        return Answer(within(float(world.bodies[id].low[2]), term), _heights(term, world, id)[0])
    above, least, most, _ = world.reach(id)
    told = within(above, term)
    sure = told.sure and all(within(m, term) == told for m in (least, most))
    return Answer(Told(told.holds, sure), _heights(term, world, id)[0])


def _heights(term: Json, world: World, id: int) -> list[Evidence]:
    height = told_digits(float(world.bodies[id].low[2]))
    if term["evidence"] == "height_m":
        return [{"height_m": height}]
    above, _, _, climbed = world.reach(id)
    found: dict[str, Any] = {"reach_height_m": told_digits(above)}
    if climbed is not None:
        found |= {"height_m": height, "climbed_id": climbed}
    return [found]


class Near(NamedTuple):
    gap: float
    counts: Told
    evidence: Evidence


def _nearest(term: Json, world: World, id: int) -> Iterator[Near]:
    """What it may be near, nearest first, and whether it counts."""
    body = world.bodies[id]
    rooms = world.rooms(id)
    if term["to_zone"]:
        zones = [z for z in world.zones if z.kind in term["to_zone"] and z.source != id]
        far = [(float(z.outline.distance(body.footprint)), z.name, z) for z in zones]
        for gap, name, zone in sorted(far, key=lambda one: one[:2]):
            parts = [YES if term["from_above"] else world.level(body, zone)]
            if term["to_state"] is not None:
                source = world.bodies.get(zone.source or 0)
                parts.append(_of_state(source, term["to_state"]))
            if term["same_room"]:
                holds = bool(rooms) and rooms[0] == zone.room
                parts.append(Told(holds, len(rooms) == 1) if zone.room in rooms else NO)
            yield Near(gap, every(parts), {"zone_name": name})
        return
    for gap, other in _apart(term["to"], world, id, term["from_above"]):
        parts = [_of_state(other, term["to_state"])]
        if term["same_room"]:
            parts.append(world.together(id, other.id))
        yield Near(gap, every(parts), {"nearest_id": other.id})


def _apart(
    categories: list[str], world: World, id: int, from_above: bool
) -> list[tuple[float, Body]]:
    body = world.bodies[id]
    others = [other for other in world.of(categories) if other.id != id]
    if from_above:
        gaps = [float(shapely.distance(body.footprint, other.footprint)) for other in others]
    else:
        gaps = [world.gap(body, other) for other in others]
    pairs = sorted(zip(gaps, others, strict=True), key=lambda one: (one[0], one[1].id))
    return pairs


def _distance(term: Json, world: World, id: int) -> Answer:
    found = list(_nearest(term, world, id))
    parts = []
    if term["min_m"] is not None:
        limit = about(term["min_m"], term["margin_m"])
        nearer = some(every([limit.less(one.gap), one.counts]) for one in found)
        parts.append(nearer.denied())
    if term["max_m"] is not None:
        limit = about(term["max_m"], term["margin_m"])
        parts.append(some(every([limit.at_most(one.gap), one.counts]) for one in found))
    return Answer(every(parts), next(iter(_distances(term, world, id)), {}))


def _distances(term: Json, world: World, id: int) -> Iterator[Evidence]:
    for one in _nearest(term, world, id):
        if one.counts.holds:
            yield {"distance_m": told_digits(one.gap), **one.evidence}


def _zone(term: Json, world: World, id: int) -> Answer:
    limit = about(term["overlap"], term["margin"])
    found = world.in_zones(id, term["any_of"])
    found.sort(key=lambda one: (one[1], one[0].name), reverse=True)
    return first_sure(
        Answer(
            every([limit.at_least(share), level]),
            {"zone": zone.kind, "zone_name": zone.name, "zone_overlap": told_digits(share)},
        )
        for zone, share, level in found
    )


def _overlaps(term: Json, world: World, id: int) -> list[Evidence]:
    shares = [share for _, share, _ in world.in_zones(id, term["any_of"])]
    return [{"zone_overlap": told_digits(max(shares, default=0.0))}]


def _heading(term: Json, world: World, id: int) -> Answer:
    away = term["kind"] == "facing_away"
    limit = about(term["min_deg" if away else "max_deg"], term["margin_deg"])
    answers = []
    for angle, clear, other in _bearings(term, world, id):
        kept = limit.at_least(angle) if away else limit.at_most(angle)
        kept = Told(kept.holds, kept.sure and clear.sure)
        told = every([world.together(id, other), kept])
        answers.append(Answer(told, _turned(term, angle, other)))
    return first_sure(answers)


def _bearings(term: Json, world: World, id: int) -> list[tuple[float, Told, int]]:
    away = term["kind"] == "facing_away"
    sign = -1 if away else 1
    found = [
        (*world.bearing(world.bodies[id], other), other.id)
        for other in world.of(term["away_from" if away else "to"])
        if other.id != id and world.together(id, other.id) != NO
    ]
    return sorted(found, key=lambda one: (sign * one[0], one[2]))


def _turned(term: Json, angle: float, other: int) -> Evidence:
    names = ("away_deg", "away_from_id") if term["kind"] == "facing_away" else None
    angle_name, thing = names or ("facing_deg", "facing_id")
    return {angle_name: told_digits(angle), thing: other}


def _turns(term: Json, world: World, id: int) -> list[Evidence]:
    return [_turned(term, angle, other) for angle, _, other in _bearings(term, world, id)]


def _overhang(term: Json, world: World, id: int) -> Answer:
    found = drops(world, id)
    told = same(within(one.over_m, term) for one in found)
    return Answer(told, {"overhang_m": told_digits(found[0].over_m)})


def _edge(term: Json, world: World, id: int) -> Answer:
    found = drops(world, id)
    there = same(Told(math.isfinite(one.edge_m)) for one in found)
    told = every([there, same(within(one.edge_m, term) for one in found)])
    return Answer(told, next(iter(_edges(term, world, id)), {}))


def _edges(term: Json, world: World, id: int) -> list[Evidence]:
    edge = drops(world, id)[0].edge_m
    return [{"edge_m": told_digits(edge)}] if math.isfinite(edge) else []


def _above(term: Json, world: World, id: int) -> Answer:
    near = about(term["within_m"], term["margin_m"])
    lower = about(term["drop_m"], term["margin_m"])
    return first_sure(
        Answer(
            every([together, near.at_most(gap), lower.at_least(drop)]),
            _over(gap, drop, other),
        )
        for gap, drop, other, together in _below(term, world, id)
    )


def _over(gap: float, drop: float, other: int) -> Evidence:
    found = {"above_gap_m": told_digits(gap), "above_drop_m": told_digits(drop)}
    return {"above_id": other, **found}


def _below(term: Json, world: World, id: int) -> Iterator[tuple[float, float, int, Told]]:
    low = float(world.bodies[id].low[2])
    for gap, other in _apart(term["of"], world, id, True):
        together = world.together(id, other.id)
        if together != NO:
            yield gap, low - other.top, other.id, together


def _overs(term: Json, world: World, id: int) -> Iterator[Evidence]:
    return (_over(gap, drop, other) for gap, drop, other, _ in _below(term, world, id))


def _count(term: Json, world: World, id: int) -> Answer:
    told, found = number(_counted(term, world, id), term["min"], term["max"])
    return Answer(told, {"count": found})


def _counted(term: Json, world: World, id: int) -> Iterator[Told]:
    """Of each thing that may be among them, itself too, whether it is."""
    body = world.bodies[id]
    for other in world.of(term["of"]):
        if other is body:
            yield _of_state(other, term["state"])
            continue
        if term["within_m"] is not None:
            near = about(term["within_m"], term["margin_m"]).at_most(world.gap(body, other))
            with_it = every([near, world.together(id, other.id)])
        else:
            mine, theirs = world.carriers(id), world.carriers(other.id)
            both = mine.keys() & theirs.keys()
            with_it = some(every([some(mine[k]), some(theirs[k])]) for k in both)
        yield every([with_it, _of_state(other, term["state"])])


def _holds(term: Json, world: World, id: int) -> Answer:
    told, _ = number((told for _, told in _held(term, world, id)), term["min"], term["max"])
    return Answer(told, _held_evidence(term, world, id)[0])


def _held(term: Json, world: World, id: int) -> Iterator[tuple[int, Told]]:
    wanted = ("ON", "INSIDE") if term["relation"] is None else (term["relation"],)
    for other in sorted(world.of(term["category"]), key=lambda b: b.id):
        if other.id == id:
            continue
        ways = []
        if "ON" in wanted:
            ways.append(world.carriers(other.id).get(id, (NO, NO))[0])
        if "INSIDE" in wanted:
            ways += [one.told for one in world.related(other.id, "INSIDE") if one.target == id]
        told = every([some(ways), _of_state(other, term["state"])])
        if told != NO:
            yield other.id, told


def _held_evidence(term: Json, world: World, id: int) -> list[Evidence]:
    holding = [other for other, told in _held(term, world, id) if told.holds]
    found: dict[str, Any] = {"held": len(holding)}
    return [found | ({"held_id": holding[0]} if holding else {})]


def _all(term: Json, world: World, id: int) -> Answer:
    evidence: dict[str, Any] = {}
    told = []
    # What is looked up first: most pairs of object and hazard end at a category.
    for part in sorted(term["terms"], key=lambda part: COST.get(part["kind"], 1)):
        found = answer(part, world, id)
        if found.told == NO:
            return found
        told.append(found.told)
        add(evidence, found.evidence)
    return Answer(every(told), evidence)


def _any(term: Json, world: World, id: int) -> Answer:
    return first_sure(answer(part, world, id) for part in term["terms"])


def _not(term: Json, world: World, id: int) -> Answer:
    return Answer(answer(term["term"], world, id).told.denied())


COST = {"category": 0, "state": 0, "room": 0, "overhang": 2, "edge": 2}

TERMS: dict[str, Term] = {
    "category": _category,
    "state": _state,
    "room": _room,
    "relation": _relation,
    "height": _height,
    "distance": _distance,
    "zone": _zone,
    "facing": _heading,
    "facing_away": _heading,
    "overhang": _overhang,
    "edge": _edge,
    "above": _above,
    "count": _count,
    "holds": _holds,
    "all": _all,
    "any": _any,
    "not": _not,
}

#: Terms that measure something whether or not they hold: the first of what they tell.
MEASURED: dict[str, Callable[[Json, World, int], Iterable[Evidence]]] = {
    "height": _heights,
    "distance": _distances,
    "zone": _overlaps,
    "facing": _turns,
    "facing_away": _turns,
    "overhang": lambda term, world, id: [{"overhang_m": told_digits(drops(world, id)[0].over_m)}],
    "edge": _edges,
    "above": _overs,
    "count": lambda term, world, id: [{"count": number(_counted(term, world, id), None, None)[1]}],
    "holds": _held_evidence,
}
