"""Write the reference of a data set's files, key by key, from their schemas: ``make docs``."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from typing import Any

from sdgen.dataset.schema import FILES, schema_of
from sdgen.scene import FORMAT_VERSION

HEAD = f"""# Files, key by key

Written by `make docs` from the JSON Schemas in [`output/schema/`](../output/schema/), format
{FORMAT_VERSION}. [data-format.md](data-format.md) says what one has to know to use them,
[`output/README.md`](../output/README.md) what the values mean.
"""


def plain(text: str) -> str:
    """A docstring as markdown on one line: one backtick, no roles."""
    text = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", text)
    return " ".join(text.replace("``", "`").split())


def limits(node: dict[str, Any]) -> str:
    """``0 to 1``, ``at least 0``: what a number or a text is held to."""
    low = node.get("minimum", node.get("exclusiveMinimum"))
    high = node.get("maximum", node.get("exclusiveMaximum"))
    above = "more than" if "exclusiveMinimum" in node else "at least"
    below = "less than" if "exclusiveMaximum" in node else "at most"
    if high is not None and high >= 2**53:
        high = None
    if low is not None and high is not None:
        # What merely keeps numbers sane says nothing.
        return "" if low == -high else f", {low:g} to {high:g}"
    if low is not None:
        return f", {above} {low:g}"
    return f", {below} {high:g}" if high is not None else ""


def kind(node: dict[str, Any]) -> str:
    """What a value is, in words; a record by its name."""
    if "$ref" in node:
        name = node["$ref"].rsplit("/", 1)[-1]
        return f"`{name}`"
    if "const" in node:
        return f"`{node['const']}`"
    if "enum" in node:
        return ", ".join(f"`{one}`" for one in node["enum"])
    for key in ("anyOf", "oneOf"):
        if key in node:
            return " or ".join(dict.fromkeys(kind(one) for one in node[key]))
    if "allOf" in node:
        return kind(node["allOf"][0])
    words = node.get("type")
    if words == "array":
        return listed(node)
    if words == "object":
        inner = node.get("additionalProperties")
        return f"mapping to {kind(inner)}" if isinstance(inner, dict) else "mapping"
    names = {
        "string": "text",
        "boolean": "true or false",
        "null": "null",
        "integer": "whole number",
    }
    return names.get(str(words), str(words or "anything")) + limits(node)


def listed(node: dict[str, Any]) -> str:
    """A list, or so many of something."""
    first = node.get("prefixItems")
    if first:
        kinds = [kind(one) for one in first]
        same = len(set(kinds)) == 1 and len(kinds) > 1
        return f"{len(kinds)} × {kinds[0]}" if same else f"[{', '.join(kinds)}]"
    return f"list of {kind(node['items'])}" if node.get("items") else "list"


def linked(words: str, file: str, records: Iterable[str]) -> str:
    """The words with every record's name a link to its section."""
    for name in records:
        there = re.sub(r"[^a-z0-9 -]", "", f"{name}: {file}".lower()).replace(" ", "-")
        words = words.replace(f"`{name}`", f"[`{name}`](#{there})")
    return words


def table(node: dict[str, Any], file: str, records: Iterable[str]) -> Iterator[str]:
    """The keys of a record, a row each."""
    if not node.get("properties"):
        if "enum" in node:
            yield f"\nOne of {kind(node)}."
        return
    required = set(node.get("required", ()))
    yield "\n| key | value |\n|---|---|"
    for key, value in node["properties"].items():
        words = linked(kind(value), file, records)
        meaning = plain(value.get("description", ""))
        left = "" if key in required else " (may be left out)"
        yield f"| `{key}` | {words}{left}{': ' + meaning if meaning else ''} |"


def section(name: str) -> Iterator[str]:
    """One file: its own record, then those in it."""
    _, file = FILES[name]
    schema = schema_of(name)
    yield f"\n## {file}\n\n{plain(schema.get('description', ''))}"
    records = schema.get("$defs", {})
    yield from table(schema, file, records)
    for inner, node in sorted(records.items()):
        yield f"\n### {inner}: {file}\n\n{plain(node.get('description', ''))}".rstrip()
        yield from table(node, file, records)


def reference() -> str:
    """The whole page."""
    lines = [HEAD.rstrip()]
    for name in FILES:
        lines += section(name)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip() + "\n"


if __name__ == "__main__":
    sys.stdout.write(reference())
