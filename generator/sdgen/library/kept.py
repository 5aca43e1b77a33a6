"""Checked records of a manifest, kept in the cache: checking 1,800 of them anew takes a second.

A file a manifest, named by its bytes and by the code that checks them: a line with the digest of
what follows, then the records as JSON.
"""

from __future__ import annotations

import contextlib
import hashlib
from functools import cache
from pathlib import Path

from pydantic import ValidationError

from sdgen.errors import AssetError
from sdgen.library.cache import cache_root, digest, write
from sdgen.library.manifest import Manifest, files_there, manifest_bytes, read_manifest
from sdgen.library.records import Asset, Surface
from sdgen.scene import Record

#: What decides whether a manifest is good, and what its records are.
_CODE = (
    "licences.py",
    "manifest.py",
    "plausible.py",
    "records.py",
    "../strict.py",
    "../yaml_source.py",
)


class _Kept(Record):
    assets: tuple[Asset, ...]
    surfaces: tuple[Surface, ...]


def kept_manifest(folder: Path) -> Manifest:
    """Records of ``folder/manifest.yaml``, from the cache where they were checked before.

    That every file they name is there is looked up anew. Raises AssetError with all problems.
    """
    raw = manifest_bytes(folder)
    path = cache_root() / "records" / f"{digest(raw, _code())}.json"
    found = _read(path, raw)
    if found is not None and files_there(folder, found):
        return found
    made = read_manifest(folder, raw)
    # As they were given: what was left out stays left out.
    kept = _Kept.model_construct(assets=made.assets, surfaces=made.surfaces)
    body = kept.model_dump_json(exclude_unset=True).encode()
    with contextlib.suppress(AssetError):  # without a cache it takes a second longer
        write(path.parent, {path.name: _line(body) + body})
    return made


def _read(path: Path, raw: bytes) -> Manifest | None:
    """The records of a file of the cache; None when it is not there or not whole."""
    try:
        data = path.read_bytes()
        body = data[data.index(b"\n") + 1 :]
        if data != _line(body) + body:
            return None
        kept = _Kept.model_validate_json(body, strict=True)
    except (OSError, ValueError, ValidationError):
        return None
    return Manifest(raw, kept.assets, kept.surfaces)


def _line(body: bytes) -> bytes:
    return hashlib.sha256(body).hexdigest().encode() + b"\n"


@cache
def _code() -> bytes:
    here = Path(__file__).parent
    return digest(*((here / name).read_bytes() for name in _CODE)).encode()
