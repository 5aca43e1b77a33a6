"""What a GLB says of itself: refused before anybody makes room for it."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from sdgen.errors import AssetError
from sdgen.library.glb import MAX_CORNERS, MAX_JSON, MAX_VERTICES, glb_document
from sdgen.library.meshes import read_glb

from tests.shipped import shipped_library

#: Vertices of the one mesh, and triangles of it.
COUNT = 3000
BLOB = b"\0" * (12 * COUNT)

Document = dict[str, Any]


def glb(document: Document, blob: bytes = BLOB) -> bytes:
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    head = b"glTF" + (2).to_bytes(4, "little") + (28 + len(text) + len(blob)).to_bytes(4, "little")
    lead = len(text).to_bytes(4, "little") + b"JSON"
    return head + lead + text + len(blob).to_bytes(4, "little") + b"BIN\0" + blob


def one_mesh() -> Document:
    """A node that shows a mesh; positions and indices are the same bytes."""
    primitive = {"attributes": {"POSITION": 0}, "indices": 1}
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": COUNT, "type": "VEC3"},
            {"bufferView": 0, "componentType": 5125, "count": 3 * COUNT, "type": "SCALAR"},
        ],
        "bufferViews": [{"buffer": 0, "byteLength": len(BLOB)}],
        "buffers": [{"byteLength": len(BLOB)}],
    }


def _nodes(document: Document) -> None:
    document["nodes"] *= MAX_VERTICES // COUNT + 1


def _primitives(document: Document) -> None:
    document["nodes"] = [{}]
    document["meshes"][0]["primitives"] *= MAX_VERTICES // COUNT + 1


def _corners(document: Document) -> None:
    document["accessors"][0]["count"] = 3
    document["nodes"] *= MAX_CORNERS // (3 * COUNT) + 1


def _strips(document: Document) -> None:
    document["meshes"][0]["primitives"][0]["mode"] = 5
    document["accessors"][0]["count"] = 3
    document["nodes"] *= MAX_CORNERS // (9 * COUNT) + 1


def _accessors(document: Document) -> None:
    document["accessors"] += [document["accessors"][0]] * 6000


def _views(document: Document) -> None:
    document["bufferViews"] *= 6000


def _json(document: Document) -> None:
    document["extras"] = "x" * MAX_JSON


def _short(document: Document) -> None:
    document["buffers"][0]["byteLength"] += 4


def _buffers(document: Document) -> None:
    document["buffers"] *= 2


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (_nodes, "^303000 vertices, at most 300000"),
        (_primitives, "^303000 vertices, at most 300000"),
        (_corners, "^1809000 corners of triangles, at most 1800000"),
        (_strips, "^1809000 corners of triangles, at most 1800000"),
        (_accessors, "^accessors: 216072000 bytes together, at most 200000000"),
        (_views, "^bufferViews: 216000000 bytes together, at most 200000000"),
        (_json, "^its JSON chunk has 2[0-9]* bytes, at most 2000000"),
        (_short, r"^buffers\[0\]: 36000 of 36004 bytes are there"),
        (_buffers, r"^buffers\[1\]: a GLB has one"),
    ],
)
def test_small_files_may_not_ask_for_any_amount(
    tmp_path: Path, change: Callable[[Document], None], words: str
) -> None:
    document = one_mesh()
    assert glb_document(glb(document)) == document
    change(document)
    with pytest.raises(ValueError, match=words):
        glb_document(glb(document))
    (tmp_path / "mug.glb").write_bytes(glb(document))
    with pytest.raises(AssetError, match=r"mug\.glb: mesh of mug_01 cannot be read: "):
        read_glb(tmp_path / "mug.glb", shipped_library().assets["mug_01"])


def test_a_cut_off_binary_chunk_is_told() -> None:
    raw = glb(one_mesh())
    size = (len(raw) - 4).to_bytes(4, "little")
    with pytest.raises(ValueError, match="its binary chunk is cut off"):
        glb_document(raw[:8] + size + raw[12:-4])


def test_a_matrix_of_too_few_numbers_is_told() -> None:
    document = one_mesh()
    document["nodes"][0]["translation"] = [1.0]
    with pytest.raises(ValueError, match="at least 3 items"):
        glb_document(glb(document))
