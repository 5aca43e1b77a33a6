"""Draw docs/images/light.jpg: overviews of a data set by day, in the evening and by night.

Run: ``python scripts/light_pictures.py DATASET OUT.jpg [--beside OLDER]``. A row each of four
rooms, drawn by sha256 of what they are; with ``--beside``, overviews of the same scenes of another
data set to their left instead, two pairs a row: so before and after are compared.
"""

from __future__ import annotations

import argparse
import hashlib
from collections.abc import Sequence
from pathlib import Path

import sdgen
from PIL import Image
from sdgen.dataset import SceneItem

SIZE, GAP, EACH, PAIRS = (400, 300), 5, 4, 6


def overview(item: SceneItem) -> Image.Image | None:
    """One overview of a scene, if it has any."""
    found = [camera.index for camera in item.cameras if camera.kind == "room"]
    if not found:
        return None
    ranked = sorted(found, key=lambda k: hashlib.sha256(f"{item.id}/{k}".encode()).hexdigest())
    return Image.fromarray(item.rgb(ranked[0])).resize(SIZE, Image.Resampling.LANCZOS)


def sheet(pictures: Sequence[Image.Image], columns: int) -> Image.Image:
    """Pictures in rows."""
    rows = -(-len(pictures) // columns)
    width, height = SIZE[0] + GAP, SIZE[1] + GAP
    out = Image.new("RGB", (columns * width - GAP, rows * height - GAP), "white")
    for k, one in enumerate(pictures):
        out.paste(one, (k % columns * width, k // columns * height))
    return out


def main() -> None:
    """Write the picture."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("dataset", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--beside", type=Path, help="the same scenes as another version drew them")
    args = parser.parse_args()
    scenes = [item for item in sdgen.Dataset(args.dataset) if item.scene.twin_of is None]
    pictures: list[Image.Image] = []
    if args.beside is None:
        for time in ("day", "evening", "night"):
            some = [overview(one) for one in scenes if one.scene.home.daylight.time == time]
            pictures += [one for one in some if one is not None][:EACH]
    else:
        older = {item.id: item for item in sdgen.Dataset(args.beside)}
        pairs = [(overview(older[one.id]), overview(one)) for one in scenes if one.id in older]
        for before, after in [pair for pair in pairs if None not in pair][:PAIRS]:
            assert before is not None
            assert after is not None
            pictures += [before, after]
    sheet(pictures, EACH).save(args.out, quality=86)


if __name__ == "__main__":
    main()
