"""The models a source has, as its own list tells, and the files of each."""

from __future__ import annotations

import re
import string
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypeGuard
from urllib.parse import quote

from sdgen.errors import AssetError
from sdgen.importing.client import Client, NotThere
from sdgen.importing.download import Wanted
from sdgen.importing.fetched import FILE
from sdgen.importing.member_names import name_parts
from sdgen.importing.sources import Source

MAX_PAGES = 500
#: Of ReplicaCAD: what belongs to all models, and what makes rooms of them.
COMMON, SCENES = "common", "scenes"

_WORD = r"[A-Za-z0-9][A-Za-z0-9_.-]*"
#: Paths of ReplicaCAD's own layout -> the model they belong to (its name is the first group).
_HUB_LAYOUT = (
    (re.compile(rf"objects/({_WORD})\.glb"), ""),
    (re.compile(rf"objects/convex/({_WORD})_cv_decomp\.glb"), ""),
    (re.compile(rf"configs/objects/({_WORD})\.object_config\.json"), ""),
    (re.compile(rf"urdf/({_WORD})/{_WORD}(?:/{_WORD})*"), ""),
    (re.compile(rf"configs/(?:scenes|stages|lighting|ssd)/{_WORD}\.json"), SCENES),
    (re.compile(rf"stages/(?:{_WORD}/)*{_WORD}\.(?:glb|json)"), SCENES),
    (re.compile(rf"(?:LICENSE\.txt|README\.md|{_WORD}\.scene_dataset_config\.json)"), COMMON),
)


@dataclass(frozen=True)
class RemoteFile:
    """A file of a model: the first of ``choices`` that is there.

    ``path`` is where it goes in the folder; empty for an archive to unpack.
    """

    choices: tuple[Wanted, ...]
    path: str = ""


@dataclass(frozen=True)
class RemoteModel:
    """A model: its files, its licence in its source's words, and a ``mark`` of its version; both
    empty where the source tells neither."""

    name: str
    files: tuple[RemoteFile, ...]
    licence: str = ""
    mark: str = ""


def list_models(source: Source, client: Client) -> dict[str, RemoteModel]:
    """All models of a source by name, sorted.

    Raises AssetError when the list cannot be had or is none. Names that cannot be a folder's are
    left out.
    """
    if source.listing == "hub_tree":
        models = _hub_models(source, client)
    elif source.listing == "fuel_pages":
        models = list(_fuel_models(source, client))
    else:
        models = list(_object_models(source, client))
    named = {model.name: model for model in sorted(models, key=lambda one: one.name)}
    if not named:
        raise AssetError([f"{source.base}: lists no model"])
    return named


def _object_models(source: Source, client: Client) -> Iterator[RemoteModel]:
    address = _address(source, source.list_path)
    value, _ = client.json(address)
    for name in _items(value.get("objects") if isinstance(value, dict) else None, address):
        if _usable(name):
            yield RemoteModel(name, (_archive(source, name),))


def _fuel_models(source: Source, client: Client) -> Iterator[RemoteModel]:
    for page in range(1, MAX_PAGES + 1):
        address = _address(source, source.list_path, page=str(page))
        try:
            items = _items(client.json(address)[0], address)
        except NotThere:  # what is behind the last page
            if page == 1:
                raise
            return
        if not items:
            return
        for item in items:
            name = item.get("name") if isinstance(item, dict) else None
            if isinstance(item, dict) and _usable(name):
                marks = [str(item.get(key, ""))[:100] for key in ("version", "modify_date")]
                licence = str(item.get("license_name") or "")[:200]
                mark = "/".join(marks) if all(marks) else ""
                yield RemoteModel(name, (_archive(source, name),), licence, mark)
    raise AssetError([f"{source.base}: lists models on more than {MAX_PAGES} pages"])


def _hub_models(source: Source, client: Client) -> list[RemoteModel]:
    files: dict[str, list[RemoteFile]] = {}
    address = _address(source, source.list_path)
    for _ in range(MAX_PAGES):
        value, following = client.json(address)
        for item in _items(value, address):
            if not isinstance(item, dict) or item.get("type") != "file":
                continue
            path, size = item.get("path"), item.get("size")
            name = _owner(path) if isinstance(path, str) else ""
            if name and isinstance(size, int) and size >= 0:
                place = _address(source, source.model_paths[0], path=str(path))
                wanted = Wanted(place, size, _git_digest(item))
                files.setdefault(name, []).append(RemoteFile((wanted,), str(path)))
        if not following:
            break
        address = following
    return [
        RemoteModel(name, tuple(sorted(found, key=lambda file: file.path)))
        for name, found in files.items()
    ]


def _git_digest(item: dict[str, Any]) -> tuple[str, str] | None:
    lfs = item.get("lfs")
    kind, digest = ("sha256", lfs.get("oid")) if isinstance(lfs, dict) else ("git", item.get("oid"))
    length = 64 if kind == "sha256" else 40
    if isinstance(digest, str) and re.fullmatch(rf"[0-9a-f]{{{length}}}", digest):
        return kind, digest
    return None


def _owner(path: str) -> str:
    """The model a file of ReplicaCAD belongs to; empty for what no import needs."""
    for pattern, name in _HUB_LAYOUT:
        if match := pattern.fullmatch(path):
            return name or match[1]
    return ""


def _archive(source: Source, name: str) -> RemoteFile:
    md5 = source.checksum == "s3_etag"
    places = [_address(source, path, name=name) for path in source.model_paths]
    return RemoteFile(tuple(Wanted(place, etag_is_md5=md5) for place in places))


def _address(source: Source, pattern: str, **names: str) -> str:
    """An address of the source, with ``{name}`` and the like filled in, and quoted."""
    for key, value in names.items():
        pattern = pattern.replace(f"{{{key}}}", quote(value))
    return f"{source.base}/{quote(pattern, safe=string.punctuation)}"


def _items(value: Any, address: str) -> list[Any]:
    if not isinstance(value, list):
        raise AssetError([f"{address}: is no list of models"])
    return value


def _usable(name: Any) -> TypeGuard[str]:
    """Whether a model's name may be its folder's."""
    if not isinstance(name, str) or name.startswith(".") or name.strip() != name:
        return False
    try:
        return len(name_parts(name)) == 1 and "/" not in name and name.casefold() != FILE
    except ValueError:
        return False
