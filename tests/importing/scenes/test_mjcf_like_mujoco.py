"""Our reader has every body where MuJoCo has it: angles, frames, defaults, includes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sdgen.errors import InputError
from sdgen.geometry import rotation_matrix
from sdgen.importing.scenes.found import FoundPiece
from sdgen.importing.scenes.mjcf import read_mjcf

from tests.importing.scenes.homes import CATALOG, NAMER

mujoco = pytest.importorskip("mujoco", reason="no MuJoCo here (pip install mujoco)")

number = st.floats(-3, 3).map(lambda value: round(value, 3))
three = st.tuples(number, number, number)
nonzero = three.filter(lambda v: np.linalg.norm(v) > 0.1)


def text(values: Any) -> str:
    return " ".join(f"{value:g}" for value in values)


turns = st.one_of(
    st.tuples(number, number, number, number)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: f'quat="{text(q)}"'),
    st.tuples(nonzero, number).map(lambda a: f'axisangle="{text((*a[0], a[1] * 40))}"'),
    three.map(lambda e: f'euler="{text(np.multiply(e, 50))}"'),
    nonzero.map(lambda z: f'zaxis="{text(z)}"'),
    st.tuples(nonzero, nonzero)
    .filter(lambda p: np.linalg.norm(np.cross(*p)) > 0.1)
    .map(lambda p: f'xyaxes="{text((*p[0], *p[1]))}"'),
    st.just(""),
)
places = st.tuples(three, turns).map(lambda p: f'pos="{text(p[0])}" {p[1]}')
orders = st.sampled_from(["xyz", "zyx", "XYZ", "ZXY", "xyx", "ZyX"])


def posed(path: Path) -> tuple[Any, Any]:
    """A file as MuJoCo reads it: the model, and where all is."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def corners(piece: FoundPiece) -> Any:
    turn = rotation_matrix(piece.quat_xyzw)
    half = np.array(piece.extents_m) / 2
    middle = np.add(piece.position_m, (0, 0, half[2]))
    return middle, np.abs(turn) @ half


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(order=orders, outer=places, inner=places, geom=places)
def test_a_box_lies_where_mujoco_has_it(
    order: str, outer: str, inner: str, geom: str, tmp_path: Path
) -> None:
    path = tmp_path / "home.xml"
    path.write_text(
        f'<mujoco><compiler eulerseq="{order}"/><worldbody><frame {outer}>'
        f'<body name="bed" {inner}><geom type="box" size=".3 .2 .1" {geom}/></body>'
        "</frame></worldbody></mujoco>"
    )
    _, data = posed(path)
    (piece,) = read_mjcf(path, CATALOG, NAMER).pieces
    middle, reach = corners(piece)
    assert np.allclose(middle, data.geom_xpos[0], atol=1e-4)
    # The box of a piece that lies aslant is one along the world's axes; a lean of a few degrees is
    # none: it moves no axis by more than the chord of that angle, so no reach by more than this.
    half = np.array((0.3, 0.2, 0.1))
    own = np.abs(data.geom_xmat[0].reshape(3, 3)) @ half
    lean = 2 * np.sin(np.radians(8.2) / 2) * np.linalg.norm(half)
    assert (reach >= own - lean).all()


