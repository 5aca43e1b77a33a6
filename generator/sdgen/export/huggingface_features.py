"""The columns of the tables of :mod:`sdgen.export.huggingface`, as ``datasets`` types them."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import datasets


def view_features(sensors: Collection[str]) -> datasets.Features:
    """Columns of a view; pictures of those sensors the data set has."""
    from datasets import Features, Image, List, Value

    text, whole, real = Value("string"), Value("int32"), Value("float64")
    pictures: dict[str, Any] = {}
    if "rgb" in sensors:
        pictures["image"] = Image()
    if "depth" in sensors:
        pictures["depth"] = Image()
    if "instance" in sensors:
        pictures |= {"instance": Image(), "part": Image()}
    return Features(
        {
            "scene": text,
            "split": text,
            "view": whole,
            **pictures,
            "kind": text,
            "room_id": whole,
            "room_type": text,
            "width": whole,
            "height": whole,
            "K": List(List(real)),
            "world_from_camera": List(List(real)),
            "hazards": List(text),
            "objects": List(
                {
                    "object_id": whole,
                    "category": text,
                    "bbox": List(whole),
                    "pixels": whole,
                    "fraction": real,
                    "hazards": List(text),
                    "near_miss_of": List(text),
                }
            ),
            "home": text,
            "twin_of": text,
        }
    )


def anomaly_features() -> datasets.Features:
    """Columns of an anomaly."""
    from datasets import Features, Value

    return Features({"scene": Value("string"), "split": Value("string"), **_anomaly()})


def _anomaly() -> dict[str, Any]:
    from datasets import List, Value

    text, whole = Value("string"), Value("int32")
    return {
        **dict.fromkeys(("id", "hazard", "group", "label"), text),
        "object_id": whole,
        "category": text,
        "states": List(text),
        "relation": text,
        "target_id": whole,
        "target_category": text,
        "room_id": whole,
        "room_type": text,
        "report": Value("bool"),
        **dict.fromkeys(("notify", "reason", "urgency", "severity", "message"), text),
        "evidence": text,
        "remedy": text,
        "best_view": whole,
        "best_pixels": whole,
    }


def scene_features(mesh: bool) -> datasets.Features:
    """Columns of a scene, a GLB among them if ``mesh`` is set."""
    from datasets import Features, List, Value

    text, whole, real, yes = Value("string"), Value("int32"), Value("float64"), Value("bool")
    meshes: dict[str, Any] = {}
    if mesh:
        from datasets import Mesh

        meshes["mesh"] = Mesh()
    return Features(
        {
            "scene": text,
            "split": text,
            "index": whole,
            "twin_of": text,
            "home": text,
            "household": {
                "template": text,
                "members": List({"role": text, "age": whole}),
                "pets": List(text),
                "conditions": List(text),
                "notifications": List({"hazard": text, "notify": text}),
                "opt_outs": List(text),
            },
            "rooms": List({"id": whole, "name": text, "type": text, "polygon_m": List(List(real))}),
            "anomalies": List(_anomaly()),
            "lookalikes": List(
                {"object_id": whole, "category": text, "near_miss_of": text, "evidence": text}
            ),
            "objects": List(
                {
                    "object_id": whole,
                    **dict.fromkeys(("category", "superclass", "asset"), text),
                    "room_id": whole,
                    "room_type": text,
                    "states": List(text),
                    "fixed": yes,
                    **dict.fromkeys(("position_m", "quat_xyzw", "center_m", "size_m"), List(real)),
                    "hazards": List(text),
                    "near_miss_of": List(text),
                    "views": List(whole),
                    "best_pixels": whole,
                }
            ),
            "graph": text,
            "scene_json": text,
            **meshes,
        }
    )
