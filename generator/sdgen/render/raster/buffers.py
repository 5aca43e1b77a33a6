"""What the renderer draws into, for pictures of one size."""

from __future__ import annotations

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.render.raster.context import Held, release_all

_NEAREST = (moderngl.NEAREST, moderngl.NEAREST)


#: Colours are drawn at four places of each pixel, from its middle, turned so that no two lie on one
#: line across or down: a rotated grid (Akenine-Moeller 2003), for nearly level and upright edges.
#: The first lies opposite the third, the second opposite the fourth.
PLACES = ((-0.125, 0.375), (0.375, 0.125), (0.125, -0.375), (-0.375, -0.125))


class Buffers:
    """What is opaque: ``albedo`` and glow, ``fine_normal`` and ``fine_depth`` (OpenGL's, 0 to 1),
    where ``fine`` four times, in the four quarters of a picture of twice the size; normals, and
    depth along the camera's axis. What is seen through, the nearest of it: ``veil`` (colour and how
    much of it hides), ``veil_normal`` and ``veil_depth``. And whose each pixel is. All (H, W);
    depth is 0 where nothing is."""

    def __init__(self, context: moderngl.Context, width: int, height: int, fine: bool) -> None:
        size, larger = (width, height), (width, height)
        self.fine, self.apart = fine, (0, 0)
        if fine:
            larger, self.apart = (width * 2, height * 2), size
        self.size = size
        self.albedo, self.fine_normal = (context.texture(larger, 4) for _ in range(2))
        self.whose, self.veil = (context.texture(size, 4) for _ in range(2))
        self.normal, self.veil_normal = (context.texture(size, 4, dtype="f2") for _ in range(2))
        self.depth, self.veil_depth = (context.texture(size, 1, dtype="f4") for _ in range(2))
        z = context.depth_renderbuffer(size)
        self.fine_depth = context.depth_texture(larger)
        self.fine_depth.compare_func, self.fine_depth.filter = "", _NEAREST
        of_veils = (self.veil_normal, self.veil_depth, self.veil)
        self.colours = context.framebuffer([self.albedo, self.fine_normal], self.fine_depth)
        self.solid = context.framebuffer([self.whose, self.normal, self.depth], z)
        self.veils = context.framebuffer([self.whose, *of_veils], z)
        #: Emptied by themselves: whose pixels are and how deep has been drawn by then.
        self._own_veils = context.framebuffer(of_veils)
        frames = (self.colours, self.solid, self.veils, self._own_veils)
        finer = (self.albedo, self.fine_normal, self.fine_depth)
        textures = (*finer, self.whose, self.normal, self.depth, *of_veils)
        self._held: tuple[Held, ...] = (*frames, z, *textures)

    def clear(self) -> None:
        """Empty all of them."""
        for frame in (self._own_veils, self.solid, self.colours):
            frame.clear(0.0, 0.0, 0.0, 0.0)

    def ids(self) -> npt.NDArray[np.int64]:
        """Numbers of the parts, from 1; 0: nothing."""
        raw = np.frombuffer(self.whose.read(alignment=1), dtype="<u4")
        width, height = self.size
        return (raw.reshape(height, width)[::-1] & 0xFFFFFF).astype(np.int64)

    def depth_m(self, veiled: bool) -> npt.NDArray[np.float64]:
        """Depth along the camera's axis, metres; 0 where nothing is."""
        depth = self._plane(self.depth)
        if veiled:
            before = self._plane(self.veil_depth)
            depth = np.where(before > 0, before, depth)
        return depth.astype(np.float64)

    def _plane(self, texture: moderngl.Texture) -> npt.NDArray[np.float32]:
        width, height = self.size
        raw = np.frombuffer(texture.read(alignment=1), dtype=np.float32)
        return raw.reshape(height, width)[::-1]

    def release(self) -> None:
        """Let go of all of it."""
        release_all(self._held)
