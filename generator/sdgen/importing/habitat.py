"""Reads models as Habitat's data sets (ReplicaCAD) have them: configs, receptacle boxes, scenes.

https://aihabitat.org/docs/habitat-sim/attributesJSON.html. Metres, Y up; quaternions w, x, y, z.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array, rotation_matrix
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.scan import Box, LinkBox, Scan
from sdgen.importing.tree import References
from sdgen.importing.urdf import read_urdf

_MAX_JSON = 5_000_000
#: So many scenes are asked how a model stands in them.
_SCENES = 20


def read_configured(path: Path, references: References) -> Scan:
    """The model of a ``*.object_config.json``: mesh, mass and receptacle boxes. Raises AssetError,
    located."""
    shown = references.shown(path)
    given = _json(path, references)
    name = given.get("render_asset")
    if not isinstance(name, str):
        raise AssetError([f"{shown}: render_asset: expected the name of a mesh"])
    mesh = references.find(path.parent, name)
    if mesh is None or mesh.suffix.lower() not in MESHES:
        raise AssetError([f"{shown}: render_asset: {name}: no such mesh"])
    pieces, _ = read_mesh(mesh, references)
    scale = given.get("scale", [1.0, 1.0, 1.0])
    try:
        matrix = np.diag([*(float(v) for v in scale), 1.0])
        if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or not np.diag(matrix).all():
            raise ValueError("scale: expected three numbers that are not 0")
        mass = float(given["mass"]) if "mass" in given else None
        rubs = given.get("friction_coefficient")
        friction = None if rubs is None else float(rubs)
        boxes = tuple(found.box for found in _boxes(given.get("user_defined")))
    except (TypeError, ValueError, OverflowError) as error:
        raise AssetError([f"{shown}: {error}"]) from None
    return Scan(
        tuple(piece.moved(matrix) for piece in pieces),
        up="y",
        mass_kg=mass,
        friction=friction,
        receptacles=boxes,
    )


def read_articulated(path: Path, references: References) -> Scan:
    """The model of a URDF, as large and upright as scenes have it, with the receptacle boxes of the
    ``*.ao_config.json`` beside it. Raises AssetError, located."""
    boxes: tuple[LinkBox, ...] = ()
    config = path.with_suffix(".ao_config.json")
    if config.is_file():
        try:
            boxes = tuple(_boxes(_json(config, references).get("user_defined")))
        except (TypeError, ValueError, OverflowError) as error:
            raise AssetError([f"{references.shown(config)}: {error}"]) from None
    scan = read_urdf(path, references, "y", boxes)
    placed = _in_scenes(path, references)
    return scan if placed is None else scan.moved(placed)


def _in_scenes(path: Path, references: References) -> Array | None:
    """How most scenes scale and tilt the model, 4x4; None where no scene has it.

    Files of ReplicaCAD are 2.5 times too large, or lie on their backs, and its scenes mend that.
    """
    folder = path.parents[2] / "configs" / "scenes" if len(path.parents) > 2 else path
    found: Counter[tuple[float, float, float, float]] = Counter()
    for scene in sorted(folder.glob("*.scene_instance.json"))[:_SCENES]:
        try:
            instances = _json(scene, references).get("articulated_object_instances")
            for entry in instances if isinstance(instances, list) else ():
                if str(entry["template_name"]).rsplit("/", 1)[-1] == path.stem:
                    found[_scale_and_up(entry)] += 1
        except (AssetError, KeyError, TypeError, ValueError, OverflowError):
            continue  # a scene that is broken says nothing
    if not found:
        return None
    scale, *up = found.most_common(1)[0][0]
    matrix = np.eye(4)
    matrix[:3, :3] = scale * shapes.least_turn(up, (0.0, 1.0, 0.0))
    return matrix


def _scale_and_up(entry: Mapping[str, Any]) -> tuple[float, float, float, float]:
    """An instance's scale, and which direction of the model is up in its scene."""
    scale = float(entry.get("uniform_scale", 1.0))
    w, x, y, z = (float(v) for v in entry.get("rotation", (1.0, 0.0, 0.0, 0.0)))
    if not (1e-3 < scale < 1e3 and 0.9 < math.hypot(w, x, y, z) < 1.1):
        raise ValueError("no scale or rotation")
    right, up, back = rotation_matrix((x, y, z, w)).T @ (0.0, 1.0, 0.0)
    return scale, round(float(right), 2), round(float(up), 2), round(float(back), 2)


def _boxes(given: Any) -> list[LinkBox]:
    """Receptacle boxes of ``user_defined``: ``scale`` is half of each side, negative in some."""
    out = []
    for name, entry in given.items() if isinstance(given, dict) else ():
        if not str(name).startswith("receptacle_aabb") or not isinstance(entry, dict):
            continue
        missing = [key for key in ("position", "scale") if not isinstance(entry.get(key), list)]
        if missing:
            raise ValueError(f"{name}: {missing[0]}: expected three numbers")
        center = np.array([float(v) for v in entry["position"]])
        half = np.array([abs(float(v)) for v in entry["scale"]])
        if center.shape != (3,) or half.shape != (3,) or not np.isfinite([center, half]).all():
            raise ValueError(f"{name}: expected three numbers")
        out.append(LinkBox(Box(center, 2 * half), str(entry.get("parent_link", "body"))))
    return out


def _json(path: Path, references: References) -> dict[str, Any]:
    shown = references.shown(path)
    try:
        given = json.loads(references.bytes_of(path, _MAX_JSON))
    except (ValueError, RecursionError) as error:
        raise AssetError([f"{shown}: not JSON ({error})"]) from None
    if not isinstance(given, dict):
        raise AssetError([f"{shown}: expected an object"])
    return given
