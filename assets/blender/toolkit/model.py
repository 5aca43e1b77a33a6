"""`Model`: all that a maker says about a thing. Coordinates are the maker's own; the shift
to the contract's origin (bottom centre of the default variant) is done at export."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from .mesh import Mesh


@dataclass
class Part:
    """A named group of meshes that is drawn, moved and hidden as one.

    collision  "hull" (one convex piece), "coacd" (decomposed by assemble.py), "none", or a
               list of convex pieces (arrays of points; see box_piece, ring_pieces, ...)
    occlusion  name of the group it shares ambient occlusion with; default: all fixed parts of
               the default variant together, every movable or alternative part on its own
    open       its back faces may be seen from where nobody looks (declared in the manifest)
    """

    meshes: list[Mesh]
    joint: str | None = None
    rgba: tuple[float, float, float, float] | None = None
    collision: object = "coacd"
    occlusion: str | None = None
    open: bool = False


@dataclass
class Joint:
    """Revolute (radians, right-hand rule) or prismatic (metres); positive opens."""

    type: str
    origin: tuple[float, float, float]
    axis: tuple[float, float, float]
    lower: float
    upper: float


@dataclass
class Support:
    name: str
    z: float
    polygon: list[tuple[float, float]]
    part: str = "body"
    headroom: float | None = None
    container: str | None = None


@dataclass
class Container:
    name: str
    center: tuple[float, float, float]
    size: tuple[float, float, float]
    part: str = "body"
    closed_by: str | None = None


@dataclass
class Model:
    title: str
    parts: dict[str, Part]
    mass: float
    friction: float = 0.6
    variants: dict[str, list[str]] | None = None  # default: every part
    joints: dict[str, Joint] = field(default_factory=dict)
    states: list[dict] = field(default_factory=list)
    supports: list[Support] = field(default_factory=list)
    containers: list[Container] = field(default_factory=list)
    texture_size: int = 256
    ground_shadow: bool = False  # darken the foot of things that always stand on the floor
    occlusion_strength: float = 1.0
    clear_joints: bool = False  # no black line where pieces meet: see `bake_texture`
    prune: bool = True
    smooth_deg: float = 40.0  # edges up to this angle are shaded round
    front: str = "+x"  # "-y" if it was modelled facing -Y: turned at export

    def __post_init__(self) -> None:
        if self.variants is None:
            self.variants = {"default": list(self.parts)}

    @property
    def default_parts(self) -> list[str]:
        return self.variants["default"]

    def occlusion_group(self, name: str) -> str:
        part = self.parts[name]
        if part.occlusion:
            return part.occlusion
        if part.joint:
            return f"joint:{part.joint}"
        return "fixed" if name in self.default_parts else f"part:{name}"


@dataclass
class Maker:
    """A category's maker: `make(**parameters)` builds, `sample(rng)` draws parameters.

    presets[i] overrides sampled parameters of model i + 1, to make sure of variety. `gone` are
    numbers that have no model any more; the others keep theirs.
    """

    make: Callable[..., Model]
    sample: Callable[[np.random.Generator], dict]
    count: int = 2
    presets: list[dict] = field(default_factory=list)
    gone: tuple[int, ...] = ()


# ---- collision pieces
def box_piece(center, size) -> np.ndarray:
    """The eight corners of a box."""
    c, s = np.asarray(center, float), np.asarray(size, float) / 2
    return np.array([c + s * [a, b, d] for a in (-1, 1) for b in (-1, 1) for d in (-1, 1)])


def prism_piece(outline, z0: float, z1: float) -> np.ndarray:
    """A convex outline (xy) between two heights."""
    return np.array([(x, y, z) for z in (z0, z1) for x, y in outline], float)


def cylinder_piece(
    radius: float, z0: float, z1: float, n: int = 12, top_radius: float | None = None
) -> np.ndarray:
    top = radius if top_radius is None else top_radius
    angles = [2 * math.pi * i / n for i in range(n)]
    return np.array(
        [
            (r * math.cos(a), r * math.sin(a), z)
            for r, z in ((radius, z0), (top, z1))
            for a in angles
        ]
    )


def ring_pieces(outer, inner, n: int = 10) -> list[np.ndarray]:
    """The wall of a round vessel as `n` convex wedges.

    outer, inner: [(radius, z) at the bottom, (radius, z) at the top] of both wall faces.
    """
    pieces = []
    for i in range(n):
        a, b = 2 * math.pi * i / n, 2 * math.pi * (i + 1) / n
        pieces.append(
            np.array(
                [(r * math.cos(t), r * math.sin(t), z) for r, z in (*outer, *inner) for t in (a, b)]
            )
        )
    return pieces


def round_polygon(radius: float, n: int = 12) -> list[tuple[float, float]]:
    """For supports: a regular polygon inside a circle."""
    return [
        (radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n))
        for i in range(n)
    ]


def rectangle(sx: float, sy: float, cx: float = 0.0, cy: float = 0.0) -> list[tuple[float, float]]:
    """For supports: a rectangle, anticlockwise."""
    x, y = sx / 2, sy / 2
    return [(cx - x, cy - y), (cx + x, cy - y), (cx + x, cy + y), (cx - x, cy + y)]
