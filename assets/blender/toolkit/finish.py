"""From a `Model` to its files."""

from __future__ import annotations

import json
from pathlib import Path

from .export import Frame, record, triangles, write_glb, write_jpeg
from .model import Model
from .prune import prune_hidden
from .uv_bake import DRAFT, bake_texture, join, unwrap


def finish(
    model: Model, asset_id: str, category: str, source: str, assets: Path, records: Path
) -> str:
    """Prune, unwrap, bake and write; returns a line about the result."""
    names = list(model.parts)
    grouped: dict[str, list[int]] = {}
    for number, name in enumerate(names):
        grouped.setdefault(model.occlusion_group(name), []).append(number)
    check(model, asset_id)
    frame = Frame(model)
    if model.prune:
        for numbers in grouped.values():
            prune_hidden([m for k in numbers for m in model.parts[names[k]].meshes])
    meshes, part_of_mesh = [], []
    for number, name in enumerate(names):
        for mesh in model.parts[name].meshes:
            if mesh.f:
                meshes.append(mesh)
                part_of_mesh.append(number)
    obj = join(meshes, part_of_mesh, asset_id, model.smooth_deg)
    unwrap(obj)
    groups = list(grouped.values())
    ground = list(grouped).index("fixed") if model.ground_shadow else None
    pixels = bake_texture(
        obj,
        groups,
        model.texture_size,
        ground,
        model.occlusion_strength,
        records / "occlusion",
        model.clear_joints,
    )
    write_jpeg(assets / "textures" / f"{asset_id}.jpg", pixels)
    data = triangles(obj)
    data["p"] = frame.points(data["p"])
    data["n"] = frame.directions(data["n"])
    split = {
        name: {k: v[data["part"] == i] for k, v in data.items()} for i, name in enumerate(names)
    }
    # Into the build folder: assemble.py stores a mesh that several skins share only once.
    write_glb(records / "meshes" / f"{asset_id}.glb", split, f"../textures/{asset_id}.jpg")
    faces = {name: len(d["p"]) for name, d in split.items()}
    if not all(faces.values()):
        raise RuntimeError(f"{asset_id}: a part without faces: {faces}")
    entry = record(model, frame, asset_id, category, source, faces)
    if DRAFT:
        entry["draft"] = True
    (records / f"{asset_id}.json").write_text(json.dumps(entry))
    size = " x ".join(f"{e:.3f}" for e in frame.extents)
    return f"{asset_id}: {sum(faces.values())} faces {faces}, {size} m"


def check(model: Model, asset_id: str) -> None:
    """Complain about what the package would stumble over."""
    known = set(model.parts)
    for variant, parts in model.variants.items():
        if unknown := set(parts) - known:
            raise ValueError(f"{asset_id}: variant {variant} names unknown parts {unknown}")
    for name, part in model.parts.items():
        if part.joint and part.joint not in model.joints:
            raise ValueError(f"{asset_id}: part {name} hangs on an unknown joint {part.joint}")
        for mesh in part.meshes:
            if mesh.signed_volume() < -1e-9 and mesh.is_closed():
                print(f"WARNING {asset_id}: a mesh of {name} is inside out")
    for item in (*model.supports, *model.containers):
        if item.part not in known:
            raise ValueError(f"{asset_id}: {item.name} is on an unknown part {item.part}")
    for state in model.states:
        joint, variants = state.get("joint"), state.get("variants", [])
        if (joint and joint not in model.joints) or set(variants) - set(model.variants):
            raise ValueError(f"{asset_id}: state {state} names something unknown")
