"""Croissant metadata of a folder of Parquet files (:mod:`sdgen.export.huggingface`).

A record set a table: ``views`` with their pictures, ``scenes``, ``anomalies``, and those of twins.
Croissant 1.0 of MLCommons, https://docs.mlcommons.org/croissant/docs/croissant-spec.html
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sdgen.dataset import Dataset

#: What a licence is called elsewhere.
LICENCES = {"CC-BY-4.0": "https://creativecommons.org/licenses/by/4.0/"}
#: The names of Croissant 1.0, as its specification lists them.
_CONTEXT: Mapping[str, Any] = {
    "@language": "en",
    "@vocab": "https://schema.org/",
    **{
        name: f"cr:{name}"
        for name in (
            *("citeAs", "column", "equivalentProperty", "extract", "field", "fileObject"),
            *("fileProperty", "fileSet", "format", "includes", "isLiveDataset", "jsonPath", "key"),
            *("md5", "parentField", "path", "recordSet", "references", "regex", "repeated"),
            *("replace", "samplingRate", "separator", "source", "subField", "transform"),
        )
    },
    "conformsTo": "dct:conformsTo",
    "cr": "http://mlcommons.org/croissant/",
    "data": {"@id": "cr:data", "@type": "@json"},
    "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "dct": "http://purl.org/dc/terms/",
    "examples": {"@id": "cr:examples", "@type": "@json"},
    "rai": "http://mlcommons.org/croissant/RAI/",
    "sc": "https://schema.org/",
}
_CITE = "@software{sdgen, title = {sdgen: procedural, certified homes with household hazards}}"
#: Columns of a table that are one value each, in Croissant's words.
_PLAIN: Mapping[str, Mapping[str, str]] = {
    "views": {
        **dict.fromkeys(("scene", "split"), "sc:Text"),
        "view": "sc:Integer",
        **dict.fromkeys(("kind", "room_type", "home", "twin_of"), "sc:Text"),
        **dict.fromkeys(("room_id", "width", "height"), "sc:Integer"),
    },
    "scenes": {
        **dict.fromkeys(("scene", "split", "home", "twin_of", "graph", "scene_json"), "sc:Text"),
        "index": "sc:Integer",
    },
    "anomalies": {
        **dict.fromkeys(("scene", "split", "id", "hazard", "group", "label"), "sc:Text"),
        "object_id": "sc:Integer",
        **dict.fromkeys(("category", "relation", "target_category", "room_type"), "sc:Text"),
        "report": "sc:Boolean",
        **dict.fromkeys(("notify", "reason", "urgency", "message", "evidence"), "sc:Text"),
        "best_pixels": "sc:Integer",
    },
}
_PICTURES = ("image", "depth", "instance", "part")


def croissant(data: Dataset, tables: Mapping[str, Iterable[str]]) -> dict[str, Any]:
    """The metadata of a data set, as JSON-LD; ``tables`` has the columns of each table, whose
    files are ``NAME/*.parquet``."""
    info, counts = data.info, data.info.counts
    files = [
        {
            "@type": "cr:FileSet",
            "@id": f"{name}-files",
            "name": f"{name}-files",
            "encodingFormat": "application/x-parquet",
            "includes": f"{name}/*.parquet",
        }
        for name in tables
    ]
    return {
        "@context": _CONTEXT,
        "@type": "sc:Dataset",
        "conformsTo": "http://mlcommons.org/croissant/1.0",
        "name": f"sdgen-n{info.n}-s{info.seed}",
        "description": (
            f"{counts.scenes} furnished homes with {counts.anomalies} household hazards of "
            f"{len(info.hazards_enabled)} kinds: pictures, graphs, proved labels, households. "
            "Synthetic; no person, address or photograph is in it."
        ),
        "version": _version(info.versions["sdgen"]),
        "license": LICENCES.get(info.licence, info.licence),
        "citeAs": _CITE,
        "distribution": files,
        "recordSet": [_record_set(name, set(columns)) for name, columns in tables.items()],
    }


def _version(text: str) -> str:
    """A version of sdgen as three numbers, which Croissant asks for."""
    numbers = [part for part in text.split(".") if part.isdigit()]
    return ".".join([*numbers, "0", "0", "0"][:3])


def _record_set(name: str, columns: set[str]) -> dict[str, Any]:
    known = _PLAIN[name.rsplit("_", 1)[-1]]
    fields = [_field(name, key, kind) for key, kind in known.items() if key in columns]
    for picture in _PICTURES:
        if picture in columns:
            # A column of pictures is a structure of bytes and path.
            fields.append(_field(name, picture, "sc:ImageObject", {"jsonPath": "bytes"}))
    return {
        "@type": "cr:RecordSet",
        "@id": name,
        "name": name,
        "description": f"the table {name}",
        "field": fields,
    }


def _field(of: str, name: str, kind: str, take: Mapping[str, str] | None = None) -> dict[str, Any]:
    source: dict[str, Any] = {"fileSet": {"@id": f"{of}-files"}, "extract": {"column": name}}
    if take:
        source["transform"] = take
    return {
        "@type": "cr:Field",
        "@id": f"{of}/{name}",
        "name": name,
        "dataType": kind,
        "source": source,
    }
