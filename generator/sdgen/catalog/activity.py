"""What people leave behind of something they do: one entry of ``activities/``."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from sdgen.catalog.words import (
    PAIR,
    Categories,
    OptionalCategories,
    RoomNames,
    State,
    Text,
    Word,
    between,
    names_of,
    numbers,
    span,
)
from sdgen.geometry import Vec2
from sdgen.scene import Record
from sdgen.strict import Expect, problem, refuse

Side = Literal["left", "right", "ahead", "before"]
Where = Literal["seat", "front", "middle", "back", "anywhere", "floor"]


class Member(Record):
    """One thing of an activity (or, by ``count``, several): one of the categories of ``thing``.

    Places are as somebody sees them who sits or stands there: metres ``ahead`` of the point the
    activity is at and to its ``left``. ``beside`` names a member that is there already: ``gap_m``
    from it, on a ``side`` of it, and ``at`` moves it from there; ``on`` or ``inside`` one: there,
    ``pile`` squarely on it. With none of these and no ``at`` it lies anywhere on the furniture.
    ``turn_deg`` turns its front, which looks at the person, to their right (anticlockwise from
    above). ``state`` brings it into a state.

    Where it finds no room it is left out; one that is ``needed`` takes the whole activity with it.
    """

    thing: Categories
    name: Word | None = None
    at: Annotated[Vec2, numbers(2, -3.0, 3.0), Expect("[ahead, left]")] | None = None
    beside: Word | None = None
    side: Side = "right"
    gap_m: Annotated[float, between(0.005, 1.0)] = 0.015
    on: Word | None = None
    inside: Word | None = None
    pile: bool = False
    count: Annotated[tuple[int, int], span(1, 12, whole=True), PAIR] = (1, 1)
    chance: Annotated[float, between(0.0, 1.0)] = 1.0
    turn_deg: Annotated[float, between(-360.0, 360.0)] = 0.0
    state: State | None = None
    needed: bool = False

    @property
    def called(self) -> str:
        """What other members call it."""
        return self.name or self.thing[0]

    @model_validator(mode="after")
    def _in_one_place(self) -> Member:
        given = [key for key in ("beside", "on", "inside") if getattr(self, key)]
        if len(given) > 1:
            refuse(problem((given[1],), f"does not go with {given[0]!r}: it has one place"))
        if self.pile and not self.on:
            refuse(problem((), "a pile needs 'on': what does it lie on?"))
        return self


class Activity(Record):
    """Things that stand together, since somebody does (or did) something with them.

    ``at`` furniture of these categories, in rooms of these types (none: in all). ``where`` on it:
    at each ``seat`` that faces it (up to ``places`` of them), at its ``front`` or ``back`` edge, in
    its ``middle`` or ``anywhere``; or on the ``floor``, put aside at a wall. ``near`` a piece of
    these categories: no more than a step away, on the floor as near as there is room.

    ``chance``: how often it is on each such piece (or floor); not on one with what it ``excludes``,
    nor more often than ``in_home`` times. ``tidiness``: only in homes so tidy (0 to 1).
    """

    name: str
    title: str = ""
    rooms: tuple[str, ...] = ()
    at: tuple[str, ...] = ()
    where: Where = "anywhere"
    near: tuple[str, ...] = ()
    chance: float = 1.0
    places: tuple[int, int] = (1, 1)
    excludes: tuple[str, ...] = ()
    in_home: int | None = None
    tidiness: Vec2 = (0.0, 1.0)
    members: tuple[Member, ...]


class ActivityYaml(Record):
    """One entry of a file of ``activities/``."""

    title: Text = ""
    rooms: RoomNames = ()
    at: OptionalCategories = ()
    where: Where = "anywhere"
    near: OptionalCategories = ()
    chance: Annotated[float, between(0.0, 1.0)] = 1.0
    places: Annotated[tuple[int, int], span(1, 20, whole=True), PAIR] = (1, 1)
    excludes: Annotated[tuple[str, ...], names_of("activity", least=0)] = ()
    in_home: Annotated[int | None, between(1, 100)] = None
    tidiness: Annotated[tuple[float, float], span(0.0, 1.0), PAIR] = (0.0, 1.0)
    members: Annotated[tuple[Member, ...], Field(min_length=1), Expect("at least one item")]
    replaces: bool = False

    @model_validator(mode="after")
    def _each_by_one_before_it(self) -> ActivityYaml:
        found = []
        if (self.where == "floor") == bool(self.at):
            text = (
                "'where: floor' has no 'at'" if self.at else "missing key 'at': on which furniture?"
            )
            found.append(problem(("at",) if self.at else (), text))
        named: set[str] = set()
        for index, member in enumerate(self.members):
            for key in ("beside", "on", "inside"):
                word = getattr(member, key)
                if word and word not in named:
                    text = f"no member before it is called {word!r}"
                    found.append(problem(("members", index, key), text))
            named.add(member.called)
        if found:
            refuse(*found)
        return self

    def record(self, name: str) -> Activity:
        """The record of it."""
        same = Activity.model_fields.keys() - {"name"}
        return Activity(name=name, **{key: getattr(self, key) for key in same})
