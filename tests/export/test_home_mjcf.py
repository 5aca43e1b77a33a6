"""A home in MuJoCo: it loads, everything stands where it did, and nothing flies."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.cli.main import cli
from sdgen.errors import SdgenError
from sdgen.export.beside import check_beside, written_beside
from sdgen.export.home_mjcf import write_home_mjcf
from sdgen.export.model_files import ModelFiles
from sdgen.facts import bodies_of
from sdgen.home.notes import KEY
from sdgen.scene import Scene

from tests.export.test_home import LIBRARY, made

mujoco = pytest.importorskip("mujoco", reason="no MuJoCo here (pip install mujoco)")
WHICH = "studio_8"


@pytest.fixture(scope="module")
def scene() -> Scene:
    return made(WHICH).bundle.scene


@pytest.fixture(scope="module")
def model(scene: Scene, tmp_path_factory: pytest.TempPathFactory) -> Any:
    folder = tmp_path_factory.mktemp("mjcf")
    (folder / "my home_assets").mkdir()
    text = write_home_mjcf(
        scene,
        LIBRARY,
        ModelFiles(LIBRARY, folder / "my home_assets"),
        "my home_assets",
        made(WHICH).spec,
    )
    (folder / "my home.xml").write_bytes(text)
    return mujoco.MjModel.from_xml_path(str(folder / "my home.xml"))


def test_every_body_stands_where_the_scene_has_it(scene: Scene, model: Any) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for item in scene.objects:
        body = model.body(f"{item.category}_{item.id}")
        x, y, z, w = item.pose.quat_xyzw
        assert np.allclose(data.xpos[body.id], item.pose.position_m, atol=1e-4)
        assert abs(abs(data.xquat[body.id] @ (w, x, y, z)) - 1) < 1e-5
        assert (model.body_dofnum[body.id] == 6) == (not item.fixed)


def test_parts_are_where_their_joints_put_them(scene: Scene, model: Any) -> None:
    """Its own meshes at its own joint values: the same box as ours, of what is drawn."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    opened = [item for item in scene.objects if any(item.joints.values())]
    assert opened, "nothing of this home stands open: choose another"
    for item in opened:
        (ours,) = bodies_of([item], LIBRARY.infos)
        root = model.body(f"{item.category}_{item.id}").id
        points = [
            _points(model, data, k)
            for k in range(model.ngeom)
            if model.geom_group[k] == 2 and model.body_rootid[model.geom_bodyid[k]] == root
        ]
        every = np.concatenate(points)
        assert np.allclose(every.min(axis=0), ours.low, atol=0.006), item
        assert np.allclose(every.max(axis=0), ours.high, atol=0.006), item
        for joint, value in item.joints.items():
            found = model.joint(f"{item.category}_{item.id}/{joint}")
            assert data.qpos[found.qposadr[0]] == pytest.approx(value, abs=1e-5)
            limits = LIBRARY.assets[item.asset].joint(joint)
            assert found.range == pytest.approx((limits.lower, limits.upper), abs=1e-5)


def _points(model: Any, data: Any, geom: int) -> Any:
    mesh = model.geom_dataid[geom]
    start, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
    points = model.mesh_vert[start : start + count]
    return points @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]


def test_masses_are_the_models(scene: Scene, model: Any) -> None:
    for item in scene.objects:
        root = model.body(f"{item.category}_{item.id}").id
        assert model.body_subtreemass[root] == pytest.approx(
            LIBRARY.assets[item.asset].mass_kg, rel=0.01, abs=0.005
        )


def test_nothing_flies(scene: Scene, model: Any) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = data.xpos.copy()
    fastest = 0.0
    loose = model.jnt_dofadr[model.jnt_type == mujoco.mjtJoint.mjJNT_FREE]
    assert len(loose) == sum(not item.fixed for item in scene.objects)
    for _ in range(round(1 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        speeds = [np.linalg.norm(data.qvel[at : at + 3]) for at in loose]
        fastest = max(fastest, *speeds)
    # What tips from edge to edge is as fast as that; what was thrown is faster by far.
    assert fastest < 1.0
    moved = np.linalg.norm(data.xpos - before, axis=1)
    assert np.quantile(moved, 0.99) < 0.01
    assert moved.max() < 0.3


def test_notes_say_what_no_shape_tells(scene: Scene, model: Any) -> None:
    kind = mujoco.mjtObj.mjOBJ_TEXT
    said = {mujoco.mj_id2name(model, kind, k): _text(model, k) for k in range(model.ntext)}
    home = json.loads(said[KEY])
    spec = made(WHICH).spec
    assert home["title"] == spec.title
    assert list(home["rooms"].items()) == [(room.name, room.type) for room in spec.rooms]
    for item in scene.objects:
        assert json.loads(said[f"{item.category}_{item.id}"])["model"] == item.asset


def _text(model: Any, k: int) -> str:
    start, size = model.text_adr[k], model.text_size[k]
    return bytes(model.text_data[start : start + size]).rstrip(b"\0").decode()


def test_command_writes_both_and_writes_over_its_own_only(tmp_path: Path) -> None:
    from click.testing import CliRunner

    out = tmp_path / "flat.xml"
    for _ in range(2):
        done = CliRunner().invoke(cli, ["home", "export", WHICH, "-o", str(out)])
        assert done.exit_code == 0, done.output
    beside = tmp_path / "flat_assets"
    assert {path.suffix for path in beside.iterdir()} == {".obj", ".png"}
    assert sorted(path.name for path in tmp_path.iterdir()) == ["flat.xml", "flat_assets"]
    (beside / "mine.txt").write_text("kept")
    with pytest.raises(SdgenError, match=r"holds mine\.txt, which no export wrote"):
        check_beside(out)
    with pytest.raises(SdgenError), written_beside(out):
        pass
    assert (beside / "mine.txt").read_text() == "kept"


def test_what_fails_on_the_way_leaves_nothing(tmp_path: Path) -> None:
    def fail() -> None:
        with written_beside(tmp_path / "x.xml") as folder:
            (folder / "a.obj").write_text("v 0 0 0\n")
            raise ValueError("halfway")

    with pytest.raises(ValueError, match="halfway"):
        fail()
    assert list(tmp_path.iterdir()) == []
