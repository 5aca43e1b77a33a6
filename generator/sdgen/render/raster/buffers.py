"""What the renderer draws into, for pictures of one size."""

from __future__ import annotations

import moderngl
import numpy as np
import numpy.typing as npt


class Buffers:
    """Albedo and glow, whose each pixel is, normals, and depth along the camera's axis, (H, W)."""

    def __init__(self, context: moderngl.Context, width: int, height: int) -> None:
        size = (width, height)
        self.size = size
        self.albedo = context.texture(size, 4)
        self.whose = context.texture(size, 4)
        self.normal = context.texture(size, 4, dtype="f2")
        self.depth = context.texture(size, 1, dtype="f4")
        self._z = context.depth_renderbuffer(size)
        self._textures = (self.albedo, self.whose, self.normal, self.depth)
        for texture in self._textures:
            texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
        self.frame = context.framebuffer(self._textures, self._z)

    def ids(self) -> npt.NDArray[np.int64]:
        """Numbers of the parts, from 1; 0: nothing."""
        raw = np.frombuffer(self.whose.read(alignment=1), dtype=np.uint8)
        width, height = self.size
        found = raw.reshape(height, width, 4)[::-1, :, :3].astype(np.int64)
        return np.asarray(found[..., 0] + 256 * found[..., 1] + 65536 * found[..., 2])

    def depth_m(self) -> npt.NDArray[np.float64]:
        """Depth along the camera's axis, metres; 0 where nothing is."""
        raw = np.frombuffer(self.depth.read(alignment=1), dtype=np.float32)
        width, height = self.size
        return raw.reshape(height, width)[::-1].astype(np.float64)

    def release(self) -> None:
        """Let go of all of it."""
        for held in (self.frame, self._z, *self._textures):
            held.release()
