"""Scenes of the sample as files of models, read by those who use them: MuJoCo, PyBullet, OpenUSD,
trimesh. All things stand where the scene has them, and nothing says what is wrong there."""

import hashlib
import json
import re
import subprocess
import sys
import xml.etree.ElementTree as Tree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.dataset import Dataset, SceneItem
from sdgen.errors import InputError
from sdgen.export import FORMATS, export

from tests import toy
from tests.shared import Shared
from tests.shipped import shipped_library

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLE = ROOT / "output" / "sample"
SPLIT = "val"
MODELS = [name for name, known in FORMATS.items() if known.models]
CLIENTS = {"mjcf": "mujoco", "mjz": "mujoco", "urdf": "scipy", "usd": "pxr"}

Exported = Callable[[str], Path]


@pytest.fixture(scope="session")
def exported(shared: Shared) -> Exported:
    def make(name: str) -> Path:
        pytest.importorskip(CLIENTS.get(name, "sdgen"))

        def write(out: Path) -> None:
            data = Dataset(SAMPLE, split=SPLIT)
            export(data, name, out / "x", library=shipped_library())

        return shared.folder(f"exported-{name}", write) / "x"

    return make


@pytest.fixture(scope="session")
def item() -> SceneItem:
    return Dataset(SAMPLE, split=SPLIT)[0]


def test_mujoco_steps_it_and_nothing_flies(exported: Exported, item: SceneItem) -> None:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(exported("mjcf") / f"{item.id}.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = {}
    for thing in item.scene.objects:
        body = model.body(f"{thing.category}_{thing.id}")
        assert np.allclose(data.xpos[body.id], thing.pose.position_m, atol=1e-4)
        before[body.id] = np.array(data.xpos[body.id])
    for _ in range(150):
        mujoco.mj_step(model, data)
    moved = {number: np.linalg.norm(data.xpos[number] - at) for number, at in before.items()}
    assert max(moved.values()) < 0.01
    assert not any(warning.number for warning in data.warning)


def test_mjz_is_the_same_model_in_one_file(exported: Exported, item: SceneItem) -> None:
    mujoco = pytest.importorskip("mujoco")
    if tuple(map(int, mujoco.__version__.split(".")[:2])) < (3, 11):
        pytest.skip("this MuJoCo reads no mjz")
    packed = mujoco.MjSpec.from_file(str(exported("mjz") / f"{item.id}.mjz")).compile()
    plain = mujoco.MjModel.from_xml_path(str(exported("mjcf") / f"{item.id}.xml"))
    for name in ("nbody", "njnt", "ngeom", "nmesh", "ntex"):
        assert getattr(packed, name) == getattr(plain, name)
    assert np.allclose(packed.body_mass, plain.body_mass)


def test_glb_has_every_thing_where_it_stands(exported: Exported, item: SceneItem) -> None:
    import trimesh

    scene = trimesh.load_scene(exported("glb") / f"{item.id}.glb")
    z_up_from_y_up = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    for thing in item.scene.objects:
        pose, _ = scene.graph.get(f"{thing.category}_{thing.id}")
        assert np.allclose(z_up_from_y_up @ pose, thing.pose.matrix(), atol=1e-5)
    some = next(iter(scene.geometry.values()))
    assert some.visual.material.baseColorTexture is not None
    assert some.visual.material.metallicFactor == 0.0


def test_urdf_has_every_link_and_pybullet_reads_it(exported: Exported, item: SceneItem) -> None:
    folder = exported("urdf")
    root = Tree.parse(folder / f"{item.id}.urdf").getroot()
    links = {link.get("name") for link in root.iter("link")}
    origins = {
        joint.find("child").get("link"): joint.find("origin")  # type: ignore[union-attr]
        for joint in root.iter("joint")
    }
    assert set(origins) == links - {"world"}
    kinds = {}
    for thing in item.scene.objects:
        name = f"{thing.category}_{thing.id}"
        at = [float(v) for v in origins[name].get("xyz").split()]  # type: ignore[union-attr]
        assert np.allclose(at, thing.pose.position_m, atol=1e-5)
        kinds[name] = thing.fixed
    for joint in root.iter("joint"):
        child = joint.find("child").get("link")  # type: ignore[union-attr]
        if child in kinds:
            assert joint.get("type") == ("fixed" if kinds[child] else "floating")
    for mesh in root.iter("mesh"):
        assert (folder / str(mesh.get("filename"))).is_file()
    # Bullet prints a line a link, and keeps what it reads until it is let go.
    code = (
        "import pybullet, sys\n"
        "pybullet.connect(pybullet.DIRECT)\n"
        "body = pybullet.loadURDF(sys.argv[1], useFixedBase=True)\n"
        "print('JOINTS', pybullet.getNumJoints(body))\n"
    )
    urdf = str(folder / f"{item.id}.urdf")
    done = subprocess.run(
        [sys.executable, "-c", code, urdf], capture_output=True, text=True, check=True, timeout=300
    )
    assert f"JOINTS {len(origins)}" in done.stdout


def test_mujoco_reads_the_urdf_with_loose_things_loose(exported: Exported, item: SceneItem) -> None:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(exported("urdf") / f"{item.id}.urdf"))
    free = sum(kind == mujoco.mjtJoint.mjJNT_FREE for kind in model.jnt_type)
    assert free == sum(not thing.fixed for thing in item.scene.objects)


