"""One try at a scene's contents: place, let settle, prove. A rejection is a value."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Mapping
from dataclasses import dataclass

from sdgen.facts import Body, Facts
from sdgen.freespace import free_shape, unreachable_rooms
from sdgen.hazards.certify import Survey, survey
from sdgen.hazards.placing import Injected
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.physics.settle import Settled
from sdgen.physics.world import World
from sdgen.pipeline.contents import Contents, lost, place_contents, without
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.rest import Rested, come_to_rest, will_not_stay
from sdgen.pipeline.spec import SceneSpec, node_ids
from sdgen.rejection import Cause, Rejection, reject
from sdgen.zones import floor_obstacles, swing_blocked

#: Most tries rest in the first round or, with some clutter gone, in the second.
SETTLE_ROUNDS = 4


@dataclass(frozen=True)
class Proved:
    """Settled, rounded contents whose labels hold, and how they were reached; ``drawn`` are the
    pairs of object and hazard that were asked for."""

    facts: Facts
    surveyed: Survey
    drawn: frozenset[tuple[int, str]]
    lookalikes: tuple[Injected, ...]
    settled: Settled
    taken_away: Counter[Cause]


def attempt(
    spec: SceneSpec,
    home: FurnishedHome,
    home_attempt: int,
    placement: int,
    library: Library,
    client: Client,
) -> Proved | Rejection:
    """Contents of a scene with exactly the drawn anomalies.

    Follows from the specification, the furnished home and the two numbers alone: no try depends
    on another.
    """
    contents = placed(spec, home, home_attempt, placement)
    if isinstance(contents, Rejection):
        return contents
    return prove(spec.index, home, contents, library, World(library, client))


def prove(
    index: int, home: FurnishedHome, contents: Contents, library: Library, world: World
) -> Proved | Rejection:
    """Contents at rest with exactly their anomalies, without the everyday things that were in the
    way of that.

    ``world`` is empty.
    """
    taken_away: Counter[Cause] = Counter()
    spent = False
    for round_ in range(SETTLE_ROUNDS):
        if spent:
            world, spent = World(library, world.client), False
        rested = come_to_rest(index, home, contents, round_ > 0, library, world)
        offenders = rested.offenders
        if not offenders:
            surveyed = survey(rested.facts, home.context.catalog)
            offenders = _unproved(rested, surveyed, library)
            if not offenders:
                offenders = will_not_stay(rested.contents, world)
                if not offenders:
                    return _proved(home, rested, surveyed, taken_away, library)
                spent = True
        reduced = without(rested.contents, offenders)
        if isinstance(reduced, Rejection):
            return reduced
        missed = lost(contents, reduced.contents, home.context.catalog)
        if missed is not None:
            return missed
        contents = reduced.contents
        taken_away.update(rejection.cause for rejection in reduced.taken_away)
    return reject("physics", "no_rest")


def placed(
    spec: SceneSpec, home: FurnishedHome, home_attempt: int, placement: int
) -> Contents | Rejection:
    """What this attempt puts into the home, before anything moves; ids and all from own lanes."""
    lane = f"{home_attempt}:{placement}"
    layout = home.layout.copy(node_ids(spec.lane(f"ids:{lane}"), taken=home.ids))
    training = spec.split == "train"
    rng = spec.lane(f"place:{lane}")
    return place_contents(_in_turn(spec, lane, placement), home, layout, training, rng, spec.only)


def _in_turn(spec: SceneSpec, lane: str, placement: int) -> list[str]:
    """The drawn hazards in the order in which they find their places, another one after the first
    try: a cloth that lies on the stove already leaves a pan no room, a pan leaves some for a
    cloth (of 48 tries 3 and 23 found room for both)."""
    if placement == 0:
        return list(spec.hazards)
    order = spec.lane(f"order:{lane}").permutation(len(spec.hazards))
    return [spec.hazards[k] for k in order]


def _unproved(rested: Rested, surveyed: Survey, library: Library) -> dict[int, Rejection]:
    """Objects for whose sake the labels do not hold: the drawn pairs hold, of other things than
    theirs none does, none is in doubt, and nothing benign stands in a door's way."""
    contents = rested.contents
    wrong: dict[int, Rejection] = {}
    proved: set[tuple[int, str]] = set()
    for positive in surveyed.positives:
        key, culprit = positive.object_id, contents.anomalies.get(positive.object_id)
        if culprit is not None:
            # What makes one hazard may make another, too: that pair is implied.
            if positive.verdict.sure:
                proved.add((key, positive.hazard))
                continue
            if positive.hazard in culprit.drawn:
                continue
        check = "accidental" if positive.verdict.sure else "in_doubt"
        wrong[key] = contents.objection(key, "proof", check, other=positive.hazard)
    for key in swing_blocked(_unlabelled(rested, surveyed)):
        wrong[key] = contents.objection(key, "proof", "in_door_swing")
    for key, culprit in contents.anomalies.items():
        if any((key, hazard) not in proved for hazard in culprit.drawn):
            wrong[key] = contents.objection(key, "proof", "not_proved")
    return wrong


def _unlabelled(rested: Rested, surveyed: Survey) -> list[Body]:
    """All but the anomalies, as they stand; what was only brought along is none."""
    labelled = {one.object_id for one in surveyed.positives}
    return [body for key, body in rested.facts.bodies.items() if key not in labelled]


def staying_bodies(bodies: Mapping[int, Body], anomalies: Container[int]) -> list[Body]:
    """What a way through the home goes around: all but loose anomalies, which may lie in a doorway
    and are picked up. The open door of a fridge stays."""
    return [body for key, body in bodies.items() if body.item.fixed or key not in anomalies]


def _proved(
    home: FurnishedHome,
    rested: Rested,
    surveyed: Survey,
    taken_away: Counter[Cause],
    library: Library,
) -> Proved | Rejection:
    contents = rested.contents
    obstacles = floor_obstacles(staying_bodies(rested.facts.bodies, contents.anomalies))
    cut_off = unreachable_rooms(home.context.home, free_shape(home.context.home, obstacles))
    if cut_off:
        return reject("proof", "room_cut_off", category=cut_off[0].type)
    return Proved(
        facts=rested.facts,
        surveyed=surveyed,
        drawn=frozenset(
            (key, hazard) for key, one in contents.anomalies.items() for hazard in one.drawn
        ),
        lookalikes=tuple(contents.lookalikes[k] for k in sorted(contents.lookalikes)),
        settled=rested.settled,
        taken_away=taken_away,
    )
