"""Reads ``manifest.yaml``: strict, with every problem located."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TypeVar

from pydantic import ValidationError
from shapely.geometry import Polygon

from sdgen.errors import AssetError, InputError, did_you_mean
from sdgen.library.records import Asset, Surface
from sdgen.scene import Record
from sdgen.yaml_source import Path_, Source, read_yaml

R = TypeVar("R", bound=Record)

#: Room for a few ten thousand models.
MAX_BYTES = 50_000_000
MAX_VALUES = 5_000_000
_KEYS = ("assets", "surfaces", "licence")


def read_manifest(folder: Path) -> tuple[list[Asset], list[Surface]]:
    """Records of ``folder/manifest.yaml``; every file they name is there.

    Raises AssetError with all problems, each ``file:line: model: key path: problem``.
    """
    try:
        source = read_yaml(folder / "manifest.yaml", None, MAX_BYTES, MAX_VALUES)
    except InputError as error:
        raise AssetError(error.problems) from None
    data = source.value
    if isinstance(data, dict):
        for key in data:
            if key not in _KEYS:
                source.problem((key,), f"unknown key{did_you_mean(key, _KEYS)}")
    elif not source.found:
        source.problem((), "expected a mapping with the key 'assets'")
    assets = _records(source, "assets", Asset)
    surfaces = _records(source, "surfaces", Surface)
    for asset, path in assets:
        for text in _inconsistencies(asset):
            _note(source, path, asset.id, text)
        textures = [part.texture for part in asset.parts if part.texture]
        _check_files(source, path, asset.id, folder, [asset.mesh, asset.hulls, asset.texture])
        _check_files(source, path, asset.id, folder, textures)
    for surface, path in surfaces:
        _check_files(source, path, surface.id, folder, [surface.texture])
    if source.found:
        raise AssetError(source.problems)
    return [asset for asset, _ in assets], [surface for surface, _ in surfaces]


def _records(source: Source, key: str, model: type[R]) -> list[tuple[R, Path_]]:
    """The good entries of one list with where they stand; the bad ones are noted."""
    entries = source.value.get(key) if isinstance(source.value, dict) else None
    if entries is None:
        return []
    if not isinstance(entries, list):
        source.problem((key,), f"expected a list, found {type(entries).__name__}")
        return []
    out: list[tuple[R, Path_]] = []
    seen: set[str] = set()
    for index, entry in enumerate(entries):
        path: Path_ = (key, index)
        name = str(entry.get("id", index)) if isinstance(entry, dict) else str(index)
        if name in seen:
            _note(source, path, name, "id: appears twice")
        seen.add(name)
        try:
            # Strict, in JSON mode: a list may become a tuple, but "1" stays no number.
            out.append((model.model_validate_json(json.dumps(entry), strict=True), path))
        except ValidationError as error:
            for item in error.errors(include_url=False):
                text = item["msg"]
                if item["type"] == "extra_forbidden":
                    hint = did_you_mean(str(item["loc"][-1]), list(model.model_fields))
                    text = f"unknown key{hint if len(item['loc']) == 1 else ''}"
                where = ".".join(str(step) for step in item["loc"])
                place = (*path, *item["loc"])
                _note(source, place, name, f"{where}: {text}" if where else text)
    return out


def _note(source: Source, path: Path_, name: str, text: str) -> None:
    source.problem((), f"{name}: {text}", line=source.line(path))


def _check_files(source: Source, path: Path_, name: str, folder: Path, files: list[str]) -> None:
    for file in files:
        if file.startswith(("/", "\\")) or ".." in Path(file).parts or ":" in file:
            _note(source, path, name, f"{file}: leaves the asset folder")
        elif not (folder / file).is_file():
            _note(source, path, name, f"{file}: no such file")


def _inconsistencies(asset: Asset) -> list[str]:
    """What a schema cannot see: names that point nowhere, numbers that make no sense."""
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
        if math.hypot(*joint.axis) < 1e-6:
            out.append(f"joints.{joint.name}: axis has no direction")
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
        if len(support.polygon_m) < 3 or not Polygon(support.polygon_m).is_valid:
            out.append(f"supports.{support.name}: polygon_m is no simple polygon")
        if support.container is not None and support.container not in containers:
            out.append(f"supports.{support.name}: no container {support.container!r}")
    for container in asset.containers:
        if container.part not in parts:
            out.append(f"containers.{container.name}: no part {container.part!r}")
        if container.closed_by is not None and container.closed_by not in joints:
            out.append(f"containers.{container.name}: no joint {container.closed_by!r}")
    if not all(0 < size < 10 for size in asset.extents_m):
        out.append(f"extents_m: {asset.extents_m} is not a size in metres")
    return out
