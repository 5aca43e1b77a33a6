"""Plain values (of YAML or JSON) checked against records, strictly, in words for people.

One place turns what pydantic found into ``key path: problem (did you mean ...)``. Strict means:
no unknown key, a number is no text, a flag no number; only a list may become a tuple. An empty
key (``key:``) counts as absent where the key may be.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NoReturn, TypeVar, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, InitErrorDetails, PydanticCustomError

from sdgen.errors import SHOWN, did_you_mean, nearest
from sdgen.yaml_source import Path_, Source

M = TypeVar("M", bound=BaseModel)
_WANTS = {float: "a number", int: "a whole number", bool: "true or false", str: "text"}
_TYPE_ERRORS = {
    "float_type": "a number",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "bool_type": "true or false",
    "string_type": "text",
    "tuple_type": "a list",
    "list_type": "a list",
    "dict_type": "a mapping (key: value)",
    "model_type": "a mapping (key: value)",
}


@dataclass(frozen=True)
class Expect:
    """Said of a field in ``Annotated``: what a person should write there."""

    text: str


def shown(value: Any) -> str:
    """What a plain value is, for a message: ``a list``, ``text 'abc'``, ``the number 3``."""
    if isinstance(value, str):
        return f"text {value[:40]!r}"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int) and abs(value) > 1e300:
        return "a number of more than 300 digits"
    if isinstance(value, int | float):
        return f"the number {value:g}"
    kinds = {dict: "a mapping", list: "a list", tuple: "a list", type(None): "nothing"}
    return kinds.get(type(value), type(value).__name__)


def unknown_key(key: str, known: Sequence[str]) -> str:
    """What to say of a key that nobody knows."""
    near = did_you_mean(key, known) or f" (known keys: {', '.join(known)})"
    return f"unknown key{near}"


def missing_key(key: str, wanted: str) -> str:
    """What to say of a key that is not there."""
    return f"missing key {key!r}: expected {wanted}"


def empty_key(wanted: str) -> str:
    """What to say of a key with nothing after its colon."""
    return f"is empty: expected {wanted}"


def no_mapping(value: Any) -> str:
    """What to say of a value that should be a mapping."""
    return f"expected {_TYPE_ERRORS['model_type']}, got {shown(value)}"


def problem(path: Path_, text: str) -> InitErrorDetails:
    """For validators: something wrong at a path below the value under test."""
    error = PydanticCustomError("problem", "{text}", {"text": text})
    return InitErrorDetails(type=error, loc=path, input=None)


def unknown(path: Path_, what: str, word: str, choices: Sequence[str]) -> InitErrorDetails:
    """For validators: a word that is none of ``choices``; what is near is looked up when told."""
    context = {"text": f"unknown {what} {word[:80]!r}", "word": word, "choices": choices}
    error = PydanticCustomError("unknown", "{text}", context)
    return InitErrorDetails(type=error, loc=path, input=None)


def refuse(*problems: InitErrorDetails) -> NoReturn:
    """For validators: raise these."""
    raise ValidationError.from_exception_data("", list(problems))


def read(source: Source, path: Path_, value: Any, model: type[M], names: Any = None) -> M | None:
    """``value``, found at ``path``, as a record; None when problems were noted in ``source``.

    ``names`` is the context of the validators: what names may be used.
    """
    try:
        return _record(model, value, names)
    except ValidationError:
        value_there = _present([model], value)  # dear, and seldom needed
    try:
        return _record(model, value_there, names)
    except ValidationError as error:
        for below, text in explain(error, model, value):
            source.problem((*path, *below), text)
        source.more += max(0, error.error_count() - SHOWN)
    return None


def _record(model: type[M], value: Any, names: Any) -> M:
    # Strict, in JSON mode: a list may become a tuple, but "1" stays no number.
    return model.model_validate_json(json.dumps(value), strict=True, context=names)


def explain(
    error: ValidationError, model: type[BaseModel], value: Any
) -> Iterator[tuple[Path_, str]]:
    """Problems of ``value`` with their key paths, the first ``SHOWN`` of them."""
    for item in error.errors(include_url=False)[:SHOWN]:
        # A list is also called too short after its items, told already, were found bad.
        if item["type"] != "too_short" or not item["input"]:
            yield _explain(item, model, value)


def _explain(item: ErrorDetails, model: type[BaseModel], value: Any) -> tuple[Path_, str]:
    kind, loc, got = item["type"], item["loc"], item["input"]
    path = _existing(loc, value)
    context: Mapping[str, Any] = item.get("ctx", {})
    if kind == "missing" and isinstance(loc[-1], str):
        return path, missing_key(loc[-1], _wanted(_field(model, loc)))
    if kind == "missing" or kind == "too_long" or kind == "too_short":
        wanted = _wanted(_field(model, loc[:-1] if kind == "missing" else loc))
        return path, f"expected {wanted}, got {len(got)} items"
    if kind == "extra_forbidden":
        known = [name for owner in _owners(model, loc) for name in owner.model_fields]
        return path, unknown_key(str(loc[-1]), known)
    if kind == "literal_error":
        choices = re.findall(r"'([^']*)'", context["expected"])
        if not isinstance(got, str):
            return path, f"expected one of {', '.join(choices)}, got {shown(got)}"
        # All choices are told: only a near one is worth another word.
        hint = did_you_mean(got, choices) if nearest(got, choices) else ""
        return path, f"{got[:40]!r} is not one of {', '.join(choices)}{hint}"
    if kind in _TYPE_ERRORS:
        wanted = _expected(_field(model, loc)) or _TYPE_ERRORS[kind]
        if got is None and loc and isinstance(loc[-1], str):
            return path, empty_key(wanted)
        return path, f"expected {wanted}, got {shown(got)}"
    if kind == "unknown":
        return path, f"{context['text']}{did_you_mean(context['word'], context['choices'])}"
    if kind == "problem":
        return path, str(context["text"])
    text = item["msg"]
    return path, f"{text[:1].lower()}{text[1:]} (got {shown(got)})"


def _existing(loc: Sequence[str | int], value: Any) -> Path_:
    """The steps of ``loc`` that lead to something: no tags of unions, no missing keys."""
    path: list[str | int] = []
    for step in loc:
        try:
            value = value[step]
        except (KeyError, IndexError, TypeError):
            continue
        path.append(step)
    return tuple(path)


def records_in(annotation: Any) -> list[type[BaseModel]]:
    """All records an annotation speaks of."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in records_in(part)]


