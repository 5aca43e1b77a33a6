"""Contact sheets: many models, one tile each, with their names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw, ImageFont

Rgb = npt.NDArray[np.uint8]

_GAP, _LINE = 4, 14
_PAPER, _INK = (250, 249, 246), (40, 40, 44)


def contact_sheet(tiles: Sequence[tuple[str, Rgb]], columns: int) -> Rgb:
    """All tiles (label, (S, S, 3)), left to right in rows of ``columns``, labels below.

    Tiles are of one size. Raises ValueError when there is none.
    """
    if not tiles:
        raise ValueError("a sheet of nothing")
    side = tiles[0][1].shape[0]
    columns = min(columns, len(tiles))
    rows = -(-len(tiles) // columns)
    sheet = Image.new(
        "RGB", (columns * (side + _GAP) + _GAP, rows * (side + _LINE + _GAP) + _GAP), _PAPER
    )
    draw = ImageDraw.Draw(sheet)
    font = ImageFont.load_default(11)
    for index, (label, tile) in enumerate(tiles):
        x = _GAP + (index % columns) * (side + _GAP)
        y = _GAP + (index // columns) * (side + _LINE + _GAP)
        sheet.paste(Image.fromarray(tile), (x, y))
        draw.text((x + 1, y + side), _fitting(draw, label, side, font), fill=_INK, font=font)
    return np.asarray(sheet)


def pages(count: int, per_page: int) -> Iterator[range]:
    """Indices of each page, all but the last one full."""
    for start in range(0, count, per_page):
        yield range(start, min(start + per_page, count))


def _fitting(
    draw: ImageDraw.ImageDraw,
    label: str,
    width: int,
    font: ImageFont.FreeTypeFont | ImageFont.ImageFont,
) -> str:
    while label and draw.textlength(label, font=font) > width:
        label = label[:-1]
    return label
