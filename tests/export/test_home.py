"""A home written and read back: the same rooms, the same models, the same places."""

from __future__ import annotations

import io
import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import trimesh
from sdgen.catalog.load import load_catalog
from sdgen.export.home_glb import home_glb
from sdgen.export.home_yaml import home_yaml
from sdgen.facts import bodies_of
from sdgen.home.drawing_check import check_drawings
from sdgen.home.notes import KEY
from sdgen.options import BuildOptions
from sdgen.pipeline.one_home import OneHome, one_home
from sdgen.vocabulary import OPENINGS

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
FITTED = {fitting.category for fitting in CATALOG.fittings}
OPTIONS = BuildOptions(views=0)


@cache
def made(which: str) -> OneHome:
    return one_home(which, CATALOG, LIBRARY, OPTIONS)


def furniture(home: OneHome) -> list[tuple[str, tuple[float, ...]]]:
    """Models with their poses: position (m) and quaternion, sorted."""
    return sorted(
        (item.asset, (*item.pose.position_m, *item.pose.quat_xyzw))
        for item in home.bundle.scene.objects
        if item.fixed and item.category not in {*OPENINGS, *FITTED}
    )


@pytest.mark.parametrize("which", ["3", "8", "21", *(home.id for home in CATALOG.homes)])
def test_yaml_brings_the_same_furniture_back(which: str, tmp_path: Path) -> None:
    first = made(which)
    (tmp_path / "homes").mkdir()
    text = home_yaml("mine", first.spec, first.furnished)
    (tmp_path / "homes" / "mine.yaml").write_text(text)
    catalog = load_catalog([tmp_path])
    check_drawings(catalog, LIBRARY, [tmp_path])
    (mine,) = (home for home in catalog.homes if home.id == "mine")
    assert mine.openings == first.spec.openings
    assert mine.height_m == first.spec.height_m
    assert [room.rectangles_m for room in mine.rooms] == [
        room.rectangles_m for room in first.spec.rooms
    ]
    again = one_home("mine", catalog, LIBRARY, OPTIONS)
    before, after = furniture(first), furniture(again)
    assert [asset for asset, _ in after] == [asset for asset, _ in before]
    poses = [np.array([pose for _, pose in rows]) for rows in (before, after)]
    (was, turned), (now, turns) = ((p[:, :3], p[:, 3:]) for p in poses)
    assert np.abs(was - now).max() < 1e-3
    # A turn by half a circle is the same either way round.
    assert np.abs(np.abs((turned * turns).sum(axis=1)) - 1.0).max() < 1e-6
    # And once more it is the same text.
    written = home_yaml("mine", again.spec, again.furnished)
    assert written.splitlines()[1:] == text.splitlines()[1:]


def test_glb_has_every_object_where_it_stands() -> None:
    scene = made("3").bundle.scene
    loaded = trimesh.load_scene(io.BytesIO(home_glb(scene, LIBRARY)), file_type="glb")
    nodes = set(loaded.graph.nodes)
    for item in scene.objects:
        assert f"{item.category}_{item.id}" in nodes
    for structure in scene.home.structures:
        assert any(name.startswith(f"{structure.category}_{structure.id}_") for name in nodes)
    bodies = {body.item.id: body for body in bodies_of(scene.objects, LIBRARY.infos)}
    for item in scene.objects:
        corners = []
        for part in LIBRARY.assets[item.asset].variants[item.variant]:
            matrix, name = loaded.graph.get(f"{item.category}_{item.id}/{part}")
            mesh = loaded.geometry[name]
            corners.append(trimesh.transform_points(mesh.vertices, matrix))
        # glTF is Y up: (x, y, z)_gltf = (x, z, -y)_ours.
        x, y, z = np.concatenate(corners).T
        points = np.stack([x, -z, y], axis=1)
        body = bodies[item.id]  # by its outermost points in some directions
        assert np.allclose(points.min(axis=0), body.low, atol=0.006), item
        assert np.allclose(points.max(axis=0), body.high, atol=0.006), item


def test_glb_says_what_no_shape_tells() -> None:
    one = made("3")
    scene = one.bundle.scene
    raw = home_glb(scene, LIBRARY, one.spec)
    size = int.from_bytes(raw[12:16], "little")
    nodes = {node["name"]: node for node in json.loads(raw[20 : 20 + size])["nodes"]}
    home = nodes[scene.home.id]["extras"][KEY]
    assert home["title"] == one.spec.title
    assert list(home["rooms"].items()) == [(room.name, room.type) for room in one.spec.rooms]
    for item in scene.objects:
        said = nodes[f"{item.category}_{item.id}"]["extras"][KEY]
        assert (said["model"], said["category"]) == (item.asset, item.category)
        assert said.get("joints", {}) == item.joints


def test_glb_wears_textures_and_holds_a_model_once() -> None:
    scene = made("3").bundle.scene
    loaded = trimesh.load_scene(io.BytesIO(home_glb(scene, LIBRARY)), file_type="glb")
    for name, mesh in loaded.geometry.items():
        assert mesh.visual.material.baseColorTexture is not None, name
        assert len(mesh.visual.uv) == len(mesh.vertices)
    models = {
        (item.asset, part)
        for item in scene.objects
        for part in LIBRARY.assets[item.asset].variants[item.variant]
    }
    shell = sum(1 + len(structure.bands) for structure in scene.home.structures)
    assert len(loaded.geometry) <= len(models) + shell


def test_a_seed_is_the_scene_of_a_build(tmp_path: Path) -> None:
    from sdgen.pipeline import make_scene

    options = BuildOptions(seed=3, homes="procedural", hazards_min=0, hazards_max=0, views=0)
    assert make_scene(0, CATALOG, LIBRARY, options).scene == made("3").bundle.scene
    assert made("3").bundle.anomalies.anomalies == ()
