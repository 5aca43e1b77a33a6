"""What placing things in a furnished home goes by."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Catalog
from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, union, unreachable_rooms
from sdgen.geometry import Array
from sdgen.home.ground import ASIDE_M, Ground, walls_of
from sdgen.home.layout import Bulk, Vec3Yaw
from sdgen.home.reach import Reach
from sdgen.library.records import Asset, AssetInfo
from sdgen.scene import Home, ObjectInstance, Zone
from sdgen.seeding import Rng
from sdgen.vocabulary import ZONE_KEEP_SHARE
from sdgen.zones import floor_obstacles

#: Which models a scene may use (its split decides): category -> models.
Models = Callable[[str], tuple[Asset, ...]]
_GroundKey = tuple[int, tuple[str, ...], tuple[str, ...], float, bool]

#: A thing on the floor has its middle at least so far from the walls: what lies there alone has
#: been dropped or left, not pushed into the angle of wall and floor.
FLOOR_OFF_WALLS_M = 0.1
#: Zones that things on the floor keep out of, or they would trip somebody.
KEEP_CLEAR = ("doorway", "walkway", "swing")
#: Spots looked at on one target where only some will do: those that views show, and of a bookcase
#: only the high shelves.
SPOTS_TRIED = 8
#: Of the everyday things that may be taken for an anomaly or a near miss, so many lie where a view
#: shows them, as every anomaly does; the others lie anywhere, or rooms that no view looks into
#: would be bare.
IN_VIEW_SHARE = 0.88
#: Corners of what stands that are so near to a line, metres, are none.
ALMOST_M = 0.001


class Shows(Protocol):
    """What the views of a home would show."""

    def thing(self, corners_m: Array, /) -> bool:
        """True for a thing with these outermost points (N, 3)."""
        ...

    def telling(self, item: ObjectInstance, parts: Sequence[str], pixels: int, /) -> bool:
        """True where so many pixels of these parts of a thing will show."""
        ...

    def floor(self, shape: BaseGeometry, /) -> BaseGeometry:
        """The part of a floor on which things may be seen."""
        ...

    def set_to(self, object_id: int, state: str, /) -> Sequence[ObjectInstance] | None:
        """A piece of furniture brought into a state, in each way that is seen; None: any way."""
        ...

    def anything_on(self, target_id: int, /) -> bool:
        """False where no thing would be seen on a piece of furniture, or on a room's floor: it need
        not be tried."""
        ...


class Everything:
    """A home that nobody has chosen views for: all will do."""

    def thing(self, _corners_m: Array, /) -> bool:
        """True."""
        return True

    def telling(self, _item: ObjectInstance, _parts: Sequence[str], _pixels: int, /) -> bool:
        """True."""
        return True

    def floor(self, shape: BaseGeometry, /) -> BaseGeometry:
        """All of it."""
        return shape

    def set_to(self, _object_id: int, _state: str, /) -> None:
        """Any way."""

    def anything_on(self, _target_id: int, /) -> bool:
        """True."""
        return True


@dataclass(frozen=True)
class HomeContext:
    """A furnished home's shell and zones, and the catalogue and models it may be filled from.

    ``shows`` tells where things can be seen, ``narrow`` is the floor that people use though no way
    leads there: what must keep off walkways keeps off it. ``standing`` is what the furniture stands
    on, ``free`` where a robot's middle can be (None: anywhere); ``tidiness`` is that of those who
    live there.
    """

    home: Home
    zones: Sequence[Zone]
    catalog: Catalog
    models: Models
    reach: Reach
    shows: Shows = field(default_factory=Everything)
    narrow: BaseGeometry = field(default_factory=Polygon)
    standing: BaseGeometry = field(default_factory=Polygon)
    free: BaseGeometry | None = None
    tidiness: float = 0.5

    def shows_at(self, bulk: Bulk, spot: Vec3Yaw) -> bool:
        """True when what fills this can be seen at a spot."""
        return self.shows.thing(bulk.corners(spot))

    def faces_wall(self, room_id: int, spot: Vec3Yaw) -> bool:
        """Whether what stands at a spot of a room looks at a wall that is near."""
        (x, y, _), yaw = spot
        return self.ground(room_id).faces_wall((x, y), yaw)

    def leaves_free(self, item: ObjectInstance, info: AssetInfo) -> BaseGeometry:
        """What is left of the free floor with a piece as it is, a leaf open across a way: nothing
        in a home where one can be anywhere."""
        grown = [
            shape.buffer(ROBOT_RADIUS_M, quad_segs=2)
            for shape in floor_obstacles(bodies_of([item], {info.id: info}))
        ]
        return (self.free or Polygon()).difference(union(grown))

    def cuts_off(self, item: ObjectInstance, info: AssetInfo) -> bool:
        """Whether some room could not be got to any more with a piece as it is."""
        if self.free is None:
            return False
        return bool(unreachable_rooms(self.home, self.leaves_free(item, info)))

    def keeps_to_views(self, category: str, rng: Rng) -> bool:
        """Draws whether an everyday thing is to lie where it can be seen."""
        return category in self.made_categories and rng.random() < IN_VIEW_SHARE

    def room_type(self, room_id: int) -> str:
        """What a room of the home is for."""
        return next(room.type for room in self.home.rooms if room.id == room_id)

    def floor_id(self, room_id: int) -> int:
        """The floor structure of a room of the home."""
        return next(
            s.id for s in self.home.structures if s.category == "floor" and s.room_id == room_id
        )

    def floor(self, room_id: int) -> BaseGeometry:
        """Where things on a room's floor may have their middle."""
        return self._outline(room_id).buffer(-FLOOR_OFF_WALLS_M)

    def ground(
        self,
        room_id: int,
        clear_of: Sequence[str] = (),
        within: Sequence[str] = (),
        keep_share: float = ZONE_KEEP_SHARE,
        in_view: bool = False,
    ) -> Ground:
        """The floor of a room that takes things which are to be clear of zones of some kinds, or
        with so much of themselves within some, or where they may be seen; computed once a home.
        What is to keep off walkways is put aside."""
        key = (room_id, tuple(clear_of), tuple(within), keep_share, in_view)
        if key not in self._grounds:
            ground = self._ground(*key[:-1])
            if in_view:
                seen = self.shows.floor(ground.outline)
                ground = ground.within(seen if ground.area is not None else seen.buffer(ASIDE_M[1]))
            self._grounds[key] = ground
        return self._grounds[key]

    def _ground(
        self, room_id: int, clear_of: Sequence[str], within: Sequence[str], keep_share: float
    ) -> Ground:
        outline, avoid = self._outline(room_id), self.zone_shape(clear_of)
        if "walkway" in clear_of and not within:
            # Clipped first: what a room's walls are clear of is little of what stands in a home.
            near = outline.buffer(ASIDE_M[1], join_style="mitre")
            taken = [shape.intersection(near) for shape in (avoid, self.narrow, self._beside)]
            walls = walls_of(outline).difference(union(taken))
            return Ground(outline, None, walls, avoid=avoid, off=self.narrow)
        area = self.floor(room_id).difference(avoid)
        if not within:
            return Ground(outline, area, avoid=avoid)
        area = area.intersection(self.zone_shape(within, room_id))
        return Ground(outline, area, keep_share=keep_share)

    @cached_property
    def _beside(self) -> BaseGeometry:
        """What stands, and where things beside it would be put aside."""
        # Corners that all but lie on a line would have no mitre.
        return self.standing.simplify(ALMOST_M).buffer(ASIDE_M[1], join_style="mitre")

    def _outline(self, room_id: int) -> Polygon:
        return Polygon(next(room.polygon_m for room in self.home.rooms if room.id == room_id))

    @cached_property
    def _grounds(self) -> dict[_GroundKey, Ground]:
        return {}

    def zone_shape(self, kinds: Sequence[str], room_id: int | None = None) -> BaseGeometry:
        """Union of the zones of these kinds (of one room); computed once a home."""
        key = (tuple(kinds), room_id)
        if key not in self._zone_shapes:
            self._zone_shapes[key] = union(
                [
                    shapely.polygons(zone.polygon_m)
                    for zone in self.zones
                    if zone.kind in kinds and (room_id is None or zone.room_id == room_id)
                ]
            )
        return self._zone_shapes[key]

    def may_hold(self, category: str, target: str, hollow: str) -> bool:
        """Whether such a thing goes into a hollow of this name of such a target: into those that
        its ``lives`` names there, else into all but the reserved ones."""
        named, reserved = self._hollows
        words = named.get((category, target))
        if words is not None:
            return any(_is_called(hollow, word) for word in words)
        return not any(_is_called(hollow, word) for word in reserved.get(target, ()))

    @cached_property
    def _hollows(
        self,
    ) -> tuple[Mapping[tuple[str, str], Sequence[str]], Mapping[str, Sequence[str]]]:
        """The hollows that each category's ``lives`` names, by it and target; the reserved ones,
        by target."""
        named: dict[tuple[str, str], list[str]] = {}
        for category in self.catalog.categories:
            for abode in category.lives:
                for target in abode.targets if abode.hollow is not None else ():
                    named.setdefault((category.name, target), []).append(str(abode.hollow))
        return named, {c.name: c.reserved for c in self.catalog.categories if c.reserved}

    @cached_property
    def made_categories(self) -> frozenset[str]:
        """Every category that recipes of anomalies and lookalikes place or set."""
        return frozenset(
            category
            for hazard in self.catalog.hazards
            for recipe in (*hazard.anomalies, *hazard.lookalikes)
            for category in recipe.categories
        )

    @cached_property
    def _zone_shapes(self) -> dict[tuple[tuple[str, ...], int | None], BaseGeometry]:
        return {}


def _is_called(hollow: str, word: str) -> bool:
    """``drawer_2`` and ``inside_left`` are a drawer and an inside, too."""
    return hollow == word or hollow.startswith(word + "_")
