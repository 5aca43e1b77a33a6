"""Unpacks models for PyBullet: one OBJ and MTL a part, textures shared by content.

PyBullet reads no GLB, and textures must come through the MTL. The cache is keyed by content, so
it never goes stale, and folders appear whole, so workers may share it.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path

from PIL import Image

from sdgen.errors import AssetError
from sdgen.library.meshes import MeshData

_VERSION = b"2"
MAX_SIDE = 8192


def cache_root() -> Path:
    """``$SDGEN_CACHE``, else ``sdgen`` in the user's cache folder."""
    chosen = os.environ.get("SDGEN_CACHE")
    if chosen:
        return Path(chosen)
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "sdgen"


def digest(*chunks: bytes) -> str:
    """Short content hash of byte strings."""
    total = hashlib.sha256(_VERSION)
    for chunk in chunks:
        total.update(hashlib.sha256(chunk).digest())
    return total.hexdigest()[:20]


def cached_texture(source: Path) -> Path:
    """The texture's copy in the cache, named by content so that equal files are loaded once."""
    data = _texture_bytes(source)
    suffix = ".png" if data.startswith(b"\x89PNG") else ".jpg"
    target = cache_root() / "textures" / f"{digest(data)}{suffix}"
    if not target.exists():
        check_texture(source)
        _write_file(target, data)
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
    try:
        data = source.read_bytes()
    except OSError as error:
        raise AssetError([f"{source}: texture cannot be read: {error.strerror}"]) from None
    if not data.startswith((b"\x89PNG", b"\xff\xd8")):
        raise AssetError([f"{source}: texture is neither PNG nor JPEG"])
    return data


def _write_file(target: Path, data: bytes) -> None:
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=target.parent)
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        os.replace(temporary, target)
    except OSError as error:
        raise AssetError([_hint(error)]) from None


def _hint(error: OSError) -> str:
    return (
        f"{cache_root()}: the model cache cannot be written: {error.strerror}; "
        "set SDGEN_CACHE to a folder that can"
    )


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
    """OBJ files of a model's parts, written on first use; ``textures`` maps part to PNG."""
    folder = cache_root() / "models" / key
    if not folder.is_dir():
        try:
            folder.parent.mkdir(parents=True, exist_ok=True)
            temporary = Path(tempfile.mkdtemp(dir=folder.parent))
            for part, mesh in meshes.items():
                texture = "../../textures/" + textures[part].name
                (temporary / f"{part}.mtl").write_text(mtl_text(texture), encoding="utf-8")
                text = obj_text(mesh, f"{part}.mtl")
                (temporary / f"{part}.obj").write_text(text, encoding="utf-8")
            # Another worker may have been faster: its folder holds the same bytes.
            with contextlib.suppress(OSError):
                os.rename(temporary, folder)
            if temporary.is_dir():
                shutil.rmtree(temporary, ignore_errors=True)
        except OSError as error:
            raise AssetError([_hint(error)]) from None
    return {part: folder / f"{part}.obj" for part in meshes}
