"""From meshes to one Blender object with an atlas, and from that to a texture."""

from __future__ import annotations

import hashlib
import math
import os
from pathlib import Path

import bmesh
import bpy
import numpy as np
from PIL import Image, ImageDraw

from .mesh import Mesh

SUPERSAMPLING = 2  # the colour is baked larger and averaged down
DRAFT = bool(os.environ.get("SDGEN_DRAFT"))  # a quick look while a maker is being written
OCCLUSION_SAMPLES = 8 if DRAFT else 64  # 16 is visibly blotchy
OCCLUSION_FLOOR = 0.08
BURIED = 0.02  # darker is what lies inside another piece


def reset_blender() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def join(
    meshes: list[Mesh], part_of_mesh: list[int], name: str, smooth_deg: float = 40
) -> bpy.types.Object:
    """One object of all meshes; face attributes keep part, weight and whether UVs are native."""
    vertices, rest, faces, shift, materials = [], [], [], 0, []
    per_face: dict[str, list] = {k: [] for k in ("material", "smooth", "native", "weight", "part")}
    corners: dict[str, list] = {"label": [], "bake": []}
    for mesh, part in zip(meshes, part_of_mesh, strict=True):
        slots = []
        for material in mesh.mats:
            if material.block not in materials:
                materials.append(material.block)
            slots.append(materials.index(material.block))
        used = sorted({i for face in mesh.f for i in face})
        renumber = {old: new + shift for new, old in enumerate(used)}
        vertices += [mesh.v[i].tolist() for i in used]
        pattern = mesh.v if mesh.rest is None else mesh.rest
        rest += [pattern[i].tolist() for i in used]
        shift += len(used)
        for i, face in enumerate(mesh.f):
            faces.append([renumber[j] for j in face])
            blank = [(0.0, 0.0)] * len(face)
            corners["label"] += list(mesh.label_uv[i]) if mesh.label_uv else blank
            corners["bake"] += list(mesh.bake_uv[i]) if mesh.bake_uv else blank
            values = (slots[mesh.mi[i]], mesh.smooth, mesh.bake_uv is not None, mesh.weight, part)
            for key, value in zip(per_face, values, strict=True):
                per_face[key].append(value)
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    data.update()
    if len(data.polygons) != len(faces):
        raise RuntimeError(f"{name}: Blender dropped faces (duplicate or degenerate)")
    for layer, values in corners.items():
        data.uv_layers.new(name=layer)
        data.uv_layers[layer].data.foreach_set("uv", np.array(values, np.float32).ravel())
    for material in materials:
        data.materials.append(material)
    data.polygons.foreach_set("material_index", per_face["material"])
    data.polygons.foreach_set("use_smooth", per_face["smooth"])
    for key, kind in (("native", "INT"), ("weight", "FLOAT"), ("part", "INT")):
        data.attributes.new(key, kind, "FACE").data.foreach_set("value", per_face[key])
    data.attributes.new("rest", "FLOAT_VECTOR", "POINT").data.foreach_set("vector", np.ravel(rest))
    data.uv_layers.active = data.uv_layers["bake"]
    data.uv_layers["bake"].active_render = True
    data.use_auto_smooth = True
    data.auto_smooth_angle = math.radians(smooth_deg)
    obj = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(obj)
    _activate(obj)
    modifier = obj.modifiers.new("normals", "WEIGHTED_NORMAL")
    modifier.keep_sharp = True
    return obj


def _activate(obj) -> None:
    for other in bpy.context.selected_objects:
        other.select_set(False)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)


def face_attribute(data, name: str, kind=int) -> np.ndarray:
    out = np.zeros(len(data.polygons), kind)
    data.attributes[name].data.foreach_get("value", out)
    return out


def _read_uv(data) -> np.ndarray:
    out = np.zeros(len(data.loops) * 2, np.float32)
    data.uv_layers["bake"].data.foreach_get("uv", out)  # fetched anew: stale after a mode change
    return out.reshape(-1, 2)


def _write_uv(data, uv: np.ndarray) -> None:
    data.uv_layers["bake"].data.foreach_set("uv", np.ascontiguousarray(uv, np.float32).ravel())


