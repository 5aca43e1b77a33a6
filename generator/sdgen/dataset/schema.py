"""JSON Schema of every file of a data set, from the records that write and read them.

``python -m sdgen.dataset.schema [FOLDER]`` writes them (``output/schema`` of a checkout by
default); a test keeps the committed ones equal to the records.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import BaseModel

from sdgen.catalog.records import Catalog
from sdgen.dataset.records import DatasetInfo, ManifestEntry, Prediction
from sdgen.library.records import AssetInfo
from sdgen.resources import data_path
from sdgen.scene import (
    FORMAT_VERSION,
    Anomalies,
    Camera,
    Graph,
    Household,
    Panorama,
    PhysicsReport,
    Scene,
    Visibility,
)
from sdgen.truth.observable import Observability

#: Schema name -> (record, the file it describes). Of ``.jsonl`` files it describes a line.
FILES: Mapping[str, tuple[type[BaseModel], str]] = {
    "dataset": (DatasetInfo, "dataset.json"),
    "catalogue": (Catalog, "catalogue.json"),
    "asset": (AssetInfo, "a line of assets.jsonl"),
    "manifest": (ManifestEntry, "a line of manifest.jsonl"),
    "scene": (Scene, "scene.json"),
    "graph": (Graph, "graph.json"),
    "anomalies": (Anomalies, "anomalies.json"),
    "household": (Household, "household.json"),
    "visibility": (Visibility, "visibility.json"),
    "observability": (Observability, "observability.json"),
    "physics": (PhysicsReport, "physics.json"),
    "view": (Camera, "views/NN/view.json"),
    "panorama": (Panorama, "panoramas/NN/panorama.json"),
    "prediction": (Prediction, "a line of predictions.jsonl"),
}


def schema_of(name: str) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of one file.

    What a build writes has every key; of a prediction, which people write, only those without a
    default are required.
    """
    model, file = FILES[name]
    schema = model.model_json_schema()
    if name != "prediction":
        _require_all(schema)
    head = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"sdgen {FORMAT_VERSION}: {file}",
    }
    return {**head, **{key: value for key, value in schema.items() if key != "title"}}


def _require_all(schema: Any) -> None:
    if isinstance(schema, dict):
        if isinstance(schema.get("properties"), dict) and schema.get("type") == "object":
            schema["required"] = list(schema["properties"])
        for value in schema.values():
            _require_all(value)
    elif isinstance(schema, list):
        for value in schema:
            _require_all(value)


def schema_text(name: str) -> str:
    """The schema as the text of its file."""
    return json.dumps(schema_of(name), indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def write_schemas(folder: Path) -> None:
    """Write ``NAME.schema.json`` of every file, and take away those of files that are gone."""
    folder.mkdir(parents=True, exist_ok=True)
    for stale in folder.glob("*.schema.json"):
        if stale.name.removesuffix(".schema.json") not in FILES:
            stale.unlink()
    for name in FILES:
        path = folder / f"{name}.schema.json"
        path.write_bytes(schema_text(name).encode("utf-8"))


if __name__ == "__main__":
    write_schemas(Path(sys.argv[1]) if len(sys.argv) > 1 else data_path("schema"))
