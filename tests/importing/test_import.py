"""Downloads become libraries: what each source has is found, and what is broken is told."""

from __future__ import annotations

import csv
import io
import json
import os
import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image
from sdgen.catalog.load import load_catalog
from sdgen.engines.build import build
from sdgen.errors import AssetError, SdgenError
from sdgen.hazards.splits import SplitModels, small_categories
from sdgen.importing.frame import stand
from sdgen.importing.layouts import Candidate, find_models
from sdgen.importing.opened import opened_source
from sdgen.importing.reading import read_model
from sdgen.importing.run import Import, Report, import_models
from sdgen.importing.scan import Scan
from sdgen.importing.shelf import Origin
from sdgen.importing.table import load_table
from sdgen.importing.tree import References
from sdgen.library import load_library
from sdgen.library.licences import narrowest
from sdgen.library.records import Asset
from sdgen.options import BuildOptions

from . import downloads

CATALOG = load_catalog()
SCANS = Path(__file__).resolve().parents[3] / "shared" / "scans"
#: Folders of shared/scans, and what they are imported as.
SOURCES = {
    "ycb": "ycb",
    "ycb_png": "ycb",
    "google_scanned_objects": "gso",
    "gso_aloha_sim": "gso",
    "mujoco_scanned_objects": "gso",
    "replica_cad": "replicacad",
    "aws-robomaker-small-house-world": "folder",
    "gazebo_models": "folder",
    "polyhaven_glTF": "folder",
    "bigym_props": "folder",
}


def run(source: str, root: Path, library: Path, **more: object) -> Report:
    return import_models(Import(source, root, library, **more), CATALOG)  # type: ignore[arg-type]


def one(report: Report) -> Origin:
    assert report.refused == ()
    (origin,) = report.made
    return origin


def checked(library: Path, asset: Asset) -> Asset:
    """The model as a build loads it, every file read."""
    return load_library([library]).assets[asset.id]


def colours(library: Path, asset: Asset) -> dict[str, np.ndarray]:
    """Average colours of the texture where the mesh's corners with x below and above 0 look."""
    mesh = load_library([library]).mesh(asset.id)["body"]
    image = np.asarray(Image.open(library / asset.texture).convert("RGB"), float)
    height, width = image.shape[:2]
    corners = mesh.vertices[mesh.faces]
    uv = mesh.uvs[mesh.faces].mean(axis=1)
    x = np.clip((uv[:, 0] * width).astype(int), 0, width - 1)
    y = np.clip(((1 - uv[:, 1]) * height).astype(int), 0, height - 1)
    side = corners[:, :, 0]
    clear = 0.3 * np.abs(side).max()
    return {
        "low": image[y, x][(side < -clear).all(axis=1)].mean(axis=0),
        "high": image[y, x][(side > clear).all(axis=1)].mean(axis=0),
    }


def test_a_scan_of_ycb_keeps_size_colours_and_category(tmp_path: Path) -> None:
    origin = one(run("ycb", downloads.ycb(tmp_path / "ycb", dense=True), tmp_path / "lib"))
    asset = checked(tmp_path / "lib", origin.asset)
    assert (asset.category, origin.how, asset.licence) == ("cereal_box", "table", "CC-BY-4.0")
    assert "Calli" in asset.attribution
    assert asset.extents_m == pytest.approx((0.07, 0.16, 0.21), rel=0.01)
    assert 100 < asset.faces <= 800
    seen = colours(tmp_path / "lib", asset)
    assert seen["low"][0] > 180 > 80 > seen["low"][1]
    assert seen["high"][1] > 160 > 80 > seen["high"][0]


def test_light_meshes_keep_their_own_texture(tmp_path: Path) -> None:
    origin = one(run("ycb", downloads.ycb(tmp_path / "ycb"), tmp_path / "lib"))
    assert origin.asset.faces == 12
    with Image.open(tmp_path / "lib" / origin.asset.texture) as image:
        assert image.size == (64, 64)  # not blown up