def unwrap(obj, margin: float = 0.005) -> None:
    """Average the islands' scale, weigh and pack them; smart projection where none is given."""
    data = obj.data
    for material in data.materials:
        # packing corrects for the proportions of the active image: an empty one, not a drawn label
        nodes = material.node_tree.nodes
        empty = nodes.get("bake target") or nodes.new("ShaderNodeTexImage")
        empty.name = "bake target"
        nodes.active = empty
    native = face_attribute(data, "native")
    bpy.context.scene.tool_settings.use_uv_select_sync = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    # (selecting through the mesh before edit mode selects everything)
    bm = bmesh.from_edit_mesh(data)
    for face in bm.faces:
        face.select_set(False)
    for face, given in zip(bm.faces, native, strict=True):
        if not given:
            face.select_set(True)
    bmesh.update_edit_mesh(data)
    if not native.all():
        bpy.ops.uv.smart_project(angle_limit=math.radians(66), island_margin=0.005)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.average_islands_scale()
    bpy.ops.object.mode_set(mode="OBJECT")
    corners = np.zeros(len(data.polygons), int)
    data.polygons.foreach_get("loop_total", corners)
    weight = np.repeat(face_attribute(data, "weight", np.float32), corners)
    _write_uv(data, _read_uv(data) * weight[:, None])
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.pack_islands(rotate=True, margin_method="FRACTION", margin=margin)
    bpy.ops.object.mode_set(mode="OBJECT")
    uv = _read_uv(data)
    low, high, border = uv.min(0), uv.max(0), 0.006
    _write_uv(data, (uv - low) / max((high - low).max(), 1e-9) * (1 - 2 * border) + border)


