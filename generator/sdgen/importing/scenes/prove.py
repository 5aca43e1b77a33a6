"""What an imported home cannot keep: pieces that cut into others by more than a drawing tells, and
what is a hazard as it stands.

A build would refuse every scene for the sake of one such piece. So the home is furnished once as a
build does it, and measured by the same checks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from sdgen.catalog.records import Catalog, HomeSpec
from sdgen.facts import entered_structures, in_the_air
from sdgen.hazards.certify import facts_of, survey
from sdgen.library import Library
from sdgen.physics.checks import penetrations
from sdgen.physics.client import Client
from sdgen.physics.world import World
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.pipeline.spec import node_ids
from sdgen.rejection import Rejection
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane

#: Furnished so often: fittings, and what stands open, are drawn anew each time.
_TIMES = 3
#: A piece is where it was drawn to so much, metres.
_THERE_M = 0.01

#: A piece by the numbers of its room and its own.
Key = tuple[int, int]


@dataclass(frozen=True)
class Unkept:
    """Pieces that cannot stay, each with why; and what is said of the home as a whole."""

    pieces: Mapping[Key, str]
    told: tuple[str, ...] = ()


def unkept(spec: HomeSpec, catalog: Catalog, library: Library) -> Unkept:
    """What of a base home no build would accept, as far as a few tries show."""
    pieces: dict[Key, str] = {}
    told: list[str] = []
    with Client() as client:
        for number in range(_TIMES):
            rng = lane(0, number, f"import:{spec.id}")
            home = furnished_home(spec, catalog, library, library.by_category, node_ids(rng), rng)
            if isinstance(home, Rejection):
                told.append(f"furnished once in {_TIMES} times it is refused: {home.cause.check}")
                continue
            for key, text in _wrong(spec, home, catalog, World(library, client)):
                pieces.setdefault(key, text)
    return Unkept(pieces, tuple(dict.fromkeys(told)))


def _wrong(
    spec: HomeSpec, home: FurnishedHome, catalog: Catalog, world: World
) -> Iterator[tuple[Key, str]]:
    library, items = home.layout.library, home.layout.items
    scene = home.scene(0, items)
    facts = facts_of(scene, library.infos, catalog, home.facts)
    drawn = _drawn(spec, home)
    world.become(scene, set())
    for found in (*penetrations(world), *entered_structures(facts), *in_the_air(facts)):
        ours = [key for key in found.objects if key in drawn]
        if not ours:
            continue
        # Of two the smaller one goes.
        ours.sort(key=lambda key: float(np.prod(library.assets[items[key].asset].extents_m)))
        others = [_called(key, items) for key in found.objects if key != ours[0]]
        beside = f" (with {', '.join(others)})" if others else ""
        yield drawn[ours[0]], f"{found.check.replace('_', ' ')}{beside}, {found.measured:.3f} m"
    for positive in survey(facts, catalog).positives:
        if positive.object_id in drawn:
            text = f"is a hazard as it stands: {positive.hazard}"
            yield drawn[positive.object_id], text


def _called(key: int, items: Mapping[int, ObjectInstance]) -> str:
    return items[key].category if key in items else "the building"


def _drawn(spec: HomeSpec, home: FurnishedHome) -> dict[int, Key]:
    """Ids of the pieces that are drawn, with their numbers."""
    names = {room.id: room.name for room in home.context.home.rooms}
    out: dict[int, Key] = {}
    for r, room in enumerate(spec.rooms):
        for k, piece in enumerate(room.furniture):
            for key, item in home.layout.items.items():
                if item.asset != piece.model or names[item.room_id] != room.name or key in out:
                    continue
                apart = np.subtract(item.pose.position_m[:2], piece.position_m[:2])
                if float(np.abs(apart).max()) < _THERE_M:
                    out[key] = (r, k)
                    break
    return out
