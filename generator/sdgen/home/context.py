"""What placing things in a furnished home goes by."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Catalog
from sdgen.freespace import union
from sdgen.library.records import Asset
from sdgen.scene import Home, Zone

#: Which models a scene may use (its split decides): category -> models.
Models = Callable[[str], tuple[Asset, ...]]

#: Zones that things on the floor keep out of, or they would trip somebody.
KEEP_CLEAR = ("doorway", "walkway", "swing")


@dataclass(frozen=True)
class HomeContext:
    """A furnished home's shell and zones, and the catalogue and models it may be filled from."""

    home: Home
    zones: Sequence[Zone]
    catalog: Catalog
    models: Models

    def room_type(self, room_id: int) -> str:
        """What a room of the home is for."""
        return next(room.type for room in self.home.rooms if room.id == room_id)

    def floor_id(self, room_id: int) -> int:
        """The floor structure of a room of the home."""
        return next(
            s.id for s in self.home.structures if s.category == "floor" and s.room_id == room_id
        )

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

    @cached_property
    def _zone_shapes(self) -> dict[tuple[tuple[str, ...], int | None], BaseGeometry]:
        return {}