def test_usd_is_valid_metric_and_z_up(exported: Exported, item: SceneItem) -> None:
    pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdValidation

    stage = Usd.Stage.Open(str(exported("usd") / f"{item.id}.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert stage.GetDefaultPrim().GetPath() == "/World"
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    found = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [error.GetMessage() for error in found] == []
    cache = UsdGeom.XformCache()
    for thing in item.scene.objects:
        prim = stage.GetPrimAtPath(f"/World/things/{thing.category}_{thing.id}")
        pose = np.array(cache.GetLocalToWorldTransform(prim)).T
        assert np.allclose(pose, thing.pose.matrix(), atol=1e-6)
        base = stage.GetPrimAtPath(f"{prim.GetPath()}/base")
        assert base.HasAPI(UsdPhysics.RigidBodyAPI) == (not thing.fixed)
        assert UsdPhysics.MassAPI(base).GetMassAttr().Get() > 0
        assert list(UsdSemantics.LabelsAPI(prim, "category").GetLabelsAttr().Get()) == [
            thing.category
        ]
    joints = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.Joint)]
    assert joints
    for prim in joints:
        joint = UsdPhysics.Joint(prim)
        targets = (*joint.GetBody0Rel().GetTargets(), *joint.GetBody1Rel().GetTargets())
        assert all(stage.GetPrimAtPath(target).IsValid() for target in targets)
        at = [
            np.array(cache.GetLocalToWorldTransform(stage.GetPrimAtPath(target))).T
            @ (*place.Get(), 1.0)
            for target, place in zip(
                targets, (joint.GetLocalPos0Attr(), joint.GetLocalPos1Attr()), strict=True
            )
        ]
        if prim.IsA(UsdPhysics.RevoluteJoint):
            assert np.allclose(*at, atol=1e-4)  # the hinge is in one place for both


@pytest.mark.parametrize("name", MODELS)
def test_no_file_says_what_is_wrong_in_the_scene(
    exported: Exported, item: SceneItem, name: str
) -> None:
    hazards = {anomaly.hazard for anomaly in item.anomalies.anomalies}
    assert hazards
    for path in exported(name).rglob("*"):
        if path.suffix in (".xml", ".urdf", ".usda", ".json", ".mtl"):
            text = path.read_text(encoding="utf-8")
            assert not any(hazard in text for hazard in hazards)
            assert not re.search("anomal|lookalike", text)


def _mjcf_bytes(folder: Path) -> dict[str, str]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in files
    }


@pytest.mark.parametrize("name", ["mjcf", "mjz", "glb"])
def test_the_same_bytes_again(exported: Exported, tmp_path: Path, name: str) -> None:
    again = tmp_path / "again"
    export(Dataset(SAMPLE, split=SPLIT), name, again, library=shipped_library())
    assert _mjcf_bytes(again) == _mjcf_bytes(exported(name))


@pytest.mark.parametrize("name", MODELS)
def test_other_models_than_the_data_sets_are_refused(tmp_path: Path, name: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    path = toy.build(tmp_path / "d", toy.small(n=1))
    with pytest.raises(InputError, match="other models than the ones at hand"):
        export(Dataset(path), name, tmp_path / "out" / "x", library=shipped_library())
    assert list((tmp_path / "out").iterdir()) == []


def test_joints_that_stand_open_are_told_beside_the_urdf(
    exported: Exported, item: SceneItem
) -> None:
    told = json.loads((exported("urdf") / f"{item.id}.joints.json").read_text())["joints"]
    wanted: dict[str, Any] = {
        f"{thing.category}_{thing.id}.{joint}.joint": value
        for thing in item.scene.objects
        for joint, value in thing.joints.items()
        if value
    }
    assert told
    assert told.items() <= wanted.items()


def test_meshes_are_a_column_where_they_are_asked_for(tmp_path: Path) -> None:
    datasets = pytest.importorskip("datasets")
    if not hasattr(datasets, "Mesh"):
        pytest.skip("this datasets has no Mesh")
    data = Dataset(SAMPLE, split=SPLIT)
    export(data, "huggingface", tmp_path / "hf", library=shipped_library())
    rows = datasets.load_dataset(
        str(tmp_path / "hf"), "scenes", split=SPLIT, cache_dir=str(tmp_path / "cache")
    )
    mesh = rows.cast_column("mesh", datasets.Mesh(decode=False))[0]["mesh"]["bytes"]
    assert mesh[:4] == b"glTF"
