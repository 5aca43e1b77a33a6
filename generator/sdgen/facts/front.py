"""The facts of a scene: what predicates ask, what the graph writes."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import NamedTuple

import numpy as np

from sdgen.catalog.predicate import (
    Bearing,
    Member,
    Overlooked,
    ReachHeight,
    Related,
    Span,
    ZoneGap,
)
from sdgen.facts import brinks, members, spatial
from sdgen.facts.measured import Measured
from sdgen.facts.relations import FINDERS
from sdgen.facts.rooms import same_room, types_of
from sdgen.facts.tags import tags
from sdgen.geometry import Vec3, vec3
from sdgen.kleene import Kleene
from sdgen.library.states import derive_states, undecided_states


class Edge(NamedTuple):
    """A relation between two nodes."""

    from_id: int
    to_id: int
    relation: str


class Facts(Measured):
    """Measured facts of a scene, derived from poses, joints, variants and asset records alone.

    Keeps to :class:`~sdgen.catalog.predicate.FactSource`.
    """

    @cached_property
    def _related(self) -> dict[tuple[int, str], tuple[Related, ...]]:
        return {}

    @cached_property
    def _brinks(self) -> dict[int, brinks.Brink]:
        return {}

    # --- what predicates ask ---------------------------------------------------------------------

    def states(self, object_id: int) -> tuple[str, ...]:
        """States that hold, from variant and joints; none for structures and rooms."""
        body = self.bodies.get(object_id)
        if body is None:
            return ()
        return derive_states(body.info, body.item.variant, body.item.joints)

    def undecided_states(self, object_id: int) -> tuple[str, ...]:
        """States within the dead band between their limits."""
        body = self.bodies.get(object_id)
        if body is None:
            return ()
        return undecided_states(body.info, body.item.variant, body.item.joints)

    def room_types(self, object_id: int) -> tuple[str, ...]:
        """Types of the rooms the object may be in, nearest first; one where that is decided."""
        return types_of(self.rooms.by_id, self.room_ids(object_id))

    def height(self, object_id: int) -> float:
        """Height of the object's lowest point above the floor, metres."""
        return float(self.bodies[object_id].low[2])

    def reach(self, object_id: int) -> ReachHeight:
        """How high the object is for a child, who climbs on what the catalogue says."""
        body = self.bodies[object_id]
        return self.climbs.heights(body.low, body.high, self._rooms, object_id)

    def related(self, object_id: int, relation: str) -> tuple[Related, ...]:
        """Targets the object stands, or nearly stands, in ``relation`` to."""
        key = (object_id, relation)
        if key not in self._related:
            self._related[key] = tuple(FINDERS[relation](self, object_id))
        return self._related[key]

    def gaps(
        self, object_id: int, categories: Collection[str], from_above: bool = False
    ) -> tuple[tuple[float, int], ...]:
        """Gap in metres to each other object of these categories, and its id, nearest first:
        between the boxes or, ``from_above``, between the outlines on the floor plan."""
        return spatial.apart(self, object_id, self.ids_of(categories), from_above)

    def zone_gaps(
        self, object_id: int, kinds: Collection[str], from_above: bool = False
    ) -> tuple[ZoneGap, ...]:
        """Zones of these kinds that the object does not make itself, nearest first: those at its
        heights or, ``from_above``, at any."""
        rooms = self.room_ids(object_id)
        return tuple(
            ZoneGap(gap, zone.name, zone.source_id, level, same_room(rooms, (zone.room_id,)))
            for gap, zone, level in self.zone_index.gaps(self.bodies[object_id], kinds, from_above)
        )

    def together(self, object_id: int, other: int) -> Kleene:
        """Whether two objects are in one room."""
        return same_room(self.room_ids(object_id), self.room_ids(other))

    def overhang(self, object_id: int) -> Span:
        """How far the object reaches beyond all that would catch it."""
        if object_id not in self._brinks and brinks.carried_whole(self, object_id):
            return Span(0.0, 0.0, 0.0)
        return self._brink(object_id).overhang

    def edge(self, object_id: int) -> Span:
        """How far the object's outline is from where a drop begins; infinite: from nowhere."""
        return self._brink(object_id).edge

    def _brink(self, object_id: int) -> brinks.Brink:
        if object_id not in self._brinks:
            self._brinks[object_id] = brinks.brink(self, object_id)
        return self._brinks[object_id]

    def overlooked(self, object_id: int, categories: Collection[str]) -> tuple[Overlooked, ...]:
        """Things of these categories that are, or may be, in the object's room, nearest first."""
        return tuple(spatial.overlooked(self, object_id, self.ids_of(categories)))

    def sharing(self, object_id: int, categories: Collection[str]) -> tuple[Member, ...]:
        """Other objects of these categories, and whether they are ON or INSIDE something that the
        object is ON or INSIDE, too, or that what carries it is."""
        return tuple(members.sharing(self, object_id, self.ids_of(categories)))

    def carried(
        self, object_id: int, categories: Collection[str], relation: str
    ) -> tuple[Member, ...]:
        """Objects of these categories, and whether the object holds them, ON or INSIDE."""
        return tuple(members.carried(self, object_id, self.ids_of(categories), relation))

    def bearings(self, object_id: int, categories: Collection[str]) -> tuple[Bearing, ...]:
        """Where things of these categories in its room are, as seen from the object's front."""
        return tuple(spatial.bearings(self, object_id, self.ids_of(categories)))

    # --- what the graph writes -------------------------------------------------------------------

    def bounding_box(self, object_id: int) -> tuple[Vec3, Vec3]:
        """World box of an object, structure or room: centre and size."""
        if object_id in self.bodies:
            low, high = self.bodies[object_id].low, self.bodies[object_id].high
        elif object_id in self.rooms.by_id:
            room = self.rooms.by_id[object_id]
            points = np.array(room.polygon_m)
            low = np.array([*points.min(axis=0), 0.0])
            high = np.array([*points.max(axis=0), room.height_m])
        else:
            pieces = self.structures[object_id].pieces
            centers = np.array([p.center_m for p in pieces])
            sizes = np.array([p.size_m for p in pieces])
            low, high = (centers - sizes / 2).min(axis=0), (centers + sizes / 2).max(axis=0)
        return vec3((low + high) / 2), vec3(high - low)

    def holds(self, object_id: int, relation: str) -> tuple[int, ...]:
        """Ids of the targets the relation holds to."""
        found = (r.target_id for r in self.related(object_id, relation) if r.holds)
        return tuple(dict.fromkeys(found))

    def edges(self) -> tuple[Edge, ...]:
        """All relations of the scene, sorted, each once; who is in which room is INSIDE it."""
        out = [Edge(s.id, s.room_id, "INSIDE") for s in self.structures.values()]
        for object_id in self.bodies:
            out += [
                Edge(object_id, room, "INSIDE") for room in self.room_ids(object_id)[:1] if room
            ]
            out += [Edge(object_id, other, "CLOSE") for other in spatial.close_to(self, object_id)]
            for relation in FINDERS:
                if relation != "CLOSE":
                    related = self.related(object_id, relation)
                    out += [Edge(object_id, r.target_id, relation) for r in related if r.holds]
        return tuple(sorted(set(out)))

    def tags(self, object_id: int) -> tuple[str, ...]:
        """Unary facts of an object, sorted; none for structures and rooms."""
        return tags(self, self, object_id) if object_id in self.bodies else ()

    def room_type(self, object_id: int) -> str:
        """Type of the room that is nearest to the object."""
        return next(iter(self.room_types(object_id)), "")
