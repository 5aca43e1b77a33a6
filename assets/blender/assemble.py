"""Merge build/assets/*.json into assets/manifest.yaml and write the hulls (no Blender needed).

Entries not rebuilt are kept. `--remove ID...` drops entries and their files. Models of a category
with the same geometry (skins of one shape) share one mesh and one set of hulls.
Needs sdgen, trimesh with scipy, and coacd.
"""

from __future__ import annotations

import argparse
import fcntl
import hashlib
import json
import os
import sys
from pathlib import Path

import cushions
import numpy as np
import trimesh
import yaml
from compact import compact
from sdgen.importing.convex import simplify_hull
from sdgen.library.meshes import read_glb
from sdgen.library.poses import resting_poses
from sdgen.library.records import Asset
from sdgen.library.shape import centre_of_mass, corners_of

ASSETS = Path(__file__).resolve().parent.parent
RECORDS = ASSETS.parent / "build" / "assets"
HEAD = "# Written by blender/assemble.py; see README.md for the fields.\n"


def geometry_digest(glb: Path) -> str:
    """Digest of a GLB without the name of its texture."""
    raw = glb.read_bytes()
    length = int.from_bytes(raw[12:16], "little")
    document = json.loads(raw[20 : 20 + length])
    document.pop("images", None)
    text = json.dumps(document, sort_keys=True).encode()
    return hashlib.sha256(text + raw[28 + length :]).hexdigest()


def store_meshes(built: dict[str, dict], entries: dict[str, dict]) -> list[str]:
    """Copy the meshes of the models just built, one for each geometry of a category.

    Sets their `mesh` and `hulls`. Returns ids that were not built but show a mesh that changed.
    """
    first: dict[tuple[str, str], str] = {}
    stale: list[str] = []
    for asset_id in sorted(built):
        entry, glb = built[asset_id], RECORDS / "meshes" / f"{asset_id}.glb"
        digest = geometry_digest(glb)
        owner = first.setdefault((entry["category"], digest), asset_id)
        entry["mesh"], entry["hulls"] = f"meshes/{owner}.glb", f"meshes/{owner}.hulls.json"
        target = ASSETS / entry["mesh"]
        if owner != asset_id:
            continue
        small = RECORDS / "compact" / f"{owner}-{digest}.glb"
        if not small.exists():
            small.parent.mkdir(exist_ok=True)
            small.write_bytes(compact(glb.read_bytes()))
        if not target.exists() or target.read_bytes() != small.read_bytes():
            if target.exists():
                users = (i for i, e in entries.items() if e["mesh"] == entry["mesh"])
                stale += [i for i in users if i not in built]
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(small.read_bytes())
    return stale


def delete_unnamed(
    entries: dict[str, dict], surfaces: dict[str, dict], read: dict[str, float]
) -> None:
    """Remove files that no record names any more.

    `read` is when each record that was read had been written: a file newer than that belongs to
    a build that goes on meanwhile.
    """
    named = {e[k] for e in entries.values() for k in ("mesh", "hulls", "texture")}
    named |= {s["texture"] for s in surfaces.values()}
    for path in (*(ASSETS / "meshes").iterdir(), *(ASSETS / "textures").iterdir()):
        stale = path.stat().st_mtime < read.get(path.name.split(".")[0], 0.0)
        if path.relative_to(ASSETS).as_posix() not in named and stale:
            path.unlink()


def built_mesh(entry: dict) -> Path:
    """The mesh of a model just built, as export.py wrote it."""
    return RECORDS / entry["mesh"]


def part_mesh(glb: Path, name: str) -> trimesh.Trimesh:
    """A part's triangles, read straight from our GLB (float32), back to Z up, vertices merged."""
    raw = glb.read_bytes()
    length = int.from_bytes(raw[12:16], "little")
    document, blob = json.loads(raw[20 : 20 + length]), raw[28 + length :]
    node = next(n for n in document["nodes"] if n["name"] == name)
    primitive = document["meshes"][node["mesh"]]["primitives"][0]

    def read(accessor: int, kind: str, width: int) -> np.ndarray:
        a = document["accessors"][accessor]
        start = document["bufferViews"][a["bufferView"]]["byteOffset"]
        return np.frombuffer(blob, kind, a["count"] * width, start).reshape(-1, width)

    p = read(primitive["attributes"]["POSITION"], "<f4", 3)[:, [0, 2, 1]] * [1, -1, 1]
    faces = read(primitive["indices"], "<u2", 1).reshape(-1, 3)
    mesh = trimesh.Trimesh(p, faces, process=True)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    return mesh


