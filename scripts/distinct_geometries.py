"""How many truly different shapes the library holds: `distinct_geometries.py [CATEGORY...]`.

Two models count as the same shape when the Chamfer distance of their surfaces (mean of both
directions' mean nearest distances, default variant, standing on the origin, real scale) is at
most 2 % of the larger one's diagonal. Greedy, in order of id: a model counts when it differs
from every model counted before. Needs scipy.

A few points tell models that are far apart: the mean of 150 nearest distances is within a tenth
of that of 3,000, so twice the limit by the few is beyond it by the many. Only pairs that may
be the nearest or the same are measured in full.
"""

from __future__ import annotations

import collections
import sys

import numpy as np
from scipy.spatial import cKDTree
from sdgen.library import Library, load_library
from sdgen.library.records import Asset

LIMIT, DENSE, SPARSE, FEW = 0.02, 30_000, 3_000, 150
#: A pair this many times beyond what matters by the few points is not measured in full.
SURELY = 2.0


def surface_points(library: Library, asset: Asset, rng: np.random.Generator) -> np.ndarray:
    """DENSE points (N, 3) spread evenly over the model's default variant, in random order."""
    meshes = [library.mesh(asset.id)[part] for part in asset.variants["default"]]
    corners = np.concatenate([mesh.vertices[mesh.faces] for mesh in meshes])
    sides = corners[:, 1:] - corners[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    face = rng.choice(len(corners), DENSE, p=area / area.sum())
    u, v = np.sqrt(rng.random(DENSE)), rng.random(DENSE)
    weights = np.stack([1 - u, u * (1 - v), u * v], axis=1)
    return np.einsum("nk,nkd->nd", weights, corners[face])


class Shape:
    """The surface of a model, ready to be compared."""

    def __init__(self, library: Library, asset: Asset) -> None:
        self.points = surface_points(library, asset, np.random.default_rng(0))
        self.tree = cKDTree(self.points)
        self.diagonal = float(np.linalg.norm(asset.extents_m))

    def distance(self, other: Shape, count: int) -> float:
        """Chamfer distance by ``count`` points of each, as a share of the larger diagonal."""
        there = other.tree.query(self.points[:count])[0].mean()
        back = self.tree.query(other.points[:count])[0].mean()
        return float(there + back) / 2 / max(self.diagonal, other.diagonal)


class Kept:
    """The shapes counted so far."""

    def __init__(self) -> None:
        self.shapes: list[Shape] = []
        self._extents = np.zeros((0, 3))

    def add(self, shape: Shape, extents_m: np.ndarray) -> None:
        """Count one more."""
        self.shapes.append(shape)
        self._extents = np.vstack([self._extents, extents_m])

    def nearest(self, shape: Shape, extents_m: np.ndarray) -> float:
        """Distance to the nearest of them, or to the first that is the same; inf: none is near."""
        diagonals = np.array([kept.diagonal for kept in self.shapes])
        apart = np.abs(self._extents - extents_m).max(axis=1)
        near = np.flatnonzero(apart <= 0.2 * np.maximum(diagonals, shape.diagonal))
        guesses = sorted((shape.distance(self.shapes[k], FEW), int(k)) for k in near)
        found = np.inf
        for guess, k in guesses:
            if guess > SURELY * max(LIMIT, min(found, guesses[0][0])):
                break
            found = min(found, shape.distance(self.shapes[k], SPARSE))
            if found <= LIMIT:
                break
        return float(found)


def count_shapes(library: Library, assets: list[Asset]) -> dict[str, list[float]]:
    """Per model the distance to the nearest shape counted before it, by category.

    Models of one mesh and one default variant are one shape: distance 0.
    """
    kept = Kept()
    seen: set[tuple[object, ...]] = set()
    found: dict[str, list[float]] = collections.defaultdict(list)
    for asset in assets:
        key = (asset.mesh, asset.variants["default"], asset.extents_m)
        if key in seen:
            found[asset.category].append(0.0)
            continue
        seen.add(key)
        shape, extents = Shape(library, asset), np.array(asset.extents_m)
        nearest = kept.nearest(shape, extents)
        found[asset.category].append(nearest)
        if nearest > LIMIT:
            kept.add(shape, extents)
    return found


def main(categories: list[str]) -> None:
    library = load_library()
    chosen = [a for a in library.assets.values() if not categories or a.category in categories]
    found = count_shapes(library, chosen)
    for category, distances in found.items():
        shown = ["far" if np.isinf(d) else f"{d:.3f}" for d in distances]
        distinct = sum(d > LIMIT for d in distances)
        print(f"{category:22} {distinct:2} of {len(distances):2}  {' '.join(shown)}")
    every = [d for distances in found.values() for d in distances]
    print(f"{sum(d > LIMIT for d in every)} distinct geometries in {len(every)} models")


if __name__ == "__main__":
    main(sys.argv[1:])
