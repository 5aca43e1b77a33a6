"""Breaking a closed mesh into shards, and laying them on the floor as they would come to rest."""

from __future__ import annotations

import math

import bmesh
import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from .materials import Material
from .mesh import Mesh, face_normal


def _solid(mesh: Mesh, name: str):
    """A Blender object of one closed mesh, with both UV layers."""
    data = bpy.data.meshes.new(name)
    data.from_pydata(mesh.v.tolist(), [], [list(f) for f in mesh.f])
    for layer, values in (("label", mesh.label_uv), ("bake", mesh.bake_uv)):
        data.uv_layers.new(name=layer)
        flat = [c for f in values for c in f] if values else [(0.0, 0.0)] * len(data.loops)
        data.uv_layers[layer].data.foreach_set("uv", np.array(flat, np.float32).ravel())
    for material in mesh.mats:
        data.materials.append(material.block)
    data.polygons.foreach_set("material_index", mesh.mi)
    obj = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(obj)
    return obj


def _cell(k: int, seeds: np.ndarray, weights: np.ndarray, low, high, jagged, edge: float):
    """The k-th cell of a power diagram, its walls made jagged by one shared displacement."""
    bm = bmesh.new()
    bmesh.ops.create_cube(bm, size=1.0)
    for v in bm.verts:
        v.co = low + (np.array(v.co) + 0.5) * (high - low)
    for j, other in enumerate(seeds):
        if j == k:
            continue
        d = other - seeds[k]
        middle = (seeds[k] + other) / 2 + d / (d @ d) * (weights[k] - weights[j]) / 2
        everything = bm.verts[:] + bm.edges[:] + bm.faces[:]
        bmesh.ops.bisect_plane(bm, geom=everything, plane_co=middle, plane_no=d, clear_outer=True)
        if len(bm.verts) < 4:
            break
        # cells are convex, so a hull closes the cut (contextual_create sometimes does not)
        points = [v.co.copy() for v in bm.verts]
        bm.clear()
        bmesh.ops.convex_hull(bm, input=[bm.verts.new(p) for p in points])
        bmesh.ops.delete(bm, geom=[v for v in bm.verts if not v.link_faces], context="VERTS")
        bmesh.ops.remove_doubles(bm, verts=bm.verts, dist=1e-6)
    if len(bm.verts) < 4:
        bm.free()
        return None
    for _ in range(6):
        bmesh.ops.triangulate(bm, faces=bm.faces)
        long = [e for e in bm.edges if e.calc_length() > edge]
        if not long or len(bm.faces) > 1500:
            break
        bmesh.ops.subdivide_edges(bm, edges=long, cuts=1)
    bmesh.ops.triangulate(bm, faces=bm.faces)
    points = np.array([v.co[:] for v in bm.verts])
    for v, moved in zip(bm.verts, points + jagged(points), strict=True):
        v.co = moved
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    for layer in ("label", "bake"):
        bm.loops.layers.uv.new(layer)
    data = bpy.data.meshes.new("cell")
    bm.to_mesh(data)
    bm.free()
    return data


def _intersect(solid, cell, solver: str):
    modifier = solid.modifiers.new("cut", "BOOLEAN")
    modifier.object, modifier.operation, modifier.solver = cell, "INTERSECT", solver
    evaluated = solid.evaluated_get(bpy.context.evaluated_depsgraph_get())
    bm = bmesh.new()
    bm.from_mesh(evaluated.to_mesh())
    evaluated.to_mesh_clear()
    solid.modifiers.clear()
    bm = _in_order(bm)
    bmesh.ops.triangulate(bm, faces=bm.faces)
    return bm