def test_a_second_run_imports_only_what_is_new(tmp_path: Path) -> None:
    root, library = downloads.ycb(tmp_path / "ycb"), tmp_path / "lib"
    first = one(run("ycb", root, library))
    mesh = library / first.asset.mesh
    before = mesh.stat().st_mtime_ns
    downloads.ycb(root, "013_apple")
    report = run("ycb", root, library)
    assert [o.name for o in report.made] == ["013_apple"]
    assert [o.name for o in report.kept] == ["003_cracker_box"]
    assert mesh.stat().st_mtime_ns == before
    assert len(load_library([library]).by_category("cereal_box")) > len(
        load_library().by_category("cereal_box")
    )
    # What changed in the source is made anew.
    downloads.picture(
        root / "013_apple" / "google_16k" / "texture_map.png", downloads.HALVES[::-1, ::-1]
    )
    assert [o.name for o in run("ycb", root, library).made] == ["013_apple"]


def test_textures_of_scanned_objects_are_found_where_they_are(tmp_path: Path) -> None:
    origin = one(run("gso", downloads.gso(tmp_path / "gso"), tmp_path / "lib"))
    assert origin.asset.category == "mug"
    assert any("materials/textures/texture.png" in note for note in origin.notes)
    assert colours(tmp_path / "lib", origin.asset)["low"][0] > 180


def test_models_in_archives(tmp_path: Path) -> None:
    """A folder of one zip a model, as Fuel gives them out, of which one is broken."""
    root = downloads.gso(tmp_path / "gso")
    zips = tmp_path / "zips"
    zips.mkdir()
    (folder,) = root.iterdir()
    with zipfile.ZipFile(zips / f"{folder.name}.zip", "w") as archive:
        for file in sorted(p for p in folder.rglob("*") if p.is_file()):
            archive.write(file, f"{folder.name}/{file.relative_to(folder)}")
    (zips / "broken.zip").write_bytes((zips / f"{folder.name}.zip").read_bytes()[:300])
    report = run("gso", zips, tmp_path / "lib")
    assert [o.name for o in report.made] == [folder.name]
    (refused,) = report.refused
    assert refused.name == "broken.zip"


def test_furniture_of_replicacad_stands_up_with_its_receptacle(tmp_path: Path) -> None:
    root, library = downloads.replicacad(tmp_path / "replica"), tmp_path / "lib"
    report = run("replicacad", root, library)
    assert report.made == ()
    assert "--non-commercial" in report.refused[0].why  # its bundled licence allows no trade
    asset = checked(library, one(run("replicacad", root, library, non_commercial=True)).asset)
    assert (asset.category, asset.licence) == ("dining_table", "CC-BY-NC-4.0")
    assert asset.extents_m == pytest.approx((0.8, 1.4, 0.74), abs=0.002)
    assert asset.mass_kg == 18
    (top,) = asset.supports
    assert top.z_m == pytest.approx(0.74, abs=0.01)
    assert top.area_m2 > 0.9


def test_a_mesh_that_a_config_names_and_that_is_missing(tmp_path: Path) -> None:
    root = downloads.replicacad(tmp_path / "replica")
    (root / "objects" / "frl_apartment_table_01.glb").unlink()
    (refused,) = run("replicacad", root, tmp_path / "lib", non_commercial=True).refused
    assert "frl_apartment_table_01.glb: no such mesh" in refused.why


def test_pairs_of_fantastic_breaks_are_one_model_that_can_be_broken(tmp_path: Path) -> None:
    table = tmp_path / "mine.yaml"
    table.write_text("rows:\n  - {models: '05_*', category: mug}\n")
    root = downloads.fantastic_breaks(tmp_path / "breaks")
    origin = one(
        run("fantastic-breaks", root, tmp_path / "lib", tables=(table,), licence="CC-BY-4.0")
    )
    asset = checked(tmp_path / "lib", origin.asset)
    assert asset.category == "mug"
    assert asset.extents_m == pytest.approx((0.09, 0.09, 0.09), rel=0.02)
    (rule,) = (rule for rule in asset.states if rule.state == "BROKEN")
    assert rule.variants == ("broken",)
    mesh = load_library([tmp_path / "lib"]).mesh(asset.id)
    assert np.ptp(mesh["broken"].vertices[:, 2]) < 0.08
    assert abs(mesh["broken"].vertices[:, 2].min()) < 1e-3
    with pytest.raises(AssetError, match="--licence"):
        run("fantastic-breaks", root, tmp_path / "lib2")


