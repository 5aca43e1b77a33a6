"""How many truly different shapes the library holds: `distinct_geometries.py [CATEGORY...]`.

Two models count as the same shape when the Chamfer distance of their surfaces (mean of both
directions' mean nearest distances, default variant, standing on the origin, real scale) is at
most 2 % of the larger one's diagonal. Greedy, in order of id: a model counts when it differs
from every model counted before. Needs scipy.
"""

from __future__ import annotations

import collections
import sys

import numpy as np
from scipy.spatial import cKDTree
from sdgen.library import Library, load_library
from sdgen.library.records import Asset

LIMIT, DENSE, SPARSE = 0.02, 30_000, 3_000


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


def main(categories: list[str]) -> None:
    library = load_library()
    kept: list[tuple[np.ndarray, float, np.ndarray, cKDTree]] = []
    found: dict[str, list[str]] = collections.defaultdict(list)
    counted: collections.Counter[str] = collections.Counter()
    for asset in library.assets.values():
        if categories and asset.category not in categories:
            continue
        points = surface_points(library, asset, np.random.default_rng(0))
        extents = np.array(asset.extents_m)
        diagonal, few, tree = float(np.linalg.norm(extents)), points[:SPARSE], cKDTree(points)
        nearest = np.inf
        for other_extents, other_diagonal, other_few, other_tree in kept:
            larger = max(diagonal, other_diagonal)
            if np.abs(extents - other_extents).max() > 0.2 * larger:
                continue
            there, back = other_tree.query(few)[0].mean(), tree.query(other_few)[0].mean()
            nearest = min(nearest, (there + back) / 2 / larger)
            if nearest <= LIMIT:
                break
        found[asset.category].append("far" if np.isinf(nearest) else f"{nearest:.3f}")
        if nearest > LIMIT:
            kept.append((extents, diagonal, few, tree))
            counted[asset.category] += 1
    for category, distances in found.items():
        print(f"{category:22} {counted[category]:2} of {len(distances):2}  {' '.join(distances)}")
    print(f"{len(kept)} distinct geometries in {sum(map(len, found.values()))} models")


if __name__ == "__main__":
    main(sys.argv[1:])
