"""What the real clients count in every export of a data set, beside what ``sdgen stats`` counts.

    python benchmarks/export_counts.py DATASET [--formats huggingface,coco,...]

Each format is written, opened by the library that people read it with (``datasets``,
``mlcroissant``, ``webdataset``, ``pycocotools``, ``mujoco``, OpenUSD, PyBullet, trimesh), and its
scenes, views, things, anomalies and hazards are counted there. Ends with 1 where one differs.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tarfile
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import sdgen
from sdgen.dataset import Dataset
from sdgen.export import FORMATS, export
from sdgen.physics.bullet import quiet
from sdgen.vocabulary import STRUCTURES

Counts = dict[str, Any]
#: How things are called in models of scenes: category and id.
NAME = re.compile(r"([a-z_]+)_(\d+)")


def main() -> int:
    """Export, count, print; 1 where a count is another than that of ``stats``."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--formats", default=",".join(COUNTERS))
    args = parser.parse_args()
    told = stats(args.dataset)
    print("sdgen stats   ", words(told))
    wrong = 0
    for name in args.formats.split(","):
        data = Dataset(args.dataset)
        with tempfile.TemporaryDirectory(dir=args.dataset.resolve().parent) as folder:
            out = Path(folder) / ("homes.tar" if FORMATS[name].output == "file" else "homes")
            library = sdgen.load_library() if FORMATS[name].models else None
            export(data, name, out, library=library)
            found = COUNTERS[name](out)
        differs = {key: (found[key], told[key]) for key in found if found[key] != told[key]}
        wrong += bool(differs)
        verdict = f"NOT SO: {differs}" if differs else "as stats has it"
        print(f"{name:14} {words(found)}: {verdict}", flush=True)
    return int(wrong > 0)


def words(counts: Mapping[str, Any]) -> str:
    """Counts on a line; of hazards how many kinds there are."""
    shown = {k: f"{len(v)}" if isinstance(v, Counter) else f"{v}" for k, v in counts.items()}
    return ", ".join(f"{number} {key}" for key, number in shown.items())


