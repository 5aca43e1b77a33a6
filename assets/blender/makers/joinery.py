"""What furniture makers share: boards that are also collision boxes, fronts, handles, cloth.

Coordinates: the front faces +X, y is the width, seen from the front the right is +Y.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Joint, Part, Support, box_piece, rectangle
from toolkit.shapes import box, loft, rounded_rectangle, tube

Point = Sequence[float]


class Assembly:
    """Meshes and collision pieces, gathered part by part."""

    def __init__(self) -> None:
        self.meshes: dict[str, list[Mesh]] = {}
        self.pieces: dict[str, list[np.ndarray]] = {}

    def add(self, part: str, mesh: Mesh, solid: bool = False) -> Mesh:
        """Add a mesh; `solid` gives it its bounding box as a collision piece."""
        self.meshes.setdefault(part, []).append(mesh)
        if solid:
            low, high = mesh.v.min(0), mesh.v.max(0)
            self.solid(part, low, high)
        return mesh

    def solid(self, part: str, low: Point, high: Point) -> None:
        """A collision box between two corners."""
        low, high = np.asarray(low, float), np.asarray(high, float)
        self.pieces.setdefault(part, []).append(box_piece((low + high) / 2, high - low))

    def piece(self, part: str, points: np.ndarray) -> None:
        """Any convex collision piece."""
        self.pieces.setdefault(part, []).append(np.asarray(points, float))

    def board(
        self,
        part: str,
        low: Point,
        high: Point,
        mat: Material,
        bevel: float = 0.0,
        labels: dict | None = None,
        weight: float = 1.0,
        solid: bool = True,
        segments: int = 1,
    ) -> Mesh:
        """A box between two corners that is drawn and, unless told otherwise, collides."""
        low, high = np.asarray(low, float), np.asarray(high, float)
        size, centre = high - low, (low + high) / 2
        at = (centre[0], centre[1], low[2])
        mesh = box(*size, at, mat, bevel, segments, labels=labels, weight=weight)
        return self.add(part, mesh, solid)

    def parts(self, **settings: dict) -> dict[str, Part]:
        """The parts, in order of first use; settings by part name, e.g. door={"joint": "door"}."""
        result = {}
        for name, meshes in self.meshes.items():
            pieces = self.pieces.get(name)
            result[name] = Part(meshes, collision=pieces or "none", **settings.get(name, {}))
        return result


# ---- boards put together
def carcass(
    asm: Assembly,
    part: str,
    low: Point,
    high: Point,
    outside: Material,
    inside: Material,
    thickness: float = 0.018,
    back: float = 0.008,
    bevel: float = 0.0015,
    top: bool = True,
) -> None:
    """An open-fronted case: two sides, bottom, top and back; the inner faces wear `inside`."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    t = thickness
    board = asm.board
    board(part, (x0, y0, z0), (x1, y0 + t, z1), outside, bevel, {"+y": inside})
    board(part, (x0, y1 - t, z0), (x1, y1, z1), outside, bevel, {"-y": inside})
    board(part, (x0, y0 + t, z0), (x1, y1 - t, z0 + t), outside, 0, {"+z": inside})
    if top:
        board(part, (x0, y0 + t, z1 - t), (x1, y1 - t, z1), outside, 0, {"-z": inside})
    inner_top = z1 - t if top else z1
    board(part, (x0, y0 + t, z0 + t), (x0 + back, y1 - t, inner_top), outside, 0, {"+x": inside})


def front(
    asm: Assembly,
    part: str,
    x: float,
    y: tuple[float, float],
    z: tuple[float, float],
    mat: Material,
    style: str = "slab",
    thickness: float = 0.018,
    rail: float = 0.06,
    recess: Material | None = None,
) -> None:
    """A door or drawer front whose back lies at x: slab, or shaker (a frame round a panel)."""
    (y0, y1), (z0, z1) = y, z
    if style == "slab":
        asm.board(part, (x, y0, z0), (x + thickness, y1, z1), mat, 0.0025)
        return
    r = min(rail, 0.3 * (z1 - z0), 0.3 * (y1 - y0))
    outer, inner = x + thickness, x + thickness - 0.007
    asm.solid(part, (x, y0, z0), (outer, y1, z1))
    panel = recess or mat
    asm.board(part, (x, y0 + r, z0 + r), (inner, y1 - r, z1 - r), panel, 0, solid=False)
    for a, b in ((y0, y0 + r), (y1 - r, y1)):
        asm.board(part, (x, a, z0), (outer, b, z1), mat, 0.002, solid=False)
    for a, b in ((z0, z0 + r), (z1 - r, z1)):
        asm.board(part, (x, y0 + r, a), (outer, y1 - r, b), mat, 0.002, solid=False)