def _in_order(bm):
    """The same mesh, its vertices and faces sorted: a Boolean's order differs between runs."""
    bm.verts.index_update()
    places = np.round([v.co[:] for v in bm.verts], 7).reshape(-1, 3)
    order = np.lexsort(places.T[::-1])
    rank = np.empty(len(order), int)
    rank[order] = np.arange(len(order))
    old = [bm.loops.layers.uv[name] for name in ("label", "bake")]
    faces = []
    for face in bm.faces:
        corners = [(int(rank[c.vert.index]), *(tuple(c[u].uv) for u in old)) for c in face.loops]
        start = min(range(len(corners)), key=lambda i: corners[i][0])
        faces.append((corners[start:] + corners[:start], face.material_index, face.smooth))
    faces.sort(key=lambda item: [c[0] for c in item[0]])
    new = bmesh.new()
    layers = [new.loops.layers.uv.new(name) for name in ("label", "bake")]
    verts = [new.verts.new(places[i]) for i in order]
    for corners, material, smooth in faces:
        if len({c[0] for c in corners}) < 3 or new.faces.get([verts[c[0]] for c in corners]):
            continue
        face = new.faces.new([verts[c[0]] for c in corners])
        face.material_index, face.smooth = material, smooth
        for loop, corner in zip(face.loops, corners, strict=True):
            for layer, uv in zip(layers, corner[1:], strict=True):
                loop[layer].uv = uv
    bm.free()
    return new


def fracture(
    meshes: list[Mesh],
    seeds,
    raw: Material,
    weights=None,
    seed: int = 0,
    roughness: float = 0.003,
    edge: float = 0.02,
) -> list[Mesh]:
    """The shards of some closed meshes, in place. `raw` covers the broken faces.

    seeds: one point per shard; weights (m²) widen a seed's cell. Patterns and labels stay on.
    """
    rng = np.random.default_rng(seed)
    seeds = np.asarray(seeds, float)
    weights = np.zeros(len(seeds)) if weights is None else np.asarray(weights, float)
    points = np.concatenate([m.v for m in meshes])
    low, high = points.min(0) - 0.008, points.max(0) + 0.008
    best, best_found = [], -1.0
    for attempt in range(8):  # when the Booleans cannot do it: shifted seeds and smoother cuts
        jagged = _displacement(rng, roughness * 0.85**attempt)
        spots = seeds + rng.normal(0, 0.04 * attempt, seeds.shape) * np.ptp(points, axis=0) / 4
        cells = [_cell(k, spots, weights, low, high, jagged, edge) for k in range(len(spots))]
        shards: list[list[Mesh]] = [[] for _ in spots]
        found, good = 0.0, True
        for mesh in meshes:
            share = _expected_shares(mesh, spots, weights, rng)
            for k, cell in enumerate(cells):
                piece = _cut(mesh, cell, raw, share[k], rng) if cell is not None else None
                if piece is not None:
                    shards[k].append(piece)
                    found += share[k]
                good &= piece is not None or share[k] < 0.01
        if found > best_found:
            best, best_found = shards, found
        if good:
            break
    else:
        print(
            f"WARNING fracture: only {best_found / len(meshes):.0%} of the volume",
            [len(s) for s in best],
        )
    return [merge(s) for s in best if s]


def _expected_shares(
    mesh: Mesh, seeds: np.ndarray, weights: np.ndarray, rng, count: int = 40000
) -> np.ndarray:
    """About how much of the solid belongs to each cell, from random points inside it."""
    tree = BVHTree.FromPolygons(mesh.v.tolist(), [list(f) for f in mesh.f])
    low, high = mesh.v.min(0), mesh.v.max(0)
    points = rng.uniform(low, high, (count, 3))
    inside = []
    for p in points:
        hits, origin = 0, Vector(p)
        while True:
            hit = tree.ray_cast(origin, Vector((0.31, 0.42, 0.85)))
            if hit[0] is None:
                break
            hits += 1
            origin = hit[0] + Vector((0.31, 0.42, 0.85)) * 1e-6
        if hits % 2:
            inside.append(p)
        if len(inside) >= 2500:
            break
    inside = np.array(inside)
    power = ((inside[:, None] - seeds) ** 2).sum(-1) - weights
    return np.bincount(power.argmin(1), minlength=len(seeds)) / len(inside)