def stats(path: Path) -> Counts:
    """What ``sdgen stats --json`` says; views of scenes alone, as exports keep twins apart."""
    command = [sys.executable, "-m", "sdgen", "stats", str(path), "--json"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    said = json.loads(done.stdout)
    hazards = Counter({k: v for k, v in said["anomalies_by_hazard"].items() if v})
    views = sum(entry.views for entry in Dataset(path).entries if entry.twin_of is None)
    return {
        "scenes": said["scenes"],
        "twins": said["twins"],
        "views": views,
        "objects": said["objects"],
        "anomalies": said["anomalies"],
        "hazards": hazards,
    }


def of_tar(path: Path) -> Counts:
    """Unpacked by ``tarfile``, opened by ourselves."""
    with tempfile.TemporaryDirectory(dir=path.parent) as folder, tarfile.open(path) as archive:
        archive.extractall(folder, filter="data")
        (unpacked,) = Path(folder).iterdir()
        return stats(unpacked)


def of_huggingface(path: Path) -> Counts:
    """Rows of ``datasets.load_dataset``, their pictures decoded."""
    from datasets import get_dataset_config_names, load_dataset

    cache = str(path.parent / "cache")

    def rows(name: str) -> list[Any]:
        if name not in names:
            return []
        return [
            row
            for split in load_dataset(str(path), name, cache_dir=cache).values()
            for row in split
        ]

    names = get_dataset_config_names(str(path))
    scenes, anomalies = rows("scenes"), rows("anomalies")
    views = 0
    for split in load_dataset(str(path), "views", cache_dir=cache).values():
        for row in split:
            views += row["image"].size == row["instance"].size == (row["width"], row["height"])
    assert sum(len(row["anomalies"]) for row in scenes) == len(anomalies)
    return {
        "scenes": len(scenes),
        "twins": len(rows("twin_scenes")),
        "views": views,
        "objects": sum(len(row["objects"]) for row in scenes),
        "anomalies": len(anomalies),
        "hazards": Counter(row["hazard"] for row in anomalies),
    }


def of_croissant(path: Path) -> Counts:
    """Records of ``mlcroissant``."""
    import mlcroissant

    data = mlcroissant.Dataset(jsonld=str(path / "croissant.json"))
    names = {record_set.id for record_set in data.metadata.record_sets}
    hazards = [row["anomalies/hazard"].decode() for row in data.records("anomalies")]
    return {
        "scenes": sum(1 for _ in data.records("scenes")),
        "twins": sum(1 for _ in data.records("twin_scenes")) if "twin_scenes" in names else 0,
        "views": sum(1 for _ in data.records("views")),
        "anomalies": len(hazards),
        "hazards": Counter(hazards),
    }


def of_webdataset(path: Path) -> Counts:
    """Samples of ``webdataset``, their pictures decoded."""
    import webdataset

    def samples(kind: str) -> Iterable[Any]:
        shards = sorted(str(shard) for shard in path.glob(f"{kind}/*.tar"))
        return webdataset.WebDataset(shards, shardshuffle=False).decode("rgb8") if shards else ()

    scenes = list(samples("scenes"))
    anomalies = [a for one in scenes for a in one["anomalies.json"]["anomalies"]]
    views = sum(
        any(
            sample.get(name) is not None and sample[name].ndim == 3
            for name in ("rgb.png", "rgb.jpg")
        )
        for sample in samples("views")
    )
    return {
        "scenes": len(scenes),
        "twins": sum(1 for _ in samples("twin_scenes")),
        "views": views,
        "objects": sum(len(one["scene.json"]["objects"]) for one in scenes),
        "anomalies": len(anomalies),
        "hazards": Counter(anomaly["hazard"] for anomaly in anomalies),
    }


def of_coco(path: Path) -> Counts:
    """Images of ``pycocotools``, and the anomalies that some picture of them shows."""
    from pycocotools.coco import COCO

    scenes, twins, views, anomalies = set(), set(), 0, set()
    for file in sorted(path.glob("annotations/hazards_*.json")):
        coco = COCO(str(file))
        images = coco.loadImgs(coco.getImgIds())
        if file.stem.endswith("_twin"):
            twins |= {image["scene"] for image in images}
            continue
        views += len(images)
        scenes |= {image["scene"] for image in images}
        for one in coco.loadAnns(coco.getAnnIds()):
            (image,) = coco.loadImgs(one["image_id"])
            (hazard,) = coco.loadCats(one["category_id"])
            anomalies.add((image["scene"], one["object_id"], hazard["name"]))
    return {
        "scenes": len(scenes),
        "twins": len(twins),
        "views": views,
        "anomalies": len(anomalies),
        "hazards": Counter(hazard for _, _, hazard in anomalies),
    }


def of_virtualhome(path: Path) -> Counts:
    """Graphs in VirtualHome's keys; things are its nodes that are no rooms and no structures."""
    graphs = {file.stem: json.loads(file.read_text()) for file in path.glob("graphs/*.json")}
    alone = {name: graph for name, graph in graphs.items() if "-" not in name}
    things = sum(
        node["category"] != "Rooms" and node["class_name"] not in STRUCTURES
        for graph in alone.values()
        for node in graph["nodes"]
    )
    anomalies = [
        anomaly
        for name in alone
        for anomaly in json.loads((path / f"anomalies/{name}.json").read_text())["anomalies"]
    ]
    return {
        "scenes": len(alone),
        "twins": len(graphs) - len(alone),
        "objects": things,
        "anomalies": len(anomalies),
        "hazards": Counter(anomaly["hazard"] for anomaly in anomalies),
    }


def models(ending: str, names: Callable[[Path], Iterable[str]]) -> Callable[[Path], Counts]:
    """A counter of formats with a file a scene, given the names of what is in a file."""

    def things(file: Path) -> int:
        found = {match.groups() for name in names(file) if (match := NAME.fullmatch(name))}
        return sum(category not in STRUCTURES for category, _ in found)

    def count(path: Path) -> Counts:
        files = sorted(path.glob(f"*{ending}"))
        alone = [file for file in files if "-" not in file.name.removesuffix(ending)]
        return {
            "scenes": len(alone),
            "twins": len(files) - len(alone),
            "objects": sum(things(file) for file in alone),
        }

    return count


def bodies(file: Path) -> list[str]:
    """Names of MuJoCo's bodies."""
    import mujoco

    if file.suffix == ".mjz":
        model = mujoco.MjSpec.from_file(str(file)).compile()
    else:
        model = mujoco.MjModel.from_xml_path(str(file))
    return [model.body(number).name for number in range(model.nbody)]


def prims(file: Path) -> list[str]:
    """Names of the prims of a stage of OpenUSD that say what they are."""
    from pxr import Usd

    stage = Usd.Stage.Open(str(file))  # its prims end with it
    label = "SemanticsLabelsAPI:category"
    return [p.GetName() for p in stage.Traverse() if label in p.GetAppliedSchemas()]


def meshes(file: Path) -> list[str]:
    """Names of the nodes below a GLB's root, as trimesh reads it."""
    import trimesh

    graph = trimesh.load(file).graph
    (root,) = graph.transforms.children[graph.base_frame]
    return list(graph.transforms.children[root])


def links(file: Path) -> list[str]:
    """Names of a URDF's links, as PyBullet loads it."""
    import pybullet

    client = pybullet.connect(pybullet.DIRECT)
    with quiet():  # it warns of each body without a mass
        body = pybullet.loadURDF(str(file), useFixedBase=True, physicsClientId=client)
    joints = range(pybullet.getNumJoints(body, physicsClientId=client))
    infos = [pybullet.getJointInfo(body, joint, physicsClientId=client) for joint in joints]
    pybullet.disconnect(client)
    return [info[12].decode() for info in infos]


COUNTERS: Mapping[str, Callable[[Path], Counts]] = {
    "tar": of_tar,
    "huggingface": of_huggingface,
    "croissant": of_croissant,
    "webdataset": of_webdataset,
    "coco": of_coco,
    "virtualhome": of_virtualhome,
    "mjcf": models(".xml", bodies),
    "mjz": models(".mjz", bodies),
    "usd": models(".usda", prims),
    "glb": models(".glb", meshes),
    "urdf": models(".urdf", links),
}

if __name__ == "__main__":
    raise SystemExit(main())
