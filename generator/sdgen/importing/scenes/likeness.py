"""Which models are like a piece that was found, and long pieces as several of ours."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from sdgen.geometry import Vec3, rotation_matrix, vec3
from sdgen.importing.scenes.found import FoundPiece
from sdgen.library import Asset, Library

#: Models tried for a piece.
_MODELS = 5
#: A model more than so many times as large or small as the piece, along its most different side,
#: is another piece.
_UNLIKE = 2.0
#: Sides thinner than this are alike, metres; of heights so much counts.
_THIN_M, _OF_HEIGHT = 0.12, 0.6
#: What stands in rows: of these, so many of our own stand for one piece that is so many times
#: longer than our longest, at most, each as like a part of it as this.
_ROWS = (
    "bathroom_cabinet",
    "bookshelf",
    "kitchen_counter",
    "wall_cabinet",
    "wall_shelf",
    "wardrobe",
)
_IN_A_ROW, _LONGER, _ROW_LIKE = 8, 1.4, 0.35


def unlike(model: Vec3, found: Vec3, turned: bool = True) -> float:
    """How different two boxes are along their most different side (a logarithm), the found one
    turned by a quarter where that is better. Half as much of their heights: what a bed's board or
    a lamp's cord makes of it."""
    logs = np.abs(np.log(np.maximum(model, _THIN_M)) - np.log(np.maximum(found, _THIN_M)))
    straight = float(max(logs[0], logs[1], logs[2] * _OF_HEIGHT))
    if not turned:
        return straight
    deep, wide, high = found
    return min(straight, unlike(model, (wide, deep, high), turned=False))


def models_like(category: str, extents_m: Vec3, library: Library) -> list[Asset]:
    """The models of a category that are about so large, the nearest first."""
    scored = [
        (unlike(model.extents_m, extents_m), model) for model in library.by_category(category)
    ]
    near = [pair for pair in scored if pair[0] < math.log(_UNLIKE)]
    near.sort(key=lambda pair: (pair[0], pair[1].id))
    return [model for _, model in near[:_MODELS]]


def side_by_side(piece: FoundPiece, category: str, library: Library) -> list[FoundPiece]:
    """A long piece of what stands in rows as several of our own beside each other; itself where a
    model is about as long, or none is as deep and high."""
    if category not in _ROWS or models_like(category, piece.extents_m, library):
        return [piece]
    axis = 0 if piece.extents_m[0] > piece.extents_m[1] else 1
    widest = max((model.extents_m[1] for model in library.by_category(category)), default=0.0)
    for number in range(2, _IN_A_ROW + 1) if piece.extents_m[axis] > _LONGER * widest else ():
        sides = list(piece.extents_m)
        sides[axis] /= number
        part = (sides[0], sides[1], sides[2])
        if not any(unlike(m.extents_m, part) < _ROW_LIKE for m in library.by_category(category)):
            continue
        way = rotation_matrix(piece.quat_xyzw)[:, axis]
        steps = (np.arange(number) - (number - 1) / 2) * sides[axis]
        return [
            replace(
                piece,
                name=f"{piece.name} ({k} of {number})",
                position_m=vec3(np.array(piece.position_m) + way * step),
                extents_m=part,
            )
            for k, step in enumerate(steps.tolist(), start=1)
        ]
    return [piece]
