"""HTML by which data sets and scenes show themselves in a notebook, small pictures in it."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable
from html import escape

import numpy as np
import numpy.typing as npt
from PIL import Image

#: Width of a picture in pixels.
WIDTH = 240
RED, BLUE = "#e03131", "#1c7ed6"
_CELL = f"display:inline-block;margin:4px;vertical-align:top;width:{WIDTH}px;position:relative"
_RECT = (
    '<rect x="{}" y="{}" width="{}" height="{}" style="fill:none;stroke-width:2;stroke:{}" '
    'vector-effect="non-scaling-stroke"/>'
)

#: [x, y, w, h] in pixels, and a colour.
Box = tuple[tuple[int, int, int, int], str]


def page(head: str, wrong: Iterable[str], figures: Iterable[str]) -> str:
    """A heading, lines of words, and figures (HTML) below."""
    lines = "".join(f"<li>{escape(line)}</li>" for line in wrong)
    return f"<div><div>{escape(head)}</div><ul>{lines}</ul>{''.join(figures)}</div>"


def figure(rgb: npt.NDArray[np.uint8] | None, boxes: Iterable[Box], words: str) -> str:
    """A picture, None where there is none, with its boxes and words below."""
    picture = "<div>no picture</div>" if rgb is None else _picture(rgb, boxes)
    return f'<div style="{_CELL}">{picture}<div>{escape(words)}</div></div>'


def _picture(rgb: npt.NDArray[np.uint8], boxes: Iterable[Box]) -> str:
    height, width = rgb.shape[:2]
    small = WIDTH, max(1, round(height * WIDTH / width))
    buffer = io.BytesIO()
    Image.fromarray(rgb).resize(small).save(buffer, "JPEG", quality=85)
    data = base64.b64encode(buffer.getvalue()).decode("ascii")
    drawn = "".join(_RECT.format(*bbox, colour) for bbox, colour in boxes)
    return (
        f'<img src="data:image/jpeg;base64,{data}" width="{small[0]}" height="{small[1]}">'
        f'<svg viewBox="0 0 {width} {height}" width="{small[0]}" height="{small[1]}" '
        f'style="position:absolute;left:0;top:0">{drawn}</svg>'
    )
