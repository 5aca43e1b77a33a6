"""Which scenes of a data set are wanted, told from its files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from sdgen.dataset.records import DatasetInfo, ManifestEntry
from sdgen.errors import InputError, did_you_mean

if TYPE_CHECKING:
    from sdgen.dataset.item import SceneItem

Open = Callable[[ManifestEntry], "SceneItem"]


def having_hazard(
    entries: Sequence[ManifestEntry],
    hazard: str,
    info: DatasetInfo,
    scene_of: Mapping[str, ManifestEntry],
) -> Iterator[ManifestEntry]:
    """Those with an anomaly of this hazard; of twins, those whose scene has one."""
    if hazard not in info.hazards_enabled:
        known = list(info.hazards_enabled)
        raise InputError([f"no hazard {hazard!r} in this data set{did_you_mean(hazard, known)}"])
    for entry in entries:
        scene = scene_of.get(entry.twin_of, entry) if entry.twin_of else entry
        if hazard in scene.hazards:
            yield entry


def having_room(
    entries: Sequence[ManifestEntry],
    room: str,
    hazard: str | None,
    info: DatasetInfo,
    item: Open,
) -> Iterator[ManifestEntry]:
    """Those with a room of this type; with a hazard, those with such an anomaly in one."""
    if room not in info.vocabularies.room_types:
        known = list(info.vocabularies.room_types)
        raise InputError([f"no room type {room!r}{did_you_mean(room, known)}"])
    for entry in entries:
        found = item(entry)
        ids = {one.id for one in found.scene.home.rooms if one.type == room}
        if hazard is not None and entry.twin_of is None:
            ids &= {a.room_id for a in found.anomalies.anomalies if a.hazard == hazard}
        if ids:
            yield entry


def having_household(
    entries: Sequence[ManifestEntry], household: str, item: Open
) -> Iterator[ManifestEntry]:
    """Those of this kind of household (``household.json``: ``template``)."""
    kinds: set[str] = set()
    some = False
    for entry in entries:
        kind = item(entry).household.template
        kinds.add(kind)
        if kind == household:
            some = True
            yield entry
    if kinds and not some:
        hint = did_you_mean(household, sorted(kinds))
        raise InputError([f"no household {household!r} in these scenes{hint}"])


def having_twin(
    entries: Sequence[ManifestEntry], twin: bool, twins: Mapping[str, object]
) -> Iterator[ManifestEntry]:
    """Those that have a benign twin, or those that have none."""
    return (entry for entry in entries if (entry.id in twins) == twin)
