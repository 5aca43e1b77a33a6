"""Small scenes of strangers in each format, and what a home of ours is compared by."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import HomeSpec
from sdgen.importing.scenes.naming import exact_namer
from sdgen.importing.scenes.read import import_home
from sdgen.importing.scenes.to_home import Imported
from shapely import box, union_all
from shapely.geometry.base import BaseGeometry

from tests.shipped import shipped_library

CATALOG = load_catalog()
NAMER = exact_namer(CATALOG)

#: A box by its middle and its sides, metres, Z up.
Block = tuple[Sequence[float], Sequence[float]]

#: Two rooms side by side, walls 0.2 m thick with a doorway between, 3 x 4 and 4 x 4 m inside.
ROOMS: Mapping[str, Block] = {
    "floor_kitchen": ((1.5, 2.0, -0.05), (3.0, 4.0, 0.1)),
    "floor_bedroom": ((5.2, 2.0, -0.05), (4.0, 4.0, 0.1)),
    "wall_south": ((3.6, -0.1, 1.3), (7.6, 0.2, 2.6)),
    "wall_north": ((3.6, 4.1, 1.3), (7.6, 0.2, 2.6)),
    "wall_west": ((-0.1, 2.0, 1.3), (0.2, 4.4, 2.6)),
    "wall_east": ((7.3, 2.0, 1.3), (0.2, 4.4, 2.6)),
    "wall_inner_a": ((3.1, 0.5, 1.3), (0.2, 1.0, 2.6)),
    "wall_inner_b": ((3.1, 3.0, 1.3), (0.2, 2.0, 2.6)),
}
#: What stands in them, with sizes near those of our models.
THINGS: Mapping[str, Block] = {
    "Fridge_01": ((0.38, 3.6, 0.92), (0.66, 0.6, 1.84)),
    "kitchen_table": ((1.5, 1.2, 0.375), (0.8, 1.2, 0.75)),
    "bed.001": ((6.1, 2.0, 0.4), (2.1, 1.6, 0.8)),
    "wardrobe (2)": ((4.2, 3.65, 1.0), (1.2, 0.6, 2.0)),
    "Alien Artefact": ((5.0, 0.6, 0.2), (0.3, 0.3, 0.4)),
}


def write_glb(path: Path, blocks: Mapping[str, Block]) -> Path:
    """A GLB of named boxes, Y up as glTF is."""
    scene = trimesh.Scene()
    turn = np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]])
    for name, (middle, sides) in blocks.items():
        mesh = trimesh.creation.box(extents=sides)
        place = np.eye(4)
        place[:3, 3] = middle
        scene.add_geometry(mesh, node_name=name, geom_name=name, transform=turn @ place)
    path.write_bytes(scene.export(file_type="glb"))
    return path


def write_mjcf(path: Path, blocks: Mapping[str, Block], more: str = "") -> Path:
    """The same as MJCF: a body and a box each."""
    bodies = [
        f'<body name="{name}" pos="{_text(middle)}"><geom type="box" '
        f'size="{_text(side / 2 for side in sides)}"/></body>'
        for name, (middle, sides) in blocks.items()
    ]
    text = f"<mujoco>{more}<worldbody>{''.join(bodies)}</worldbody></mujoco>"
    path.write_text(text, encoding="utf-8")
    return path


def _text(values: Any) -> str:
    return " ".join(f"{value:g}" for value in values)


def write_graph(path: Path, blocks: Mapping[str, Block], more: Sequence[Any] = ()) -> Path:
    """The same as VirtualHome's graph: (x, y, z) of ours is (x, z, y) of Unity's."""

    def node(number: int, name: str, kind: str, block: Block) -> dict[str, Any]:
        (x, y, z), (a, b, c) = block
        spot = {"center": [x, z, y], "size": [a, c, b]}
        return {"id": number, "class_name": name, "category": kind, "bounding_box": spot}

    rooms = [
        node(1, "kitchen", "Rooms", ROOMS["floor_kitchen"]),
        node(2, "bedroom", "Rooms", ROOMS["floor_bedroom"]),
    ]
    edges = []
    nodes: list[Any] = [*rooms, *more]
    for number, (name, block) in enumerate(blocks.items(), start=10):
        kind = name.split("_")[0] if name.startswith("floor") else name
        nodes.append(node(number, kind, "Decor", block))
        room = 1 if block[0][0] < 3.1 else 2
        edges.append({"from_id": number, "to_id": room, "relation_type": "INSIDE"})
    path.write_text(json.dumps({"nodes": nodes, "edges": edges}))
    return path


def imported(format_: str, path: Path, name: str = "mine") -> Imported:
    """What becomes of a file."""
    return import_home(format_, path, name, CATALOG, shipped_library(), NAMER)


def shape_of(spec: HomeSpec, name: str) -> BaseGeometry:
    """The outline of a room, on the middle lines of its walls."""
    (room,) = (room for room in spec.rooms if room.name == name)
    return union_all([box(*rectangle) for rectangle in room.rectangles_m])


def shared(name: str) -> Path | None:
    """A folder of other people's data beside the repository; None where it is not."""
    folder = Path(__file__).resolve().parents[4] / "shared" / name
    return folder if folder.is_dir() else None