def _owners(model: type[BaseModel], loc: Sequence[str | int]) -> list[type[BaseModel]]:
    """The records that the last step of ``loc`` belongs to (several in a union)."""
    owners = [model]
    for step in loc[:-1]:
        below = [
            found
            for owner in owners
            if step in owner.model_fields
            for found in records_in(owner.model_fields[str(step)].annotation)
        ]
        owners = below or owners  # an index of a list, a key of a mapping or a tag of a union
    return owners


def _field(model: type[BaseModel], loc: Sequence[str | int]) -> FieldInfo:
    """The field that the last step of ``loc`` names (one that says nothing when there is none)."""
    for owner in _owners(model, loc):
        if loc and loc[-1] in owner.model_fields:
            return owner.model_fields[str(loc[-1])]
    return FieldInfo()


def _expected(field: FieldInfo) -> str:
    """What its ``Expect`` says, also within ``... | None``; empty without one."""
    metadata = list(field.metadata)
    for part in get_args(field.annotation):
        metadata += getattr(part, "__metadata__", ())
    return next((item.text for item in metadata if isinstance(item, Expect)), "")


def _wanted(field: FieldInfo) -> str:
    annotation = field.annotation
    if expected := _expected(field):
        return expected
    if get_origin(annotation) is Literal:
        return f"one of {', '.join(map(str, get_args(annotation)))}"
    if get_origin(annotation) is tuple:
        return "a list"
    return _WANTS.get(annotation, "a value") if isinstance(annotation, type) else "a value"


def _present(models: Sequence[type[BaseModel]], value: Any) -> Any:
    """``value`` without the empty keys that may be left out."""
    if isinstance(value, list):
        return [_present(models, item) for item in value]
    if not isinstance(value, dict):
        return value
    fields = {name: field for model in models for name, field in model.model_fields.items()}
    return {
        key: _present(records_in(fields[key].annotation) if key in fields else models, item)
        for key, item in value.items()
        if item is not None or key not in fields or fields[key].is_required()
    }
