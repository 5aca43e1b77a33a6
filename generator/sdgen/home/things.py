"""The small things that a base home draws itself, as they lie."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from sdgen.actions import at_rest, settled_states
from sdgen.catalog.records import HomeSpec
from sdgen.geometry import round_position, round_quat
from sdgen.home.layout import Intent
from sdgen.library import Library
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, ObjectInstance, Pose


@dataclass(frozen=True)
class Things:
    """The things of a home, by id what each lies on or in, and which are labelled as the anomaly
    of a hazard."""

    items: tuple[ObjectInstance, ...] = ()
    intents: Mapping[int, Intent] = field(default_factory=dict)
    anomalies: Mapping[int, str] = field(default_factory=dict)


#: Of a home that draws none.
NO_THINGS = Things()


def things_drawn(
    spec: HomeSpec, home: Home, library: Library, ids: Iterator[int]
) -> Things | Rejection:
    """The things that a home draws; ``ids`` are used up. Rejected where the library has no such
    model, variant or joint."""
    items = []
    anomalies = {}
    for source, room in zip(spec.rooms, home.rooms, strict=True):
        for thing in source.things:
            asset = library.assets.get(thing.model)
            joints = {joint.name for joint in asset.joints} if asset is not None else set()
            if asset is None or thing.variant not in asset.variants or set(thing.joints) - joints:
                return reject("home", "no_model_fits", category=thing.category)
            item = ObjectInstance(
                id=next(ids),
                category=asset.category,
                asset=asset.id,
                pose=Pose(
                    position_m=round_position(thing.position_m),
                    quat_xyzw=round_quat(thing.quat_xyzw),
                ),
                room_id=room.id,
            )
            item = at_rest(item, asset)
            joints_now = {**item.joints, **thing.joints}
            item = settled_states(
                item.model_copy(update={"joints": joints_now, "variant": thing.variant}), asset
            )
            items.append(item)
            if thing.anomaly is not None:
                anomalies[item.id] = thing.anomaly
    return Things(tuple(items), {}, anomalies)