def _bake(obj, kind: str, size: int, samples: int) -> np.ndarray:
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False  # this build has none, and bakes black when asked for it
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.seed = 1
    scene.view_settings.view_transform = "Standard"
    image = bpy.data.images.new("bake", size, size, alpha=True, float_buffer=True)
    image.colorspace_settings.name = "Linear" if kind == "EMIT" else "Non-Color"
    for material in obj.data.materials:
        nodes = material.node_tree.nodes
        node = nodes.get("bake target") or nodes.new("ShaderNodeTexImage")
        node.name, node.image, nodes.active = "bake target", image, node
    _activate(obj)
    bpy.ops.object.bake(type=kind, margin=4, use_clear=True)
    pixels = np.empty(size * size * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(size, size, 4)[::-1, :, :3]


def _subset(obj, keep: np.ndarray):
    """A copy of the object with some of its faces."""
    bm = bmesh.new()
    bm.from_mesh(obj.data)
    bmesh.ops.delete(
        bm, geom=[f for f, k in zip(bm.faces, keep, strict=True) if not k], context="FACES"
    )
    data = obj.data.copy()
    bm.to_mesh(data)
    bm.free()
    copy = bpy.data.objects.new("subset", data)
    bpy.context.collection.objects.link(copy)
    return copy


def _ground(z: float):
    data = bpy.data.meshes.new("ground")
    s = 50.0
    data.from_pydata([(-s, -s, z), (s, -s, z), (s, s, z), (-s, s, z)], [], [(0, 1, 2, 3)])
    ground = bpy.data.objects.new("ground", data)
    bpy.context.collection.objects.link(ground)
    return ground


def _masks(obj, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Per texel: the part it belongs to (-1: none), and its material's occlusion strength."""
    data = obj.data
    uv = _read_uv(data) * [size, -size] + [0, size]
    part = face_attribute(data, "part")
    owner, strength = Image.new("I", (size, size), -1), Image.new("L", (size, size), 255)
    draw_owner, draw_strength = ImageDraw.Draw(owner), ImageDraw.Draw(strength)
    for polygon in data.polygons:
        points = [tuple(uv[i] - 0.5) for i in polygon.loop_indices]
        k = int(part[polygon.index])
        draw_owner.polygon(points, fill=k, outline=k)
        value = int(255 * data.materials[polygon.material_index]["occlusion"])
        draw_strength.polygon(points, fill=value, outline=value)
    return np.asarray(owner).astype(int), np.asarray(strength) / 255.0


def bake_texture(
    obj,
    groups: list[list[int]],
    size: int,
    ground_group: int | None = None,
    strength: float = 1.0,
    cache: Path | None = None,
    clear_joints: bool = False,
) -> np.ndarray:
    """The finished texture: colour times occlusion, gutters filled. uint8, (size, size, 3).

    groups: lists of part numbers that shade one another; each group is baked without the
    others, so that the inside of a cupboard is not black behind its shut door.
    cache: folder that keeps the occlusion of each geometry; skins of one shape share it.
    clear_joints: of a face that is half buried in another piece, the buried texels take the light
        of those beside them. Black, they would show along the joint wherever the strip that is
        seen is no wider than a texel or two: a dotted line.
    """
    big = _bake(obj, "EMIT", size * SUPERSAMPLING, 2)
    valid = (big.sum(-1) > 0)[..., None]  # baked alpha is 1 everywhere: black means nothing there
    weight = _shrink(valid.astype(np.float32))
    colour = _to_srgb(_shrink(big * valid) / np.maximum(weight, 1e-6))
    covered = weight[..., 0] > 0
    if len(np.unique((colour[covered] * 255).astype(int))) < 2:
        raise RuntimeError("the bake is blank")
    occlusion = _occlusion(obj, groups, size, ground_group, cache)
    _, sensitivity = _masks(obj, size)
    if clear_joints:
        light = np.repeat(occlusion[..., None], 3, -1)
        occlusion = _fill_gutters(light, covered & (occlusion >= BURIED))[..., 0]
    occlusion = OCCLUSION_FLOOR + (1 - OCCLUSION_FLOOR) * _blur(occlusion, covered)
    # bright surfaces darken less: light bounces between them, and white must not turn grey
    exponent = strength * sensitivity[..., None] * (1 - 0.6 * colour)
    result = _fill_gutters(colour * occlusion[..., None] ** exponent, covered)
    return (result.clip(0, 1) * 255 + 0.5).astype(np.uint8)


def _occlusion(
    obj, groups: list[list[int]], size: int, ground_group: int | None, cache: Path | None
) -> np.ndarray:
    """The occlusion, from the cache where the same geometry has been baked before."""
    if cache is None:
        return _bake_occlusion(obj, groups, size, ground_group)
    data = obj.data
    corners = np.array([v for p in data.polygons for v in (*p.vertices, -1)])
    points = np.zeros(len(data.vertices) * 3, np.float32)
    data.vertices.foreach_get("co", points)
    key = hashlib.sha256(repr((groups, size, ground_group, OCCLUSION_SAMPLES)).encode())
    for array in (corners, points, _read_uv(data), face_attribute(data, "part")):
        key.update(array.tobytes())
    path = cache / f"{key.hexdigest()}.npy"
    if not path.exists():
        cache.mkdir(parents=True, exist_ok=True)
        temporary = cache / f"{os.getpid()}.tmp.npy"
        np.save(temporary, _bake_occlusion(obj, groups, size, ground_group).astype(np.float32))
        os.replace(temporary, path)
    return np.load(path).astype(float)


def _bake_occlusion(
    obj, groups: list[list[int]], size: int, ground_group: int | None
) -> np.ndarray:
    world = bpy.context.scene.world or bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    part = face_attribute(obj.data, "part")
    owner, _ = _masks(obj, size)
    occlusion = np.ones((size, size))
    obj.hide_render = True
    for number, group in enumerate(groups):
        copy = _subset(obj, np.isin(part, group))
        world.light_settings.distance = max(copy.dimensions) * 0.6
        z = min(v.co.z for v in copy.data.vertices)
        ground = _ground(z - 0.0005) if number == ground_group else None
        baked = _bake(copy, "AO", size, OCCLUSION_SAMPLES)[..., 0]
        for leftover in (copy, ground):  # anything left behind would blotch the next bake
            if leftover is not None:
                bpy.data.objects.remove(leftover)
        mine = np.isin(owner, group)
        if len(groups) == 1:
            mine |= owner < 0
        occlusion[mine] = baked[mine]
    obj.hide_render = False
    return occlusion


def _to_srgb(x: np.ndarray) -> np.ndarray:
    x = np.clip(x, 0, 1)
    return np.where(x <= 0.0031308, x * 12.92, 1.055 * x ** (1 / 2.4) - 0.055)


def _shrink(a: np.ndarray) -> np.ndarray:
    k, n = SUPERSAMPLING, a.shape[0] // SUPERSAMPLING
    return a.reshape(n, k, n, k, -1).mean((1, 3))


def _blur(values: np.ndarray, mask: np.ndarray) -> np.ndarray:
    weight = mask.astype(np.float32)
    total = values * weight
    for axis in (0, 1):
        for_each = ((-1, 0.25), (0, 0.5), (1, 0.25))
        total = sum(np.roll(total, s, axis) * c for s, c in for_each)
        weight = sum(np.roll(weight, s, axis) * c for s, c in for_each)
    return np.where(weight > 0, total / np.maximum(weight, 1e-6), values)


def _fill_gutters(colour: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Spread island colours outwards (push-pull): EGL uses mipmaps, which would bleed black."""
    levels = [(colour * mask[..., None], mask.astype(np.float32))]
    while levels[-1][0].shape[0] > 1:
        c, w = levels[-1]
        h = c.shape[0] // 2
        total, weight = c.reshape(h, 2, h, 2, 3).sum((1, 3)), w.reshape(h, 2, h, 2).sum((1, 3))
        some = (weight > 0).astype(np.float32)
        levels.append((total / np.maximum(weight, 1e-6)[..., None] * some[..., None], some))
    out = levels[-1][0]
    for c, w in levels[-2::-1]:
        out = np.where(w[..., None] > 0, c, out.repeat(2, 0).repeat(2, 1))
    return out
