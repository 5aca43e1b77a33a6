"""``manifest.yaml`` of an asset folder, written: one flow line for each thing inside a record."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from sdgen.errors import AssetError
from sdgen.library.manifest import MAX_BYTES, MAX_VALUES, manifest_bytes
from sdgen.library.records import Asset
from sdgen.yaml_source import parse_yaml

#: Keys of a record in the order that ``assets/README.md`` tells them.
_ORDER = (
    *("id", "category", "suite", "tags", "title", "licence", "source", "attribution"),
    *(
        "extents_m",
        "mass_kg",
        "friction",
        "mesh",
        "hulls",
        "texture",
        "parts",
        "joints",
        "variants",
        "states",
    ),
    *("supports", "containers", "resting"),
)
_LISTS = ("parts", "joints", "states", "supports", "containers", "resting")
_BASE: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
#: What we read as a number although YAML 1.1 does not: ``1e3``.
_NUMBER_LIKE = re.compile(r"[-+]?[.0-9][-+.0-9eE]*")


class _Dumper(_BASE):  # type: ignore[misc]
    """Writes text so that our reader takes it for text again."""


def _text_node(dumper: Any, value: str) -> Any:
    style = '"' if _NUMBER_LIKE.fullmatch(value) else None
    return dumper.represent_scalar("tag:yaml.org,2002:str", value, style=style)


_Dumper.add_representer(str, _text_node)


def entry_of(asset: Asset) -> dict[str, Any]:
    """A record as the manifest has it: plain values, without those that may be left out."""
    plain = asset.model_dump(mode="json", exclude_defaults=True)
    return {key: plain[key] for key in (*_ORDER, *plain) if key in plain}


def with_entry(raw: bytes | None, name: str, asset: Asset) -> bytes:
    """The manifest with a record, in the place of the one of the same id or after all others.

    ``raw`` are the bytes there are, None for a new one; ``name`` is what problems call them.
    Comments are lost, all but those at the top. Raises AssetError for what is no manifest.
    """
    data: dict[str, Any] = {}
    head: list[str] = []
    if raw is not None:
        source = parse_yaml(raw, name, MAX_BYTES, MAX_VALUES)
        if source.noted or not isinstance(source.value, dict):
            raise AssetError(source.problems or [f"{name}: is no manifest"])
        data = source.value
        for line in raw.decode("utf-8-sig").splitlines():
            if not line.startswith("#"):
                break
            head.append(line)
    entries = list(data.get("assets") or ())
    places = [k for k, entry in enumerate(entries) if entry.get("id") == asset.id]
    if places:
        entries[places[0]] = entry_of(asset)
    else:
        entries.append(entry_of(asset))
    return _text(head, {**data, "assets": entries}).encode()


def manifest_of(head: str, assets: Sequence[Asset], rest: Mapping[str, Any]) -> bytes:
    """A manifest of these models under a comment; ``rest`` are its other keys (surfaces)."""
    entries = [entry_of(asset) for asset in assets]
    return _text([head], {"assets": entries, **rest}).encode()


def folder_manifest(folder: Path) -> bytes | None:
    """The bytes of a folder's manifest; None when it has none yet."""
    return manifest_bytes(folder) if (folder / "manifest.yaml").exists() else None


def _text(head: Sequence[str], data: Mapping[str, Any]) -> str:
    lines = list(head)
    for key, value in data.items():
        if key == "assets" and value:
            lines.append("assets:")
            for entry in value:
                lines += _entry_lines(entry)
        elif isinstance(value, list) and value:
            lines += [f"{key}:", *(f"- {_flow(item)}" for item in value)]
        else:
            lines.append(f"{key}: {_flow(value)}")
    return "\n".join(lines) + "\n"


def _entry_lines(entry: Mapping[str, Any]) -> list[str]:
    lines = []
    for key, value in entry.items():
        if key in _LISTS and value:
            lines += [f"{key}:", *(f"  - {_flow(item)}" for item in value)]
        elif key == "variants":
            lines += [f"{key}:", *(f"  {_flow(name)}: {_flow(v)}" for name, v in value.items())]
        else:
            lines.append(f"{key}: {_flow(value)}")
    return [f"{'- ' if k == 0 else '  '}{line}" for k, line in enumerate(lines)]


def _flow(value: Any) -> str:
    text: str = yaml.dump(
        value,
        Dumper=_Dumper,
        default_flow_style=True,
        width=10**9,
        sort_keys=False,
        allow_unicode=True,
    )
    return text.strip().removesuffix("...").strip()
