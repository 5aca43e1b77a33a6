"""The words a data set's files use, from the catalogue and the models."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import get_args

from sdgen.catalog.records import Catalog, Group, Label
from sdgen.dataset.records import Vocabularies
from sdgen.library.records import AssetInfo
from sdgen.scene import Notify
from sdgen.vocabulary import RELATIONS, ROOM_SUPERCLASS, STRUCTURE_SUPERCLASS, STRUCTURES, TAGS


def vocabularies(catalog: Catalog, infos: Mapping[str, AssetInfo]) -> Vocabularies:
    """All words a scene of this catalogue and library may use, sorted."""
    categories = catalog.categories
    homes = (*STRUCTURE_SUPERCLASS.values(), ROOM_SUPERCLASS)
    return Vocabularies(
        hazards=_words(hazard.id for hazard in catalog.hazards),
        groups=_words(get_args(Group)),
        labels=_words(get_args(Label)),
        notify=tuple(get_args(Notify)),
        categories=_words([*(c.name for c in categories), *STRUCTURES]),
        superclasses=_words([*(c.superclass for c in categories), *homes]),
        properties=_words(name for c in categories for name in c.properties),
        states=_words(state for info in infos.values() for state in info.state_names),
        relations=_words(RELATIONS),
        tags=_words(TAGS),
        room_types=_words(room.name for room in catalog.room_types),
    )


def _words(values: Iterable[str]) -> tuple[str, ...]:
    return tuple(sorted(set(values)))