def test_includes_defaults_and_meshes(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "tetra.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    )
    (tmp_path / "bed.xml").write_text(
        '<mujocoinclude><body name="bed" pos="1 2 0" childclass="half">'
        '<geom mesh="tetra" type="mesh"/><joint type="slide" axis="1 0 0"/></body></mujocoinclude>'
    )
    (tmp_path / "home.xml").write_text(
        '<mujoco><compiler angle="radian" meshdir="parts"/>'
        '<default><default class="half"><geom euler="0 0 1.5707963"/></default></default>'
        '<asset><mesh name="tetra" file="tetra.obj" scale=".5 .5 .5"/></asset>'
        '<worldbody><include file="bed.xml"/></worldbody></mujoco>'
    )
    (piece,) = read_mjcf(tmp_path / "home.xml", CATALOG, NAMER).pieces
    # Half as large, then turned by a quarter: 0.5 by 1 by 0.5, from (0, 0, 0) towards -x and +y.
    middle, reach = corners(piece)
    assert np.allclose(reach, (0.5, 0.25, 0.25), atol=1e-6)
    assert np.allclose(middle, (0.5, 2.25, 0.25), atol=1e-6)
    assert piece.loose is None


def test_a_free_thing_is_loose_and_what_is_not_seen_is_no_thing(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    path.write_text(
        "<mujoco><worldbody>"
        '<body name="apple" pos="0 0 1"><freejoint/><geom size=".04"/></body>'
        '<body name="region"><geom type="box" size="1 1 1" rgba="1 0 0 0"/></body>'
        '<geom name="floor" type="plane" size="5 5 .1"/></worldbody></mujoco>'
    )
    found = read_mjcf(path, CATALOG, NAMER)
    assert [(piece.name, piece.loose) for piece in found.pieces] == [("apple", True)]


#: What a class says, what an element says: which of two rotations counts, where copies begin.
OVER = [
    ('<geom euler="0 0 90"/>', '<geom {} quat="1 0 0 0"/>'),
    ('<geom quat="1 0 0 0"/>', '<geom {} euler="0 0 90"/>'),
    ('<geom axisangle="1 0 0 90"/>', '<geom {} zaxis="1 1 0"/>'),
    ("", '<replicate count="2" offset="3 0 0" euler="0 0 90"><geom {}/></replicate>'),
]


@pytest.mark.parametrize(("usual", "own"), OVER)
def test_rotations_of_classes_and_copies(usual: str, own: str, tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    geom = own.format('type="box" size=".3 .2 .1"')
    path.write_text(
        f"<mujoco><default>{usual}</default><worldbody>"
        f'<body name="bed">{geom}</body></worldbody></mujoco>'
    )
    _, data = posed(path)
    (piece,) = read_mjcf(path, CATALOG, NAMER).pieces
    middle, reach = corners(piece)
    assert np.allclose(middle, data.geom_xpos[0], atol=1e-4)
    own_reach = np.abs(data.geom_xmat[0].reshape(3, 3)) @ (0.3, 0.2, 0.1)
    assert np.allclose(reach, own_reach, atol=1e-4)


@pytest.mark.parametrize("file", [False, True])
def test_meshes_with_a_frame_of_reference(tmp_path: Path, file: bool) -> None:
    vertices = [(0, 0, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0), (0, 0, 0.5), (1, 2, 0.5)]
    frame = 'scale="2 1 1" refpos=".4 .2 .1" refquat=".7071068 0 0 .7071068"'
    inline = f'vertex="{" ".join(text(v) for v in vertices)}"'
    (tmp_path / "m.obj").write_text(
        "".join(f"v {text(v)}\n" for v in vertices)
        + "f 1 3 2\nf 1 4 3\nf 1 2 5\nf 2 6 5\nf 2 3 6\nf 3 4 6\nf 4 5 6\nf 4 1 5\n"
    )
    source = 'file="m.obj"' if file else inline
    path = tmp_path / "home.xml"
    path.write_text(
        f'<mujoco><asset><mesh name="m" {source} {frame}/></asset><worldbody>'
        '<body name="bed" pos="1 1 0"><geom type="mesh" mesh="m"/></body></worldbody></mujoco>'
    )
    model, data = posed(path)
    theirs = model.mesh_vert @ data.geom_xmat[0].reshape(3, 3).T + data.geom_xpos[0]
    (piece,) = read_mjcf(path, CATALOG, NAMER).pieces
    middle, reach = corners(piece)
    assert np.allclose(middle - reach, theirs.min(axis=0), atol=1e-4)
    assert np.allclose(middle + reach, theirs.max(axis=0), atol=1e-4)


def test_what_is_only_there_to_collide_has_no_part_in_a_size(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    path.write_text(
        '<mujoco><worldbody><body name="bed"><geom type="box" size=".9 1 .2" group="2"/>'
        '<geom type="box" size="3 3 3" group="3"/></body></worldbody></mujoco>'
    )
    (piece,) = read_mjcf(path, CATALOG, NAMER).pieces
    assert np.allclose(piece.extents_m, (1.8, 2.0, 0.4))


def test_nothing_is_dropped_without_a_word(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    path.write_text(
        '<mujoco><worldbody><geom type="box" size="1 1 1"/><geom type="box" size="1 1 2"/>'
        '<body name="bed"><geom type="box" size="1 1 .2"/></body></worldbody></mujoco>'
    )
    told = read_mjcf(path, CATALOG, NAMER).unresolved
    assert told == ["geoms of the world without a name: nobody can tell what they are"]
    path.write_text(
        '<mujoco><worldbody><body name="bed"><geom type="mesh" mesh="gone"/></body>'
        "</worldbody></mujoco>"
    )
    with pytest.raises(InputError, match="mesh 'gone': no such mesh in <asset>"):
        read_mjcf(path, CATALOG, NAMER)
