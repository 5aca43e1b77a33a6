"""The rigid bodies that a thing is made of: what stays, and what each of its joints moves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.geometry import Array
from sdgen.library import Library, MeshData
from sdgen.library.records import Asset
from sdgen.library.shape import centre_of_mass
from sdgen.scene import ObjectInstance

#: A thing without thickness still has inertia: of its box no side counts less, metres.
LEAST_SIDE_M = 0.01
#: Simulators refuse to move what weighs nothing.
LEAST_MASS_KG = 1e-3


@dataclass(frozen=True)
class Link:
    """One rigid body, in the object's frame with all joints at 0.

    ``joint`` moves it (None: the body the others hang on), ``parts`` are drawn, ``hulls`` are the
    places of its convex pieces among the model's. ``centre_m`` is its centre of mass, that of its
    pieces; ``inertia`` (3,) about it is that of the box of its parts, kg m².
    """

    joint: str | None
    parts: tuple[str, ...]
    hulls: tuple[int, ...]
    mass_kg: float
    centre_m: Array
    inertia: Array


def links_of(library: Library, item: ObjectInstance) -> Iterator[Link]:
    """The links of an object as it is drawn, the one that stays first; masses by their boxes."""
    asset = library.assets[item.asset]
    meshes = library.mesh(item.asset)
    drawn = asset.variants[item.variant]
    moved = {
        joint.name: tuple(p for p in drawn if asset.part(p).joint == joint.name)
        for joint in asset.joints
    }
    mass = masses(asset, meshes, drawn, moved)
    still = tuple(part for part in drawn if asset.part(part).joint is None)
    hulls = library.hulls(item.asset)
    for name, parts in ((None, still or drawn), *moved.items()):
        if parts:
            here = tuple(k for k, hull in enumerate(hulls) if hull.part in parts)
            box = box_of(meshes, parts)
            pieces = [hulls[k].vertices_m for k in here]
            yield Link(
                joint=name,
                parts=parts,
                hulls=here,
                mass_kg=mass[name],
                # As the scene was settled: what leans over an edge would tip about another one.
                centre_m=centre_of_mass(pieces) if pieces else (box[0] + box[1]) / 2,
                inertia=box_inertia(box, mass[name]),
            )


def masses(
    asset: Asset,
    meshes: Mapping[str, MeshData],
    drawn: Sequence[str],
    moved: Mapping[str, Sequence[str]],
) -> dict[str | None, float]:
    """What each joint's parts weigh, by the volume of their boxes, and the rest (None)."""
    sizes = {part: float(np.prod(_sides(*meshes[part].bounds_m))) for part in drawn}
    whole = sum(sizes.values())
    out: dict[str | None, float] = {
        name: max(asset.mass_kg * sum(sizes[p] for p in parts) / whole, LEAST_MASS_KG)
        for name, parts in moved.items()
    }
    out[None] = max(asset.mass_kg - sum(out.values()), LEAST_MASS_KG)
    return out


def box_of(meshes: Mapping[str, MeshData], parts: Sequence[str]) -> tuple[Array, Array]:
    """Lowest and highest corner of the box round some parts."""
    boxes = np.array([meshes[part].bounds_m for part in parts])
    return boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)


def box_inertia(box: tuple[Array, Array], mass_kg: float) -> Array:
    """Moments of inertia of a filled box about its middle, (3,) kg m²."""
    squares = _sides(*box) ** 2
    inertia: Array = mass_kg / 12 * (squares.sum() - squares)
    return inertia


def _sides(low: Array, high: Array) -> Array:
    sides: Array = np.maximum(high - low, LEAST_SIDE_M)
    return sides
