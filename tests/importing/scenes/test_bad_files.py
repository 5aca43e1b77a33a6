"""Files that are broken or mean ill: a line that says what and where, never a traceback."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sdgen.errors import InputError, UsageError
from sdgen.importing.scenes.gltf import read_gltf
from sdgen.importing.scenes.mjcf import read_mjcf
from sdgen.importing.scenes.read import FORMATS
from sdgen.importing.scenes.virtualhome import read_virtualhome
from sdgen.library.gltf import glb_of

from tests.importing.scenes.homes import (
    CATALOG,
    NAMER,
    ROOMS,
    THINGS,
    imported,
    write_glb,
    write_mjcf,
)

HOME = '<worldbody><body name="floor_kitchen"><geom type="box" size="2 2 .1"/></body></worldbody>'


def refused(read: Any, path: Path) -> str:
    with pytest.raises(InputError) as caught:
        read(path, CATALOG, NAMER)
    return str(caught.value)


MJCF = {
    "not closed": ("<mujoco><worldbody>", "not valid XML"),
    "another root": ("<robot/>", "is no MJCF"),
    "entities": (
        '<!DOCTYPE mujoco [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><mujoco>&b;</mujoco>',
        "declares entities",
    ),
    "NaN": (
        '<mujoco><worldbody><body name="bed" pos="0 nan 0"><geom size="1"/></body></worldbody>'
        "</mujoco>",
        "body 'bed': pos: '0 nan 0' is not 3 finite numbers",
    ),
    "infinite size": (
        '<mujoco><worldbody><body name="bed"><geom type="box" size="1 1e400 1"/></body>'
        "</worldbody></mujoco>",
        "size: '1 1e400 1' is not finite numbers",
    ),
    "too few sizes": (
        '<mujoco><worldbody><body name="bed"><geom type="box" size="1"/></body></worldbody>'
        "</mujoco>",
        "size: a box needs 3 numbers",
    ),
    "no such class": (
        '<mujoco><worldbody><body name="bed"><geom class="soft" size="1"/></body></worldbody>'
        "</mujoco>",
        "there is no default class 'soft'",
    ),
    "zero quaternion": (
        '<mujoco><worldbody><body name="bed" quat="0 0 0 0"><geom size="1"/></body></worldbody>'
        "</mujoco>",
        "quat is zero",
    ),
    "climbing include": ('<mujoco><include file="../other.xml"/></mujoco>', "no such file in its"),
    "absolute include": ('<mujoco><include file="/etc/passwd"/></mujoco>', "no such file in its"),
    "missing include": ('<mujoco><include file="rooms.xml"/></mujoco>', "no such file"),
    "itself": ('<mujoco><include file="home.xml"/></mujoco>', "includes home.xml, which includes"),
    "missing mesh": (
        '<mujoco><asset><mesh name="m" file="m.obj"/></asset><worldbody><body name="bed">'
        '<geom type="mesh" mesh="m"/></body></worldbody></mujoco>',
        "m.obj': no such file in the scene's folder",
    ),
    "climbing mesh": (
        '<mujoco><asset><mesh name="m" file="../../m.obj"/></asset><worldbody><body name="bed">'
        '<geom type="mesh" mesh="m"/></body></worldbody></mujoco>',
        "m.obj': no such file in the scene's folder",
    ),
}


@pytest.mark.parametrize(("text", "told"), MJCF.values(), ids=MJCF)
def test_bad_mjcf(text: str, told: str, tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "other.xml").write_text("<mujoco/>")
    path = tmp_path / "in" / "home.xml"
    path.write_text(text)
    said = refused(read_mjcf, path)
    assert told in said
    assert str(path.parent) in said or "rooms.xml" in said


def test_a_ring_of_includes_ends(tmp_path: Path) -> None:
    (tmp_path / "home.xml").write_text('<mujoco><include file="a.xml"/></mujoco>')
    (tmp_path / "a.xml").write_text('<mujoco><include file="b.xml"/></mujoco>')
    (tmp_path / "b.xml").write_text('<mujoco><include file="a.xml"/></mujoco>')
    assert "includes a.xml, which includes it" in refused(read_mjcf, tmp_path / "home.xml")


def test_a_link_out_of_the_folder_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "secret.xml").write_text(f"<mujoco>{HOME}</mujoco>")
    (tmp_path / "in" / "part.xml").symlink_to(tmp_path / "secret.xml")
    (tmp_path / "in" / "home.xml").write_text('<mujoco><include file="part.xml"/></mujoco>')
    assert "part.xml': no such file" in refused(read_mjcf, tmp_path / "in" / "home.xml")


@pytest.mark.parametrize("tag", ["body", "frame"])
def test_files_within_files_are_not_nested_without_end(tag: str, tmp_path: Path) -> None:
    for k in range(12):
        inner = f'<include file="home{k + 1}.xml"/>' if k < 11 else ""
        text = f"<{tag}>" * 90 + inner + f"</{tag}>" * 90
        (tmp_path / f"home{k}.xml").write_text(f"<mujoco><worldbody>{text}</worldbody></mujoco>")
    assert "home2.xml: is nested too deeply" in refused(read_mjcf, tmp_path / "home0.xml")


def test_a_geom_out_of_any_home_is_told(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    geom = '<geom name="bed" type="box" size="1 1 1" pos="5000 0 0"/>'
    path.write_text(f"<mujoco><worldbody>{geom}</worldbody></mujoco>")
    (line,) = read_mjcf(path, CATALOG, NAMER).unresolved
    assert line.startswith("bed: it lies or reaches further than")


def test_all_that_is_wrong_is_told_at_once(tmp_path: Path) -> None:
    bodies = "".join(f'<body name="b{k}" pos="x 0 0"><geom size="1"/></body>' for k in range(5))
    (tmp_path / "home.xml").write_text(f"<mujoco><worldbody>{bodies}</worldbody></mujoco>")
    said = refused(read_mjcf, tmp_path / "home.xml")
    assert all(f"body 'b{k}'" in said for k in range(5))


def gltf(**changes: Any) -> dict[str, Any]:
    plain = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "bed", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [
            {"componentType": 5126, "type": "VEC3", "count": 3, "min": [0, 0, 0], "max": [2, 1, 2]}
        ],
    }
    return {**plain, **changes}


GLTF = {
    "no JSON": ("{", "is no glTF"),
    "a list": ("[]", "is no glTF"),
    "no asset": (json.dumps({"nodes": []}), "'asset' is missing"),
    "no such node": (gltf(scenes=[{"nodes": [4]}]), "scenes[0].nodes: there is no 4"),
    "no such mesh": (gltf(nodes=[{"name": "bed", "mesh": 3}]), "nodes[0].mesh: there is no 3"),
    "text for a number": (
        gltf(nodes=[{"name": "bed", "translation": ["a", 0, 0]}]),
        "nodes[0].translation[0]",
    ),
    "in itself": (
        gltf(nodes=[{"name": "a", "children": [0]}]),
        "nodes[0]: is a child of its own",
    ),
    "too deep": (
        gltf(nodes=[*({"children": [k]} for k in range(1, 300)), {"name": "bed"}]),
        "nodes[200]: is nested more than 200 deep",
    ),
    "a child twice": (
        gltf(nodes=[{"children": [2]}, {"children": [2]}, {"name": "bed"}]),
        "is a child twice",
    ),
    "no accessor": (gltf(accessors=[]), "attributes.POSITION: there is no 0"),
    "a floor without bytes": (gltf(nodes=[{"name": "floor", "mesh": 0}]), "sparse or compressed"),
}

#: What is changed in a floor's primitive and in the accessor of its corners.
FLOORS: dict[str, tuple[dict[str, Any], dict[str, Any], str]] = {
    "numbers in twos": ({}, {"type": "VEC2"}, "attributes.POSITION: not VEC3"),
    "corners by fractions": ({"indices": 0}, {}, "primitives[0].indices: not whole numbers from 0"),
    "corners that are none": ({"indices": 1}, {}, "primitives[0]: has triangles without corners"),
    "more than is there": ({}, {"count": 4}, "accessors[0]: reaches beyond its bufferView"),
    "no such type": ({}, {"componentType": 1}, "accessors[0].componentType: glTF has no 1"),
}


@pytest.mark.parametrize(("primitive", "accessor", "told"), FLOORS.values(), ids=FLOORS)
def test_a_floor_whose_triangles_are_none(
    primitive: dict[str, Any], accessor: dict[str, Any], told: str, tmp_path: Path
) -> None:
    assert told in refused(read_gltf, floor_of(primitive, accessor, tmp_path))


@pytest.mark.parametrize("mode", [0, 4, 5, 6, 9])
def test_too_few_corners_are_no_floor(mode: int, tmp_path: Path) -> None:
    path = floor_of({"mode": mode}, {"count": 1}, tmp_path)
    assert read_gltf(path, CATALOG, NAMER).floors == []


def floor_of(primitive: dict[str, Any], accessor: dict[str, Any], folder: Path) -> Path:
    positions = {"componentType": 5126, "type": "VEC3", "count": 3, "bufferView": 0, **accessor}
    document = gltf(
        nodes=[{"name": "floor", "mesh": 0}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}, **primitive}]}],
        accessors=[
            positions,
            {"componentType": 5123, "type": "SCALAR", "count": 3, "bufferView": 1},
        ],
        bufferViews=[
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteLength": 6, "byteOffset": 36},
        ],
        buffers=[{"byteLength": 42, "uri": "b.bin"}],
    )
    (folder / "b.bin").write_bytes(bytes(36) + b"\0\0\1\0\7\0")
    path = folder / "home.gltf"
    path.write_text(json.dumps(document))
    return path


@pytest.mark.parametrize(("document", "told"), GLTF.values(), ids=GLTF)
def test_bad_gltf(document: Any, told: str, tmp_path: Path) -> None:
    path = tmp_path / "home.gltf"
    path.write_text(document if isinstance(document, str) else json.dumps(document))
    said = refused(read_gltf, path)
    assert told in said
    assert said.startswith(str(path))


@pytest.mark.parametrize("uri", ["../b.bin", "/etc/passwd", "http://a/b.bin", "data:,%%%", "a\0b"])
def test_buffers_elsewhere_are_not_read(uri: str, tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "b.bin").write_bytes(bytes(36))
    view = {"buffer": 0, "byteLength": 36}
    accessor = {"componentType": 5126, "type": "VEC3", "count": 3, "bufferView": 0}
    document = gltf(
        nodes=[{"name": "floor", "mesh": 0}],
        accessors=[accessor],
        bufferViews=[view],
        buffers=[{"byteLength": 36, "uri": uri}],
    )
    path = tmp_path / "in" / "home.gltf"
    path.write_text(json.dumps(document))
    said = refused(read_gltf, path)
    assert "lies outside its folder" in said or "base64" in said


def test_a_glb_cut_short_anywhere_is_told(tmp_path: Path) -> None:
    raw = write_glb(tmp_path / "whole.glb", {**ROOMS, **THINGS}).read_bytes()
    for size in (0, 3, 11, 19, 21, len(raw) // 2, len(raw) - 5):
        path = tmp_path / "home.glb"
        path.write_bytes(raw[:size])
        assert str(path) in refused(read_gltf, path)


@settings(
    max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(changes=st.lists(st.tuples(st.integers(0, 10**6), st.integers(0, 255)), max_size=12))
def test_a_damaged_glb_is_read_or_refused(changes: list[tuple[int, int]], tmp_path: Path) -> None:
    raw = bytearray(GOOD or good_glb(tmp_path))
    for at, value in changes:
        raw[at % len(raw)] = value
    path = tmp_path / "damaged.glb"
    path.write_bytes(raw)
    with suppress(InputError):
        read_gltf(path, CATALOG, NAMER)


GOOD = bytearray()


def good_glb(folder: Path) -> bytes:
    GOOD[:] = write_glb(folder / "good.glb", {**ROOMS, **THINGS}).read_bytes()
    return bytes(GOOD)


GRAPHS = {
    "no JSON": ("nodes:", "is no JSON that can be read"),
    "a list": ("[1]", "expected a mapping"),
    "no nodes": ("{}", "missing key 'nodes'"),
    "text for an id": ('{"nodes": [{"id": "1", "class_name": "bed"}]}', "nodes[0].id"),
    "a number of hundreds of digits": (
        '{"nodes": [{"id": 1, "class_name": "bed", "bounding_box": {"center": [0, 1'
        + "0" * 400
        + ', 0], "size": [1, 1, 1]}}]}',
        "nodes[0].bounding_box.center[1]",
    ),
    "a short box": (
        '{"nodes": [{"id": 1, "class_name": "bed", "bounding_box": {"center": [0, 1], '
        '"size": [1, 1, 1]}}]}',
        "nodes[0].bounding_box.center",
    ),
    "NaN": (
        '{"nodes": [{"id": 1, "class_name": "bed", "bounding_box": {"center": [0, NaN, 0], '
        '"size": [1, 1, 1]}}]}',
        "nodes[0].bounding_box.center[1]",
    ),
}


@pytest.mark.parametrize(("text", "told"), GRAPHS.values(), ids=GRAPHS)
def test_bad_graphs(text: str, told: str, tmp_path: Path) -> None:
    path = tmp_path / "home.json"
    path.write_text(text)
    said = refused(read_virtualhome, path)
    assert told in said
    assert said.startswith(str(path))


@pytest.mark.parametrize("format_", FORMATS)
def test_an_empty_scene_has_no_room(format_: str, tmp_path: Path) -> None:
    texts = {
        "gltf": json.dumps({"asset": {"version": "2.0"}}),
        "mjcf": "<mujoco><worldbody/></mujoco>",
        "virtualhome": '{"nodes": [], "edges": []}',
        "replicacad": '{"object_instances": []}',
    }
    path = tmp_path / "home"
    path.write_text(texts[format_])
    with pytest.raises(InputError, match="no room was found"):
        imported(format_, path)


def test_a_format_that_nobody_knows() -> None:
    with pytest.raises(UsageError, match="did you mean 'gltf'"):
        imported("glft", Path("home.glb"))


def test_a_wrong_unit_is_told_not_built(tmp_path: Path) -> None:
    """Millimetres: a bed two kilometres long."""
    large = {
        name: ([v * 1000 for v in middle], [v * 1000 for v in sides])
        for name, (middle, sides) in THINGS.items()
    }
    path = write_glb(tmp_path / "home.glb", large)
    found = read_gltf(path, CATALOG, NAMER)
    assert len(found.unresolved) == len(THINGS)
    assert all("is its unit metres?" in line for line in found.unresolved)


def test_a_rotation_without_length_turns_nothing(tmp_path: Path) -> None:
    path = tmp_path / "home.gltf"
    nodes = [{"name": "bed", "mesh": 0, "rotation": [1e-300, 0, 0, 0]}]
    path.write_text(json.dumps(gltf(nodes=nodes)))
    (piece,) = read_gltf(path, CATALOG, NAMER).pieces
    assert piece.extents_m == (2.0, 2.0, 1.0)


@pytest.mark.filterwarnings("error")
def test_numbers_that_overflow_are_told_without_warnings(tmp_path: Path) -> None:
    path = tmp_path / "home.gltf"
    nodes = [
        {"name": "bed", "mesh": 0, "scale": [1e300, 1, 1], "translation": [1e308, 0, 0]},
        {"name": "room", "children": [0], "scale": [1e300, 1, 1]},
    ]
    path.write_text(json.dumps(gltf(nodes=nodes, scenes=[{"nodes": [1]}])))
    with pytest.raises(InputError, match="no room was found"):
        imported("gltf", path)


def test_rooms_and_walls_out_of_any_home_are_told(tmp_path: Path) -> None:
    far = {name: ((9e4, 0.0, 0.0), sides) for name, (_, sides) in ROOMS.items()}
    # As far out as no room may be, but for the half of a wall around it.
    edge = {"floor_hall": ((998.0, 0.0, 0.0), (3.99, 3.0, 0.1))}
    found = read_gltf(write_glb(tmp_path / "home.glb", far), CATALOG, NAMER)
    assert (found.walls, found.floors) == ([], [])
    assert all("is its unit metres?" in line for line in found.unresolved)
    assert len(found.unresolved) == len(far)
    for read in (write_glb(tmp_path / "edge.glb", edge), write_mjcf(tmp_path / "edge.xml", edge)):
        with pytest.raises(InputError, match="no room was found"):
            imported("gltf" if read.suffix == ".glb" else "mjcf", read)


def test_huge_counts_ask_for_no_memory(tmp_path: Path) -> None:
    accessor = {"componentType": 5126, "type": "VEC3", "count": 2**31, "bufferView": 0}
    document = gltf(
        nodes=[{"name": "floor", "mesh": 0}],
        accessors=[accessor],
        bufferViews=[{"buffer": 0, "byteLength": 36}],
        buffers=[{"byteLength": 36}],
    )
    path = tmp_path / "home.glb"
    path.write_bytes(glb_of(document, bytes(36)))
    assert "accessors[0]: reaches beyond its bufferView" in refused(read_gltf, path)
