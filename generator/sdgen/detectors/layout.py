"""The columns of what a trained detector reads of a scene graph, by the words of a data set.

Columns come in blocks, so that a kind of detector sees some of them and not the others: what an
object list tells is no state and no place.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from sdgen.dataset import Dataset
from sdgen.vocabulary import STRUCTURES

#: Columns of the shape of a thing and of how it lies, metres: see ``graph_rows``.
SHAPE = ("bottom", "top", "long", "short", "height", "footprint", "upright")
#: Of what is around it, metres; ``far`` where there is none.
AROUND = (
    "door_gap",
    "furniture_gap",
    "heat_gap",
    "water_gap",
    "free_x",
    "free_y",
    "free_least",
    "above_climb",
)
#: How many there are.
COUNTS = ("same_in_room", "same_in_home", "in_room", "in_home")
#: Of what holds it: how many things it is on, containers it is in, and whether one of them, however
#: far out, is closed.
HELD = ("on", "inside", "shut_in")


@dataclass(frozen=True)
class Layout:
    """The words that become columns; ``superclasses`` are those of ``categories``, one each."""

    categories: tuple[str, ...]
    superclasses: tuple[str, ...]
    properties: tuple[str, ...]
    states: tuple[str, ...]
    relations: tuple[str, ...]
    tags: tuple[str, ...]
    room_types: tuple[str, ...]
    holders: tuple[str, ...]

    @classmethod
    def of(cls, data: Dataset) -> Layout:
        """The layout for a data set: its vocabularies, and which of its models hold things."""
        words = data.info.vocabularies
        categories = sorted(data.catalog.categories, key=lambda one: one.name)
        holding = {i.category for i in data.infos.values() if i.supports or i.containers}
        return cls(
            categories=tuple(one.name for one in categories),
            superclasses=tuple(one.superclass for one in categories),
            properties=words.properties,
            states=words.states,
            relations=words.relations,
            tags=words.tags,
            room_types=words.room_types,
            holders=tuple(sorted(holding | set(STRUCTURES))),
        )

    @classmethod
    def from_words(cls, words: Mapping[str, tuple[str, ...]]) -> Layout:
        """The layout that a model was trained with. ValueError where words are missing, or one is
        there twice."""
        names = cls.__dataclass_fields__
        missing = [name for name in names if name not in words]
        if missing:
            raise ValueError(f"no words for {', '.join(missing)}")
        for name in names:
            if name != "superclasses" and len(set(words[name])) != len(words[name]):
                raise ValueError(f"{name}: a word appears twice")
        if len(words["superclasses"]) != len(words["categories"]):
            raise ValueError("superclasses and categories differ in number")
        return cls(**{name: words[name] for name in names})

    def words(self) -> dict[str, tuple[str, ...]]:
        """Its words, as ``from_words`` takes them."""
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        """The superclasses, each once, sorted."""
        return tuple(sorted(set(self.superclasses)))

    @cached_property
    def blocks(self) -> Mapping[str, tuple[str, ...]]:
        """The names of the columns of each block, in order."""
        return {
            "kind": self.kinds,
            "state": self.states,
            "room": self.room_types,
            "property": self.properties,
            "tag": self.tags,
            "shape": SHAPE,
            "held": HELD,
            "on": self.holders,
            "inside": self.holders,
            "on_state": self.states,
            "inside_state": self.states,
            "from": self.relations,
            "to": self.relations,
            "around": AROUND,
            "count": COUNTS,
        }

    @cached_property
    def columns(self) -> Mapping[tuple[str, str], int]:
        """(block, name) -> column."""
        names = [(block, name) for block, names in self.blocks.items() for name in names]
        return {name: k for k, name in enumerate(names)}

    def columns_of(self, blocks: Iterable[str]) -> list[int]:
        """The columns of these blocks."""
        wanted = set(blocks)
        return [k for (block, _), k in self.columns.items() if block in wanted]

    @cached_property
    def category_number(self) -> Mapping[str, int]:
        """Category -> its place; what is none of them is ``len(categories)``."""
        return {name: k for k, name in enumerate(self.categories)}

    @cached_property
    def kind_number(self) -> Mapping[str, int]:
        """Superclass -> its place; what is none of them is ``len(kinds)``."""
        return {name: k for k, name in enumerate(self.kinds)}
