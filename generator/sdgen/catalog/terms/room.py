"""``room: kitchen``: the type of the room the object is in.

Undecided where the room is (in the middle of a doorway) and the answer depends on it.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from sdgen.catalog.predicate import FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import EITHER, NEVER, Can, Case, Scope, Term, either


class RoomTerm(Term):
    """The object is in a room of one of these types."""

    kind: Literal["room"] = "room"
    any_of: tuple[str, ...]

    cheap: ClassVar[bool] = True

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> RoomTerm | None:
        if not reader.has("room"):
            return None
        return cls(any_of=reader.words("room", choices=scope.rooms, what="room type"))

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        types = facts.room_types(object_id)
        among = [name in self.any_of for name in types]
        return Verdict(bool(among) and among[0], all(among) or not any(among))

    def in_words(self) -> str:
        return f"it is in a {either(self.any_of)}"

    def possible(self, case: Case) -> Can:
        return NEVER if case.rooms and not set(case.rooms) & set(self.any_of) else EITHER