def decompose(mesh: trimesh.Trimesh) -> list[np.ndarray]:
    import coacd

    coacd.set_log_level("error")
    pieces = coacd.run_coacd(
        coacd.Mesh(mesh.vertices, mesh.faces),
        threshold=0.08,
        max_convex_hull=12,
        seed=1,
        resolution=1000,
        mcts_iterations=60,
        mcts_nodes=10,
        preprocess_resolution=40,
    )
    return [np.asarray(v) for v, _ in pieces]


#: Models whose pieces are taken as they are: drawn out to the mesh they would tip, roll or fill
#: what is open. Found by `sdgen assets validate`.
COMPLETE = (
    "balloon_04",
    "cushion_05",
    "headphones_04",
    "ladle_06",
    "phone_03",
    "umbrella_04",
    "umbrella_06",
)


def hull_pieces(entry: dict, collision: dict) -> list[dict]:
    """Convex pieces of all parts, as the hulls file holds them; what is padded is laid already."""
    pieces = []
    padded = [s for s in entry["supports"] if cushions.is_padded(entry["category"], s)]
    for part, wish in collision.items():
        if wish == "none":
            continue
        if wish == "hull":
            found = [part_mesh(built_mesh(entry), part).vertices]
        elif wish == "coacd":
            found = decompose(part_mesh(built_mesh(entry), part))
        else:
            found = [np.array(p) for p in wish]
        own = [s for s in padded if s["part"] == part]
        if own:
            names = entry["variants"]["default"]
            drawn = np.concatenate([part_mesh(built_mesh(entry), name).triangles for name in names])
            found = [piece for points in found for piece in cushions.capped(drawn, points, own)]
        for points in found:
            corners = np.round(simplify_hull(points, cushions.STEEP if own else 1.0), 4)
            # Slices of a lying thing can be flat: nothing to stand on.
            if np.linalg.matrix_rank(corners - corners[0], tol=1e-3) == 3:
                piece = {"part": part, "vertices_m": corners.tolist()}
                pieces.append(piece | ({"complete": True} if entry["id"] in COMPLETE else {}))
    return pieces


def hulls_text(entry: dict, collision: dict) -> str:
    """The hulls file of a model; kept in the build folder, for decomposing takes seconds, until
    what makes it changes."""
    code = "".join(Path(file).read_text() for file in (__file__, cushions.__file__))
    wishes = json.dumps([collision, entry["supports"]], sort_keys=True)
    key = geometry_digest(built_mesh(entry)) + wishes + code
    kept = RECORDS / "hulls" / f"{hashlib.sha256(key.encode()).hexdigest()}.json"
    if not kept.exists():
        pieces = hull_pieces(entry, collision)
        print(f"{entry['id']}: {len(pieces)} convex pieces", flush=True)
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(json.dumps({"pieces": pieces}, separators=(",", ":")) + "\n")
    return kept.read_text()


def resting(entry: dict) -> list[dict]:
    """The model's stable poses, from the hulls of its default variant; kept like the hulls."""
    text = (ASSETS / entry["hulls"]).read_text()
    drawn = entry["variants"]["default"]
    key = hashlib.sha256((text + repr(drawn)).encode()).hexdigest()
    kept = RECORDS / "resting" / f"{key}.json"
    if not kept.exists():
        pieces = [
            np.array(piece["vertices_m"])
            for piece in json.loads(text)["pieces"]
            if piece["part"] in drawn
        ]
        poses = resting_poses(pieces, centre_of_mass(pieces))
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(json.dumps([pose.model_dump(mode="json") for pose in poses]))
    return json.loads(kept.read_text())


def add_standing_states(entries: dict[str, dict]) -> None:
    """Give single models the states of `standing_states.yaml`, once."""
    text = (Path(__file__).with_name("standing_states.yaml")).read_text()
    for state, groups in yaml.safe_load(text).items():
        for category, numbers in ((c, n) for group in groups for c, n in group.items()):
            for number in numbers:
                entry = entries[f"{category}_{number:02d}"]
                rule = {"state": state, "variants": ["default"]}
                if rule not in entry["states"]:
                    entry["states"] = [rule, *entry["states"]]


