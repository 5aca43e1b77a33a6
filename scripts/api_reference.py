"""Write the reference of the public Python names from their docstrings: ``make docs``."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from typing import Any

from pydantic import BaseModel

HEAD = """# Python, name by name

Written by `make docs` from the code itself; [python.md](python.md) shows how it is used. What
stands here is public: it changes only with a line in the [changelog](../CHANGELOG.md). All of it is
typed (`py.typed`). The records of files (`Scene`, `Anomalies`, `Camera`, ...) are in
[files.md](files.md).
"""
#: What is public: a heading, and names by the module to import them from.
SECTIONS: dict[str, dict[str, tuple[str, ...]]] = {
    "Reading a data set": {
        "sdgen": ("Dataset", "Perception"),
        "sdgen.dataset": ("SceneItem", "Frames", "Table"),
        "sdgen.perception": ("Perceived",),
    },
    "Building": {
        "sdgen": ("build", "make_scene", "BuildOptions", "load_catalog", "load_library"),
        "sdgen.scene": ("SceneBundle",),
        "sdgen.engines.report": ("BuildReport",),
    },
    "Checking, showing, passing on": {
        "sdgen.validate": ("validate", "rebuild", "Problem"),
        "sdgen.gallery": ("write_gallery", "serve"),
        "sdgen.export": ("export",),
    },
    "Scoring": {
        "sdgen": ("evaluate",),
        "sdgen.benchmark": (
            "Evaluation",
            "Score",
            "Report",
            "detect",
            "read_predictions",
            "write_predictions",
        ),
    },
    "Errors": {
        "sdgen.errors": ("SdgenError", "InputError", "UsageError", "SceneRejected", "Stopped"),
    },
}


def plain(text: str | None) -> str:
    """A docstring as markdown: one backtick, no roles."""
    text = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", inspect.cleandoc(text or ""))
    return text.replace("``", "`")


def signature(thing: Any, name: str, skip_self: bool = False) -> str:
    """``name(a: int) -> None``; a function's on several lines where one is too long."""
    told = inspect.signature(thing)
    parameters = list(told.parameters.values())[1 if skip_self else 0 :]
    words = [_parameter(one) for one in parameters]
    back = told.return_annotation
    end = "" if back is inspect.Signature.empty or inspect.isclass(thing) else f" -> {_type(back)}"
    line = f"{name}({', '.join(words)}){end}"
    if skip_self or len(line) <= 96:
        return line
    return f"{name}(\n" + "".join(f"    {one},\n" for one in words) + f"){end}"


def _parameter(one: inspect.Parameter) -> str:
    name = {"VAR_POSITIONAL": "*", "VAR_KEYWORD": "**"}.get(one.kind.name, "") + one.name
    if one.annotation is not inspect.Parameter.empty:
        name += f": {_type(one.annotation)}"
    if one.default is inspect.Parameter.empty:
        return name
    default = getattr(one.default, "__name__", None) or repr(one.default)
    return f"{name} = {default}"


def _type(annotation: Any) -> str:
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    return re.sub(r"\b(?:\w+\.)+(?=[A-Z])", "", text)


def members(cls: type) -> Iterator[tuple[str, str]]:
    """What a class offers: name or call, and what its docstring says first."""
    for name, value in vars(cls).items():
        if name.startswith("_"):
            continue
        if isinstance(value, property | cached_property):
            getter = value.fget if isinstance(value, property) else value.func
            back = inspect.signature(getter).return_annotation if getter else ""
            yield f"{name}: {_type(back)}", plain(value.__doc__)
        elif inspect.isfunction(value):
            yield signature(value, name, skip_self=True), plain(value.__doc__)


def fields(cls: type[BaseModel]) -> Iterator[tuple[str, str]]:
    """The fields of a record, with their defaults."""
    for name, field in cls.model_fields.items():
        default = (
            "" if field.is_required() else f" = {field.get_default(call_default_factory=True)!r}"
        )
        yield f"{name}: {_type(field.annotation)}{default}", plain(field.description)


def entry(module: str, name: str) -> Iterator[str]:
    """A name: how it is called, what it does, what it has."""
    thing = getattr(import_module(module), name)
    yield f"### {module}.{name}\n"
    record = inspect.isclass(thing) and issubclass(thing, BaseModel)
    if not record and not (inspect.isclass(thing) and issubclass(thing, BaseException)):
        yield f"```python\n{signature(thing, name)}\n```\n"
    yield plain(thing.__doc__) + "\n"
    if not inspect.isclass(thing):
        return
    rows = [*(fields(thing) if record else ()), *members(thing)]
    for call, words in rows:
        first = " ".join(words.split())
        yield f"- `{call}`{': ' + first if first else ''}"
    if rows:
        yield ""


def reference() -> str:
    """The whole page."""
    lines = [HEAD]
    for heading, modules in SECTIONS.items():
        lines.append(f"## {heading}\n")
        for module, names in modules.items():
            for name in names:
                lines += entry(module, name)
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    sys.stdout.write(reference())
