"""Sources of models on this machine, in the form of the real ones."""

from __future__ import annotations

import gzip
import hashlib
import json
from urllib.parse import quote

from tests.importing.evil_archives import tar_of, zip_of
from tests.importing.file_server import Site

HUB = "/datasets/ai-habitat/ReplicaCAD_dataset/resolve/main"
HUB_LIST = "/api/datasets/ai-habitat/ReplicaCAD_dataset/tree/main?recursive=true&limit=1000"
YCB = ("002_can", "025_mug", "063-a_marbles", "099_gone")
GSO = ("Mug_Blue", "Plate White", "Café_Set")
HUB_FILES = {
    "LICENSE.txt": b"CC BY-NC 4.0",
    "replicaCAD.scene_dataset_config.json": b"{}",
    "configs/objects/frl_sofa.object_config.json": b"{}",
    "objects/frl_sofa.glb": b"glTF" * 5000,
    "objects/convex/frl_sofa_cv_decomp.glb": b"glTF",
    "urdf/fridge/fridge.urdf": b"<robot/>",
    "urdf/fridge/body.glb": b"glTF",
    "configs/scenes/apt_0.scene_instance.json": b"{}",
    "stages/frl_stage.glb": b"glTF",
    "navmeshes/apt_0.navmesh": b"not needed",
    "../evil.glb": b"evil",
    "objects/../../evil.glb": b"evil",
}


def ycb_path(name: str) -> str:
    return f"/data/google/{name}_google_16k.tgz"


def gso_path(name: str) -> str:
    return f"/1.0/GoogleResearch/models/{quote(name)}.zip"


def put_ycb(site: Site) -> None:
    """``002_can`` and ``063-a_marbles`` by Google, ``025_mug`` by Berkeley only, one nowhere."""
    site.put("/data/objects.json", json.dumps({"objects": [*YCB, "../evil", 7]}).encode())
    for name in YCB[:3:2]:
        files = {
            f"{name}/google_16k/textured.obj": f"# {name}\n".encode() * 2000,
            f"{name}/google_16k/texture_map.png": b"PNG",
        }
        site.put(ycb_path(name), gzip.compress(tar_of(files), mtime=0))
    mug = gzip.compress(tar_of({"025_mug/tsdf/textured.obj": b"# mug\n"}), mtime=0)
    site.put("/data/berkeley/025_mug/025_mug_berkeley_meshes.tgz", mug)


def put_gso(site: Site, licence: str = "Creative Commons Attribution 4.0 International") -> None:
    """Two pages of models, then none; zips without a folder of their own."""

    def row(name: str) -> dict[str, object]:
        date = "2020-09-01T10:00:00Z"
        return {"name": name, "license_name": licence, "version": 1, "modify_date": date}

    pages = [[row(name) for name in GSO[:2]], [row(GSO[2]), {"name": ".hidden"}, {}]]
    for number, page in enumerate(pages, start=1):
        path = f"/1.0/GoogleResearch/models?per_page=100&page={number}"
        site.put(path, json.dumps(page).encode())
    for name in GSO:
        files = {"model.config": b"<model/>", "meshes/model.obj": f"# {name}\n".encode()}
        site.put(gso_path(name), zip_of(files), etag=None)


def put_hub(site: Site) -> None:
    """A list on two pages, half of the files in large storage."""
    rows = [{"type": "directory", "path": "objects", "oid": "0" * 40, "size": 0}]
    for number, (path, body) in enumerate(HUB_FILES.items()):
        git = hashlib.sha1(b"blob %d\0" % len(body) + body).hexdigest()
        row: dict[str, object] = {"type": "file", "path": path, "oid": git, "size": len(body)}
        if number % 2:
            row["lfs"] = {"oid": hashlib.sha256(body).hexdigest(), "size": len(body)}
            row["oid"] = "0" * 40
        rows.append(row)  # type: ignore[arg-type]
        site.put(f"{HUB}/{path}", body)
    following = {"Link": f'<{site.base}/page2>; rel="next"'}
    site.put(HUB_LIST, json.dumps(rows[:5]).encode(), headers=following)
    site.put("/page2", json.dumps(rows[5:]).encode())