#: Of what stands open like this, so many radians at the most are ajar.
AJAR_AT_MOST = {"front_door": 0.5, "door": 0.5, "double_door": 0.5, "fridge": 0.75, "freezer": 0.75}


def add_parts_of_states(entries: dict[str, dict]) -> None:
    """Give doors and fridges AJAR, a part of OPEN, and stoves with a lit oven ON and OVEN_ON."""
    for entry in entries.values():
        at_most = AJAR_AT_MOST.get(entry["category"])
        revolute = {j["name"] for j in entry["joints"] if j["type"] == "revolute"}
        ajar = [
            {"state": "AJAR", "joint": rule["joint"], "min": rule["min"], "max": at_most}
            | {key: rule[key] for key in ("parts",) if key in rule}
            for rule in entry["states"]
            if rule["state"] == "OPEN" and rule.get("joint") in revolute and at_most is not None
        ]
        lit = [
            {"state": state, "variants": ["oven_lit"], "parts": ["oven_light"]}
            for state in ("ON", "OVEN_ON")
            if entry["category"] == "stove" and "oven_lit" in entry["variants"]
        ]
        entry["states"] += [rule for rule in (*ajar, *lit) if rule not in entry["states"]]


def add_sets(entries: dict[str, dict]) -> None:
    """Name the suites of `suites.yaml` and the tags of `tags.yaml` in the records of their members,
    and in no other's."""
    suites, tags = members_of("suites.yaml", entries), members_of("tags.yaml", entries)
    for name, entry in entries.items():
        entry.pop("suite", None)
        entry.pop("tags", None)
        after = {key: entry.pop(key) for key in list(entry)[2:]}  # behind its category
        if len(suites.get(name, ())) > 1:
            raise ValueError(f"{name} is in several suites: {', '.join(suites[name])}")
        if name in suites:
            entry["suite"] = suites[name][0]
        if name in tags:
            entry["tags"] = tags[name]
        entry.update(after)


def members_of(listing: str, entries: dict[str, dict]) -> dict[str, list[str]]:
    """The words under which a listing beside this file names each model."""
    found: dict[str, list[str]] = {}
    listed = yaml.safe_load(Path(__file__).with_name(listing).read_text())
    for word, categories in listed.items():
        for category, numbers in categories.items():
            for number in numbers:
                found.setdefault(f"{category}_{number:02d}", []).append(word)
    if unknown := sorted(set(found) - set(entries)):
        raise ValueError(f"{listing} names models that are not there: {', '.join(unknown)}")
    return found


#: Models whose broken variant is not shown: a shard hangs in the air or would tip over what it lies
#: on (`tests/audit/test_models.py` lays them all on a floor).
UNSTABLE = ("glass_jar_06", "plate_04", "plate_07", "teapot_01", "teapot_06", "teapot_07")


def drop_unstable(entries: dict[str, dict]) -> None:
    """Take the BROKEN state and its variant from these models; skins share meshes with others, so
    the part stays."""
    for entry in (entries[name] for name in UNSTABLE):
        entry["states"] = [rule for rule in entry["states"] if rule["state"] != "BROKEN"]
        entry["variants"].pop("broken", None)


def lay_on_cushions(entries: dict[str, dict]) -> None:
    """Lay the supports of what is padded on what is drawn; done to those done before, nothing."""
    known: dict[str, list[dict]] = {}
    for entry in entries.values():
        out = []
        for support in entry["supports"]:
            key = entry["mesh"] + repr(support)
            if cushions.is_padded(entry["category"], support) and key not in known:
                asset = Asset.model_validate(
                    {k: v for k, v in entry.items() if k in Asset.model_fields}
                )
                meshes = read_glb(ASSETS / entry["mesh"], asset)
                drawn = corners_of([meshes[part] for part in entry["variants"]["default"]])
                known[key] = cushions.laid(drawn, support)
            out += known.get(key, [support])
        entry["supports"] = out


