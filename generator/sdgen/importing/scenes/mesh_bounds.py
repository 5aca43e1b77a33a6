"""The box of a mesh file that a scene names, without unpacking what it looks like."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from sdgen.files import read_plain
from sdgen.geometry import Array, lowest_highest

#: A scan in text takes 200 MB.
MAX_BYTES = 400_000_000
Bounds = tuple[Array, Array]


def mesh_bounds(path: Path, shown: str) -> Bounds:
    """Lowest and highest corner, (3,), of a mesh's points, in its own axes.

    Raises InputError for a missing file, ValueError for one that cannot be read.
    """
    read = _READERS.get(path.suffix.lower())
    if read is None:
        known = ", ".join(sorted(_READERS))
        raise ValueError(f"{path.suffix or 'no'} files are not read ({known} are)")
    points = read(read_plain(path, shown, MAX_BYTES))
    if not len(points) or not np.isfinite(points).all():
        raise ValueError("it has no points, or some that are not finite")
    return lowest_highest(points)


def _obj(raw: bytes) -> Array:
    rows = [line.split()[1:4] for line in raw.splitlines() if line[:2] in (b"v ", b"v\t")]
    try:
        return np.array([[float(value) for value in row] for row in rows]).reshape(-1, 3)
    except ValueError:
        raise ValueError("a line 'v x y z' of it cannot be read") from None


def _stl(raw: bytes) -> Array:
    if len(raw) >= 84:
        (count,) = struct.unpack_from("<I", raw, 80)
        if len(raw) == 84 + 50 * count and count:
            kind = np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
            corners = np.frombuffer(raw, kind, count, 84)["v"]
            return np.asarray(corners, dtype=float).reshape(-1, 3)
    rows = [line.split()[1:4] for line in raw.splitlines() if line.strip()[:6] == b"vertex"]
    try:
        return np.array([[float(value) for value in row] for row in rows]).reshape(-1, 3)
    except ValueError:
        raise ValueError("it is no STL") from None


def _msh(raw: bytes) -> Array:
    """MuJoCo's own: four counts, then points."""
    if len(raw) < 16:
        raise ValueError("it is cut off")
    count, normals, uvs, faces = struct.unpack_from("<4i", raw)
    if min(count, normals, uvs, faces) < 0:
        raise ValueError("it is no MSH")
    if len(raw) < 16 + 4 * (3 * count + 3 * normals + 2 * uvs + 3 * faces):
        raise ValueError("it is cut off")
    return np.frombuffer(raw, "<f4", 3 * count, 16).astype(float).reshape(-1, 3)


_READERS: Mapping[str, Callable[[bytes], Array]] = {".obj": _obj, ".stl": _stl, ".msh": _msh}
