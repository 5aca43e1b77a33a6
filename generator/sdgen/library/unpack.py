"""Unpacks models for PyBullet: one OBJ and MTL a part, textures shared by content.

PyBullet reads no GLB, and textures must come through the MTL.
"""

from __future__ import annotations

import io
import json
import zlib
from collections.abc import Mapping
from pathlib import Path

from PIL import Image

from sdgen.errors import AssetError
from sdgen.library.cache import cache_root, digest, write
from sdgen.library.meshes import MeshData
from sdgen.library.raw import file_bytes

#: Pixels: what graphics cards take at least, and 268 MB unpacked.
MAX_SIDE = 8192
#: Says of every other file of a model's folder how it was written; itself written last.
_SEAL = "seal.json"


def cached_texture(source: Path) -> Path:
    """The texture's copy in the cache, named by content so that equal files are loaded once."""
    data = _texture_bytes(source)
    suffix = ".png" if data.startswith(b"\x89PNG") else ".jpg"
    target = cache_root() / "textures" / f"{digest(data)}{suffix}"
    if _read(target) != data:
        check_texture(source)
        write(target.parent, {target.name: data})
    return target


def check_texture(source: Path) -> None:
    """Raise AssetError unless this is a whole PNG or JPEG of a sensible size.

    The renderer would show a broken one as plain white, without a word.
    """
    try:
        with Image.open(io.BytesIO(_texture_bytes(source)), formats=("PNG", "JPEG")) as image:
            if max(image.size) > MAX_SIDE:
                text = f"texture of {image.size} pixels, at most {MAX_SIDE} a side"
                raise AssetError([f"{source}: {text}"])
            image.load()
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError):
        raise AssetError([f"{source}: texture is no whole PNG or JPEG"]) from None


def _texture_bytes(source: Path) -> bytes:
    data = file_bytes(source)
    if not data.startswith((b"\x89PNG", b"\xff\xd8")):
        raise AssetError([f"{source}: texture is neither PNG nor JPEG"])
    return data


def obj_text(mesh: MeshData, mtl: str) -> str:
    """A Wavefront OBJ of the mesh with normals and texture coordinates."""
    lines = [f"mtllib {mtl}", "usemtl m"]
    lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in mesh.vertices]
    lines += [f"vt {u:.5f} {v:.5f}" for u, v in mesh.uvs]
    lines += [f"vn {x:.3f} {y:.3f} {z:.3f}" for x, y, z in mesh.normals]
    lines += [f"f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}" for a, b, c in mesh.faces + 1]
    return "\n".join(lines) + "\n"


def mtl_text(texture: str) -> str:
    """A material that shows the texture as it is."""
    return f"newmtl m\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nmap_Kd {texture}\n"


def unpack(
    key: str, meshes: Mapping[str, MeshData], textures: Mapping[str, Path]
) -> dict[str, Path]:
    """OBJ files of a model's parts, written on first use; ``textures`` maps part to PNG.

    A folder whose files are not as they were written is written anew.
    """
    folder = cache_root() / "models" / key
    if not _whole(folder, meshes):
        files: dict[str, bytes] = {}
        for part, mesh in meshes.items():
            texture = "../../textures/" + textures[part].name
            files[f"{part}.mtl"] = mtl_text(texture).encode("utf-8")
            files[f"{part}.obj"] = obj_text(mesh, f"{part}.mtl").encode("utf-8")
        sums = {name: zlib.crc32(data) for name, data in files.items()}
        write(folder, {**files, _SEAL: json.dumps(sums).encode()})
    return {part: folder / f"{part}.obj" for part in meshes}


def _whole(folder: Path, parts: Mapping[str, MeshData]) -> bool:
    """True when every file of the parts is as it was written."""
    try:
        sums = json.loads(_read(folder / _SEAL) or b"")
        names = {f"{part}.{kind}" for part in parts for kind in ("obj", "mtl")}
        return names == set(sums) and all(
            zlib.crc32(_read(folder / name) or b"") == sums[name] for name in names
        )
    except (ValueError, TypeError):
        return False


def _read(path: Path) -> bytes | None:
    """The bytes of a file of the cache; None when it cannot be read."""
    try:
        return path.read_bytes()
    except OSError:
        return None