def check(entry: dict) -> list[str]:
    problems = []
    total = sum(p["faces"] for p in entry["parts"] if p["name"] in entry["variants"]["default"])
    limit = 2500 if max(entry["extents_m"]) > 0.6 else 800
    if total > limit:
        problems.append(f"{entry['id']}: {total} faces, more than {limit}")
    if not (ASSETS / entry["texture"]).exists() or not (ASSETS / entry["mesh"]).exists():
        problems.append(f"{entry['id']}: a file is missing")
    return problems


def dump(entries: list[dict], surfaces: list[dict]) -> str:
    """Block style for the records, one flow line for each thing inside them."""

    def flow(value) -> str:
        text = yaml.dump(
            value,
            Dumper=yaml.CSafeDumper,
            default_flow_style=True,
            width=10**9,
            sort_keys=False,
            allow_unicode=True,
        )
        return text.strip().removesuffix("...").strip()

    lines = [HEAD + "assets:"]
    for entry in entries:
        lead = "- "
        for key, value in entry.items():
            if key in ("parts", "joints", "states", "supports", "containers", "resting") and value:
                lines.append(f"{lead}{key}:")
                lines += [f"    - {flow(item)}" for item in value]
            elif key == "variants":
                lines.append(f"{lead}{key}:")
                lines += [f"    {flow(name)}: {flow(parts)}" for name, parts in value.items()]
            else:
                lines.append(f"{lead}{key}: {flow(value)}")
            lead = "  "
    lines.append("surfaces:" if surfaces else "surfaces: []")
    lines += [f"- {flow(s)}" for s in surfaces]
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--remove", nargs="*", default=[], metavar="ID")
    options = parser.parse_args()
    RECORDS.mkdir(parents=True, exist_ok=True)
    target = ASSETS / "manifest.yaml"
    with open(RECORDS / ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # two people may assemble at once
        old = yaml.load(target.read_text(), yaml.CSafeLoader) if target.exists() else {}
        entries = {e["id"]: e for e in (old or {}).get("assets") or []}
        surfaces = {s["id"]: s for s in (old or {}).get("surfaces") or []}
        for path in sorted((RECORDS / "surfaces").glob("*.json")):
            surfaces[path.stem] = json.loads(path.read_text())
        for asset_id in options.remove:
            entry = entries.pop(asset_id, None)
            (RECORDS / f"{asset_id}.json").unlink(missing_ok=True)
            if entry:
                (ASSETS / entry["texture"]).unlink(missing_ok=True)
        failures = 0
        built: dict[str, dict] = {}
        read: dict[str, float] = {}
        for path in sorted(RECORDS.glob("*.json")):
            read[path.stem] = path.stat().st_mtime
            entry = json.loads(path.read_text())
            if (RECORDS / "meshes" / f"{entry['id']}.glb").exists():
                built[entry["id"]] = entry
        for asset_id in store_meshes(built, entries):
            failures += 1
            print(f"FAILED {asset_id}: its mesh was rebuilt under another skin; build it, too")
        lay_on_cushions(built)
        for asset_id, entry in built.items():
            try:
                collision = entry.pop("collision")
                if entry.pop("draft", False):
                    print(f"DRAFT {asset_id}: build it again without SDGEN_DRAFT")
                if entry["hulls"] == f"meshes/{asset_id}.hulls.json":  # not another skin's
                    text = hulls_text(entry, collision)
                    (ASSETS / entry["hulls"]).write_text(text)
                entry["resting"] = resting(entry)
                entries[asset_id] = entry
            except Exception as error:  # one bad record must not stop the others
                failures += 1
                print(f"FAILED {asset_id}: {error!r}")
        for entry in entries.values():
            if "resting" not in entry:
                entry["resting"] = resting(entry)
        add_standing_states(entries)
        add_parts_of_states(entries)
        drop_unstable(entries)
        add_sets(entries)
        lay_on_cushions(entries)
        ordered = [entries[k] for k in sorted(entries)]
        temporary = target.with_suffix(".tmp")
        temporary.write_text(dump(ordered, [surfaces[k] for k in sorted(surfaces)]))
        os.replace(temporary, target)
        delete_unnamed(entries, surfaces, read)
    problems = [p for e in ordered for p in check(e)]
    print(
        "\n".join([*problems, f"{len(ordered)} models, {len(surfaces)} surfaces in {target.name}"])
    )
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