def bar_handle(
    asm: Assembly,
    part: str,
    x: float,
    y: float,
    z: float,
    length: float,
    mat: Material,
    vertical: bool = True,
    reach: float = 0.03,
    radius: float = 0.006,
) -> None:
    """A bar on two posts, centred on (y, z), on a front whose outer face lies at x."""
    half = length / 2
    offset = (lambda s: (0.0, s)) if vertical else (lambda s: (s, 0.0))
    bar_x = x + reach - radius
    ends = [(bar_x, y + offset(s)[0], z + offset(s)[1]) for s in (-half, half)]
    asm.add(part, tube(ends, radius, 6, mat=mat))
    for s in (-0.8 * half, 0.8 * half):
        dy, dz = offset(s)
        post = radius * 1.2
        asm.board(
            part,
            (x - 0.001, y + dy - post / 2, z + dz - post / 2),
            (bar_x, y + dy + post / 2, z + dz + post / 2),
            mat,
            solid=False,
        )


def drawer_box(
    asm: Assembly,
    part: str,
    low: Point,
    high: Point,
    mat: Material,
    wall: float = 0.012,
) -> None:
    """The open-topped box behind a drawer front (the front closes it at high x)."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    asm.board(part, (x0, y0, z0), (x1, y1, z0 + 0.008), mat)
    asm.board(part, (x0, y0, z0 + 0.008), (x1, y0 + wall, z1), mat)
    asm.board(part, (x0, y1 - wall, z0 + 0.008), (x1, y1, z1), mat)
    asm.board(part, (x0, y0 + wall, z0 + 0.008), (x0 + wall, y1 - wall, z1), mat)


def leg(
    asm: Assembly,
    part: str,
    foot: tuple[float, float],
    head: tuple[float, float],
    z: tuple[float, float],
    radius: tuple[float, float],
    mat: Material,
    sides: int = 8,
) -> None:
    """A tapered leg from the floor (`foot`) up to `head`; sides = 4 gives a square one."""
    (xf, yf), (xh, yh), (z0, z1) = foot, head, z
    if sides == 4:
        square = rounded_rectangle(2, 2, 0.18, 2)
    else:
        t = np.arange(sides) * 2 * np.pi / sides
        square = np.c_[np.cos(t), np.sin(t)]
    rings = [
        np.c_[square * r + [x, y], np.full(len(square), height)]
        for x, y, height, r in ((xf, yf, z0, radius[0]), (xh, yh, z1, radius[1]))
    ]
    mesh = cube_project(loft(rings, mat)) if sides == 4 else loft(rings, mat)
    asm.add(part, mesh)
    asm.piece(part, np.concatenate([ring[:: max(1, len(ring) // 8)] for ring in rings]))


def cushion(
    size: Point,
    at: Point,
    mat: Material,
    radius: float = 0.05,
    crown: float = 0.02,
    edge: float = 0.04,
) -> Mesh:
    """A stuffed block standing on `at`: rounded in plan, rounded edges, a domed top."""
    sx, sy, sz = size
    edge = min(edge, sz * 0.45)
    short = min(sx, sy) / 2
    # (inset, height): up the side, over the edge, in towards the middle of the dome
    section = [(edge * 0.8, 0), (edge * 0.2, edge * 0.3), (0, edge), (0, sz - edge)]
    section += [(edge * 0.3, sz - edge * 0.3), (edge, sz)]
    # in a narrow dome further rings would leave a last strip of a few millimetres: a black slit
    for t in (0.22, 0.52, 0.85) if short - edge > 0.045 else (0.35,):
        section.append((edge + (short - edge) * t, sz + crown * (1 - (1 - t) ** 2)))
    rings = []
    for inset, z in section:
        # the corners get rounder inwards, or creases would run up the dome from them
        r = min(max(radius - 0.5 * inset, 0.35 * inset + 0.015), (short - inset) * 0.95)
        outline = rounded_rectangle(sx - 2 * inset, sy - 2 * inset, r, 3)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    # the loft's own strip of texture round the side: projected, its hidden rest would fall apart
    # into slivers
    mesh = loft(rings, mat)
    # in one piece over the dome: a strip round it would draw out its last texels to a star
    side, count = section.index((edge, sz)), len(rings[0])
    top = range(side * count, (len(rings) - 1) * count)
    aside = 4 * (sx + sy + sz)
    for face in (*top, len(mesh.f) - 1):
        mesh.bake_uv[face] = [(aside + mesh.v[i][0], mesh.v[i][1]) for i in mesh.f[face]]
    return mesh.move(*at)


# ---- materials
def fabric(colour: str, offset: Point = (0, 0, 0), amount: float = 0.09) -> Material:
    """Upholstery: uneven dye, brushed patches and a visible weave."""
    m = Material()
    patches = m.remap(m.noise(7, 3, offset=offset), 0.3, 0.7, 0, 0.7)
    base = m.mix(patches, shade(colour, 1 - amount), shade(colour, 1 + amount))
    weave = m.remap(m.noise(110, 2, offset=offset, stretch=(1, 1, 1.7)), 0.35, 0.65, 0, 0.5)
    return m.colour(m.mix(weave, base, shade(colour, 1 - 1.6 * amount)))


def stone(colour: str, fleck: str, offset: Point = (0, 0, 0)) -> Material:
    """A speckled worktop."""
    m = Material()
    cloud = m.remap(m.noise(9, 4, offset=offset), 0.3, 0.7, 0, 0.5)
    base = m.mix(cloud, colour, shade(colour, 0.9))
    spots = m.remap(m.noise(140, 2, offset=offset), 0.58, 0.68, 0, 0.55)
    return m.colour(m.mix(spots, base, fleck))


WOODS = {
    "oak": ("c9a06a", "9a7142"),
    "walnut": ("7d5636", "4f331d"),
    "pine": ("dcb983", "b98e56"),
    "birch": ("e2cda6", "c6aa7c"),
    "teak": ("a8713f", "774a24"),
    "black": ("3b3734", "242120"),
}


def timber(kind: str, grain_axis: int = 0, offset: Point = (0, 0, 0)) -> Material:
    """Wood by name; scale and contrast suit furniture."""
    light, dark = WOODS[kind]
    return wood(light, dark, grain_axis, 5.0, tuple(offset), 0.8)


def finish(name: str, grain_axis: int = 2, offset: Point = (0, 0, 0)) -> Material:
    """A wood by name, or paint in a colour ('#…')."""
    return timber(name, grain_axis, offset) if name in WOODS else plain(name, 0.015, 6, offset)


def steel(scale: float = 12.0) -> Material:
    """Brushed stainless steel, for handles and taps."""
    return metal("c8ccd0", "878d93", (1, 1, 8), scale)


def sheet_steel(offset: Point = (0, 0, 0)) -> Material:
    """Large steel fronts: brushed so finely that they look even, clouded very softly."""
    m = Material(occlusion=0.8)
    up, out = (m.math("MULTIPLY", m.normal(k), share) for k, share in ((2, 0.35), (0, 0.25)))
    tilt = m.math("ADD", up, out)
    base = m.mix(m.remap(tilt, -0.3, 0.4), "#b9bec3", "#d3d7da")
    cloud = m.noise(1.4, 1, offset=tuple(offset), stretch=(1, 0.6, 1))
    return m.colour(m.mix(m.remap(cloud, 0.3, 0.7, 0, 0.14), base, "#a2a9ae"))


# ---- record helpers
def hinge(x: float, y: float, z: float = 0.0, upper: float = 1.9) -> Joint:
    """A door hinge on a vertical line; right-hung (+y) doors turn about +Z, left-hung about -Z.

    Put it on the outer front corner of the leaf: so it cuts neither case nor neighbour.
    """
    return Joint("revolute", (x, y, z), (0, 0, 1 if y > 0 else -1), 0.0, upper)


#: A leaf or lid turned so far is open: one 0.6 m wide stands 9 cm off, a front door 15 cm.
AJAR = 0.15
#: From here on one also sees what is inside, where that tells: a fridge's door is 18 cm off.
SHOWS = 0.3


def open_closed(joint: str, part: str, closed: float = 0.03, opened: float = AJAR) -> list[dict]:
    """The CLOSED and OPEN states of one joint; nothing is said of what lies between."""
    return [
        {"state": "CLOSED", "joint": joint, "max": closed, "parts": [part]},
        {"state": "OPEN", "joint": joint, "min": opened, "parts": [part]},
    ]


def surface(
    name: str,
    low: tuple[float, float],
    high: tuple[float, float],
    z: float,
    headroom: float | None = None,
    container: str | None = None,
    part: str = "body",
    margin: float = 0.01,
) -> Support:
    """A rectangular support between two corners (x, y), shrunk by `margin`."""
    sx, sy = high[0] - low[0] - 2 * margin, high[1] - low[1] - 2 * margin
    outline = rectangle(sx, sy, (low[0] + high[0]) / 2, (low[1] + high[1]) / 2)
    return Support(name, z, outline, part, headroom, container)