def test_joints_of_urdf_open_and_shut(tmp_path: Path) -> None:
    origin = one(run("folder", downloads.cabinet(tmp_path / "cabinet"), tmp_path / "lib"))
    asset = checked(tmp_path / "lib", origin.asset)
    assert asset.category == "nightstand"
    (joint,) = asset.joints
    assert joint.lower == 0
    assert joint.upper == pytest.approx(1.6)
    assert joint.axis == pytest.approx((0, 0, -1), abs=1e-6)  # so that positive values open
    assert set(asset.state_names) == {"CLOSED", "OPEN"}
    (inside,) = asset.containers
    assert inside.closed_by == joint.name
    assert sum(s.container == "inside" for s in asset.supports) == 2


def test_single_sided_meshes_show_no_holes(tmp_path: Path) -> None:
    root = tmp_path / "folder"
    root.mkdir()
    (root / "LICENSE").write_text("CC0")
    bowl = trimesh.creation.icosphere(subdivisions=3, radius=0.08).slice_plane(
        (0, 0, 0), (0, 0, -1)
    )
    bowl.export(root / "bowl.ply")
    origin = one(run("folder", root, tmp_path / "lib"))
    assert origin.asset.category == "bowl"
    assert any("single-sided" in note for note in origin.notes)
    assert [c.name for c in origin.asset.containers] == ["inside"]


def test_a_mug_of_forty_metres_is_one_in_another_unit(tmp_path: Path) -> None:
    root = tmp_path / "folder"
    (root / "mug").mkdir(parents=True)
    (root / "LICENSE").write_text("CC0 1.0 Universal")
    downloads.obj(root / "mug" / "mug.obj", (12.0, 9.0, 10.0), None)
    origin = one(run("folder", root, tmp_path / "lib"))
    # A guess by name and size takes it for centimetres, and says so.
    assert origin.asset.category == "mug"
    assert origin.how == "guess"
    assert max(origin.asset.extents_m) == pytest.approx(0.12, rel=0.01)
    assert any("0.01 times" in note for note in origin.notes)


def _evil_obj(folder: Path, reference: str) -> None:
    downloads.obj(folder / "textured.obj", material="evil.mtl")
    (folder / "evil.mtl").write_text(f"newmtl m\nmap_Kd {reference}\n")


@pytest.mark.parametrize(
    "reference",
    ["../../../secret.png", "/etc/secret.png", "C:\\secret.png", "https://example.org/secret.png"],
)
def test_nothing_outside_the_download_is_read(tmp_path: Path, reference: str) -> None:
    downloads.picture(tmp_path / "secret.png")
    folder = tmp_path / "down" / "ycb" / "003_cracker_box" / "google_16k"
    _evil_obj(folder, reference)
    origin = one(run("ycb", tmp_path / "down" / "ycb", tmp_path / "lib"))
    assert any("not there" in note or "network" in note for note in origin.notes)
    assert colours(tmp_path / "lib", origin.asset)["low"].std() < 5  # grey, no red


def test_pointers_of_git_lfs_are_named_so(tmp_path: Path) -> None:
    downloads.ycb(tmp_path / "ycb")
    mesh = tmp_path / "ycb" / "003_cracker_box" / "google_16k" / "textured.obj"
    mesh.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 5\n")
    (refused,) = run("ycb", tmp_path / "ycb", tmp_path / "lib").refused
    assert "git lfs pull" in refused.why


def test_links_out_of_the_download_are_not_followed(tmp_path: Path) -> None:
    downloads.picture(tmp_path / "secret.png")
    folder = tmp_path / "down" / "003_cracker_box" / "google_16k"
    _evil_obj(folder, "texture_map.png")
    os.symlink(tmp_path / "secret.png", folder / "texture_map.png")
    origin = one(run("ycb", tmp_path / "down", tmp_path / "lib"))
    assert colours(tmp_path / "lib", origin.asset)["low"].std() < 5


