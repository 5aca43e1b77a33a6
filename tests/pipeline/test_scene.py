"""A scene depends on catalogue, library, content options, seed and index: on nothing else."""

import json
import os
import subprocess
import sys

import pytest
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene

from tests.made import OPTIONS

CONTENT = "from sdgen.cli.main import main; main()"


def dump(bundle):
    return [
        bundle.scene.model_dump_json(),
        bundle.anomalies.model_dump_json(),
        bundle.household.model_dump_json(),
        bundle.physics.model_dump_json(),
        [camera.model_dump_json() for camera in bundle.cameras],
    ]


@pytest.mark.slow
def test_the_same_scene_whatever_was_made_before(catalog, library, scene_bundle):
    with Client() as client:
        make_scene(4, catalog, library, OPTIONS, client)
        used = dump(make_scene(5, catalog, library, OPTIONS, client))
    assert used == dump(scene_bundle(5))


@pytest.mark.slow
def test_picture_options_change_cameras_only(catalog, library, scene_bundle):
    few = make_scene(
        2, catalog, library, BuildOptions(n=20, seed=7, views=2, width=320, height=240)
    )
    many = scene_bundle(2)
    assert dump(few)[:4] == dump(many)[:4]
    assert (len(few.cameras), len(many.cameras)) == (2, OPTIONS.views)


@pytest.mark.slow
@pytest.mark.slow
def test_other_numbers_of_views_are_of_the_same_places(catalog, library, scene_bundle):
    """Fewer are some of the eight; more begin with all of them."""
    usual = {camera.world_from_camera for camera in scene_bundle(2).cameras}
    few, many = (
        make_scene(2, catalog, library, BuildOptions(n=20, seed=7, views=views))
        for views in (6, 12)
    )
    assert {camera.world_from_camera for camera in few.cameras} < usual
    assert {camera.world_from_camera for camera in many.cameras} > usual
    assert few.scene == many.scene == scene_bundle(2).scene
    assert few.anomalies == many.anomalies == scene_bundle(2).anomalies


def test_ids_and_order_say_nothing_and_fit_the_mask(scene_bundle):
    scene = scene_bundle(1).scene
    ids = [o.id for o in scene.objects]
    everything = ids + [r.id for r in scene.home.rooms] + [s.id for s in scene.home.structures]
    assert len(set(everything)) == len(everything)
    assert all(1 <= i <= 65535 for i in everything)
    assert ids == sorted(ids)
    assert sum(i > 32768 for i in ids) > len(ids) / 4  # spread over the range


@pytest.mark.slow
def test_same_bytes_in_other_processes_ranges_and_folders(tmp_path):
    def build(name, workers, *more, **environment):
        out = tmp_path / name
        command = [sys.executable, "-c", CONTENT, "build", "--n", "2", "--seed", "7"]
        command += ["--views", "2", "--size", "160x120", "--workers", str(workers)]
        command += ["--out", str(out), *more]
        where = tmp_path / f"cwd-{name}"
        where.mkdir()
        env = {**os.environ, **environment}
        done = subprocess.run(command, cwd=where, env=env, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        lines = (out / "manifest.jsonl").read_text().splitlines()
        return {line["id"]: line for line in map(json.loads, lines)}

    whole = build("a", 1, PYTHONHASHSEED="1", LC_ALL="C")
    again = build("b", 2, PYTHONHASHSEED="42", LC_ALL="C.UTF-8")
    alone = build("c", 1, "--range", "1:2", PYTHONHASHSEED="7")
    assert whole == again
    assert list(alone) == ["000001"]
    assert alone["000001"] == whole["000001"]
