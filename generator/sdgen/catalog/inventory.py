"""What authors can name: categories, their models with states and parts, and where they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sdgen.catalog.records import Catalog, Category, CategoryKind
from sdgen.library.records import AssetInfo


@dataclass(frozen=True)
class Stocked:
    """A category and what its models offer, each sorted.

    ``on`` says whether things can be put ON one of them, ``inside`` names hollows that things can
    be INSIDE of. ``rooms`` are the types of rooms in which generated homes have it: that are
    furnished with it or, for a small thing, with what it lives on or in.
    """

    name: str
    kind: CategoryKind
    superclass: str
    models: int
    states: tuple[str, ...]
    parts: tuple[str, ...]
    on: bool
    inside: tuple[str, ...]
    rooms: tuple[str, ...]


def inventory(catalog: Catalog, models: Mapping[str, Sequence[AssetInfo]]) -> tuple[Stocked, ...]:
    """All categories of a catalogue by name; ``models`` are those there are of each."""
    furnished = _furnished(catalog)
    return tuple(
        _stocked(category, models.get(category.name, ()), _rooms(category, furnished))
        for category in sorted(catalog.categories, key=lambda one: one.name)
    )


def _stocked(category: Category, models: Sequence[AssetInfo], rooms: set[str]) -> Stocked:
    def every(names: set[str]) -> tuple[str, ...]:
        return tuple(sorted(names))

    return Stocked(
        name=category.name,
        kind=category.kind,
        superclass=category.superclass,
        models=len(models),
        states=every({state for model in models for state in model.state_names}),
        parts=every({part.name for model in models for part in model.parts}),
        on=any(support.container is None for model in models for support in model.supports),
        inside=every({hollow.name for model in models for hollow in model.containers}),
        rooms=every(rooms),
    )


def _furnished(catalog: Catalog) -> dict[str, set[str]]:
    """By room type, what stands or hangs in it; a floor, too."""
    out = {room.name: {"floor"} for room in catalog.room_types}
    for room in catalog.room_types:
        for rule in room.furniture:
            out[room.name] |= {rule.category, rule.corner, *rule.row, *rule.extra}
    for fitting in catalog.fittings:
        for name in fitting.rooms or tuple(out):
            out[name].add(fitting.category)
    return out


def _rooms(category: Category, furnished: Mapping[str, set[str]]) -> set[str]:
    rooms = {name for name, there in furnished.items() if category.name in there}
    for abode in category.lives:
        rooms |= {
            name
            for name, there in furnished.items()
            if (not abode.rooms or name in abode.rooms) and not there.isdisjoint(abode.targets)
        }
    return rooms
