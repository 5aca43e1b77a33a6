"""Windows: they fill holes cut through walls 0.12 m thick, exactly."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageFilter
from toolkit.materials import label
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick

from .joinery import Assembly, finish, steel
from .pictures import garden

Offset = tuple[float, float, float]
WALL = 0.12


def window(
    width: float = 1.2,
    height: float = 1.2,
    colour: str = "#f3f2ee",
    casements: int = 2,
    view: int = 0,
    frosted: bool = False,
    bars: tuple[int, int] | None = None,
    sash: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A window with a bright view; casements: number of lights side by side.

    bars: columns and rows of small panes in each light; sash: two halves that slide up and down.
    """
    asm, half, x, t = Assembly(), width / 2, WALL / 2, 0.045
    paint = finish(colour, 1, offset)
    for low, high in (
        ((-x, -half, 0), (x, -half + t, height)),
        ((-x, half - t, 0), (x, half, height)),
        ((-x, -half + t, height - t), (x, half - t, height)),
        ((-x, -half + t, 0), (x, half - t, t)),
    ):
        asm.board("body", low, high, paint)
    # window boards inside and out
    for a, b in ((-x - 0.018, -x), (x, x + 0.018)):
        asm.board(
            "body",
            (a, -half + 0.001, t - 0.022),
            (b, half - 0.001, t + 0.002),
            paint,
            0.004,
            solid=False,
        )
    step = (width - 2 * t) / casements
    for k in range(casements):
        ya, yb, w, d = -half + t + k * step, -half + t + (k + 1) * step, 0.045, 0.046
        for low, high in (
            ((-d, ya, t), (d, ya + w, height - t)),
            ((-d, yb - w, t), (d, yb, height - t)),
            ((-d, ya + w, t), (d, yb - w, t + w)),
            ((-d, ya + w, height - t - w), (d, yb - w, height - t)),
        ):
            asm.board("body", low, high, paint, 0.005, solid=False)
        y = yb - w / 2 if k == 0 else ya + w / 2
        for face in () if sash else (-1, 1):
            near, far = sorted((face * d, face * (d + 0.012)))
            low, high = (near, y - 0.008, height / 2 - 0.06), (far, y + 0.008, height / 2 + 0.02)
            asm.board("body", low, high, steel(30), 0.002, solid=False)
        if bars:
            inner_y, inner_z = (ya + w, yb - w), (t + w, height - t - w)
            for j in range(1, bars[0]):
                y = inner_y[0] + (inner_y[1] - inner_y[0]) * j / bars[0]
                low, high = (-0.042, y - 0.011, inner_z[0]), (0.042, y + 0.011, inner_z[1])
                asm.board("body", low, high, paint, solid=False)
            for j in range(1, bars[1]):
                z = inner_z[0] + (inner_z[1] - inner_z[0]) * j / bars[1]
                low, high = (-0.041, inner_y[0], z - 0.011), (0.041, inner_y[1], z + 0.011)
                asm.board("body", low, high, paint, solid=False)
    if sash:
        middle = height / 2
        low, high = (-0.05, -half + t, middle - 0.04), (0.05, half - t, middle + 0.04)
        asm.board("body", low, high, paint, 0.006, solid=False)
        for face in (-1, 1):
            near, far = sorted((face * 0.046, face * 0.064))
            low, high = (near, -0.03, middle + 0.005), (far, 0.03, middle + 0.03)
            asm.board("body", low, high, steel(30), 0.003, solid=False)
    tail = " with glazing bars" if bars else "" if casements < 3 else ", three lights"
    picture = garden(view, 256, int(256 * height / width)) if not frosted else _frosted()
    pane = label(picture, occlusion=0.0)
    # Through a clear pane the renderer shows the world outside; frosted glass is as it is made.
    name = "frosted" if frosted else "pane"
    low, high = (-0.037, -half + t + 0.02, t + 0.02), (0.037, half - t - 0.02, height - t - 0.02)
    asm.board(name, low, high, pane, 0, {"+x": pane, "-x": pane}, 2.0)
    return Model(
        title=f"{'bathroom ' if frosted else ''}{'sash ' if sash else ''}window{tail}",
        parts=asm.parts(**{name: {"rgba": (1.35, 1.35, 1.35, 1.0)}}),
        mass=28.0 * width * height,
    )


def _frosted(width: int = 128, height: int = 128) -> Image.Image:
    rng = np.random.default_rng(4)
    base = np.asarray(
        garden(9, width, height).convert("RGB").filter(ImageFilter.GaussianBlur(14)), float
    )
    cells = rng.standard_normal((height, width, 1))
    blurred = np.asarray(
        Image.fromarray((cells[..., 0] * 40 + 128).clip(0, 255).astype(np.uint8)).filter(
            ImageFilter.GaussianBlur(1.2)
        ),
        float,
    )
    return Image.fromarray(
        (0.35 * base + 150 + 0.9 * (blurred[..., None] - 128)).clip(0, 255).astype(np.uint8)
    )


def window_random(rng: np.random.Generator) -> dict:
    """Parameters of a random window."""
    return {
        "colour": pick(rng, ["#f3f2ee", "oak"]),
        "view": int(rng.integers(1000)),
        "offset": noise_offset(rng),
    }


def _small(colour: str, bars: tuple[int, int] | None = None, sash: bool = False) -> dict:
    """A bathroom window."""
    more = {"bars": bars} if bars else {}
    more |= {"sash": True} if sash else {}
    small = {"width": 0.6, "height": 0.6, "casements": 1, "frosted": True}
    return small | {"colour": colour} | more


MODELS = {
    "window": Maker(
        window,
        window_random,
        12,
        [
            {"casements": 2, "colour": "#f3f2ee"},
            {"casements": 3, "colour": "oak"},
            _small("#f3f2ee"),
            {"casements": 2, "colour": "#f3f2ee", "bars": (2, 3)},
            {"casements": 1, "colour": "#f3f2ee", "sash": True, "bars": (3, 2)},
            {"casements": 1, "colour": "#3c4044"},
            {"casements": 2, "colour": "#5f7a6a", "bars": (1, 2)},
            _small("oak", (2, 2)),
            # small ones for the frames that had none
            _small("#f3f2ee", (2, 2)),
            _small("#f3f2ee", (2, 2), True),
            _small("#3c4044"),
            _small("#5f7a6a", (1, 2)),
        ],
    ),
}