def _displacement(rng: np.random.Generator, amount: float):
    frequency, phase = rng.uniform(90, 260, (6, 3)), rng.uniform(0, 6.28, 6)
    strength = rng.normal(0, 1, (6, 3)) * amount / 1.8

    def jagged(x: np.ndarray) -> np.ndarray:
        return sum(
            strength[k] * np.sin((x * frequency[k]).sum(-1, keepdims=True) + phase[k])
            for k in range(6)
        )

    return jagged


def _cut(mesh: Mesh, data, raw: Material, share: float, rng) -> Mesh | None:
    """Mesh and cell intersected; None if nothing is left or no solver gets near the volume."""
    data.materials.clear()
    for material in (*mesh.mats, raw):
        data.materials.append(material.block)
    data.polygons.foreach_set("material_index", [len(mesh.mats)] * len(data.polygons))
    whole, found = mesh.signed_volume(), None
    for attempt in range(4):
        solid, cell = _solid(mesh, "solid"), bpy.data.objects.new("cell", data)
        solid.data.materials.append(raw.block)
        bpy.context.collection.objects.link(cell)
        # a nudge too small to see gets a solver past a degenerate case
        cell.location = rng.normal(0, 2e-5, 3) if attempt > 1 else (0, 0, 0)
        bm = _intersect(solid, cell, ("EXACT", "FAST")[attempt % 2])
        for leftover in (cell, solid):  # else it would blotch the occlusion
            bpy.data.objects.remove(leftover)
        closed = all(len(e.link_faces) == 2 for e in bm.edges)
        off = abs(bm.calc_volume() / whole - share)
        if bm.faces and closed and off < 0.03 + 0.12 * share:
            _lighten(bm)
            found = _take(bm, [*mesh.mats, raw], mesh)
        bm.free()
        if found:
            break
    return found


def _lighten(bm) -> None:
    """Merge what the Boolean cut into slivers."""
    bmesh.ops.remove_doubles(bm, verts=bm.verts, dist=0.0012)
    bmesh.ops.dissolve_limit(
        bm, angle_limit=0.2, verts=bm.verts, edges=bm.edges, delimit={"MATERIAL", "UV"}
    )
    bmesh.ops.triangulate(bm, faces=bm.faces)
    bmesh.ops.dissolve_degenerate(bm, edges=bm.edges, dist=1e-5)
    pairs: set[frozenset] = set()
    double = []
    for f in bm.faces:
        key = frozenset(v.index for v in f.verts)
        (double.append(f) if key in pairs else pairs.add(key))
    bmesh.ops.delete(bm, geom=double, context="FACES")


def _take(bm, materials: list[Material], like: Mesh) -> Mesh:
    bm.verts.index_update()
    label, bake = bm.loops.layers.uv["label"], bm.loops.layers.uv["bake"]
    piece = Mesh(
        [v.co[:] for v in bm.verts],
        [[v.index for v in f.verts] for f in bm.faces],
        [f.material_index for f in bm.faces],
        materials,
        [[loop[label].uv[:] for loop in f.loops] for f in bm.faces],
        [[tuple(loop[bake].uv) for loop in f.loops] for f in bm.faces],
        like.weight,
        like.smooth,
    )
    far = 50 * float(np.ptp(piece.v, axis=0).max())
    for i, face in enumerate(piece.f):  # broken faces: projected along their dominant axis
        if piece.mi[i] == len(materials) - 1:
            q = piece.v[list(face)]
            axis = int(np.abs(face_normal(q)).argmax())
            a, b = [(1, 2), (0, 2), (0, 1)][axis]
            piece.bake_uv[i] = [(far * (axis + 1) + p[a], p[b]) for p in q]
    return piece


