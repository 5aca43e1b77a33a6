"""Tileable room surfaces (floors, walls, ceiling), painted with numpy alone.

Plain Python, no Blender: ``python assets/blender/surfaces.py`` writes
``assets/textures/surface_<id>.png`` and the records that ``assemble.py`` puts under
``surfaces:`` of the manifest. Each surface draws from its own generator, seeded by its id, so
that adding one never changes another. Everything wraps around at the edges: the noise is shaped
in Fourier space, and the grids divide the tile evenly.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from zlib import crc32

import numpy as np
from PIL import Image

REPOSITORY = Path(__file__).resolve().parents[2]
TEXTURES = REPOSITORY / "assets" / "textures"
RECORDS = REPOSITORY / "build" / "assets" / "surfaces"

COLOURS = 64

Array = np.ndarray


def colour(code: str) -> Array:
    """``'#c8a070'`` as three floats in 0…1 (sRGB, as stored)."""
    code = code.lstrip("#")
    return np.array([int(code[i : i + 2], 16) / 255 for i in (0, 2, 4)])


def tile_noise(
    rng: np.random.Generator,
    size: int,
    fineness: float,
    stretch: tuple[float, float] = (1.0, 1.0),
    slope: float = 1.5,
) -> Array:
    """Periodic noise of zero mean and unit deviation, (size, size).

    ``fineness`` is the feature count along the tile; ``stretch`` > 1 lengthens the features
    along (rows, columns); ``slope`` is how fast finer detail fades.
    """
    spectrum = np.fft.rfft2(rng.standard_normal((size, size)))
    row = np.fft.fftfreq(size, 1 / size)[:, None] * stretch[0]
    col = np.fft.rfftfreq(size, 1 / size)[None, :] * stretch[1]
    radius = np.hypot(row, col) / fineness
    weight = radius**2 / (1 + radius ** (2 + 2 * slope))
    field = np.fft.irfft2(spectrum * weight, s=(size, size))
    return (field - field.mean()) / field.std()


#: What a clean white paint or glaze gives back of the light it gets: pictures are lit by what
#: bounces between walls, and walls that gave back nearly all of it would glow.
WHITEST = 0.82


def paint(code: str) -> Array:
    """A colour of paint or glaze as stored, none brighter than real white."""
    stored = colour(code)
    bright = np.where(stored <= 0.04045, stored / 12.92, ((stored + 0.055) / 1.055) ** 2.4)
    bright = bright * min(1.0, WHITEST / bright.max())
    return np.where(bright <= 0.0031308, bright * 12.92, 1.055 * bright ** (1 / 2.4) - 0.055)


def soft_line(distance_px: Array, width_px: float) -> Array:
    """How much of a pixel a line covers: lines may be thinner than a pixel."""
    return np.clip(width_px / 2 + 0.5 - distance_px, 0, min(1.0, width_px))


def planks(
    rng: np.random.Generator,
    light: str,
    dark: str,
    rows: int = 16,
    size: int = 512,
    spread: float = 0.35,
    groove: float = 0.42,
) -> Array:
    """Floor boards along the columns, each with its own tone and grain, joints staggered; two
    boards a row."""
    y, x = np.mgrid[0:size, 0:size]
    height = size / rows
    row = (y // height).astype(int)
    across = np.minimum(y % height, height - y % height)
    grain_fine = tile_noise(rng, size, 140, (1, 16), 0.8)
    grain_broad = tile_noise(rng, size, 40, (1, 12), 1.2)
    pores = tile_noise(rng, size, 200, (1, 10), 0.4)
    tone = np.zeros((size, size))
    line = soft_line(across, 0.7)
    shift = np.zeros((size, size), int)
    start = 0
    for r in range(rows):
        # The joint moves by more than a fifth of the picture from row to row.
        start = (start + int(rng.integers(size // 5, size // 2))) % size
        length = int(rng.integers(size * 2 // 5, size * 3 // 5))
        place = (np.arange(size) - start) % size
        first = place < length
        inside = row == r
        tones = rng.normal(0, spread, 2)
        shifts = rng.integers(0, size, 2)
        tone[inside] = np.broadcast_to(np.where(first, *tones), (size, size))[inside]
        shift[inside] = np.broadcast_to(np.where(first, *shifts), (size, size))[inside]
        edge = np.minimum.reduce([place, size - place, np.abs(place - length)])
        joint = np.broadcast_to(soft_line(edge, 0.7), (size, size))
        line[inside] = np.maximum(line, joint)[inside]
    rolled = (x + shift) % size
    source = (y + shift * 7) % size
    grain = 0.55 * grain_broad[source, rolled] + 0.35 * grain_fine[source, rolled]
    mixture = np.clip(0.5 + 0.2 * tone + 0.12 * grain, 0, 1)[..., None]
    image = colour(dark) * (1 - mixture) + colour(light) * mixture
    image *= 1 - 0.05 * np.clip(pores[source, rolled] - 1.0, 0, 1.5)[..., None]
    return image * (1 - groove * line[..., None])


def tiles(
    rng: np.random.Generator,
    base: str,
    joint: str,
    rows: int,
    columns: int | None = None,
    offset: float = 0.0,
    size: int = 512,
    spread: float = 0.006,
    stone: float = 0.0,
    joint_px: float = 1.2,
) -> Array:
    """Ceramic tiles in ``rows`` and ``columns``, every other row moved by a share of a tile. Each
    has a tone of its own; within one it is even, or mottled as ``stone`` is."""
    columns = columns or rows
    y, x = np.mgrid[0:size, 0:size]
    high, wide = size / rows, size / columns
    row = (y // high).astype(int)
    moved = (x + (row % 2) * offset * wide) % size
    col = np.minimum((moved // wide).astype(int), columns - 1)
    to_row = np.minimum(y % high, high - y % high)
    to_col = np.minimum(moved % wide, wide - moved % wide)
    border = np.minimum(to_row, to_col)
    tone = 1 + rng.normal(0, spread, (rows, columns))[row, col]
    warmth = rng.normal(0, spread / 5, (rows, columns))[row, col]
    tone = tone[..., None] * (1 + warmth[..., None] * np.array([1.0, 0.0, -1.0]))
    if stone:
        turn = rng.integers(0, size, (rows, columns))[row, col]
        veins = tile_noise(rng, size, 60, (1, 1.5), 0.8)[(y + turn) % size, (x + 3 * turn) % size]
        tone = tone * (1 + stone * veins[..., None])
    image = paint(base) * tone * (1 + 0.002 * tile_noise(rng, size, 200, (1, 1), 0.2)[..., None])
    grout = soft_line(border, joint_px)[..., None]
    return image * (1 - grout) + paint(joint) * grout


def cement_tiles(
    rng: np.random.Generator, base: str, figure: str, count: int = 6, size: int = 512
) -> Array:
    """Cement tiles with a figure: rings about every other corner, a star in their midst."""
    image = tiles(rng, base, "#a9a69e", count, size=size, spread=0.012, stone=0.008, joint_px=0.7)
    y, x = (np.mgrid[0:size, 0:size] + 0.5) * count / size
    # From the corner where four tiles make a figure, and from that between figures.
    dx, dy = (np.abs((at + 1) % 2 - 1) for at in (x, y))
    ex, ey = 1 - dx, 1 - dy
    pixel = count / size
    ring = np.abs(np.hypot(dx, dy) - 0.8) - 0.06
    star = np.minimum(np.maximum(dx, dy), (dx + dy) / math.sqrt(2)) - 0.3
    inner = np.hypot(dx, dy) - 0.14
    diamond = (ex + ey) / math.sqrt(2) - 0.17
    cover = np.clip(
        0.5 - np.minimum.reduce([ring, np.maximum(star, -inner), diamond]) / pixel, 0, 1
    )
    return image * (1 - cover[..., None] * (1 - paint(figure) / paint(base)))


def plaster(rng: np.random.Generator, base: str, size: int = 256, rough: float = 1.0) -> Array:
    """Painted wall: the fine grain that a roller leaves, and nothing broader, which would be seen
    again and again along a wall."""
    roller = tile_noise(rng, size, 120, (1, 1), 0.2)
    return paint(base) * (1 + rough * 0.006 * roller)[..., None]


def striped_paper(rng: np.random.Generator, base: str, stripe: str, size: int = 256) -> Array:
    """Wallpaper with stripes up the wall: broad ones, each with a thin one beside it."""
    place = (np.arange(size) % 64) + 0.5
    broad = np.clip(16.5 - np.abs(place - 20), 0, 1)
    thin = np.clip(2 - np.abs(place - 50), 0, 1)
    share = np.maximum(broad, thin)[None, :, None]
    weave = 1 + 0.006 * tile_noise(rng, size, 110, (1, 3), 0.3)[..., None]
    return (paint(base) * (1 - share) + paint(stripe) * share) * weave


def sprigged_paper(rng: np.random.Generator, base: str, leaf: str, size: int = 256) -> Array:
    """Wallpaper with small sprigs, each row moved by half their distance."""
    y, x = np.mgrid[0:size, 0:size] + 0.5
    cover = np.zeros((size, size))
    step = size // 4
    for row in range(4):
        for column in range(4):
            left = (column + (row % 2) / 2 + 0.25) * step
            dx = (x - left + size / 2) % size - size / 2
            dy = (y - (row + 0.5) * step + size / 2) % size - size / 2
            if (row + column) % 2:
                dx = -dx
            stem = np.abs(dx - 0.004 * dy**2) - 0.7
            cover = np.maximum(cover, np.clip(0.5 - stem, 0, 1) * (np.abs(dy) < 17))
            for k, (up, side) in enumerate(((-13, 1), (-6, -1), (1, 1), (8, -1), (-19, 0))):
                turn = side * 0.7
                ox, oy = dx - side * 5 - 0.004 * up**2, dy - up
                u = ox * np.sin(turn) - oy * np.cos(turn)
                v = ox * np.cos(turn) + oy * np.sin(turn)
                long = 6.5 - 0.4 * k
                shape = (np.hypot(u / long, v / (long * 0.42)) - 1) * long * 0.42
                cover = np.maximum(cover, np.clip(0.5 - shape, 0, 1))
    weave = 1 + 0.006 * tile_noise(rng, size, 110, (1, 1), 0.3)[..., None]
    share = cover[..., None]
    return (paint(base) * (1 - share) + paint(leaf) * share) * weave


def boarded(rng: np.random.Generator, base: str, count: int = 8, size: int = 256) -> Array:
    """Painted boards up a wall, tongue in groove."""
    wide = size / count
    place = np.arange(size) % wide
    gap = soft_line(np.minimum(place, wide - place), 1.1)[None, :, None]
    tone = 1 + rng.normal(0, 0.004, count)[(np.arange(size) // wide).astype(int)]
    brush = 1 + 0.006 * tile_noise(rng, size, 100, (12, 1), 0.4)
    return paint(base) * (tone[None, :] * brush)[..., None] * (1 - 0.3 * gap)


def veneer(rng: np.random.Generator, light: str, dark: str, size: int = 512) -> Array:
    """Panels of veneer, two side by side, the grain up the wall."""
    x = np.arange(size)
    half = size // 2
    broad, fine = tile_noise(rng, size, 30, (16, 1), 1.0), tile_noise(rng, size, 130, (14, 1), 0.6)
    # The second panel is the first turned over, as veneers are laid.
    source = np.where(x < half, x, size - 1 - x)
    grain = 0.5 * broad[:, source] + 0.3 * fine[:, source]
    mixture = np.clip(0.5 + 0.16 * grain, 0, 1)[..., None]
    image = colour(dark) * (1 - mixture) + colour(light) * mixture
    joint = soft_line(np.minimum(x % half, half - x % half), 1.2)[None, :, None]
    return image * (1 - 0.45 * joint)


def carpet(rng: np.random.Generator, base: str, size: int = 256) -> Array:
    """Short pile: tufts in rough rows, two tones of yarn."""
    tuft = tile_noise(rng, size, 115, (1, 1), 0.2)
    yarn = tile_noise(rng, size, 80, (1, 1), 0.3)
    value = 1 + 0.05 * tuft + 0.02 * yarn
    image = colour(base) * value[..., None]
    image += np.clip(yarn - 1.3, 0, 1)[..., None] * np.array([0.02, 0.02, 0.025])
    return image


def skirting(
    rng: np.random.Generator, base: str, wood: bool = False, step: float = 0.0, size: int = 128
) -> Array:
    """A board along the foot of a wall, the top of the picture its upper edge: a rounded edge with
    the shadow of what stands out below it, and, ``step`` of its height down, a moulding."""
    up = 1 - (np.arange(size) + 0.5) / size
    shade = 1 - 0.25 * np.exp(-((up / 0.06) ** 2))
    shade += 0.06 * np.exp(-(((up - 0.8) / 0.06) ** 2)) - 0.45 * np.exp(-(((up - 1) / 0.09) ** 2))
    if step:
        shade -= 0.3 * np.exp(-(((up - step) / 0.03) ** 2))
    grain = tile_noise(rng, size, 9, (12.0, 0.4), 0.7) if wood else tile_noise(rng, size, 40)
    base_colour = colour(base) if wood else paint(base)
    return base_colour * (shade[:, None] * (1 + (0.035 if wood else 0.004) * grain))[..., None]


def herringbone(
    rng: np.random.Generator, light: str, dark: str, long: int = 4, size: int = 512
) -> Array:
    """Parquet of blocks one wide and ``long`` long, laid at right angles to each other; so many
    cells that the pattern comes again but after two metres."""
    cells = 8 * long
    wide = size // cells
    y, x = np.mgrid[0:size, 0:size]
    row, col = y // wide, x // wide
    # Every block starts on a diagonal of cells: of 2 * long cells of a row, half lie along it.
    phase = (col - row) % (2 * long)
    lies = phase < long
    along = np.where(lies, x - (col - phase) * wide, y - (row - (2 * long - 1 - phase)) * wide)
    across = np.where(lies, y, x) % wide
    first_col = np.where(lies, col - phase, col) % cells
    first_row = np.where(lies, row, row - (2 * long - 1 - phase)) % cells
    tone = rng.normal(0, 1, (cells, cells, 2))[first_row, first_col, lies.astype(int)]
    shift = rng.integers(0, size, (cells, cells))[first_row, first_col]
    grain = tile_noise(rng, size, 110, (1, 10), 0.9)[(across + shift) % size, along % size]
    mixture = np.clip(0.5 + 0.14 * tone + 0.11 * grain, 0, 1)[..., None]
    edge = np.minimum.reduce([across, wide - across, along, long * wide - along])
    image = colour(dark) * (1 - mixture) + colour(light) * mixture
    return image * (1 - 0.35 * soft_line(edge, 0.7)[..., None])


Painter = Callable[[np.random.Generator], Array]
QUIET = ["living_room", "bedroom", "child_room", "dining_room", "office"]
DRY = [*QUIET, "hall", "corridor", "storage", "balcony"]
WET = ["kitchen", "bathroom", "toilet", "laundry"]

# id: (kind, width of the tile in metres, room types, painter)
SURFACES: dict[str, tuple[str, float, list[str], Painter]] = {
    "wood_oak": (
        "floor",
        2.4,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#c8a273", "#9d7448", rows=20),
    ),
    "wood_walnut": (
        "floor",
        2.4,
        DRY,
        lambda rng: planks(rng, "#916844", "#65442b", rows=20, spread=0.4, groove=0.5),
    ),
    "wood_pale": (
        "floor",
        2.4,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#dccdb3", "#bda986", rows=14, spread=0.3, groove=0.3),
    ),
    "tile_white": (
        "floor",
        2.4,
        WET,
        lambda rng: tiles(rng, "#dddcd7", "#a9a8a3", 8, joint_px=0.7),
    ),
    "tile_slate": (
        "floor",
        2.4,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#777c80", "#5a5d5f", 4, spread=0.02, stone=0.012, joint_px=0.7),
    ),
    "tile_beige": (
        "floor",
        1.8,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#cdbda3", "#a39580", 4, spread=0.01, stone=0.008, joint_px=0.9),
    ),
    "carpet_grey": (
        "floor",
        0.6,
        QUIET,
        lambda rng: carpet(rng, "#a3a19e"),
    ),
    "plaster_white": (
        "wall",
        1.0,
        [*DRY, *WET],
        lambda rng: plaster(rng, "#f3f1eb"),
    ),
    "plaster_warm": (
        "wall",
        1.0,
        [*DRY, "kitchen"],
        lambda rng: plaster(rng, "#efe2cb"),
    ),
    "plaster_sage": (
        "wall",
        1.0,
        [*QUIET, "kitchen"],
        lambda rng: plaster(rng, "#ccd5bf"),
    ),
    "plaster_blue": (
        "wall",
        1.0,
        DRY,
        lambda rng: plaster(rng, "#c4d2dd"),
    ),
    "plaster_sand": (
        "wall",
        1.0,
        DRY,
        lambda rng: plaster(rng, "#e2ccab", rough=1.3),
    ),
    "tile_wall_white": (
        "wall",
        1.2,
        WET,
        lambda rng: tiles(rng, "#f1f2f0", "#c3c5c4", 12, columns=4, offset=0.5, spread=0.004),
    ),
    "plaster_grey": (
        "wall",
        1.0,
        [*DRY, "kitchen"],
        lambda rng: plaster(rng, "#d5d6d4"),
    ),
    "plaster_cream": (
        "wall",
        1.0,
        [*DRY, *WET],
        lambda rng: plaster(rng, "#f3ead8"),
    ),
    "plaster_blush": (
        "wall",
        1.0,
        QUIET,
        lambda rng: plaster(rng, "#e8d2c8"),
    ),
    "plaster_olive": (
        "wall",
        1.0,
        QUIET,
        lambda rng: plaster(rng, "#b9bc9d"),
    ),
    "plaster_clay": (
        "wall",
        1.0,
        QUIET,
        lambda rng: plaster(rng, "#d6b49b"),
    ),
    "plaster_mint": (
        "wall",
        1.0,
        [*QUIET, "kitchen", "bathroom"],
        lambda rng: plaster(rng, "#d3e3d8"),
    ),
    "plaster_lemon": (
        "wall",
        1.0,
        ["child_room", "kitchen", "bedroom"],
        lambda rng: plaster(rng, "#f3e8bd"),
    ),
    "plaster_lilac": (
        "wall",
        1.0,
        ["child_room", "bedroom"],
        lambda rng: plaster(rng, "#dcd3e2"),
    ),
    "plaster_slate": (
        "wall",
        1.0,
        ["living_room", "bedroom", "office"],
        lambda rng: plaster(rng, "#8f9aa3"),
    ),
    "wood_grey": (
        "floor",
        2.4,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#b4aa9c", "#8f867a", rows=13, spread=0.3, groove=0.35),
    ),
    "wood_smoked": (
        "floor",
        2.4,
        DRY,
        lambda rng: planks(rng, "#6d5646", "#4a382c", rows=16, spread=0.3, groove=0.45),
    ),
    "wood_pine": (
        "floor",
        2.4,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#d9b985", "#b98f58", rows=18, spread=0.35, groove=0.4),
    ),
    "parquet_oak": (
        "floor",
        2.24,
        DRY,
        lambda rng: herringbone(rng, "#c6a274", "#9c774c"),
    ),
    "carpet_sand": (
        "floor",
        0.6,
        QUIET,
        lambda rng: carpet(rng, "#b9ab96"),
    ),
    "tile_terracotta": (
        "floor",
        2.4,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#b0714f", "#9b8c7c", 8, spread=0.025, stone=0.01, joint_px=1.1),
    ),
    "tile_grey": (
        "floor",
        2.4,
        [*WET, "hall"],
        lambda rng: tiles(
            rng,
            "#b4b4b0",
            "#93938f",
            8,
            columns=4,
            offset=0.5,
            spread=0.008,
            stone=0.004,
            joint_px=0.7,
        ),
    ),
    "tile_wall_sand": (
        "wall",
        1.2,
        WET,
        lambda rng: tiles(
            rng, "#e6dccb", "#c4b9a8", 4, columns=2, spread=0.006, stone=0.005, joint_px=1.0
        ),
    ),
    "tile_wall_sage": (
        "wall",
        1.2,
        WET,
        lambda rng: tiles(rng, "#b9c9ba", "#d2d6d0", 12, columns=6, offset=0.5, spread=0.009),
    ),
    "tile_wall_blue": (
        "wall",
        1.2,
        WET,
        lambda rng: tiles(rng, "#b8cbd6", "#d6dbdd", 8, spread=0.009),
    ),
    "skirting_white": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#fdfcf8")),
    "skirting_tall": ("skirting", 0.13, DRY, lambda rng: skirting(rng, "#fbf9f3", step=0.7)),
    "skirting_oak": ("skirting", 0.07, DRY, lambda rng: skirting(rng, "#b98b58", wood=True)),
    "skirting_walnut": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#6d4a30", wood=True)),
    "skirting_pale": ("skirting", 0.07, DRY, lambda rng: skirting(rng, "#d9c3a0", wood=True)),
    "skirting_grey": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#8d8f90")),
    "splash_metro": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(rng, "#f3f3f0", "#bfc1c0", 16, columns=8, offset=0.5, spread=0.005),
    ),
    "splash_square": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(rng, "#ece4d2", "#cbc2b2", 12, spread=0.007),
    ),
    "splash_grey": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(rng, "#9aa2a6", "#c0c4c4", 16, columns=4, offset=0.5, spread=0.012),
    ),
    "splash_sage": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(rng, "#a9bba4", "#dfe2da", 12, spread=0.02),
    ),
    "splash_blue": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(rng, "#7f9db3", "#dcdedc", 16, spread=0.022),
    ),
    "splash_slate": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(
            rng, "#4b4f53", "#3b3e41", 4, columns=2, spread=0.02, stone=0.012, joint_px=0.9
        ),
    ),
    "parquet_walnut": ("floor", 2.24, DRY, lambda rng: herringbone(rng, "#8d6646", "#5f4230")),
    "tile_cement": (
        "floor",
        1.2,
        [*WET, "hall"],
        lambda rng: cement_tiles(rng, "#cfcdc6", "#6f7f88"),
    ),
    "paper_stripe": (
        "wall",
        0.36,
        QUIET,
        lambda rng: striped_paper(rng, "#dde0dc", "#d0d6d4"),
    ),
    "paper_sprig": (
        "wall",
        0.48,
        QUIET,
        lambda rng: sprigged_paper(rng, "#ece6d8", "#c3cbb4"),
    ),
    "panel_white": ("wall", 1.0, DRY, lambda rng: boarded(rng, "#f1efe9")),
    "panel_oak": (
        "wall",
        1.2,
        ["living_room", "bedroom", "office", "dining_room", "hall"],
        lambda rng: veneer(rng, "#c6a577", "#a98355"),
    ),
    "ceiling_white": (
        "ceiling",
        1.0,
        [*DRY, *WET],
        lambda rng: plaster(rng, "#fafaf7", rough=0.5),
    ),
}


def save_png(image: Array, path: Path) -> None:
    """Write 0…1 floats as a PNG of few colours (no visible loss at these contrasts)."""
    eight_bit = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8)
    picture = Image.fromarray(eight_bit).quantize(
        COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE
    )
    picture.save(path, optimize=True)


def surface(surface_id: str) -> Array:
    """The picture of one surface, (size, size, 3) floats in 0…1."""
    rng = np.random.default_rng([crc32(surface_id.encode()), 0])
    return SURFACES[surface_id][3](rng)


def main() -> None:
    """Write every texture and the records."""
    TEXTURES.mkdir(parents=True, exist_ok=True)
    RECORDS.mkdir(parents=True, exist_ok=True)
    for surface_id, (kind, size_m, rooms, _) in SURFACES.items():
        name = f"surface_{surface_id}.png"
        save_png(surface(surface_id), TEXTURES / name)
        record = {
            "id": surface_id,
            "kind": kind,
            "texture": f"textures/{name}",
            "size_m": size_m,
            "rooms": rooms,
        }
        (RECORDS / f"{surface_id}.json").write_text(json.dumps(record))


if __name__ == "__main__":
    main()
