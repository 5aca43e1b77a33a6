"""A home of ours, written for others and read back, is the same home."""

from __future__ import annotations

import json
import re
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.catalog.load import load_catalog
from sdgen.export.home_glb import home_glb
from sdgen.export.home_mjcf import write_home_mjcf
from sdgen.export.model_files import ModelFiles
from sdgen.importing.scenes.read import text_of
from sdgen.library.gltf import chunks_of, glb_of
from sdgen.pipeline.one_home import OneHome, one_home
from sdgen.vocabulary import OPENINGS
from shapely import box, union_all

from tests.export.test_home import FITTED, LIBRARY, OPTIONS, made
from tests.importing.scenes.homes import imported

FORMATS = ("gltf", "mjcf")


def written(home: OneHome, format_: str, folder: Path) -> Path:
    scene = home.bundle.scene
    if format_ == "gltf":
        path = folder / "home.glb"
        path.write_bytes(home_glb(scene, LIBRARY, home.spec))
        return path
    (folder / "home_assets").mkdir()
    path = folder / "home.xml"
    path.write_bytes(
        write_home_mjcf(
            scene, LIBRARY, ModelFiles(LIBRARY, folder / "home_assets"), "home_assets", home.spec
        )
    )
    return path


def openings(spec: Any) -> list[Any]:
    """Openings without what fills them."""
    bare = [one.model_copy(update={"model": None, "joints": {}}) for one in spec.openings]
    return sorted(bare, key=lambda one: (one.kind, one.center_m))


@pytest.mark.parametrize("format_", FORMATS)
@pytest.mark.parametrize("which", ["apartment_1", "family_flat_6", "3", "5", "99"])
def test_the_same_rooms_openings_and_furniture(which: str, format_: str, tmp_path: Path) -> None:
    home = made(which)
    back = imported(format_, written(home, format_, tmp_path))
    assert [(room.name, room.type) for room in back.spec.rooms] == [
        (room.name, room.type) for room in home.spec.rooms
    ]
    for ours, theirs in zip(home.spec.rooms, back.spec.rooms, strict=True):
        shapes = [union_all([box(*r) for r in room.rectangles_m]) for room in (ours, theirs)]
        assert shapes[0].symmetric_difference(shapes[1]).area < 1e-6
    assert openings(back.spec) == openings(home.spec)
    assert (back.spec.title, back.spec.height_m) == (home.spec.title, home.spec.height_m)
    assert back.spec.style == home.bundle.scene.home.style
    for fixed in (True, False):
        wanted = sorted(
            (item.asset, item.pose.position_m)
            for item in home.bundle.scene.objects
            if item.fixed == fixed and item.category not in OPENINGS
        )
        lists = [room.furniture if fixed else room.things for room in back.spec.rooms]
        found = sorted((one.model or "", one.position_m) for one in chain(*lists))
        assert [model for model, _ in found] == [model for model, _ in wanted]
        apart = np.array([p for _, p in found])[:, :2] - np.array([p for _, p in wanted])[:, :2]
        assert np.abs(apart).max() < 1e-3
    assert back.unresolved == ()


@pytest.mark.slow
@pytest.mark.parametrize(("which", "format_"), [("senior_flat_7", "gltf"), ("5", "mjcf")])
def test_the_same_certificate(which: str, format_: str, tmp_path: Path) -> None:
    """Built again, it holds the same things in the same places, and the same pairs were proved."""
    home = made(which)
    back = imported(format_, written(home, format_, tmp_path))
    file = tmp_path / "mine.yaml"
    file.write_text(text_of(back, format_, Path("home")))
    again = one_home("mine", load_catalog([file]), LIBRARY, OPTIONS).bundle
    before, after = home.bundle.anomalies.certificate, again.anomalies.certificate
    assert after.pairs_checked == before.pairs_checked
    assert after.pairs_positive == before.pairs_positive == 0
    assert after.hazards_enabled == before.hazards_enabled
    left = list(again.scene.objects)
    for item in home.bundle.scene.objects:
        same = [other for other in left if other.asset == item.asset]
        apart = [np.abs(np.subtract(o.pose.position_m, item.pose.position_m)).max() for o in same]
        nearest = int(np.argmin(apart))
        assert apart[nearest] < 0.01, item
        assert same[nearest].states == item.states
        left.remove(same[nearest])
    assert left == []


def bare(path: Path) -> Path:
    """The file without what our export says of itself."""
    if path.suffix == ".xml":
        text = re.sub(r"<custom>.*</custom>", "", path.read_text(), flags=re.S)
        path.write_text(text)
        return path
    text, blob = chunks_of(path.read_bytes())
    document = json.loads(text)
    for node in document["nodes"]:
        node.pop("extras", None)
    path.write_bytes(glb_of(document, blob))
    return path


@pytest.mark.parametrize("format_", FORMATS)
def test_names_and_shapes_alone_bring_nearly_all_of_it_back(format_: str, tmp_path: Path) -> None:
    home = made("apartment_1")
    back = imported(format_, bare(written(home, format_, tmp_path)))
    shapes = {
        room.name: union_all([box(*r) for r in room.rectangles_m]) for room in home.spec.rooms
    }
    assert {room.name: room.type for room in back.spec.rooms} == {
        room.name: room.type for room in home.spec.rooms
    }
    for room in back.spec.rooms:
        shape = union_all([box(*r) for r in room.rectangles_m])
        assert shape.symmetric_difference(shapes[room.name]).area < 0.01
    ways = [(one.kind, one.along, one.sill_m, one.small) for one in openings(home.spec)]
    assert [(one.kind, one.along, one.sill_m, one.small) for one in openings(back.spec)] == ways
    for ours, theirs in zip(openings(home.spec), openings(back.spec), strict=True):
        assert np.allclose(ours.center_m, theirs.center_m, atol=0.01)
    wanted = sum(len(room.furniture) for room in home.spec.rooms)
    drawn = sum(
        item.fixed and item.category not in {*OPENINGS, *FITTED}
        for item in home.bundle.scene.objects
    )
    assert wanted >= drawn
    assert sum(len(room.furniture) for room in back.spec.rooms) >= 0.9 * drawn
