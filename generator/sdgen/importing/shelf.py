"""A library that imports fill: its manifest, and one record a model of where it came from.

``imports/<id>.json`` is written last of a model's files, so a model is there as a whole or not at
all; the manifest is made from these records. Nothing else in the folder is touched.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sdgen.dataset.output_file import write_output
from sdgen.errors import AssetError, InputError
from sdgen.files import read_plain
from sdgen.importing.manifest import manifest_of
from sdgen.importing.tree import is_file
from sdgen.library.manifest import MAX_BYTES, MAX_VALUES, manifest_bytes
from sdgen.library.records import Asset
from sdgen.locks import FileLock
from sdgen.scene import Record
from sdgen.yaml_source import parse_yaml

FOLDER = "imports"
_HEAD = "# Written by sdgen assets import from imports/*.json; fields: see assets/README.md."
_MAX_BYTES = 5_000_000


class Origin(Record):
    """Where a model came from: source and name there, its file as seen from the folder that was
    imported, the digest of all that it was made from, how its category was found, and notes."""

    source: str
    name: str
    kind: str
    entry: str
    root: str
    digest: str
    how: str
    why: str
    placed: bool
    notes: tuple[str, ...] = ()
    asset: Asset


@contextmanager
def held(library: Path) -> Iterator[None]:
    """The library for one import at a time. Raises AssetError while another holds it."""
    library.mkdir(parents=True, exist_ok=True)
    lock = FileLock.take(library / ".import-lock")
    if lock is None:
        raise AssetError([f"{library}: another import is writing it; wait for it, or name another"])
    try:
        yield
    finally:
        lock.release()
        with suppress(OSError):
            (library / ".import-lock").unlink()


def origins(library: Path) -> dict[str, Origin]:
    """What was imported into a library, by asset id; records that are broken are left out."""
    out = {}
    for path in sorted((library / FOLDER).glob("*.json")):
        found = _origin(path)
        if found is not None and found.asset.id == path.stem and _files_there(library, found.asset):
            out[path.stem] = found
    return out


def put(library: Path, origin: Origin, files: Mapping[str, bytes]) -> None:
    """Write a model's files, then its record."""
    for name, data in files.items():
        write_output(library / name, data)
    write_output(library / record_name(origin.asset.id), record_bytes(origin))


def record_name(asset_id: str) -> str:
    """Where a model's record lies in its library."""
    return f"{FOLDER}/{asset_id}.json"


def record_bytes(origin: Origin) -> bytes:
    """A record as it is written."""
    return (origin.model_dump_json(indent=1, exclude_defaults=True) + "\n").encode()


def write_manifest(library: Path, found: Sequence[Origin]) -> None:
    """``manifest.yaml`` of all models, and whom to name for them.

    Models that were not imported (made by hand, copied to be retextured) stay in it, and surfaces.
    Raises AssetError as :func:`kept_entries` does.
    """
    mine, surfaces = kept_entries(library)
    assets = sorted([*(origin.asset for origin in found), *mine], key=lambda asset: asset.id)
    rest = {"surfaces": surfaces}
    write_output(library / "manifest.yaml", manifest_of(_HEAD, assets, rest))
    write_output(
        library / "ATTRIBUTION.md", _attribution([a for a in assets if a.attribution]).encode()
    )


def kept_entries(library: Path) -> tuple[list[Asset], list[Any]]:
    """What a library's manifest has that no import made: models without a record, and surfaces.

    Raises AssetError, located, for a manifest that cannot be read: writing it anew would lose that.
    """
    path = library / "manifest.yaml"
    if not path.exists():
        return [], []
    source = parse_yaml(manifest_bytes(library), str(path), MAX_BYTES, MAX_VALUES)
    value = source.value if isinstance(source.value, dict) else {}
    entries, surfaces = value.get("assets") or [], value.get("surfaces") or []
    lists = isinstance(entries, list) and isinstance(surfaces, list)
    if source.noted or not isinstance(source.value, dict) or not lists:
        raise AssetError(source.problems or [f"{path}: is no manifest: mend it, or move it away"])
    models: list[Asset] = []
    problems: list[str] = []
    for number, entry in enumerate(entries):
        name = entry.get("id") if isinstance(entry, dict) else None
        if isinstance(name, str) and is_file(library / record_name(name)):
            continue
        try:
            models.append(Asset.model_validate_json(json.dumps(entry)))
        except (ValidationError, ValueError, TypeError) as error:
            called = name if isinstance(name, str) else f"entry {number + 1}"
            text = str(error)
            if isinstance(error, ValidationError):
                first = error.errors(include_url=False)[0]
                text = f"{'.'.join(map(str, first['loc']))}: {first['msg']}"
            problems.append(f"{path}: assets: {called}: {text}")
    if problems:
        raise AssetError(problems)
    return models, surfaces


def _attribution(assets: Sequence[Asset]) -> str:
    groups: dict[tuple[str, str], list[str]] = {}
    for asset in assets:
        groups.setdefault((asset.attribution, asset.licence), []).append(asset.id)
    lines = ["# Whom to name for these models", ""]
    for (attribution, licence), ids in sorted(groups.items()):
        lines += [
            f"## {attribution}",
            "",
            f"{licence}, changed: made light, textures baked anew.",
            "",
        ]
        lines += [f"- {name}" for name in ids] + [""]
    return "\n".join(lines)


def _origin(path: Path) -> Origin | None:
    try:
        return Origin.model_validate_json(read_plain(path, str(path), _MAX_BYTES))
    except (InputError, ValidationError, ValueError):
        return None


def _files_there(library: Path, asset: Asset) -> bool:
    names = [asset.mesh, asset.hulls, asset.texture, *(p.texture for p in asset.parts if p.texture)]
    return all((library / name).is_file() for name in names)


def report_json(origin: Origin) -> dict[str, object]:
    """What ``assets import --json`` says of a model."""
    asset = origin.asset
    return {
        "id": asset.id,
        "name": origin.name,
        "category": asset.category,
        "how": origin.how,
        "why": origin.why,
        "placed": origin.placed,
        "faces": asset.faces,
        "extents_m": list(asset.extents_m),
        "mass_kg": asset.mass_kg,
        "licence": asset.licence,
        "notes": list(origin.notes),
    }
