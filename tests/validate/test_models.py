"""What ``sdgen assets validate`` finds in models, one fault at a time."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
import yaml
from PIL import Image
from sdgen.catalog.records import Category
from sdgen.cli.main import run
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.validate.models import Model, check_model

CATEGORY = Category(
    name="locker",
    superclass="Furniture",
    extents_min_m=(0.3, 0.3, 0.4),
    extents_max_m=(0.6, 0.6, 1.0),
    mass_min_kg=5.0,
    mass_max_kg=40.0,
    properties=("SURFACES",),
    kind="furniture",
)
BODY, DOOR = ((-0.2, -0.2, 0.0), (0.17, 0.2, 0.6)), ((0.17, -0.2, 0.0), (0.2, 0.2, 0.6))


def box(bounds: Any) -> trimesh.Trimesh:
    """A box with flat normals, its six faces spread over the texture."""
    mesh = trimesh.creation.box(bounds=bounds)
    mesh.unmerge_vertices()
    uv = np.random.default_rng(0).random((len(mesh.vertices), 2))
    mesh.visual = trimesh.visual.TextureVisuals(uv=uv)
    return mesh


def sound() -> tuple[dict[str, Any], dict[str, trimesh.Trimesh], list[dict[str, Any]]]:
    """The record, meshes and hulls of a locker that is as it should be."""
    meshes = {"body": box(BODY), "door": box(DOOR)}
    hulls = [{"part": part, "vertices_m": mesh.vertices.tolist()} for part, mesh in meshes.items()]
    record = {
        "id": "locker_01",
        "category": "locker",
        "licence": "CC0-1.0",
        "source": "test",
        "extents_m": [0.4, 0.4, 0.6],
        "mass_kg": 12.0,
        "mesh": "locker.glb",
        "hulls": "locker.json",
        "texture": "locker.png",
        "parts": [{"name": "body", "faces": 12}, {"name": "door", "faces": 12, "joint": "door"}],
        "joints": [
            {
                "name": "door",
                "type": "revolute",
                "origin_m": [0.2, 0.2, 0.0],
                "axis": [0, 0, 1],
                "lower": 0.0,
                "upper": 1.8,
            }
        ],
        "variants": {"default": ["body", "door"]},
        "states": [{"state": "OPEN", "joint": "door", "min": 0.6, "parts": ["door"]}],
        "supports": [
            {
                "name": "top",
                "part": "body",
                "z_m": 0.6,
                "polygon_m": [[-0.19, -0.19], [0.15, -0.19], [0.15, 0.19], [-0.19, 0.19]],
            }
        ],
    }
    return record, meshes, hulls


def texture() -> Image.Image:
    grain = np.random.default_rng(1).integers(60, 200, (32, 32, 3), dtype=np.uint8)
    return Image.fromarray(grain)


def write(folder: Path, record: Any, meshes: Any, hulls: Any, image: Image.Image) -> Path:
    scene = trimesh.Scene()
    for part, mesh in meshes.items():
        turned = mesh.copy()
        turned.vertices = np.asarray(mesh.vertices)[:, [0, 2, 1]] * [1, 1, -1]
        scene.add_geometry(turned, node_name=part, geom_name=part)
    folder.mkdir(exist_ok=True)
    scene.export(folder / "locker.glb", include_normals=True)
    (folder / "locker.json").write_text(json.dumps({"pieces": hulls}), encoding="utf-8")
    image.save(folder / "locker.png")
    image.save(folder / "floor.png")
    floor = {"id": "f", "kind": "floor", "texture": "floor.png", "size_m": 1.0}
    text = yaml.safe_dump({"assets": [record], "surfaces": [floor]})
    (folder / "manifest.yaml").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with Client() as made:
        yield made


def found(folder: Path, client: Client, category: Category | None = CATEGORY) -> list[str]:
    library = Library([folder])
    return check_model(Model(library.assets["locker_01"], library, category), client)


def test_a_sound_model_passes(tmp_path: Path, client: Client) -> None:
    assert found(write(tmp_path, *sound(), texture()), client) == []


def test_a_category_without_a_size_is_named(tmp_path: Path, client: Client) -> None:
    (told,) = found(write(tmp_path, *sound(), texture()), client, None)
    assert told == ("locker_01 (test): size: no catalogue gives a size for the category 'locker'")


def _other_record(record: Any, meshes: Any, hulls: Any) -> None:
    record["extents_m"] = [0.4, 0.4, 0.9]


def _too_tall(record: Any, meshes: Any, hulls: Any) -> None:
    for mesh in meshes.values():
        mesh.vertices *= (1, 1, 2)
    for hull in hulls:
        hull["vertices_m"] = (np.array(hull["vertices_m"]) * (1, 1, 2)).tolist()
    record["extents_m"], record["supports"][0]["z_m"] = [0.4, 0.4, 1.2], 1.2


def _too_heavy(record: Any, meshes: Any, hulls: Any) -> None:
    record["mass_kg"] = 120.0


def _off_centre(record: Any, meshes: Any, hulls: Any) -> None:
    for mesh in meshes.values():
        mesh.vertices += (0.05, 0, 0)


def _hole(record: Any, meshes: Any, hulls: Any) -> None:
    outward = meshes["body"].face_normals @ (0, 0, 1) > 0.9
    meshes["body"].update_faces(~outward)
    record["parts"][0]["faces"] = 10
    record["supports"] = []


def _no_coordinates(record: Any, meshes: Any, hulls: Any) -> None:
    meshes["body"].visual.uv[:] = 0.5


def _small_hulls(record: Any, meshes: Any, hulls: Any) -> None:
    hulls[0]["vertices_m"] = (np.array(hulls[0]["vertices_m"]) * 0.6).tolist()


def _large_hulls(record: Any, meshes: Any, hulls: Any) -> None:
    # A box around a wedge. (Beyond the box of what is drawn pieces are cut when they are read.)
    vertices = np.array(meshes["body"].vertices)
    vertices[vertices[:, 2] > 0.5, 0] = 0.17
    meshes["body"].vertices = vertices


def _tipping(record: Any, meshes: Any, hulls: Any) -> None:
    # A foot under one edge only.
    low, high = (-0.2, -0.2, 0.1), (0.17, 0.2, 0.6)
    foot = ((-0.2, -0.2, 0.0), (-0.19, 0.2, 0.1))
    meshes["body"] = trimesh.util.concatenate([box((low, high)), box(foot)])
    meshes["door"] = box(((0.17, -0.2, 0.1), (0.2, 0.2, 0.6)))
    record["parts"][0]["faces"] = 24
    hulls[:] = [
        {"part": "body", "vertices_m": box((low, high)).vertices.tolist()},
        {"part": "body", "vertices_m": box(foot).vertices.tolist()},
        {"part": "door", "vertices_m": meshes["door"].vertices.tolist()},
    ]


def _cutting_joint(record: Any, meshes: Any, hulls: Any) -> None:
    record["joints"][0]["axis"] = [0, 0, -1]


def _unreachable(record: Any, meshes: Any, hulls: Any) -> None:
    record["states"][0]["min"] = 2.5


def _support_in_the_air(record: Any, meshes: Any, hulls: Any) -> None:
    record["supports"].append({**record["supports"][0], "name": "shelf", "z_m": 0.75})


def _support_forgotten(record: Any, meshes: Any, hulls: Any) -> None:
    record["supports"] = []


def _false_headroom(record: Any, meshes: Any, hulls: Any) -> None:
    bottom = ((-0.2, -0.2, 0.0), (0.17, 0.2, 0.04))
    lid = ((-0.2, -0.2, 0.5), (0.17, 0.2, 0.6))
    back = ((-0.2, -0.2, 0.04), (-0.17, 0.2, 0.5))
    boxes = [box(bounds) for bounds in (bottom, lid, back)]
    meshes["body"] = trimesh.util.concatenate(boxes)
    record["parts"][0]["faces"] = 36
    hulls[:1] = [{"part": "body", "vertices_m": b.vertices.tolist()} for b in boxes]
    inner = [[-0.16, -0.19], [0.15, -0.19], [0.15, 0.19], [-0.16, 0.19]]
    floor = {"name": "floor", "part": "body", "z_m": 0.04, "polygon_m": inner, "headroom_m": 0.55}
    record["supports"].append(floor)


Damage = Callable[[Any, Any, Any], None]


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (_other_record, "size: the mesh measures 0.400 x 0.400 x 0.600 m, the record says"),
        (_too_tall, "size: 1.200 m high; a locker has 0.4 to 1 m"),
        (_too_heavy, "size: 120 kg; a locker has 5 to 40 kg"),
        (_off_centre, "size: the origin is not the middle of the bottom"),
        (_hole, "closed: variant 'default' shows its back faces"),
        (_no_coordinates, "texture: part 'body' has no texture coordinates"),
        (_small_hulls, "outside the hulls"),
        (_large_hulls, "collision: the hulls reach around"),
        (_tipping, "rest: "),
        (_cutting_joint, "joints: joint 'door' cuts"),
        (_unreachable, "joints: state OPEN lies beyond the range of the joint 'door'"),
        (_support_in_the_air, "supports: support 'shelf' at 0.75 m lies on nothing"),
        (_support_forgotten, "supports: no support names the surface of 0.1"),
        (_false_headroom, "supports: support 'floor' has 0.46 m above it, not 0.55"),
    ],
)
def test_a_fault_is_named(tmp_path: Path, client: Client, damage: Damage, words: str) -> None:
    record, meshes, hulls = sound()
    damage(record, meshes, hulls)
    told = found(write(tmp_path, record, meshes, hulls, texture()), client)
    assert any(words in line for line in told), told


@pytest.mark.parametrize(("start", "named"), [(0.06, True), (0.085, False)])
def test_a_step_is_of_one_piece_with_the_support_that_ends_at_it(
    tmp_path: Path, client: Client, start: float, named: bool
) -> None:
    """As the sheet turned down over a blanket is: 4 cm apart they could be two compartments."""
    record, meshes, hulls = sound()
    top = max(vertex[2] for vertex in meshes["body"].vertices.tolist())
    sheet = box(((-0.2, -0.2, top), (0.05, 0.2, top + 0.015)))
    meshes["body"] = trimesh.util.concatenate([meshes["body"], sheet])
    record["parts"][0]["faces"] = len(meshes["body"].faces)
    record["extents_m"][2] = top + 0.015
    beside = [[start, -0.18], [0.18, -0.18], [0.18, 0.18], [start, 0.18]]
    record["supports"] = [{**record["supports"][0], "polygon_m": beside, "z_m": top}]
    told = found(write(tmp_path, record, meshes, hulls, texture()), client)
    assert any("no support names" in line for line in told) is not named, told


def test_a_part_declared_open_may_be(tmp_path: Path, client: Client) -> None:
    record, meshes, hulls = sound()
    _hole(record, meshes, hulls)
    record["parts"][0]["open"] = True
    told = found(write(tmp_path, record, meshes, hulls, texture()), client)
    assert not any("closed" in line for line in told), told


def test_one_colour_is_no_texture(tmp_path: Path, client: Client) -> None:
    folder = write(tmp_path, *sound(), Image.new("RGB", (32, 32), (120, 90, 60)))
    (told,) = found(folder, client)
    assert "texture: locker.png: 1 colours" in told


def test_too_many_faces_are_told_for_every_variant(tmp_path: Path, client: Client) -> None:
    record, meshes, hulls = sound()
    while len(meshes["body"].faces) <= 2500:
        meshes["body"] = meshes["body"].subdivide()
    record["parts"][0]["faces"] = len(meshes["body"].faces)
    record["variants"]["bare"] = ["body"]
    told = found(write(tmp_path, record, meshes, hulls, texture()), client)
    assert sorted(line for line in told if "faces, at most" in line) == [
        "locker_01 (test): faces: variant 'bare' has 3072 faces, at most 800",
        "locker_01 (test): faces: variant 'default' has 3084 faces, at most 800",
    ]


def test_the_command_checks_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    record, meshes, hulls = sound()
    _too_heavy(record, meshes, hulls)
    write(tmp_path, record, meshes, hulls, texture())
    sizes = tmp_path / "catalog" / "categories"
    sizes.mkdir(parents=True)
    entry = {
        "superclass": "Furniture",
        "kind": "furniture",
        "size_m": [[0.3, 0.3, 0.4], [0.6, 0.6, 1.0]],
        "mass_kg": [5, 40],
        "properties": ["SURFACES"],
    }
    (sizes / "mine.yaml").write_text(yaml.safe_dump({"locker": entry}), encoding="utf-8")
    command = ["assets", "validate", str(tmp_path), "--catalog", str(sizes.parent)]
    assert run(command) == 1
    told = capsys.readouterr()
    assert told.out.startswith("locker_01 (test): size: 120 kg")
    assert told.err == "1 models checked, 1 problem\n"
    record["mass_kg"] = 12.0
    write(tmp_path, record, meshes, hulls, texture())
    assert run(command) == 0
    assert capsys.readouterr().out == "1 models checked, no problem found\n"


def test_a_folder_that_cannot_be_read_is_an_error(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "manifest.yaml").write_text("assets: 3\n", encoding="utf-8")
    assert run(["assets", "validate", str(tmp_path)]) == 1
    assert "expected a list, got the number 3" in capsys.readouterr().err