def test_of_many_models_the_broken_ones_are_listed(tmp_path: Path) -> None:
    root = tmp_path / "ycb"
    for number in range(9):
        downloads.ycb(root, f"{number:03d}_cracker_box")
    (root / "002_cracker_box" / "google_16k" / "textured.obj").write_text(
        "v nan nan nan\nf 1 1 1\n"
    )
    (root / "004_cracker_box" / "google_16k" / "textured.obj").write_text("no mesh\n")
    (root / "006_cracker_box" / "google_16k" / "textured.obj").unlink()
    report = run("ycb", root, tmp_path / "lib")
    assert len(report.made) == 6
    assert [item.name[:3] for item in report.refused] == ["002", "004", "006"]
    assert all("\n" not in item.why and item.why for item in report.refused)
    load_library([tmp_path / "lib"])


BAD = {
    "entities.urdf": '<!DOCTYPE r [<!ENTITY a "b">]><robot name="&a;"/>',
    "circle.urdf": '<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/></geometry>'
    '</visual></link><link name="b"/><joint name="j" type="fixed"><parent link="b"/>'
    '<child link="a"/></joint><joint name="k" type="fixed"><parent link="a"/><child link="b"/>'
    "</joint></robot>",
    "include.xml": '<mujoco><include file="include.xml"/></mujoco>',
    "climb.xml": '<mujoco><include file="../../etc/passwd"/></mujoco>',
    "words.xml": '<mujoco><worldbody><geom type="box" size="a b c"/></worldbody></mujoco>',
    "empty.sdf": "<sdf/>",
    "nan.sdf": "<sdf><model name='m'><link name='l'><visual name='v'><geometry><box><size>nan 1 1"
    "</size></box></geometry></visual></link></model></sdf>",
    "prefix.urdf": '<robot name="r"><x:link name="a"/></robot>',
    "two.sdf": "<sdf><model name='m'><link name='l'><visual name='v'><geometry><mesh><scale>1 1"
    "</scale><uri>two.obj</uri></mesh></geometry></visual></link></model></sdf>",
    "flat.obj": "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n",
    "corner.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 1\n3 0 1 7\n",
    "zeros.gltf": '{"asset": {"version": "2.0"}, "accessors": [{"componentType": 5126, '
    '"type": "VEC3", "count": 900000000}], "meshes": [{"primitives": [{"attributes": '
    '{"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}',
    "short.glb": "glTF",
    "text.ply": "ply\nformat ascii 1.0\nend_header\n",
    "text.dae": "<COLLADA>",
    "empty.dae": "<COLLADA/>",
    "text.gltf": '{"asset": {"version": "2.0"}, "meshes": 7}',
}


@pytest.mark.parametrize("name", sorted(BAD))
def test_broken_files_of_strangers_are_told_and_leave_nothing(tmp_path: Path, name: str) -> None:
    root = tmp_path / "folder"
    root.mkdir()
    (root / name).write_text(BAD[name])
    report = run("folder", root, tmp_path / "lib", licence="MIT")
    (refused,) = report.refused
    assert name.split(".")[0] in refused.why or name in refused.why
    left = [p.name for p in (tmp_path / "lib").rglob("*") if p.is_file()]
    assert sorted(left) == ["ATTRIBUTION.md", "manifest.yaml"]


def test_what_nobody_thought_of_stops_one_model_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = downloads.ycb(downloads.ycb(tmp_path / "ycb"), "013_apple")

    def odd(source: str, candidate: Candidate, references: References) -> Scan:
        if candidate.name == "013_apple":
            raise LookupError("a\nthing")
        return read_model(source, candidate, references)

    monkeypatch.setattr("sdgen.importing.run.read_model", odd)
    report = run("ycb", root, tmp_path / "lib")
    assert [origin.name for origin in report.made] == ["003_cracker_box"]
    (refused,) = report.refused
    assert refused.why == "textured.obj: nothing can be made of it (LookupError: a thing)"


def test_pairs_state_one_matrix_of_real_numbers(tmp_path: Path) -> None:
    root = downloads.fantastic_breaks(tmp_path / "fb")
    pair = root / "05" / "00012" / "meta_0.npz"
    for matrix in (np.eye(4) * 1j, np.zeros((3000, 4, 4)), np.array("abc")):
        np.savez_compressed(pair, transform=matrix)
        (refused,) = run("fantastic-breaks", root, tmp_path / "lib", licence="MIT").refused
        assert "meta_0.npz" in refused.why


