"""What the library knows of a model: the record of ``manifest.yaml`` and ``assets.jsonl``."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Literal

import numpy as np
from pydantic import Field
from shapely import Polygon

from sdgen.geometry import Array, Coordinate, Vec2, Vec3
from sdgen.scene import Record
from sdgen.vocabulary import SurfaceKind

Rgba = tuple[float, float, float, float]

#: Names of models and parts become file names in the cache: nothing that could lead elsewhere.
NAME = r"^[A-Za-z0-9][A-Za-z0-9_.-]{0,99}$"


class Joint(Record):
    """A hinge or slide; a part that names it moves with it. Positive values open."""

    name: str
    type: Literal["revolute", "prismatic"]
    origin_m: Vec3
    axis: Vec3
    lower: Coordinate
    upper: Coordinate


class Part(Record):
    """A named mesh of the model (a GLB node), in the object's frame at joint value 0.

    ``open`` declares a mesh whose back faces can be seen (and which shows holes there).
    """

    name: str = Field(pattern=NAME)
    faces: int = Field(ge=1)
    joint: str | None = None
    rgba: Rgba = (1.0, 1.0, 1.0, 1.0)
    texture: str | None = None
    open: bool = False


class StateRule(Record):
    """When a state holds: a joint beyond a limit, or one of some variants."""

    state: str = Field(pattern=r"^[A-Z][A-Z_]*$")
    joint: str | None = None
    min: Coordinate | None = None
    max: Coordinate | None = None
    variants: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()


class Support(Record):
    """An upward surface things can stand on; ``headroom_m`` None = nothing above."""

    name: str
    part: str
    z_m: Coordinate
    polygon_m: tuple[Vec2, ...]
    headroom_m: Coordinate | None = None
    container: str | None = None

    def __eq__(self, other: object) -> bool:
        # By what is stored: what is kept of it once computed has arrays, which have no one truth.
        return type(other) is Support and all(
            getattr(self, name) == getattr(other, name) for name in Support.model_fields
        )

    @cached_property
    def area_m2(self) -> float:
        """Area of the surface."""
        return float(Polygon(self.polygon_m).area)

    @cached_property
    def edge_m(self) -> Array:
        """Corners (N, 3) of the real surface: supports are stored shrunk by a centimetre."""
        edge = Polygon(self.polygon_m).buffer(0.01, join_style="mitre").exterior
        corners = np.array(edge.coords)[:-1]
        return np.column_stack([corners, np.full(len(corners), self.z_m)])


class Container(Record):
    """A hollow box things can be inside of; ``closed_by`` names the joint that shuts it."""

    name: str
    part: str
    center_m: Vec3
    size_m: Vec3
    closed_by: str | None = None


class RestingPose(Record):
    """A way the model can lie on a floor: the direction, in its frame, that then points up, and
    the chance of coming to rest so when dropped at random."""

    up: Vec3
    share: float = Field(gt=0, le=1)


class AssetInfo(Record):
    """One model, as ``assets.jsonl`` carries it: all that labels need, no meshes.

    ``outlines_m`` are outermost points of the visual mesh of every part (joints at 0), of each of
    its pieces that lie apart: where the object touches and what it covers from above follow from
    those of the drawn parts, where its joints put them, however it lies. ``attribution`` says whom
    to name for it where the licence asks for that.
    """

    id: str = Field(pattern=NAME)
    category: str = Field(pattern=NAME)
    title: str = ""
    licence: str
    source: str
    attribution: str = ""
    extents_m: Vec3
    outlines_m: dict[str, tuple[tuple[Vec3, ...], ...]] = Field(default_factory=dict)
    mass_kg: float = Field(gt=0)
    friction: float = Field(default=0.6, ge=0)
    parts: tuple[Part, ...]
    joints: tuple[Joint, ...] = ()
    variants: dict[str, tuple[str, ...]]
    states: tuple[StateRule, ...] = ()
    supports: tuple[Support, ...] = ()
    containers: tuple[Container, ...] = ()
    resting: tuple[RestingPose, ...] = ()

    def joint(self, name: str) -> Joint:
        """The joint of this name (KeyError when there is none)."""
        for item in self.joints:
            if item.name == name:
                return item
        raise KeyError(name)

    def part(self, name: str) -> Part:
        """The part of this name (KeyError when there is none)."""
        for item in self.parts:
            if item.name == name:
                return item
        raise KeyError(name)

    @cached_property
    def known_outlines(self) -> dict[tuple[str, tuple[str, ...]], Any]:
        """What :mod:`sdgen.library.drawn` has made of the outlines already."""
        return {}

    @property
    def faces(self) -> int:
        """Faces of the default variant."""
        return sum(self.part(name).faces for name in self.variants["default"])

    @property
    def state_names(self) -> tuple[str, ...]:
        """All states the model can be in, sorted."""
        return tuple(sorted({rule.state for rule in self.states}))


class Asset(AssetInfo):
    """One model of the library: its record and where its files are (relative to the folder).

    ``suite`` names the set it was made for: models of several categories that belong into one
    home together; None belongs to none. ``tags`` are words by which a home's style picks models.
    """

    mesh: str
    hulls: str
    texture: str
    suite: str | None = Field(default=None, pattern=NAME)
    tags: tuple[str, ...] = ()

    def info(self, outlines_m: dict[str, tuple[tuple[Vec3, ...], ...]]) -> AssetInfo:
        """The record without file names, with the outlines of its meshes."""
        # Its values are checked already, and records are frozen: both may share them.
        data = {name: getattr(self, name) for name in AssetInfo.model_fields}
        return AssetInfo.model_construct(**{**data, "outlines_m": outlines_m})


class Surface(Record):
    """A tileable surface of floors, walls, ceilings or bands of walls; the tile covers ``size_m``
    metres. A skirting is one tile high."""

    id: str
    kind: SurfaceKind
    texture: str
    size_m: float = Field(gt=0)
    rooms: tuple[str, ...] = ()
