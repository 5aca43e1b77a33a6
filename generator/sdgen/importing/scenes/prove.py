"""What an imported home cannot keep: pieces that cut into others by more than a drawing tells,
things that do not stay where they lie, and what is a hazard as it is.

A build would refuse every scene for the sake of such a piece of furniture, and take such a thing
away. So the home is furnished a few times as a build does it, comes to rest, and is measured by the
same checks.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from sdgen.catalog.records import Catalog, HomeSpec
from sdgen.facts import entered_structures, in_the_air
from sdgen.hazards.certify import survey
from sdgen.library import Library
from sdgen.physics.checks import penetrations
from sdgen.physics.client import Client
from sdgen.physics.world import World
from sdgen.pipeline.contents import Contents
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.pipeline.rest import come_to_rest
from sdgen.pipeline.spec import node_ids
from sdgen.rejection import Rejection
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane

#: Furnished so often: fittings, and what stands open, are drawn anew each time, and ids, by whose
#: order the simulator goes.
_TIMES = 3
#: A piece is where it was drawn to so much, metres.
_THERE_M = 0.01


class Key(NamedTuple):
    """A piece by the number of its room, its list and its number there."""

    room: int
    list: Literal["furniture", "things"]
    number: int


@dataclass(frozen=True)
class Unkept:
    """What cannot stay, each with why; things that are the anomaly of a hazard, surely of one; and
    what is said of the home as a whole."""

    pieces: Mapping[Key, str]
    anomalies: Mapping[Key, str]
    told: tuple[str, ...] = ()


def unkept(spec: HomeSpec, catalog: Catalog, library: Library) -> Unkept:
    """What of a base home no build would accept, as far as a few tries show.

    A piece of furniture goes for what one try finds: a build would refuse that scene. A thing goes
    for what every try finds. One and the same stack comes to rest in most orders of its bodies and
    trembles on in some (a mug on a coaster did in one of thirty): a build takes it away in those
    scenes, and all others have it.
    """
    wrong: dict[Key, str] = {}
    anomalies: dict[Key, str] = {}
    times: Counter[Key] = Counter()
    refused: Counter[str] = Counter()
    with Client() as client:
        for number in range(_TIMES):
            rng = lane(0, number, f"import:{spec.id}")
            home = furnished_home(spec, catalog, library, library.by_category, node_ids(rng), rng)
            if isinstance(home, Rejection):
                refused[home.cause.check] += 1
                continue
            look = _Look(spec, home, catalog, World(library, client))
            found: dict[Key, str] = {}
            for key, text in look.wrong():
                found.setdefault(key, text)
            wrong = found | wrong
            anomalies.update(look.anomalies)
            times.update({*found, *look.anomalies})
    tries = _TIMES - refused.total()
    lasting = {k for k in wrong if k.list == "furniture" or times[k] == tries}
    told = [f"{n} of {_TIMES} times it is refused: {check}" for check, n in refused.items()]
    for key in sorted(wrong.keys() - lasting):
        room = spec.rooms[key.room]
        thing = f"{room.things[key.number].category} in {room.name}"
        seldom = f"{times[key]} of {tries} tries {wrong[key]}"
        told.append(f"{thing}: kept, but in {seldom}: such scenes are without it")
    return Unkept(
        pieces={k: v for k, v in wrong.items() if k in lasting},
        anomalies={k: v for k, v in anomalies.items() if k not in wrong},
        told=tuple(told),
    )


class _Look:
    """One furnished home at rest, held against the checks of a build."""

    def __init__(self, spec: HomeSpec, home: FurnishedHome, catalog: Catalog, world: World) -> None:
        self._catalog, self._world = catalog, world
        self._library = home.layout.library
        self._keys = {**_pieces(spec, home), **_things(spec, home)}
        items = {**home.layout.items, **{item.id: item for item in home.things.items}}
        intents = {**home.layout.intents, **home.things.intents}
        self._items: Mapping[int, ObjectInstance] = items
        contents = Contents(items, intents, {}, {})
        self._rested = come_to_rest(0, home, contents, False, self._library, world)
        self.anomalies: dict[Key, str] = {}

    def wrong(self) -> Iterator[tuple[Key, str]]:
        """What would not be accepted, with why."""
        restless = {key for key, item in self._items.items() if not item.fixed}
        restless &= set(self._rested.offenders)
        for number in sorted(restless):
            if number in self._keys:
                check = self._rested.offenders[number].cause.check
                yield self._keys[number], check.replace("_", " ")
        facts = self._rested.facts
        for found in (*penetrations(self._world), *entered_structures(facts), *in_the_air(facts)):
            ours = [number for number in found.objects if number in self._keys]
            if not ours or restless.intersection(found.objects):
                continue
            ours.sort(key=self._weight)
            others = [self._called(number) for number in found.objects if number != ours[0]]
            beside = f" (with {', '.join(others)})" if others else ""
            text = f"{found.check.replace('_', ' ')}{beside}, {found.measured:.3f} m"
            yield self._keys[ours[0]], text
        yield from self._hazards()

    def _hazards(self) -> Iterator[tuple[Key, str]]:
        found: dict[int, list[str]] = {}
        sure: set[int] = set()
        for positive in survey(self._rested.facts, self._catalog).positives:
            found.setdefault(positive.object_id, []).append(positive.hazard)
            if positive.verdict.value and positive.verdict.sure:
                sure.add(positive.object_id)
        for number, hazards in found.items():
            key = self._keys.get(number)
            if key is None:
                continue
            if key.list == "things" and number in sure and len(hazards) == 1:
                self.anomalies[key] = hazards[0]
            else:
                yield key, f"is a hazard as it is, or nearly: {', '.join(hazards)}"

    def _weight(self, number: int) -> tuple[bool, float]:
        """Of two, which goes: what is loose, then the smaller one."""
        item = self._items[number]
        return item.fixed, float(np.prod(self._library.assets[item.asset].extents_m))

    def _called(self, number: int) -> str:
        return self._items[number].category if number in self._items else "the building"


def _pieces(spec: HomeSpec, home: FurnishedHome) -> dict[int, Key]:
    """Ids of the pieces of furniture that are drawn."""
    names = {room.id: room.name for room in home.context.home.rooms}
    out: dict[int, Key] = {}
    for r, room in enumerate(spec.rooms):
        for k, piece in enumerate(room.furniture):
            for number, item in home.layout.items.items():
                if item.asset != piece.model or names[item.room_id] != room.name or number in out:
                    continue
                apart = np.subtract(item.pose.position_m[:2], piece.position_m[:2])
                if float(np.abs(apart).max()) < _THERE_M:
                    out[number] = Key(r, "furniture", k)
                    break
    return out


def _things(spec: HomeSpec, home: FurnishedHome) -> dict[int, Key]:
    """Ids of the things that are drawn: they are in the same order."""
    keys = [
        Key(r, "things", k) for r, room in enumerate(spec.rooms) for k in range(len(room.things))
    ]
    return {item.id: key for item, key in zip(home.things.items, keys, strict=True)}
