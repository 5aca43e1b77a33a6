"""What stands on the ground of a world: blocks, and what is seen of their walls."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from sdgen.render.backdrop.canvas import Floats, Ints
from sdgen.render.backdrop.light import Light


class Wall(NamedTuple):
    """What of a wall is seen: along it and up it, metres, which way it looks, 0 to 3 for +x, -x,
    +y, -y, how long it is and how wide a pixel is there, metres, (N,)."""

    along_m: Floats
    up_m: Floats
    facing: Ints
    long_m: Floats
    pixel_m: Floats

    def some(self, which: Ints) -> Wall:
        """These pixels of it."""
        along, up, facing, long, pixel = self
        return Wall(along[which], up[which], facing[which], long[which], pixel[which])


#: From what is seen of a wall and the light on it (N, 3) to its colours (N, 3).
Painter = Callable[[Wall, Floats, Light, Floats, int], Floats]


class Block(NamedTuple):
    """A block on the ground from ``low`` to ``high`` (x, y), its walls so high. Its top is flat or
    rises by ``slope`` to a ridge along ``ridge`` (0: x, 1: y); ``tiled``: with tiles."""

    low: tuple[float, float]
    high: tuple[float, float]
    wall_m: float
    painter: Painter
    top: Floats
    slope: float = 0.0
    ridge: int = 0
    foot_m: float = 0.0
    seed: int = 0
    tiled: bool = False

    @property
    def away_m(self) -> float:
        """How far its nearest point is."""
        x, y = (max(self.low[k], -self.high[k], 0.0) for k in (0, 1))
        return float(np.hypot(x, y))

    @property
    def high_m(self) -> float:
        """Its highest point."""
        k = 1 - self.ridge
        return self.wall_m + self.slope * (self.high[k] - self.low[k]) / 2
