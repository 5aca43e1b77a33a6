"""A tiny library and home made of boxes, for tests that need bodies but no real models."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
import yaml
from PIL import Image
from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.geometry import Quat, Vec2, Vec3, look_at
from sdgen.library import Library
from sdgen.scene import AgentStart, Box, Camera, Home, ObjectInstance, Pose, Room, Scene, Structure

RED, GREEN, BLUE, GREY = (200, 40, 40), (40, 180, 60), (40, 60, 200), (150, 150, 150)

#: id → (parts, joints, mass): a part is name, low corner, high corner, joint.
MODELS: dict[str, dict[str, Any]] = {
    "cube_01": {"parts": [("body", (-0.1, -0.1, 0.0), (0.1, 0.1, 0.2), None)], "rgb": RED},
    "cube_02": {"parts": [("body", (-0.1, -0.1, 0.0), (0.1, 0.1, 0.2), None)], "rgb": GREEN},
    "sheet_01": {"parts": [("body", (-0.3, -0.05, 0.0), (0.3, 0.05, 0.004), None)], "rgb": BLUE},
    "plank_01": {"parts": [("body", (-0.3, -0.05, 0.0), (0.3, 0.05, 0.02), None)], "rgb": BLUE},
    # Two parts whose faces coincide: which one is seen is up to the order of drawing.
    "flush_01": {
        "parts": [
            ("frame", (-0.1, -0.1, 0.0), (0.1, 0.1, 0.2), None),
            ("pane", (-0.1, -0.05, 0.05), (0.1, 0.05, 0.15), None),
        ],
        "variants": {"pane": ["pane"]},
        "rgb": BLUE,
    },
    "ceiling_lamp_91": {
        "parts": [("body", (-0.15, -0.15, 0.0), (0.15, 0.15, 0.1), None)],
        "rgb": (250, 240, 220),
        "rgba": [1.6, 1.6, 1.6, 1.0],
    },
    "glass_91": {
        "parts": [("body", (-0.1, -0.1, 0.0), (0.1, 0.1, 0.2), None)],
        "rgb": BLUE,
        "rgba": [1.0, 1.0, 1.0, 0.4],
    },
    # Its back at -x, hung by the foot.
    "mirror_91": {
        "parts": [
            ("body", (-0.02, -0.4, 0.0), (0.0, 0.4, 0.6), None),
            ("pane", (0.0, -0.38, 0.02), (0.005, 0.38, 0.58), None),
        ],
        "rgb": GREY,
    },
    "table_01": {
        "parts": [
            ("top", (-0.5, -0.4, 0.7), (0.5, 0.4, 0.74), None),
            ("legs", (-0.05, -0.05, 0.0), (0.05, 0.05, 0.7), None),
        ],
        "rgb": GREY,
        "mass": 20.0,
    },
    "cabinet_01": {
        "parts": [
            ("back", (-0.3, -0.3, 0.0), (-0.26, 0.3, 0.8), None),
            ("floor", (-0.26, -0.3, 0.0), (0.3, 0.3, 0.04), None),
            ("door", (0.3, -0.3, 0.0), (0.33, 0.3, 0.8), "door"),
        ],
        "joints": [
            {
                "name": "door",
                "type": "revolute",
                "origin_m": [0.3, 0.3, 0.0],
                "axis": [0, 0, -1],
                "lower": -2.0,
                "upper": 0.0,
            }
        ],
        "rgb": GREY,
        "mass": 30.0,
    },
}


def write_library(folder: Path) -> Path:
    """An asset folder with :data:`MODELS` and two surfaces; returns the folder."""
    (folder / "meshes").mkdir(parents=True)
    (folder / "textures").mkdir()
    assets = []
    for name, model in MODELS.items():
        Image.new("RGB", (16, 16), model["rgb"]).save(folder / "textures" / f"{name}.png")
        scene = trimesh.Scene()
        pieces = []
        for part, low, high, _ in model["parts"]:
            box = trimesh.creation.box(bounds=[low, high])
            box.unmerge_vertices()  # flat normals
            pieces.append({"part": part, "vertices_m": _corners(low, high)})
            vertices = np.asarray(box.vertices)[:, [0, 2, 1]] * [1, 1, -1]  # to glTF's Y up
            mesh = trimesh.Trimesh(vertices, box.faces, process=False)
            mesh.visual = trimesh.visual.TextureVisuals(uv=np.full((len(vertices), 2), 0.5))
            scene.add_geometry(mesh, node_name=part, geom_name=part)
        scene.export(folder / "meshes" / f"{name}.glb", include_normals=True)
        hulls = {"pieces": pieces}
        (folder / "meshes" / f"{name}.hulls.json").write_text(json.dumps(hulls), encoding="utf-8")
        low_all = np.min([p[1] for p in model["parts"]], axis=0)
        high_all = np.max([p[2] for p in model["parts"]], axis=0)
        assets.append(
            {
                "id": name,
                "category": name[:-3],
                "licence": "CC0-1.0",
                "source": "test",
                "extents_m": [float(v) for v in high_all - low_all],
                "mass_kg": model.get("mass", 0.5),
                "parts": [
                    {
                        "name": p,
                        "faces": 12,
                        **({"joint": j} if j else {}),
                        **({"rgba": model["rgba"]} if "rgba" in model else {}),
                    }
                    for p, _, _, j in model["parts"]
                ],
                "joints": model.get("joints", []),
                "variants": {
                    "default": [p[0] for p in model["parts"]],
                    **model.get("variants", {}),
                },
                "mesh": f"meshes/{name}.glb",
                "hulls": f"meshes/{name}.hulls.json",
                "texture": f"textures/{name}.png",
            }
        )
    Image.new("RGB", (16, 16), (160, 120, 80)).save(folder / "textures" / "surface_f.png")
    Image.new("RGB", (16, 16), (220, 220, 210)).save(folder / "textures" / "surface_w.png")
    surfaces = [
        {"id": "f", "kind": "floor", "texture": "textures/surface_f.png", "size_m": 1.0},
        {"id": "w", "kind": "wall", "texture": "textures/surface_w.png", "size_m": 1.0},
    ]
    text = yaml.safe_dump({"assets": assets, "surfaces": surfaces})
    (folder / "manifest.yaml").write_text(text, encoding="utf-8")
    return folder


def fake_library(folder: Path) -> Library:
    """The library of :func:`write_library`."""
    return Library([write_library(folder)])


def _corners(low: Sequence[float], high: Sequence[float]) -> list[list[float]]:
    return [
        [x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])
    ]


def thing(
    number: int,
    asset: str,
    position_m: Vec3,
    quat_xyzw: Quat = (0.0, 0.0, 0.0, 1.0),
    **more: Any,
) -> ObjectInstance:
    """An object of one of the fake models, default variant, all its parts drawn."""
    return ObjectInstance(
        id=number,
        category=asset[:-3],
        asset=asset,
        pose=Pose(position_m=position_m, quat_xyzw=quat_xyzw),
        room_id=1,
        parts=tuple(part[0] for part in MODELS[asset]["parts"]),
        **more,
    )


def box_room(
    objects: Sequence[ObjectInstance] = (), size_m: Vec2 = (4.0, 4.0), height_m: float = 2.5
) -> Scene:
    """One closed room around the origin: room 1, floor 2, ceiling 3, walls 4 to 7."""
    x, y = size_m[0] / 2, size_m[1] / 2
    outline: tuple[Vec2, ...] = ((-x, -y), (x, -y), (x, y), (-x, y))
    floor = Box(center_m=(0, 0, -0.05), size_m=(2 * x + 0.2, 2 * y + 0.2, 0.1))
    ceiling = Box(center_m=(0, 0, height_m + 0.05), size_m=(2 * x + 0.2, 2 * y + 0.2, 0.1))
    walls = [
        Box(center_m=(x + 0.05, 0, height_m / 2), size_m=(0.1, 2 * y, height_m)),
        Box(center_m=(-x - 0.05, 0, height_m / 2), size_m=(0.1, 2 * y, height_m)),
        Box(center_m=(0, y + 0.05, height_m / 2), size_m=(2 * x, 0.1, height_m)),
        Box(center_m=(0, -y - 0.05, height_m / 2), size_m=(2 * x, 0.1, height_m)),
    ]
    structures = [
        Structure(id=2, category="floor", room_id=1, surface="f", pieces=(floor,)),
        Structure(id=3, category="ceiling", room_id=1, surface="w", pieces=(ceiling,)),
        *(
            Structure(id=4 + k, category="wall", room_id=1, surface="w", pieces=(wall,))
            for k, wall in enumerate(walls)
        ),
    ]
    room = Room(id=1, name="room", type="living_room", polygon_m=outline, height_m=height_m)
    return Scene(
        id="000000",
        index=0,
        home=Home(id="test", kind="base", rooms=(room,), structures=tuple(structures), openings=()),
        zones=(),
        free_space=(outline,),
        agent_start=AgentStart(position_m=(0, 0, 0), yaw_rad=0, room_id=1),
        objects=tuple(objects),
    )


def camera_at(eye_m: Vec3, target_m: Vec3, size: tuple[int, int] = (640, 480)) -> Camera:
    """A camera of ``size`` (width, height) that looks from one point at another."""
    return Camera(
        index=0,
        kind="room",
        room_id=1,
        width=size[0],
        height=size[1],
        K=intrinsics(*size),
        world_from_camera=matrix4(look_at(eye_m, target_m)),
        near_m=NEAR_M,
        far_m=FAR_M,
    )