@pytest.mark.parametrize(
    ("said", "rubs"), [("0.9", 0.9), ("100000", 0.6), ("-1", 0.6), (None, 0.6)]
)
def test_friction_is_what_a_file_says_if_things_rub_so(
    tmp_path: Path, said: str | None, rubs: float
) -> None:
    root = tmp_path / "folder"
    root.mkdir()
    mu = f"<friction><ode><mu>{said}</mu></ode></friction>" if said else ""
    geometry = "<geometry><box><size>.08 .08 .1</size></box></geometry>"
    (root / "mug.sdf").write_text(
        f"<sdf><model name='mug'><link name='l'><visual name='v'>{geometry}</visual>"
        f"<collision name='c'>{geometry}<surface>{mu}</surface></collision></link></model></sdf>"
    )
    (root / "two").mkdir()
    friction = f'friction="{said} .01"' if said else ""
    (root / "two" / "mug.xml").write_text(
        f'<mujoco><worldbody><body><geom type="box" size=".04 .04 .05" {friction}/></body>'
        "</worldbody></mujoco>"
    )
    downloads.replicacad(tmp_path / "cad")
    config = next((tmp_path / "cad").rglob("*.object_config.json"))
    given = json.loads(config.read_text())
    if said:
        given["friction_coefficient"] = float(said)
    config.write_text(json.dumps(given))
    made = [
        *run("folder", root, tmp_path / "lib", licence="MIT").made,
        *run("folder", root / "two", tmp_path / "lib", licence="MIT").made,
        *run("replicacad", tmp_path / "cad", tmp_path / "lib", licence="MIT").made,
    ]
    assert [origin.asset.friction for origin in made] == [rubs] * 3


MINE = "- {id: mine, category: mug, licence: MIT, source: me, extents_m: [1, 1, 1]"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (f"assets:\n{MINE}, mas_kg: 2}}\n", "assets: mine: "),
        ("assets: [\n", "manifest.yaml:"),
        ("- a\n", "is no manifest"),
        ("assets: 7\n", "is no manifest"),
        ("assets: [3]\n", "assets: entry 1: "),
    ],
)
def test_a_manifest_with_a_fault_is_not_written_anew(tmp_path: Path, text: str, told: str) -> None:
    root, library = downloads.ycb(tmp_path / "ycb"), tmp_path / "lib"
    library.mkdir()
    (library / "manifest.yaml").write_text(text)
    with pytest.raises(AssetError, match=told):
        run("ycb", root, library)
    assert (library / "manifest.yaml").read_text() == text
    assert not (library / "imports").exists()


def test_models_of_two_downloads_with_one_name_are_two(tmp_path: Path) -> None:
    library = tmp_path / "lib"
    for number, name in enumerate(("a", "b")):
        downloads.obj(tmp_path / name / "mug.obj", (0.1, 0.1, 0.1 + 0.01 * number), None)
        assert len(run("folder", tmp_path / name, library, licence="MIT").made) == 1
    assert set(load_library([library]).assets) >= {"folder_mug", "folder_mug_2"}
    # Again, and from a copy elsewhere: nothing is new. Moved and changed it is the same model.
    assert run("folder", tmp_path / "b", library, licence="MIT").made == ()
    copy = shutil.copytree(tmp_path / "a", tmp_path / "elsewhere" / "a")
    assert run("folder", copy, library, licence="MIT").made == ()
    shutil.rmtree(tmp_path / "a")
    downloads.obj(copy / "mug.obj", (0.1, 0.1, 0.13), None)
    (changed,) = run("folder", copy, library, licence="MIT").made
    assert changed.asset.id == "folder_mug"


def test_a_library_does_not_import_itself(tmp_path: Path) -> None:
    root = tmp_path / "src"
    downloads.obj(root / "mug.obj", (0.1, 0.1, 0.1), None)
    with pytest.raises(AssetError, match="is the download itself"):
        run("folder", root, root, licence="MIT")
    for _ in range(2):
        run("folder", root, root / "lib", licence="MIT")
    assert len(list((root / "lib" / "imports").iterdir())) == 1


