"""Reads ``manifest.yaml``: strict, with every problem located."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml
from pydantic import ValidationError

from sdgen.errors import AssetError
from sdgen.library.records import Asset, Surface


class _Loader(yaml.SafeLoader):
    """The safe loader in its C form where PyYAML has one; manifests are big."""


_BASE: type = getattr(yaml, "CSafeLoader", _Loader)


def _entries(path: Path, data: dict[str, Any], key: str) -> list[Any]:
    value = data.get(key) or []
    if not isinstance(value, list):
        raise AssetError([f"{path}: {key}: expected a list, found {type(value).__name__}"])
    return value


def _name(entry: Any, index: int) -> str:
    return str(entry.get("id", index)) if isinstance(entry, dict) else str(index)


def read_manifest(folder: Path) -> tuple[list[Asset], list[Surface]]:
    """Records of ``folder/manifest.yaml``.

    Raises AssetError naming the file, the asset and the key of every problem at once.
    """
    path = folder / "manifest.yaml"
    try:
        data = yaml.load(path.read_text(encoding="utf-8"), Loader=_BASE)  # noqa: S506 (safe loader)
    except (OSError, UnicodeDecodeError, yaml.YAMLError, RecursionError) as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise AssetError([f"{path}: cannot be read: {reason}"]) from None
    if not isinstance(data, dict):
        raise AssetError([f"{path}: expected a mapping with the key 'assets'"])
    problems: list[str] = []
    assets: list[Asset] = []
    surfaces: list[Surface] = []
    for unknown in sorted(set(map(str, data)) - {"assets", "surfaces", "licence"}):
        problems.append(f"{path}: {unknown}: unknown key")
    for index, entry in enumerate(_entries(path, data, "assets")):
        try:
            asset = Asset.model_validate(entry)
            problems += [f"{path}: {asset.id}: {text}" for text in _inconsistencies(asset)]
            assets.append(asset)
        except ValidationError as error:
            problems += _located(path, _name(entry, index), error)
    for index, entry in enumerate(_entries(path, data, "surfaces")):
        try:
            surfaces.append(Surface.model_validate(entry))
        except ValidationError as error:
            problems += _located(path, _name(entry, index), error)
    seen: set[str] = set()
    for asset in assets:
        if asset.id in seen:
            problems.append(f"{path}: {asset.id}: id appears twice")
        seen.add(asset.id)
    if problems:
        raise AssetError(problems)
    return assets, surfaces


def _located(path: Path, name: str, error: ValidationError) -> list[str]:
    return [
        f"{path}: {name}: {'.'.join(str(p) for p in item['loc'])}: {item['msg']}"
        for item in error.errors()
    ]


def _inconsistencies(asset: Asset) -> list[str]:
    """What pydantic cannot see: names that point nowhere, files that would leave the folder."""
    out: list[str] = []
    parts = {part.name for part in asset.parts}
    joints = {joint.name for joint in asset.joints}
    containers = {container.name for container in asset.containers}
    if len(parts) != len(asset.parts):
        out.append("parts: a name appears twice")
    if "default" not in asset.variants:
        out.append("variants: 'default' is missing")
    for variant, names in asset.variants.items():
        out += [f"variants.{variant}: no part {n!r}" for n in names if n not in parts]
        if not names:
            out.append(f"variants.{variant}: draws nothing")
    for part in asset.parts:
        if part.joint is not None and part.joint not in joints:
            out.append(f"parts.{part.name}: no joint {part.joint!r}")
    for joint in asset.joints:
        if joint.lower > joint.upper:
            out.append(f"joints.{joint.name}: lower > upper")
    for rule in asset.states:
        if rule.joint is not None and rule.joint not in joints:
            out.append(f"states.{rule.state}: no joint {rule.joint!r}")
        out += [
            f"states.{rule.state}: no variant {v!r}"
            for v in rule.variants
            if v not in asset.variants
        ]
        out += [f"states.{rule.state}: no part {p!r}" for p in rule.parts if p not in parts]
    for support in asset.supports:
        if support.part not in parts:
            out.append(f"supports.{support.name}: no part {support.part!r}")
        if len(support.polygon_m) < 3:
            out.append(f"supports.{support.name}: polygon needs three points or more")
        if support.container is not None and support.container not in containers:
            out.append(f"supports.{support.name}: no container {support.container!r}")
    for container in asset.containers:
        if container.part not in parts:
            out.append(f"containers.{container.name}: no part {container.part!r}")
        if container.closed_by is not None and container.closed_by not in joints:
            out.append(f"containers.{container.name}: no joint {container.closed_by!r}")
    if not all(0 < size < 10 for size in asset.extents_m):
        out.append(f"extents_m: {asset.extents_m} is not a size in metres")
    textures = [part.texture for part in asset.parts if part.texture]
    for file in (asset.mesh, asset.hulls, asset.texture, *textures):
        if file.startswith(("/", "\\")) or ".." in Path(file).parts:
            out.append(f"{file}: leaves the asset folder")
    return out
