"""Tileable room surfaces (floors, walls, ceiling), painted with numpy alone.

Plain Python, no Blender: ``python assets/blender/surfaces.py`` writes
``assets/textures/surface_<id>.png`` and the records that ``assemble.py`` puts under
``surfaces:`` of the manifest. Each surface draws from its own generator, seeded by its id, so
that adding one never changes another. Everything wraps around at the edges: the noise is shaped
in Fourier space, and the grids divide the tile evenly.
"""

from __future__ import annotations

import json
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


def soft_line(distance_px: Array, width_px: float) -> Array:
    """1 on a line, 0 beside it, with one pixel of blur."""
    return np.clip(width_px / 2 + 0.5 - distance_px, 0, 1)


def planks(
    rng: np.random.Generator,
    light: str,
    dark: str,
    rows: int = 12,
    size: int = 512,
    spread: float = 0.35,
    groove: float = 0.42,
) -> Array:
    """Floor boards along the columns, each with its own tone and grain, joints staggered."""
    y, x = np.mgrid[0:size, 0:size]
    height = size / rows
    row = (y // height).astype(int)
    across = np.minimum(y % height, height - y % height)
    grain_fine = tile_noise(rng, size, 90, (1, 14), 0.8)
    grain_broad = tile_noise(rng, size, 22, (1, 9), 1.2)
    pores = tile_noise(rng, size, 160, (1, 10), 0.4)
    tone = np.zeros((size, size))
    line = soft_line(across, 1.2) * 0.8
    shift = np.zeros((size, size), int)
    start = 0
    for r in range(rows):
        # Two boards a row; the joint moves by more than a fifth of a tile from row to row.
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
        joint = np.broadcast_to(soft_line(edge, 1.2) * 0.8, (size, size))
        line[inside] = np.maximum(line, joint)[inside]
    rolled = (x + shift) % size
    source = (y + shift * 7) % size
    grain = 0.55 * grain_broad[source, rolled] + 0.35 * grain_fine[source, rolled]
    mixture = np.clip(0.5 + 0.22 * tone + 0.13 * grain, 0, 1)[..., None]
    image = colour(dark) * (1 - mixture) + colour(light) * mixture
    image *= 1 - 0.07 * np.clip(pores[source, rolled] - 1.0, 0, 1.5)[..., None]
    return image * (1 - groove * line[..., None])


def tiles(
    rng: np.random.Generator,
    base: str,
    joint: str,
    count: int,
    columns: int | None = None,
    offset: bool = False,
    size: int = 512,
    spread: float = 0.012,
    cloud: float = 0.015,
    joint_px: float = 3.0,
) -> Array:
    """Ceramic tiles: ``count`` rows, ``columns`` columns, a soft bevel and a grout joint."""
    columns = columns or count
    y, x = np.mgrid[0:size, 0:size]
    high, wide = size / count, size / columns
    row = (y // high).astype(int)
    moved = (x + np.where((row % 2 == 1) & offset, wide / 2, 0)) % size
    col = (moved // wide).astype(int)
    to_row = np.minimum(y % high, high - y % high)
    to_col = np.minimum(moved % wide, wide - moved % wide)
    border = np.minimum(to_row, to_col)
    tone = rng.normal(0, spread, (count, columns))[row, col]
    turn = rng.integers(0, size, (count, columns))[row, col]
    broad = tile_noise(rng, size, 7, (1, 1), 0.75)[(y + turn) % size, (x + 3 * turn) % size]
    fine = tile_noise(rng, size, 160, (1, 1), 0.3)
    image = colour(base) * (1 + tone + cloud * broad + 0.006 * fine)[..., None]
    # A lit upper-left and a shaded lower-right edge make each tile slightly cushioned.
    bevel = np.clip(1 - (border - joint_px / 2) / 4, 0, 1)
    lit = np.where(np.minimum(y % high, moved % wide) == border, 1.0, -1.0)
    image *= (1 + 0.035 * bevel * lit)[..., None]
    grout = soft_line(border, joint_px)[..., None]
    grit = 1 + 0.03 * tile_noise(rng, size, 200, (1, 1), 0.2)[..., None]
    return image * (1 - grout) + colour(joint) * grit * grout


def plaster(rng: np.random.Generator, base: str, size: int = 256, rough: float = 1.0) -> Array:
    """Painted wall: roller grain and very faint clouds."""
    clouds = tile_noise(rng, size, 4, (1, 1), 1.6)
    roller = tile_noise(rng, size, 110, (1, 1), 0.3)
    relief = np.roll(roller, 1, 0) - np.roll(roller, -1, 0)
    value = 1 + rough * (0.002 * clouds + 0.008 * roller + 0.004 * relief)
    return colour(base) * value[..., None]


def carpet(rng: np.random.Generator, base: str, size: int = 256) -> Array:
    """Short pile: tufts in rough rows, two tones of yarn, wide brushed patches."""
    tuft = tile_noise(rng, size, 115, (1, 1), 0.2)
    yarn = tile_noise(rng, size, 60, (1, 1), 0.3)
    brushed = tile_noise(rng, size, 3, (1, 1.6), 1.4)
    value = 1 + 0.06 * tuft + 0.025 * yarn + 0.012 * brushed
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
    image = colour(base) * (shade[:, None] * (1 + (0.035 if wood else 0.004) * grain))[..., None]
    return image


def herringbone(
    rng: np.random.Generator, light: str, dark: str, long: int = 4, size: int = 512
) -> Array:
    """Parquet of blocks one wide and ``long`` long, laid at right angles to each other."""
    wide = size // (4 * long)
    y, x = np.mgrid[0:size, 0:size]
    row, col = y // wide, x // wide
    # Every block starts on a diagonal of cells: of 2 * long cells of a row, half lie along it.
    phase = (col - row) % (2 * long)
    lies = phase < long
    along = np.where(lies, x - (col - phase) * wide, y - (row - (2 * long - 1 - phase)) * wide)
    across = np.where(lies, y, x) % wide
    first_col = np.where(lies, col - phase, col) % (4 * long)
    first_row = np.where(lies, row, row - (2 * long - 1 - phase)) % (4 * long)
    tone = rng.normal(0, 1, (4 * long, 4 * long, 2))[first_row, first_col, lies.astype(int)]
    shift = rng.integers(0, size, (4 * long, 4 * long))[first_row, first_col]
    grain = tile_noise(rng, size, 60, (1, 10), 0.9)[(across + shift) % size, along % size]
    mixture = np.clip(0.5 + 0.16 * tone + 0.12 * grain, 0, 1)[..., None]
    edge = np.minimum.reduce([across, wide - across, along, long * wide - along])
    image = colour(dark) * (1 - mixture) + colour(light) * mixture
    return image * (1 - 0.35 * soft_line(edge, 1.2)[..., None])


Painter = Callable[[np.random.Generator], Array]
QUIET = ["living_room", "bedroom", "child_room", "dining_room", "office"]
DRY = [*QUIET, "hall", "corridor", "storage", "balcony"]
WET = ["kitchen", "bathroom", "toilet", "laundry"]

# id: (kind, width of the tile in metres, room types, painter)
SURFACES: dict[str, tuple[str, float, list[str], Painter]] = {
    "wood_oak": (
        "floor",
        1.5,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#c8a273", "#9d7448"),
    ),
    "wood_walnut": (
        "floor",
        1.5,
        DRY,
        lambda rng: planks(rng, "#916844", "#65442b", spread=0.4, groove=0.5),
    ),
    "wood_pale": (
        "floor",
        1.6,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#dccdb3", "#bda986", rows=10, spread=0.3, groove=0.3),
    ),
    "tile_white": (
        "floor",
        1.2,
        WET,
        lambda rng: tiles(rng, "#dddcd7", "#a9a8a3", 4),
    ),
    "tile_slate": (
        "floor",
        1.2,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#777c80", "#5a5d5f", 4, spread=0.02, cloud=0.02),
    ),
    "tile_beige": (
        "floor",
        0.99,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#cdbda3", "#a39580", 3, spread=0.012, cloud=0.012),
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
        0.9,
        WET,
        lambda rng: tiles(
            rng,
            "#f1f2f0",
            "#c9cbca",
            6,
            columns=3,
            offset=True,
            joint_px=2.5,
            spread=0.007,
            cloud=0.006,
        ),
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
        1.6,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#b4aa9c", "#8f867a", rows=10, spread=0.3, groove=0.35),
    ),
    "wood_smoked": (
        "floor",
        1.6,
        DRY,
        lambda rng: planks(rng, "#6d5646", "#4a382c", rows=10, spread=0.3, groove=0.45),
    ),
    "wood_pine": (
        "floor",
        1.5,
        [*DRY, "kitchen"],
        lambda rng: planks(rng, "#d9b985", "#b98f58", rows=10, spread=0.35, groove=0.4),
    ),
    "parquet_oak": (
        "floor",
        1.28,
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
        1.0,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#b0714f", "#9b8c7c", 4, spread=0.03, cloud=0.015),
    ),
    "tile_grey": (
        "floor",
        1.2,
        [*WET, "hall"],
        lambda rng: tiles(rng, "#b4b4b0", "#93938f", 4, columns=2, spread=0.012, cloud=0.01),
    ),
    "tile_wall_sand": (
        "wall",
        0.9,
        WET,
        lambda rng: tiles(rng, "#e6dccb", "#c9bfae", 6, columns=3, spread=0.01, cloud=0.006),
    ),
    "tile_wall_sage": (
        "wall",
        0.9,
        WET,
        lambda rng: tiles(
            rng,
            "#b9c9ba",
            "#d8dcd6",
            6,
            columns=3,
            offset=True,
            joint_px=2.5,
            spread=0.012,
            cloud=0.006,
        ),
    ),
    "tile_wall_blue": (
        "wall",
        0.9,
        WET,
        lambda rng: tiles(rng, "#b8cbd6", "#dde2e4", 6, joint_px=2.5, spread=0.012, cloud=0.006),
    ),
    "skirting_white": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#fdfcf8")),
    "skirting_tall": ("skirting", 0.13, DRY, lambda rng: skirting(rng, "#fbf9f3", step=0.7)),
    "skirting_oak": ("skirting", 0.07, DRY, lambda rng: skirting(rng, "#b98b58", wood=True)),
    "skirting_walnut": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#6d4a30", wood=True)),
    "skirting_pale": ("skirting", 0.07, DRY, lambda rng: skirting(rng, "#d9c3a0", wood=True)),
    "skirting_grey": ("skirting", 0.08, DRY, lambda rng: skirting(rng, "#8d8f90")),
    "splash_metro": (
        "splashback",
        0.8,
        ["kitchen"],
        lambda rng: tiles(
            rng, "#f3f3f0", "#bfc1c0", 8, columns=4, offset=True, joint_px=3.0, spread=0.008
        ),
    ),
    "splash_square": (
        "splashback",
        0.75,
        ["kitchen"],
        lambda rng: tiles(rng, "#ece4d2", "#cfc6b4", 5, joint_px=3.0, spread=0.012),
    ),
    "splash_grey": (
        "splashback",
        0.8,
        ["kitchen"],
        lambda rng: tiles(
            rng, "#9aa2a6", "#c9cccc", 8, columns=4, offset=True, joint_px=3.0, spread=0.02
        ),
    ),
    "splash_sage": (
        "splashback",
        0.75,
        ["kitchen"],
        lambda rng: tiles(rng, "#a9bba4", "#dfe2da", 7, joint_px=3.0, spread=0.025),
    ),
    "splash_blue": (
        "splashback",
        0.75,
        ["kitchen"],
        lambda rng: tiles(rng, "#7f9db3", "#e4e6e4", 7, joint_px=3.0, spread=0.03),
    ),
    "splash_slate": (
        "splashback",
        1.2,
        ["kitchen"],
        lambda rng: tiles(
            rng, "#4b4f53", "#3b3e41", 4, columns=2, offset=True, joint_px=2.0, spread=0.03
        ),
    ),
    "ceiling_white": (
        "ceiling",
        1.0,
        [*DRY, *WET],
        lambda rng: plaster(rng, "#fafaf7", rough=0.7),
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