def merge(meshes: list[Mesh]) -> Mesh:
    """Several meshes as one."""
    first = meshes[0]
    for other in meshes[1:]:
        shift, offset = len(first.v), len(first.mats)
        first.v = np.concatenate([first.v, other.v])
        first.f += [tuple(i + shift for i in f) for f in other.f]
        first.mi += [i + offset for i in other.mi]
        first.mats += other.mats
        for name in ("label_uv", "bake_uv"):
            setattr(first, name, getattr(first, name) + getattr(other, name))
    return first


def resting_turns(points: np.ndarray) -> list[tuple[float, np.ndarray]]:
    """The poses a convex hull can lie in: (height of the centre, rotation matrix), lowest first."""
    bm = bmesh.new()
    bmesh.ops.convex_hull(bm, input=[bm.verts.new(p) for p in points])
    bm.normal_update()
    loose = [v for v in bm.verts if not v.link_faces]
    bmesh.ops.delete(bm, geom=loose, context="VERTS")
    bmesh.ops.dissolve_limit(bm, angle_limit=0.06, verts=bm.verts, edges=bm.edges)
    centre, volume = np.zeros(3), 0.0
    found = []
    for f in bm.faces:
        for i in range(1, len(f.verts) - 1):
            a, b, c = (np.array(f.verts[k].co) for k in (0, i, i + 1))
            v = float(a @ np.cross(b, c)) / 6
            centre, volume = centre + v * (a + b + c) / 4, volume + v
    centre /= volume
    for f in bm.faces:
        corners, normal = [np.array(v.co) for v in f.verts], np.array(f.normal)
        inside = all(
            np.cross(q - p, centre - p) @ normal > 0
            for p, q in zip(corners, corners[1:] + corners[:1], strict=True)
        )
        if inside:
            turn = np.array(Vector(normal).rotation_difference(Vector((0, 0, -1))).to_matrix())
            found.append((float((corners[0] - centre) @ normal), turn))
    bm.free()
    return sorted(found, key=lambda item: item[0])


def scatter(shards: list[Mesh], rng: np.random.Generator, gap: float = 0.006) -> list[np.ndarray]:
    """Lay shards on z = 0 around the one with the foot, which stays up; returns the pieces."""

    def footprint(shard: Mesh) -> float:
        low = shard.v[shard.v[:, 2] < 0.012]
        return float(np.prod(np.ptp(low[:, :2], axis=0))) if len(low) else 0.0

    base = max(shards, key=footprint)
    shards.sort(key=lambda q: q is not base)
    placed: list[tuple[np.ndarray, float]] = []
    for k, shard in enumerate(shards):
        shard.keep_pattern()
        towards = shard.v.mean(0)[:2]
        if k:
            turns = resting_turns(shard.v)
            if turns:
                shard.v = shard.v @ turns[0][1].T
            else:  # a sliver: its thinnest direction upwards
                axes = np.linalg.svd(shard.v - shard.v.mean(0), full_matrices=False)[2]
                axes[2] *= np.linalg.det(axes)
                shard.v = shard.v @ axes.T
            yaw = rng.uniform(0, 2 * math.pi)
            c, s = math.cos(yaw), math.sin(yaw)
            shard.v = shard.v @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T
            shard.v -= [*((shard.v.min(0) + shard.v.max(0)) / 2)[:2], 0]
        shard.v[:, 2] -= shard.v[:, 2].min()
        middle = (shard.v.min(0) + shard.v.max(0))[:2] / 2
        radius = float(np.linalg.norm(shard.v[:, :2] - middle, axis=1).max()) * 0.85
        if k:
            angle = math.atan2(towards[1], towards[0]) + rng.normal(0, 0.25)
            away = 0.0
            while any(
                np.linalg.norm(np.array([math.cos(angle), math.sin(angle)]) * away - p)
                < r + radius + gap
                for p, r in placed
            ):
                away += 0.003
            away += abs(rng.normal(0, 0.006))
            middle = np.array([math.cos(angle), math.sin(angle)]) * away
            shard.move(middle[0], middle[1], 0)
        placed.append((middle, radius))
    return [s.v.copy() for s in shards]
