"""What is measured of a scene's things, one by one: their rooms, hollows, surfaces and zones.

Relations, tags and predicates stand on it; it knows none of them.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cached_property

from sdgen.catalog.predicate import Related, ZoneShare
from sdgen.facts.body import Body, rows, with_footprints
from sdgen.facts.carriers import Carrier, carriers_of
from sdgen.facts.containers import Containers
from sdgen.facts.grounds import Grounds
from sdgen.facts.reach import Climbs
from sdgen.facts.rooms import Rooms
from sdgen.facts.supports import Supports
from sdgen.facts.zones import ZoneIndex
from sdgen.geometry import Array
from sdgen.kleene import Kleene, any_of
from sdgen.library.records import AssetInfo
from sdgen.scene import ObjectInstance, Scene


class Measured:
    """A scene's bodies, and what each of them is in and on, measured once and kept.

    ``properties`` maps category to its catalogue properties (LOOKABLE, SITTABLE …), needed for
    FACING only; ``climbs`` maps category to how high a child stands that climbed on it, metres.
    """

    def __init__(
        self,
        scene: Scene,
        infos: Mapping[str, AssetInfo],
        properties: Mapping[str, Collection[str]] | None = None,
        known: Measured | None = None,
        climbs: Mapping[str, float] | None = None,
    ) -> None:
        """``known`` is another scene of the same home: what stands there too, and as it does
        here, is not measured again."""
        self.scene = scene
        self.properties = properties or {}
        same_home = known and known.scene.home is scene.home and known.scene.zones == scene.zones
        self._known = known if same_home else None
        bodies = [self._known_body(item) or Body(item, infos[item.asset]) for item in scene.objects]
        self.bodies = {body.item.id: body for body in with_footprints(bodies)}
        self.structures = {s.id: s for s in scene.home.structures}
        self.rooms: Rooms = self._known.rooms if self._known else Rooms(scene.home)
        self.supports = Supports(self.bodies, scene.home)
        self.containers = Containers(self.bodies)
        self.zone_index: ZoneIndex = (
            self._known.zone_index if self._known else ZoneIndex(scene.zones)
        )
        self.climbs = Climbs(self.bodies.values(), climbs or {})
        known_grounds = self._known.grounds if self._known else None
        self.grounds: Grounds = Grounds(self.bodies, self.rooms, known_grounds)
        self._carriers: dict[int, dict[int, Carrier]] = {}
        self._inside: dict[int, tuple[Related, ...]] = {}
        self._on: dict[int, tuple[Related, ...]] = {}
        self._shares: dict[int, tuple[ZoneShare, ...]] = {}

    def _known_body(self, item: ObjectInstance) -> Body | None:
        body = self._known.bodies.get(item.id) if self._known else None
        return body if body is not None and body.item is item else None

    def category(self, object_id: int) -> str:
        """Category of an object or structure; the type of a room."""
        if object_id in self.bodies:
            return self.bodies[object_id].item.category
        if object_id in self.structures:
            return self.structures[object_id].category
        return self.rooms.by_id[object_id].type

    def room_ids(self, object_id: int) -> tuple[int, ...]:
        """Ids of the rooms the object may be in, by its pose, nearest first (0: outdoors)."""
        return self._rooms[object_id]

    @cached_property
    def _rooms(self) -> dict[int, tuple[int, ...]]:
        centers = rows([body.center for body in self.bodies.values()], 3)
        return dict(zip(self.bodies, self.rooms.of(list(self.bodies), centers), strict=True))

    def inside(self, object_id: int) -> tuple[Related, ...]:
        """What the object is INSIDE, or nearly."""
        if object_id not in self._inside:
            self._inside[object_id] = tuple(self.containers.inside(self.bodies[object_id]))
        return self._inside[object_id]

    def on(self, object_id: int) -> tuple[Related, ...]:
        """What the object is ON, or nearly: nothing that it is INSIDE."""
        if object_id not in self._on:
            inside: dict[int, Kleene] = {}
            for r in self.inside(object_id):
                before = inside.get(r.target_id, Kleene(False))
                inside[r.target_id] = any_of((before, Kleene(r.holds, r.sure)))
            self._on[object_id] = tuple(self.supports.on(self.bodies[object_id], inside))
        return self._on[object_id]

    def carriers(self, object_id: int) -> Mapping[int, Carrier]:
        """All that carries the object, or may, however indirectly, by id."""
        if object_id not in self._carriers:
            self._carriers[object_id] = carriers_of(self, object_id)
        return self._carriers[object_id]

    def part_holding(self, object_id: int, owner: int) -> str | None:
        """The part of ``owner`` that the object stands on or, if on none, is in the hollow of."""
        body = self.bodies[object_id]
        under = self.supports.part_under(body, owner)
        return under or self.containers.part_around(body, owner)

    def zones(self, object_id: int) -> tuple[ZoneShare, ...]:
        """Zones the object's footprint touches, where its height range meets the zone's."""
        body = self.bodies[object_id]
        if self._known and self._known.bodies.get(object_id) is body:
            return self._known.zones(object_id)
        if object_id not in self._shares:
            self._shares[object_id] = tuple(self.zone_index.shares(body))
        return self._shares[object_id]

    def zone_shares(self, object_id: int, kinds: Collection[str]) -> tuple[ZoneShare, ...]:
        """What of the object's footprint lies in zones of these kinds, taken together."""
        shares = self.zones(object_id)
        return tuple(self.zone_index.together(self.bodies[object_id], shares, kinds))

    @cached_property
    def boxes(self) -> tuple[list[int], Array, Array]:
        """Ids of all objects, and the low and high corners of their boxes (N, 3)."""
        bodies = self.bodies.values()
        return (
            list(self.bodies),
            rows([b.low for b in bodies], 3),
            rows([b.high for b in bodies], 3),
        )

    @cached_property
    def fixtures(self) -> tuple[list[int], Array, Array, Array]:
        """All that is fixed: ids, the low and high corners of the boxes (N, 3), and how high what
        people use of each is (N,)."""
        fixed = [body for body in self.bodies.values() if body.item.fixed]
        return (
            [body.item.id for body in fixed],
            rows([body.low for body in fixed], 3),
            rows([body.high for body in fixed], 3),
            rows([body.top_m for body in fixed]),
        )

    @cached_property
    def roofs(self) -> tuple[list[int], Array, Array]:
        """What things can be under."""
        return self.supports.roofs(self.bodies)

    def having(self, trait: str) -> tuple[int, ...]:
        """Ids of the objects whose category has a property."""
        return self._by_property.get(trait, ())

    def ids_of(self, categories: Collection[str]) -> list[int]:
        """Ids of the objects of these categories, by category."""
        return [key for name in sorted(categories) for key in self._by_category.get(name, ())]

    @cached_property
    def _by_property(self) -> dict[str, tuple[int, ...]]:
        out: dict[str, tuple[int, ...]] = {}
        for key, body in self.bodies.items():
            for trait in self.properties.get(body.item.category, ()):
                out[trait] = (*out.get(trait, ()), key)
        return out

    @cached_property
    def _by_category(self) -> dict[str, list[int]]:
        out: dict[str, list[int]] = {}
        for key, body in self.bodies.items():
            out.setdefault(body.item.category, []).append(key)
        return out
