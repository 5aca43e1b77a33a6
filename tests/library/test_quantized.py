"""GLBs with small vertices read like plain ones."""

import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.errors import AssetError
from sdgen.library.glb import glb_document
from sdgen.library.meshes import read_glb
from sdgen.library.quantized import plain_glb

from tests.shipped import shipped_library

ROOT = Path(__file__).resolve().parent.parent.parent


def small_glb(
    component: int, width: int, stride: int, blob: bytes, count: int, extras: str = ""
) -> bytes:
    """A GLB that holds one normalized accessor, after whatever else somebody wrote."""
    kind = {2: "VEC2", 3: "VEC3"}[width]
    document = {
        "asset": {"version": "2.0"},
        "extras": extras,
        "accessors": [
            {
                "bufferView": 0,
                "componentType": component,
                "count": count,
                "type": kind,
                "normalized": True,
            }
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(blob), "byteStride": stride}
        ],
        "buffers": [{"byteLength": len(blob)}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = blob + b"\0" * (-len(blob) % 4)
    head = b"glTF" + (2).to_bytes(4, "little") + (28 + len(text) + len(body)).to_bytes(4, "little")
    lead = len(text).to_bytes(4, "little") + b"JSON"
    return head + lead + text + len(body).to_bytes(4, "little") + b"BIN\0" + body


def floats(raw: bytes) -> np.ndarray:
    length = int.from_bytes(raw[12:16], "little")
    document, body = json.loads(raw[20 : 20 + length]), raw[28 + length :]
    (accessor,) = document["accessors"]
    assert accessor["componentType"] == 5126
    assert "normalized" not in accessor
    view = document["bufferViews"][accessor["bufferView"]]
    data = body[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    return np.frombuffer(data, "<f4").reshape(accessor["count"], -1)


def plain(raw: bytes) -> bytes:
    return plain_glb(raw, glb_document(raw))


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(*[st.integers(0, 65535)] * 2), min_size=1, max_size=20))
def test_texture_coordinates_come_back_as_fractions(rows: list[tuple[int, int]]) -> None:
    values = np.array(rows, "<u2")
    found = floats(plain(small_glb(5123, 2, 4, values.tobytes(), len(rows))))
    assert found == pytest.approx(values / 65535, abs=1e-6)


def test_normals_with_a_stride_come_back() -> None:
    values = np.array([(127, 0, 0, 9), (0, -128, 0, 9), (0, 90, 90, 9)], "i1")
    found = floats(plain(small_glb(5120, 3, 4, values.tobytes(), 3)))
    assert found == pytest.approx(np.array([(1, 0, 0), (0, -1, 0), (0, 0.709, 0.709)]), abs=1e-3)


def test_anything_else_is_left_alone() -> None:
    box = trimesh.creation.box().export(file_type="glb")
    assert plain(box) is box


def test_small_numbers_are_seen_wherever_the_file_names_them() -> None:
    raw = small_glb(5123, 2, 4, b"\0" * 8, 2, extras="x" * 300_000)
    assert raw.index(b"normalized") > 200_000
    assert floats(plain(raw)).tolist() == [[0.0, 0.0], [0.0, 0.0]]


@pytest.mark.parametrize(("count", "stride"), [(3, 4), (0, 4), (2, 1)])
def test_accessors_beyond_their_buffer_are_refused(count: int, stride: int) -> None:
    with pytest.raises(ValueError, match="accessor"):
        glb_document(small_glb(5123, 2, stride, b"\0" * 8, count))


def test_a_lying_file_is_a_located_error(tmp_path: Path) -> None:
    asset = shipped_library().assets["mug_01"]
    path = tmp_path / "mug.glb"
    path.write_bytes(small_glb(5123, 2, 4, b"\0" * 8, 10**6))
    with pytest.raises(AssetError, match=r"mug.glb: mesh of mug_01 cannot be read"):
        read_glb(path, asset)


def test_compact_meshes_are_the_meshes(tmp_path: Path) -> None:
    path = ROOT / "assets" / "blender" / "compact.py"
    spec = importlib.util.spec_from_file_location("compact", path)
    assert spec is not None
    assert spec.loader is not None
    compact = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(compact)
    ball = trimesh.creation.icosphere(2, radius=0.7)
    uv = np.random.default_rng(3).random((len(ball.vertices), 2)).astype(np.float32)
    normals = np.asarray(ball.vertex_normals, np.float32)
    corners = np.asarray(ball.vertices, np.float32) + np.float32(0.2)
    index = np.asarray(ball.faces, "<u2").ravel()
    chunks = [corners.tobytes(), normals.tobytes(), uv.tobytes(), index.tobytes()]
    offsets = np.cumsum([0, *map(len, chunks)]).tolist()
    kinds = [("VEC3", 5126), ("VEC3", 5126), ("VEC2", 5126), ("SCALAR", 5123)]
    lengths = [len(corners), len(normals), len(uv), len(index)]
    attributes = {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}
    primitive = {"attributes": attributes, "indices": 3, "material": 0}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "body", "mesh": 0}],
        "meshes": [{"name": "body", "primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"roughnessFactor": 0.8}}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": len(chunk)}
            for start, chunk in zip(offsets, chunks, strict=False)
        ],
        "accessors": [
            {"bufferView": k, "componentType": component, "count": length, "type": kind}
            for k, ((kind, component), length) in enumerate(zip(kinds, lengths, strict=True))
        ],
        "buffers": [{"byteLength": offsets[-1]}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = b"".join(chunks)
    body += b"\0" * (-len(body) % 4)
    head = b"glTF" + (2).to_bytes(4, "little") + (28 + len(text) + len(body)).to_bytes(4, "little")
    raw = head + len(text).to_bytes(4, "little") + b"JSON" + text
    raw += len(body).to_bytes(4, "little") + b"BIN\0" + body
    small = compact.compact(raw)
    assert len(small) < 0.75 * len(raw)
    scene = trimesh.load_scene(
        trimesh.util.wrap_as_stream(plain(small)), file_type="glb", process=False
    )
    (mesh,) = scene.dump()
    found = mesh.vertices[mesh.faces]
    assert found == pytest.approx(corners[np.asarray(ball.faces)], abs=2e-5)
    read_uv = np.asarray(mesh.visual.uv)[mesh.faces]
    assert read_uv == pytest.approx(uv[np.asarray(ball.faces)] * [1, -1] + [0, 1], abs=2e-5)
