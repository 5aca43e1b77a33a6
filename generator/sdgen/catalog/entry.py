"""One named entry of a catalogue's YAML: what was written, and where it stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

from pydantic import BaseModel

from sdgen import strict
from sdgen.yaml_source import Path_, Source

M = TypeVar("M", bound=BaseModel)


def as_record(written: BaseModel, model: type[M], **changes: Any) -> M:
    """A record with the fields that what was written has under the same name, and ``changes``."""
    same = type(written).model_fields.keys() & model.model_fields.keys() - changes.keys()
    return model(**{name: getattr(written, name) for name in same}, **changes)


@dataclass(frozen=True)
class Entry:
    """A value below ``path`` of a file, and the ``pack`` (folder) the file belongs to."""

    name: str
    source: Source
    path: Path_
    value: Any
    pack: str = ""

    def problem(self, message: str, *steps: str | int) -> None:
        """Note a problem at a path below the entry."""
        self.source.problem((*self.path, *steps), message)

    def read(self, model: type[M], names: Any = None) -> M | None:
        """The entry as a record; None when problems were noted."""
        return strict.read(self.source, self.path, self.value, model, names)

    def key(self, name: str) -> Any:
        """The value of a key; None when it has none."""
        return self.value.get(name) if isinstance(self.value, dict) else None
