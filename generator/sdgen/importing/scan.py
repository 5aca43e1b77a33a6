"""A model as its source has it: triangles, colours, joints; nothing of ours yet."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply

Ints = npt.NDArray[np.int64]
Up = Literal["y", "z", "unknown"]


@dataclass(frozen=True)
class Paint:
    """What colours a surface: ``image`` (a Pillow image, lazily read) times ``colour`` (RGBA, 0-1).

    ``uv`` is a 3x3 matrix that texture coordinates pass through (KHR_texture_transform).
    """

    image: Any = None
    colour: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    uv: tuple[tuple[float, ...], ...] | None = None

    @property
    def plain(self) -> bool:
        """True when the picture alone colours it."""
        return self.image is not None and min(self.colour) > 0.99


@dataclass(frozen=True)
class Piece:
    """Triangles of one paint. ``vertices`` (N, 3) metres, ``faces`` (M, 3), ``uvs`` (N, 2) with v
    upwards or None, ``colours`` (N, 3) 0-1 of vertices or None; ``link`` is what moves it."""

    vertices: Array
    faces: Ints
    uvs: Array | None = None
    colours: Array | None = None
    paint: Paint = Paint()
    link: str = "body"

    @property
    def triangles(self) -> Array:
        """Corners (M, 3, 3)."""
        return np.asarray(self.vertices[self.faces])

    def moved(self, matrix: Array) -> Piece:
        """The piece under a 4x4 matrix; a mirroring one turns its faces round."""
        faces = self.faces[:, ::-1] if np.linalg.det(matrix[:3, :3]) < 0 else self.faces
        return replace(self, vertices=apply(matrix, self.vertices), faces=faces)


@dataclass(frozen=True)
class ScanJoint:
    """What moves the link ``name`` against the body: as :class:`sdgen.library.records.Joint`."""

    name: str
    type: Literal["revolute", "prismatic"]
    origin_m: Array
    axis: Array
    lower: float
    upper: float


@dataclass(frozen=True)
class Box:
    """A box in the model's frame: middle and whole sizes, metres (a receptacle of ReplicaCAD)."""

    center_m: Array
    size_m: Array

    def moved(self, matrix: Array) -> Box:
        """The box that holds this one after a 4x4 matrix of rotation, scale and shift."""
        size = np.abs(matrix[:3, :3]) @ self.size_m
        return Box(apply(matrix, self.center_m[None])[0], size)


@dataclass(frozen=True)
class LinkBox:
    """A box in the frame of a link of a URDF."""

    box: Box
    link: str


@dataclass(frozen=True)
class Scan:
    """One model of a source. ``up`` is the axis that its format has up; ``words`` further describe
    the model; ``mass_kg`` and ``friction`` (Coulomb's, sliding) are what the source says."""

    pieces: tuple[Piece, ...]
    up: Up = "unknown"
    joints: tuple[ScanJoint, ...] = ()
    mass_kg: float | None = None
    friction: float | None = None
    receptacles: tuple[Box, ...] = ()
    words: tuple[str, ...] = ()
    licence: str | None = None
    broken: tuple[Piece, ...] = field(default=())

    @property
    def triangles(self) -> Array:
        """Corners (M, 3, 3) of all pieces."""
        return np.concatenate([piece.triangles for piece in self.pieces])

    @property
    def extents_m(self) -> Array:
        """Size along x, y, z."""
        points = self.triangles.reshape(-1, 3)
        return np.asarray(points.max(axis=0) - points.min(axis=0))

    def moved(self, matrix: Array) -> Scan:
        """The scan under a 4x4 matrix of rotation, one scale and shift."""
        linear = matrix[:3, :3]
        scale = float(np.cbrt(abs(np.linalg.det(linear))))
        joints = tuple(
            replace(
                joint,
                origin_m=apply(matrix, joint.origin_m[None])[0],
                axis=linear @ joint.axis / scale,
                lower=joint.lower * (scale if joint.type == "prismatic" else 1.0),
                upper=joint.upper * (scale if joint.type == "prismatic" else 1.0),
            )
            for joint in self.joints
        )
        return replace(
            self,
            pieces=tuple(piece.moved(matrix) for piece in self.pieces),
            broken=tuple(piece.moved(matrix) for piece in self.broken),
            joints=joints,
            receptacles=tuple(box.moved(matrix) for box in self.receptacles),
        )
