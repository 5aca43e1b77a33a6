"""JSON of strangers against records: what is wrong with it, located, all at once."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sdgen.errors import SHOWN, InputError
from sdgen.files import read_plain
from sdgen.strict import explain, no_mapping
from sdgen.yaml_source import show_path

#: A home's graph takes a megabyte, its scene's file fifty kilobytes.
MAX_BYTES = 100_000_000

M = TypeVar("M", bound=BaseModel)
Number = Annotated[float, Field(allow_inf_nan=False, ge=-1e6, le=1e6)]
Three = Annotated[list[Number], Field(min_length=3, max_length=3)]
Four = Annotated[list[Number], Field(min_length=4, max_length=4)]


class Loose(BaseModel):
    """A record of which only what is named is read."""

    model_config = ConfigDict(extra="ignore", strict=True, frozen=True)


def read_json(path: Path, model: type[M], shown: str | None = None) -> M:
    """A file as a record. Raises InputError with all that is wrong, each located."""
    shown = shown or str(path)
    raw = read_plain(path, shown, MAX_BYTES)
    try:
        value: Any = json.loads(raw)
    except (ValueError, RecursionError) as error:
        where = f":{error.lineno}" if isinstance(error, json.JSONDecodeError) else ""
        raise InputError([f"{shown}{where}: is no JSON that can be read"]) from None
    if not isinstance(value, dict):
        raise InputError([f"{shown}: {no_mapping(value)}"])
    try:
        return model.model_validate(value)
    except ValidationError as error:
        raise InputError(in_words(error, model, value, shown)) from None


def in_words(error: ValidationError, model: type[BaseModel], value: Any, shown: str) -> list[str]:
    """What is wrong with a value of the file ``shown``, a line each; at most ``SHOWN``."""
    told = [(at, text) for at, text in explain(error, model, value)]
    # Lists of numbers that are too long or short: our catalogues have none.
    said = {at for at, _ in told}
    told += [(one["loc"], one["msg"]) for one in error.errors() if tuple(one["loc"]) not in said]
    return [f"{shown}: {show_path(at)}: {text}" for at, text in told[:SHOWN]]
