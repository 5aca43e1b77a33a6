"""Textures on the renderer: each put there once, and kept from scene to scene while there is
room."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection
from pathlib import Path

import moderngl
from PIL import Image

#: So many pixels are kept, 200 MB with their smaller copies: the models of some twenty homes.
_MOST_PIXELS = 48 * 2**20


class Textures:
    """Those used last."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._held: OrderedDict[Path, moderngl.Texture] = OrderedDict()
        self._pixels = 0

    def bring(self, paths: Collection[Path]) -> dict[Path, moderngl.Texture]:
        """All of these, by their paths; what others have not been used for longest may go."""
        for path in paths:
            if path in self._held:
                self._held.move_to_end(path)
            else:
                self._held[path] = self._read(path)
        wanted = set(paths)
        for path in [*self._held]:
            if self._pixels <= _MOST_PIXELS or path in wanted:
                break
            gone = self._held.pop(path)
            self._pixels -= gone.width * gone.height
            gone.release()
        return {path: self._held[path] for path in paths}

    def clear(self) -> None:
        """Let go of all of them."""
        for texture in self._held.values():
            texture.release()
        self._held.clear()
        self._pixels = 0

    def _read(self, path: Path) -> moderngl.Texture:
        with Image.open(path) as image:
            upright = image.convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM)
        texture = self._context.texture(upright.size, 3, upright.tobytes(), alignment=1)
        texture.build_mipmaps()
        texture.filter = (moderngl.LINEAR_MIPMAP_NEAREST, moderngl.LINEAR)
        self._pixels += texture.width * texture.height
        return texture
