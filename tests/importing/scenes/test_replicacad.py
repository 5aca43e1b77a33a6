"""ReplicaCAD's scenes: a small data set of the same form, and the sample where it is."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from sdgen.importing.scenes.read import import_home
from sdgen.importing.scenes.replicacad import read_replicacad
from sdgen.importing.scenes.table_namer import table_namer

from tests.importing.scenes.homes import CATALOG, imported, shape_of, shared
from tests.shipped import shipped_library

#: Y up: (x, y, z)_habitat = (x, z, -y)_ours.
TURN = np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]])


def cad(folder: Path, scene: Mapping[str, Any]) -> Path:
    """A data set with a bed and a fridge, whose origins are mid-body, and a scene."""
    for name in (
        "configs/objects",
        "configs/scenes",
        "configs/stages",
        "objects",
        "stages",
        "urdf/fridge",
    ):
        (folder / name).mkdir(parents=True)
    box(folder / "objects" / "bed.glb", (2.1, 1.6, 0.8))
    config = {"render_asset": "../../objects/bed.glb", "mass": 18, "COM": [0, 0, 0]}
    (folder / "configs/objects/bed.object_config.json").write_text(json.dumps(config))
    box(folder / "urdf" / "fridge" / "body.glb", (0.66, 0.58, 1.84))
    (folder / "urdf" / "fridge" / "fridge.urdf").write_text(
        '<robot name="fridge"><link name="root"/><link name="body"><visual><geometry>'
        '<mesh filename="body.glb"/></geometry></visual></link><joint name="j" type="fixed">'
        '<origin xyz="0 0.1 0"/><parent link="root"/><child link="body"/></joint></robot>'
    )
    path = folder / "configs" / "scenes" / "apt.scene_instance.json"
    path.write_text(json.dumps(scene))
    return path


def box(path: Path, sides: tuple[float, float, float]) -> None:
    mesh = trimesh.creation.box(extents=sides)
    mesh.apply_transform(TURN)
    path.write_bytes(trimesh.Scene(mesh).export(file_type="glb"))


def instance(name: str, at: tuple[float, float, float], yaw: float = 0.0) -> dict[str, Any]:
    """At a place of ours, by the middle; turned about what is up."""
    x, y, z = at
    spin = [math.cos(yaw / 2), 0.0, math.sin(yaw / 2), 0.0]
    return {"template_name": f"objects/{name}", "translation": [x, z, -y], "rotation": spin}


SCENE = {
    "stage_instance": {"template_name": "stages/shell"},
    "object_instances": [instance("bed", (2.0, 3.0, 0.4), math.pi / 2)],
    "articulated_object_instances": [
        {**instance("fridge", (5.0, 0.5, 0.82)), "template_name": "fridge", "uniform_scale": 1.0}
    ],
}


def test_things_are_where_they_were_put(tmp_path: Path) -> None:
    found = read_replicacad(cad(tmp_path, SCENE), CATALOG, table_namer("replicacad", CATALOG))
    bed, fridge = found.pieces
    assert np.allclose(bed.position_m, (2.0, 3.0, 0.0), atol=1e-6)
    assert np.allclose(bed.extents_m, (2.1, 1.6, 0.8), atol=1e-6)
    assert bed.source == "replicacad:bed"
    # A quarter turn about what is up, in Habitat's frame and in ours alike.
    assert np.allclose(np.abs(bed.quat_xyzw), (0, 0, math.sqrt(0.5), math.sqrt(0.5)), atol=1e-6)
    # The link's own origin lifts it by 0.1.
    assert np.allclose(fridge.position_m, (5.0, 0.5, 0.0), atol=1e-6)


def test_the_mesh_of_the_stage_tells_of_rooms(tmp_path: Path) -> None:
    path = cad(tmp_path, SCENE)
    walls = [
        ((3.0, -0.05, 1.3), (6.2, 0.1, 2.6)),
        ((3.0, 4.05, 1.3), (6.2, 0.1, 2.6)),
        ((-0.05, 2.0, 1.3), (0.1, 4.2, 2.6)),
        ((6.05, 2.0, 1.3), (0.1, 4.2, 2.6)),
        ((4.0, 0.75, 1.3), (0.1, 1.5, 2.6)),
        ((4.0, 3.25, 1.3), (0.1, 1.5, 2.6)),
        ((4.0, 2.0, 2.35), (0.1, 1.0, 0.5)),  # over the doorway
        ((3.0, 2.0, -0.05), (6.0, 4.0, 0.1)),  # the floor
    ]
    meshes = []
    for middle, sides in walls:
        mesh = trimesh.creation.box(extents=sides)
        mesh.apply_translation(middle)
        mesh.apply_transform(TURN)
        meshes.append(mesh)
    (tmp_path / "stages" / "shell.glb").write_bytes(
        trimesh.Scene(trimesh.util.concatenate(meshes)).export(file_type="glb")
    )
    config = {"render_asset": "../../stages/shell.glb"}
    (tmp_path / "configs/stages/shell.stage_config.json").write_text(json.dumps(config))
    spec = imported("replicacad", path).spec
    kinds = {room.type: shape_of(spec, room.name).bounds for room in spec.rooms}
    assert np.allclose(kinds["bedroom"], (-0.06, -0.06, 4.0, 4.06), atol=0.05)
    assert np.allclose(kinds["kitchen"], (4.0, -0.06, 6.06, 4.06), atol=0.05)
    (way,) = (o for o in spec.openings if o.kind == "passage")
    assert np.allclose(way.center_m, (4.0, 2.0), atol=0.03)


def test_what_has_no_file_is_of_usual_size_and_told(tmp_path: Path) -> None:
    scene = {
        **SCENE,
        "object_instances": [*SCENE["object_instances"], instance("nightstand", (0.3, 0.3, 0.3))],
    }
    made = imported("replicacad", cad(tmp_path, scene))
    assert any(
        line.startswith("nightstand: its size is not known (nightstand.object_config.json: no")
        for line in made.told
    )
    (stand,) = (p for room in made.spec.rooms for p in room.furniture if p.category == "nightstand")
    assert stand.position_m[2] == 0


@pytest.mark.parametrize("name", ["../../../etc/passwd", "..", "a\0b", "/etc/passwd"])
def test_names_that_lead_elsewhere(name: str, tmp_path: Path) -> None:
    scene = {**SCENE, "object_instances": [{"template_name": name}]}
    path = cad(tmp_path, scene)
    config = {"render_asset": f"../../../{name}"}
    (tmp_path / "configs/objects/bed.object_config.json").write_text(json.dumps(config))
    found = read_replicacad(path, CATALOG, table_namer("replicacad", CATALOG))
    assert len(found.pieces) == 2
    assert any("size is not known" in line for line in found.told)


SAMPLE = shared("scans/replica_cad")


@pytest.mark.slow
@pytest.mark.skipif(SAMPLE is None, reason="shared/scans is not here")
def test_a_flat_of_the_sample_is_a_home() -> None:
    assert SAMPLE is not None
    path = SAMPLE / "configs" / "scenes" / "apt_0.scene_instance.json"
    namer = table_namer("replicacad", CATALOG)
    made = import_home("replicacad", path, "apt_0", CATALOG, shipped_library(), namer)
    (room,) = made.spec.rooms  # its stage is not in the sample
    furniture = {piece.category for piece in room.furniture}
    assert {"sofa", "fridge", "dining_table", "tv_stand", "rug", "kitchen_counter"} <= furniture
    assert len(room.furniture) >= 20
    assert made.counts["found"] == 118
