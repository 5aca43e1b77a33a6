"""Textures of many scenes, side by side in arrays of one size each."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import moderngl
import numpy as np
from PIL import Image

#: An array grows by so many layers at a time.
_STEP = 64
#: When all arrays hold more than so many pixels, half a gigabyte, they are emptied.
_MOST_PIXELS = 128 * 2**20

Size = tuple[int, int]


class Place(NamedTuple):
    """Where a texture is: the size of its array, and its layer there."""

    size: Size
    layer: int


class Shelf:
    """Texture arrays, one a size (width, height), with mipmaps."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._places: dict[Path, Place] = {}
        self._pictures: dict[Size, list[bytes]] = {}
        self._arrays: dict[Size, moderngl.TextureArray] = {}

    def bring(self, paths: Iterable[Path]) -> None:
        """See to it that these are there. What was there before may have gone."""
        if sum(w * h * len(held) for (w, h), held in self._pictures.items()) > _MOST_PIXELS:
            self.clear()
        grown: set[Size] = set()
        for path in dict.fromkeys(paths):
            if path in self._places:
                continue
            with Image.open(path) as image:
                pixels = np.asarray(image.convert("RGB"))[::-1]
            size = (pixels.shape[1], pixels.shape[0])
            held = self._pictures.setdefault(size, [])
            self._places[path] = Place(size, len(held))
            held.append(np.ascontiguousarray(pixels).tobytes())
            grown.add(size)
        for size in sorted(grown):
            self._upload(size)

    def place(self, path: Path) -> Place:
        """Where a texture is. KeyError when it was not brought."""
        return self._places[path]

    def use(self, size: Size, unit: int) -> None:
        """Have an array be the one of this texture unit."""
        self._arrays[size].use(unit)

    def clear(self) -> None:
        """Let go of all of them."""
        for array in self._arrays.values():
            array.release()
        self._places, self._pictures, self._arrays = {}, {}, {}

    def _upload(self, size: Size) -> None:
        held = self._pictures[size]
        layers = -(-len(held) // _STEP) * _STEP
        array = self._arrays.get(size)
        if array is None or array.layers < layers:
            if array is not None:
                array.release()
            array = self._context.texture_array((*size, layers), 3, alignment=1)
            array.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
            array.anisotropy = 8.0
            self._arrays[size] = array
        for layer, content in enumerate(held):
            array.write(content, viewport=(0, 0, layer, *size, 1), alignment=1)
        array.build_mipmaps()
