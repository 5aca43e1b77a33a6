"""What a worker needs of a model, prepared once on disk and mapped by all processes.

A file a model, named by the bytes it was made from and by the code that made it: a line of JSON
that says what lies where, then the arrays. Decoding a GLB takes 5 ms and loads trimesh and scipy;
mapping its arrays takes 0.1 ms, and the pages are shared.
"""

from __future__ import annotations

import contextlib
import json
import mmap
import struct
import sys
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import vec3
from sdgen.library.cache import cache_root, digest, write
from sdgen.library.glb import MAX_BYTES
from sdgen.library.meshes import (
    Hull,
    MeshData,
    read_glb,
    read_hulls,
    within_meshes,
)
from sdgen.library.outlines import Points, outlines_of
from sdgen.library.raw import file_bytes
from sdgen.library.reaching import reaching_meshes
from sdgen.library.records import Asset

try:
    import resource
except ImportError:  # pragma: no cover - Windows
    resource = None  # type: ignore[assignment]

#: Arrays begin at multiples of this, as numpy's own do at least.
_ALIGN = 64
#: CRC-32 of all that follows, and the length of the JSON.
_HEAD = struct.Struct("<II")
_Array = np.ndarray[Any, Any]
_MESH = ("vertices", "normals", "uvs", "faces")


@dataclass(frozen=True)
class Model:
    """Meshes by part, convex pieces (none beyond what is drawn) and outlines of one model.

    The arrays can only be read.
    """

    meshes: Mapping[str, MeshData]
    hulls: tuple[Hull, ...]
    outlines_m: Mapping[str, tuple[Points, ...]]


class Prepared:
    """The models of asset folders, from the cache, or read from their files and put there."""

    def __init__(self) -> None:
        self._paths: dict[tuple[Path, str], Path] = {}

    def model(self, folder: Path, asset: Asset) -> Model:
        """The model of ``folder``. Raises AssetError for a missing or broken file of the model.

        A cache that is broken or cannot be written only costs time. Once a model was read, it
        stays what it was, whatever becomes of its files.
        """
        known = self._paths.get((folder, asset.id))
        if known is not None and (found := _mapped(known)) is not None:
            return found
        glb, hulls = (file_bytes(folder / name, MAX_BYTES) for name in (asset.mesh, asset.hulls))
        path = cache_root() / "prepared" / _key(asset, glb, hulls)
        self._paths[folder, asset.id] = path
        found = _mapped(path)
        if found is not None:
            return found
        made = pack(_read(folder, asset, glb, hulls))
        with contextlib.suppress(AssetError):
            write(path.parent, {path.name: made})
        return _mapped(path) or unpacked(memoryview(made))


def open_files() -> int:
    """How many files this process may have open: 256 on macOS, 1024 and more on Linux."""
    if resource is None:
        return 256
    soft, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return sys.maxsize if soft == resource.RLIM_INFINITY else int(soft)


def _key(asset: Asset, glb: bytes, hulls: bytes) -> str:
    named = (
        [(part.name, part.faces, part.joint) for part in asset.parts],
        [(support.part, support.z_m, support.polygon_m) for support in asset.supports],
        bool(asset.containers),
    )
    return digest(glb, hulls, repr(named).encode(), _code())


def pack(model: Model) -> bytes:
    """The file of a model."""
    arrays: list[bytes] = []
    end = 0

    def place(array: _Array) -> list[Any]:
        nonlocal end
        data = np.ascontiguousarray(array).tobytes()
        start, gap = end, -len(data) % _ALIGN
        arrays.append(data + b"\0" * gap)
        end += len(data) + gap
        return [array.dtype.str, array.shape, start]

    text = json.dumps(
        {
            "meshes": {
                part: [place(getattr(mesh, name)) for name in _MESH]
                for part, mesh in model.meshes.items()
            },
            "hulls": [[hull.part, place(hull.vertices_m)] for hull in model.hulls],
            "outlines": {
                part: [place(np.array(points)) for points in pieces]
                for part, pieces in model.outlines_m.items()
            },
        }
    ).encode()
    text += b" " * (-(_HEAD.size + len(text)) % _ALIGN)
    body = text + b"".join(arrays)
    return _HEAD.pack(zlib.crc32(body), len(text)) + body


def unpacked(data: memoryview) -> Model:
    """The model of a file's bytes, its arrays views of them. Raises ValueError for broken ones."""
    if len(data) < _HEAD.size:
        raise ValueError("cut off")
    checksum, length = _HEAD.unpack_from(data)
    if zlib.crc32(data[_HEAD.size :]) != checksum:
        raise ValueError("not as it was written")
    start = _HEAD.size + length
    index = json.loads(bytes(data[_HEAD.size : start]))

    def array(entry: list[Any]) -> _Array:
        kind, shape, offset = entry
        count = int(np.prod(shape))
        found = np.frombuffer(data, np.dtype(kind), count, start + offset).reshape(shape)
        found.flags.writeable = False
        return np.asarray(found)

    return Model(
        meshes={
            part: MeshData(**dict(zip(_MESH, map(array, entries), strict=True)))
            for part, entries in index["meshes"].items()
        },
        hulls=tuple(Hull(part, array(entry)) for part, entry in index["hulls"]),
        outlines_m={
            part: tuple(tuple(map(vec3, array(entry).tolist())) for entry in pieces)
            for part, pieces in index["outlines"].items()
        },
    )


def _mapped(path: Path) -> Model | None:
    """The model of a file of the cache; None when it is not there or not whole."""
    try:
        with path.open("rb") as stream:
            data = mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ)
        return unpacked(memoryview(data))
    except (OSError, ValueError):
        return None


def _read(folder: Path, asset: Asset, glb: bytes, hulls: bytes) -> Model:
    meshes = read_glb(folder / asset.mesh, asset, glb)
    pieces = read_hulls(folder / asset.hulls, asset, hulls)
    return Model(
        meshes=meshes,
        hulls=reaching_meshes(within_meshes(pieces, meshes, asset), meshes, asset),
        outlines_m={part: outlines_of(mesh) for part, mesh in meshes.items()},
    )


@cache
def _code() -> bytes:
    """What else decides the arrays: the code that reads models, ours and that of others."""
    here = Path(__file__).parent
    names = ("glb.py", "meshes.py", "outlines.py", "prepared.py", "quantized.py", "reaching.py")
    sources = [(here / name).read_bytes() for name in names]
    return digest(f"{version('trimesh')} {np.__version__}".encode(), *sources).encode()
