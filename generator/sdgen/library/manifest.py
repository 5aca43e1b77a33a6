"""Reads ``manifest.yaml``: strict, with every problem located."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from sdgen.errors import AssetError
from sdgen.files import kind_of
from sdgen.library.plausible import inconsistencies
from sdgen.library.raw import file_bytes
from sdgen.library.records import Asset, Surface
from sdgen.scene import Record
from sdgen.strict import read, shown, unknown_key
from sdgen.yaml_source import Path_, Source, parse_yaml

R = TypeVar("R", bound=Record)

#: Room for a few ten thousand models.
MAX_BYTES = 50_000_000
MAX_VALUES = 5_000_000
_KEYS = ("assets", "surfaces", "licence")


@dataclass(frozen=True)
class Manifest:
    """A manifest's bytes and the records in it."""

    raw: bytes
    assets: tuple[Asset, ...]
    surfaces: tuple[Surface, ...]

    def files(self) -> Iterator[str]:
        """Every file that some record names."""
        for asset in self.assets:
            yield from _files_of(asset)
        for surface in self.surfaces:
            yield surface.texture


def manifest_bytes(folder: Path) -> bytes:
    """The manifest of a folder. Raises AssetError when there is none, or none that is a file."""
    return file_bytes(folder / "manifest.yaml", MAX_BYTES)


def read_manifest(folder: Path, raw: bytes) -> Manifest:
    """Records of ``folder/manifest.yaml``, whose bytes are given; every file they name is there.

    Raises AssetError with all problems, each ``file:line: model: key path: problem``.
    """
    source = parse_yaml(raw, str(folder / "manifest.yaml"), MAX_BYTES, MAX_VALUES)
    data = source.value
    if isinstance(data, dict):
        for key in data:
            if key not in _KEYS:
                source.problem((key,), unknown_key(key, _KEYS))
    elif not source.noted:
        source.problem((), "expected a mapping with the key 'assets'")
    assets = _records(source, "assets", Asset)
    surfaces = _records(source, "surfaces", Surface)
    for asset, path in assets:
        for below, text in inconsistencies(asset):
            source.problem((*path, *below), text)
        _check_files(source, path, folder, _files_of(asset))
    for surface, path in surfaces:
        _check_files(source, path, folder, [surface.texture])
    if source.noted:
        raise AssetError(source.problems)
    return Manifest(raw, tuple(a for a, _ in assets), tuple(s for s, _ in surfaces))


def files_there(folder: Path, manifest: Manifest) -> bool:
    """True when every file that a record names is still there, and a file."""
    try:
        # As text: paths of 5,000 files would take as long as all the rest.
        return all(stat.S_ISREG(os.stat(f"{folder}/{name}").st_mode) for name in manifest.files())
    except (OSError, ValueError):
        return False


def _files_of(asset: Asset) -> list[str]:
    textures = [part.texture for part in asset.parts if part.texture]
    return [asset.mesh, asset.hulls, asset.texture, *textures]


def _records(source: Source, key: str, model: type[R]) -> list[tuple[R, Path_]]:
    """The good entries of one list with where they stand; the bad ones are noted."""
    entries = source.value.get(key) if isinstance(source.value, dict) else None
    if entries is None:
        return []
    if not isinstance(entries, list):
        source.problem((key,), f"expected a list, got {shown(entries)}")
        return []
    out: list[tuple[R, Path_]] = []
    seen: set[str] = set()
    for index, entry in enumerate(entries):
        path: Path_ = (key, index)
        name = str(entry.get("id", index)) if isinstance(entry, dict) else str(index)
        source.named[path] = name[:80]
        if name in seen:
            source.problem((*path, "id"), "appears twice")
        seen.add(name)
        record = read(source, path, entry, model)
        if record is not None:
            out.append((record, path))
    return out


def _check_files(source: Source, path: Path_, folder: Path, files: list[str]) -> None:
    for file in files:
        if file.startswith(("/", "\\")) or ".." in Path(file).parts or ":" in file:
            source.problem(path, f"{file}: leaves the asset folder")
            continue
        try:
            mode = (folder / file).stat().st_mode
        except (OSError, ValueError):
            source.problem(path, f"{file}: no such file")
            continue
        if not stat.S_ISREG(mode):
            source.problem(path, f"{file}: is {kind_of(mode)}, not a file")
