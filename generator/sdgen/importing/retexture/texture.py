"""One texture in, the same texture in another state out: Blender's part of retexturing."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from sdgen.errors import SdgenError
from sdgen.importing.blender import Blender, run_script
from sdgen.library.meshes import MeshData
from sdgen.resources import data_path

if TYPE_CHECKING:
    from PIL.Image import Image

Pixels = npt.NDArray[np.uint8]
Mask = npt.NDArray[np.bool_]

#: Smaller textures are enlarged: spots of mould would be single texels.
FEWEST_PIXELS = 256
#: Larger ones are made smaller: Blender bakes in 16 bytes a channel set and several copies.
MOST_PIXELS = 4096
#: A bake with fewer colours went wrong: Blender bakes black when it cannot bake.
FEWEST_COLOURS = 32
#: Mean change of a channel, 0 to 255, below which nobody would see a difference.
LEAST_CHANGE = 5.0
_QUALITY = 90


class BakeError(SdgenError):
    """What Blender made is no texture of the state."""


def bake(
    blender: Blender,
    meshes: Sequence[MeshData],
    texture: Pixels,
    look: str,
    kind: str,
    seed: int,
    scratch: Path,
) -> Pixels:
    """The texture (H, W, 3) of some meshes in a look of ``assets/blender/wear.py``.

    ``scratch`` is an empty folder of its own. Raises BlenderError when Blender fails, BakeError
    when what it made cannot be right.
    """
    counts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    job, result = scratch / "job.npz", scratch / "result.npz"
    np.savez(
        job,
        vertices=np.concatenate([mesh.vertices for mesh in meshes]),
        normals=np.concatenate([mesh.normals for mesh in meshes]),
        uvs=np.concatenate([mesh.uvs for mesh in meshes]),
        faces=np.concatenate([m.faces + n for m, n in zip(meshes, counts[:-1], strict=True)]),
        texture=texture,
    )
    script = data_path("assets", "blender", "retexture.py")
    run_script(blender, script, [str(job), str(result), look, kind, str(seed)], scratch)
    baked, covered = _result(result, texture.shape, blender)
    check_bake(texture, baked, covered)
    return _fill(baked, covered)


def _result(path: Path, shape: tuple[int, ...], blender: Blender) -> tuple[Pixels, Mask]:
    try:
        with np.load(path, allow_pickle=False) as found:
            baked, covered = found["texture"], found["covered"]
    except (OSError, ValueError, KeyError, EOFError):
        raise BakeError(f"{blender.name} ended without a texture") from None
    if baked.shape != shape or baked.dtype != np.uint8 or covered.shape != shape[:2]:
        raise BakeError(f"{blender.name} baked {baked.shape}, not {shape}")
    return baked, covered.astype(bool)


def check_bake(before: Pixels, after: Pixels, covered: Mask) -> None:
    """Raises BakeError for a bake that is blank, or like the texture that there was."""
    if not covered.any():
        raise BakeError("nothing of the mesh lies on its texture: its UVs are no surface")
    seen = after[covered]
    colours = len(np.unique(seen @ np.array([1, 256, 65536])))
    if colours < min(FEWEST_COLOURS, len(seen)):
        raise BakeError(f"the bake is blank: {colours} colours in {len(seen)} texels")
    change = float(np.abs(seen.astype(float) - before[covered]).mean())
    if change < LEAST_CHANGE:
        raise BakeError(f"the bake changes nothing that one sees ({change:.1f} of 255)")


def _fill(pixels: Pixels, covered: Mask) -> Pixels:
    """Colours spread from the covered texels over all others (push-pull): renderers take smaller
    copies of a texture, in which what lies beside the mesh's islands would bleed in."""
    height, width = covered.shape
    side = 1 << max(height - 1, width - 1, 1).bit_length()
    colour = np.zeros((side, side, 3), np.float32)
    weight = np.zeros((side, side), np.float32)
    weight[:height, :width] = covered
    colour[:height, :width] = pixels * covered[..., None]
    levels = [(colour, weight)]
    while levels[-1][0].shape[0] > 1:
        colour, weight = levels[-1]
        half = colour.shape[0] // 2
        total = weight.reshape(half, 2, half, 2).sum((1, 3))
        mean = colour.reshape(half, 2, half, 2, 3).sum((1, 3)) / np.maximum(total, 1)[..., None]
        levels.append((mean, (total > 0).astype(np.float32)))
    out = levels[-1][0]
    for colour, weight in levels[-2::-1]:
        out = np.where(weight[..., None] > 0, colour, out.repeat(2, 0).repeat(2, 1))
    return np.asarray(out[:height, :width].clip(0, 255) + 0.5, dtype=np.uint8)


def read_texture(raw: bytes) -> Pixels:
    """A PNG or JPEG as (H, W, 3), brought to a size that can be baked."""
    from PIL import Image

    with Image.open(io.BytesIO(raw), formats=("PNG", "JPEG")) as image:
        whole = image.convert("RGB")
    return np.asarray(_sized(whole), dtype=np.uint8)


def _sized(image: Image) -> Image:
    from PIL.Image import Resampling

    low, high = min(image.size), max(image.size)
    factor = 1.0
    if low < FEWEST_PIXELS:
        factor = -(-FEWEST_PIXELS // low)
    if high * factor > MOST_PIXELS:
        factor = MOST_PIXELS / high
    if factor == 1.0:
        return image
    size = [max(1, round(side * factor)) for side in image.size]
    return image.resize((size[0], size[1]), Resampling.LANCZOS)


def jpeg(pixels: Pixels) -> bytes:
    """Full colour resolution, or red letters on white would blur. (``optimize`` fails on noise.)"""
    from PIL import Image

    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "JPEG", quality=_QUALITY, subsampling=0)
    return out.getvalue()
