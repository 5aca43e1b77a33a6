"""Draw docs/images/overview.png: views of a data set with their hazards outlined.

Run: ``python scripts/overview_image.py DATASET OUT.png SCENE:VIEW [SCENE:VIEW ...]``, six of them;
the last row shows the depth and instance mask of the first view.
"""

from __future__ import annotations

import sys

import numpy as np
import sdgen
from PIL import Image, ImageDraw, ImageFont

WIDTH, HEIGHT, GAP = 480, 360, 6
RED = (214, 40, 40)


def labelled(item: sdgen.dataset.reader.SceneItem, view: int) -> Image.Image:
    """A view with a box and the hazard's name around each anomaly it shows."""
    picture = Image.fromarray(item.rgb(view)).resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)
    draw = ImageDraw.Draw(picture)
    font = ImageFont.load_default(15)
    scale = WIDTH / item.rgb(view).shape[1]
    named = {a.object_id: a.hazard.replace("_", " ") for a in item.anomalies.anomalies}
    for seen in item.visibility.views[view].objects:
        if seen.object_id not in named or seen.pixels < 150:
            continue
        x, y, w, h = (v * scale for v in seen.bbox)
        draw.rectangle((x, y, x + w, y + h), outline=RED, width=2)
        size = draw.textlength(named[seen.object_id], font=font)
        x = min(max(x, 0), WIDTH - size - 8)
        top = max(y - 20, 0)
        draw.rectangle((x, top, x + size + 8, top + 20), fill=RED)
        draw.text((x + 4, top + 1), named[seen.object_id], fill="white", font=font)
    return picture


def depth_picture(depth_m: np.ndarray) -> Image.Image:
    """Near is bright."""
    seen = depth_m[depth_m > 0]
    near = np.interp(depth_m, (seen.min(), seen.max()), (1.0, 0.15)) * (depth_m > 0)
    grey = Image.fromarray((near * 255).astype(np.uint8))
    return grey.convert("RGB").resize((WIDTH, HEIGHT), Image.Resampling.NEAREST)


def mask_picture(ids: np.ndarray) -> Image.Image:
    """Every id its own colour."""
    mixed = (ids.astype(np.uint32) * 2654435761) & 0xFFFFFF
    colours = np.stack([mixed >> 16 & 255, mixed >> 8 & 255, mixed & 255], axis=-1)
    return Image.fromarray((colours * 0.8 + 40).clip(0, 255).astype(np.uint8)).resize(
        (WIDTH, HEIGHT), Image.Resampling.NEAREST
    )


def main() -> None:
    """Write the picture."""
    data = sdgen.Dataset(sys.argv[1])
    wanted = [tuple(map(int, name.split(":"))) for name in sys.argv[3:]]
    tiles = [labelled(data[scene], view) for scene, view in wanted]
    first = data[wanted[0][0]]
    tiles.append(depth_picture(first.depth(wanted[0][1])))
    tiles.append(mask_picture(first.instance(wanted[0][1])))
    rows = -(-len(tiles) // 4)
    sheet = Image.new("RGB", (4 * (WIDTH + GAP) - GAP, rows * (HEIGHT + GAP) - GAP), "white")
    for k, tile in enumerate(tiles):
        sheet.paste(tile, (k % 4 * (WIDTH + GAP), k // 4 * (HEIGHT + GAP)))
    sheet.save(sys.argv[2], optimize=True)


if __name__ == "__main__":
    main()