def test_archives_in_a_download_share_one_limit_and_lie_in_it(tmp_path: Path) -> None:
    zeros = bytes(30_000_000)
    with zipfile.ZipFile(tmp_path / "outer.zip", "w") as outer:
        for number in range(4):
            inner = io.BytesIO()
            with zipfile.ZipFile(inner, "w", zipfile.ZIP_DEFLATED) as packed:
                packed.writestr("mug.obj", zeros)
            outer.writestr(f"{number}.zip", inner.getvalue())
    with opened_source(tmp_path / "outer.zip") as (roots, refused):
        assert len(roots) == 2
        assert [item.name for item in refused] == ["1.zip", "2.zip", "3.zip"]
        assert all("unpacks to more than" in item.why for item in refused)
    folder = tmp_path / "folder"
    folder.mkdir()
    (folder / "link.zip").symlink_to(tmp_path / "outer.zip")
    with opened_source(folder) as (roots, refused):
        assert len(roots) == 1
        assert [item.why for item in refused] == ["lies outside folder"]


def test_stopped_it_leaves_a_library_that_builds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = downloads.ycb(downloads.ycb(tmp_path / "ycb"), "013_apple")

    def stop(done: int, of: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        import_models(Import("ycb", root, tmp_path / "lib"), CATALOG, stop)
    assert "ycb_003_cracker_box" in load_library([tmp_path / "lib"]).assets


def test_a_picture_inside_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    root = downloads.replicacad(tmp_path / "cad")
    mesh = next(root.rglob("*.glb"))
    mesh.write_bytes(mesh.read_bytes().replace(b"\x89PNG", b"\x89PNX"))
    origin = one(run("replicacad", root, tmp_path / "lib", licence="MIT"))
    assert any("picture" in note for note in origin.notes)


def test_names_with_blanks_and_other_letters(tmp_path: Path) -> None:
    root = tmp_path / "folder"
    (root / "Käse Teller").mkdir(parents=True)
    downloads.obj(root / f"{'mug' * 70}.obj", (0.1, 0.1, 0.1), None)
    downloads.obj(root / "Käse Teller" / "große Tasse.obj", (0.1, 0.1, 0.1), None)
    downloads.obj(root / "Käse Teller" / "mug.obj", (0.12, 0.09, 0.1), None)
    report = run("folder", root, tmp_path / "lib", licence="CC0-1.0")
    assert report.refused == ()
    assert {o.placed for o in report.made if o.name == "große Tasse"} == {False}
    assert all(o.asset.id.isascii() for o in report.made)
    load_library([tmp_path / "lib"])


def test_what_else_a_library_holds_stays(tmp_path: Path) -> None:
    root, library = downloads.ycb(tmp_path / "ycb"), tmp_path / "lib"
    first = one(run("ycb", root, library)).asset
    manifest = library / "manifest.yaml"
    surface = f"- {{id: mine, kind: floor, texture: {first.texture}, size_m: 1.0}}"
    manifest.write_text(manifest.read_text().replace("surfaces: []", f"surfaces:\n{surface}"))
    downloads.ycb(root, "013_apple")
    run("ycb", root, library)
    found = load_library([library])
    assert "mine" in found.surfaces
    assert {first.id, "ycb_013_apple"} <= set(found.assets)


def test_titles_like_numbers_stay_text(tmp_path: Path) -> None:
    root = tmp_path / "folder"
    downloads.obj(root / "1e3.obj", (0.1, 0.1, 0.1), None)
    origin = one(run("folder", root, tmp_path / "lib", licence="CC0-1.0"))
    assert load_library([tmp_path / "lib"]).assets[origin.asset.id].title == "1e3"


def test_builds_may_take_small_things_of_own_folders_alone(tmp_path: Path) -> None:
    origin = one(run("ycb", downloads.ycb(tmp_path / "ycb"), tmp_path / "lib"))
    library = load_library([tmp_path / "lib"])
    mixed = SplitModels(library, "test")("cereal_box")
    alone = SplitModels(library, "test", small_categories(CATALOG))("cereal_box")
    assert len(mixed) > len(alone)
    assert origin.asset.id in {model.id for model in alone}
    # Of ours only those whose states no model of the folder has.
    assert all(model.state_names for model in alone if model.id != origin.asset.id)


def test_models_for_no_trade_are_built_with_a_word_only(tmp_path: Path) -> None:
    root = downloads.replicacad(tmp_path / "replica")
    one(run("replicacad", root, tmp_path / "lib", non_commercial=True))
    library = load_library([tmp_path / "lib"])
    options = BuildOptions(n=0, views=0)
    with pytest.raises(AssetError, match="--non-commercial"):
        build(options, tmp_path / "set", CATALOG, library)
    assert not (tmp_path / "set").exists()
    build(options, tmp_path / "set", CATALOG, library, non_commercial=True)


def test_a_data_set_has_the_narrowest_licence_of_its_models() -> None:
    assert narrowest(["CC-BY-4.0", "CC0-1.0", "MIT"]) == "CC-BY-4.0"
    assert narrowest(["CC-BY-4.0", "CC-BY-NC-4.0", "CC-BY-SA-4.0"]) == "CC-BY-NC-4.0"


def test_a_plain_install_says_what_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sdgen.importing.packages.find_spec", lambda name: None)
    with pytest.raises(SdgenError, match=r"xatlas: pip install 'sdgen\[assets\]'"):
        run("ycb", downloads.ycb(tmp_path / "ycb"), tmp_path / "lib")
    assert not (tmp_path / "lib").exists()


def test_an_unknown_source_layout_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(AssetError, match="google_16k"):
        run("ycb", tmp_path / "empty", tmp_path / "lib")


@pytest.mark.skipif(not SCANS.is_dir(), reason="shared/scans is not here")
def test_all_shared_models_stand_as_large_as_they_are() -> None:
    """Sizes of all 92 within 1 % of what was measured, whichever way they lie."""
    with (SCANS / "INDEX.csv").open() as stream:
        rows = [row for row in csv.DictReader(stream) if row["source"] in SOURCES]
    seen = {}
    for folder, source in SOURCES.items():
        table = load_table(source, CATALOG)
        for candidate in find_models(source, SCANS / folder):
            references = References(SCANS / folder, candidate.folder)
            try:
                scan = read_model(source, candidate, references)
            except AssetError:  # configs of objects that are not in the sample
                assert folder == "replica_cad"
                continue
            scan, _ = stand(scan, candidate.name, table, CATALOG, [])
            seen[folder, candidate.name] = np.sort(scan.extents_m)
    assert len(rows) == 92
    named = {"fridge/body": "urdf_fridge", "doors/door1": "urdf_door1"}
    for row in rows:
        found = seen[row["source"], named.get(row["model"], row["model"])]
        if row["model"] == "fridge/body":
            continue  # its doors belong to it
        expected = np.sort([float(v) for v in row["extents_m"].split()])
        assert found == pytest.approx(expected, rel=0.01, abs=0.0006), row["model"]


@pytest.mark.skipif(not SCANS.is_dir(), reason="shared/scans is not here")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("folder", "name", "category"),
    [
        ("ycb", "025_mug", "mug"),
        ("google_scanned_objects", "ACE_Coffee_Mug_Kristen_16_oz_cup", "mug"),
        ("replica_cad", "frl_apartment_chair_01", "armchair"),
        ("replica_cad", "urdf_fridge", "fridge"),
        ("gazebo_models", "beer", "beer_bottle"),
        ("aws-robomaker-small-house-world", "aws_robomaker_residential_Trash_01", "trash_bin"),
        ("bigym_props", "ketchup", "ketchup_bottle"),
    ],
)
def test_shared_models_import(tmp_path: Path, folder: str, name: str, category: str) -> None:
    asked = Import(
        SOURCES[folder], SCANS / folder, tmp_path / "lib", licence="CC-BY-4.0", non_commercial=True
    )
    origin = one(import_models(asked, CATALOG, names=[name]))
    assert checked(tmp_path / "lib", origin.asset).category == category
    again = import_models(asked, CATALOG, names=[name])
    assert again.made == ()
    shutil.rmtree(tmp_path / "lib" / "imports")
    record = json.loads(origin.model_dump_json())
    assert record["asset"]["source"] == f"{SOURCES[folder]}:{name}"
