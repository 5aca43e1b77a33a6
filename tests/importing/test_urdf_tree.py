"""Links of a URDF: where they are, and files that are broken or mean ill."""

from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import fromstring

import numpy as np
import pytest
from sdgen.errors import InputError
from sdgen.importing.scenes.mesh_bounds import Bounds
from sdgen.importing.scenes.urdf_box import urdf_box
from sdgen.importing.urdf_tree import urdf_tree


def joint(parent: str, child: str, origin: str = "") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{child}_joint" type="revolute">{ends}<origin {origin}/></joint>'


def link(name: str, mesh: str = "") -> str:
    shape = f'<visual><geometry><mesh filename="m.glb" {mesh}/></geometry></visual>'
    return f'<link name="{name}">{shape}</link>'


def robot(*parts: str) -> str:
    return f'<robot name="r">{"".join(parts)}</robot>'


def test_links_hang_on_links() -> None:
    # Habitat's right angles are a little less, and meant as such.
    turned = joint("a", "b", 'xyz="1 0 0" rpy="0 0 1.565"')
    tree = urdf_tree(fromstring(robot(turned, joint("b", "c", 'xyz="2 0 0"'))))
    assert [one.get("name") for one in tree.chain("c")] == ["b_joint", "c_joint"]
    assert np.allclose(tree.placed("c")[:3, 3], (1, 2, 0), atol=1e-12)
    assert np.array_equal(tree.placed("a"), np.eye(4))


BAD = {
    "another root": ("<mujoco/>", "is no URDF: its root is <mujoco>"),
    "in itself": (robot(link("a"), joint("a", "a")), "links go round in a circle"),
    "a ring": (robot(link("a"), joint("b", "a"), joint("a", "b")), "links go round in a circle"),
    "words": (robot(link("a"), joint("w", "a", 'xyz="x 0 0"')), "xyz: 'x 0 0' is not 3 finite"),
    "NaN": (robot(link("a", 'scale="1 nan 1"')), "mesh scale: '1 nan 1' is not 3 finite numbers"),
    "nothing": (robot(), "has no mesh that can be read"),
}


@pytest.mark.parametrize(("text", "told"), BAD.values(), ids=BAD)
def test_a_broken_urdf_is_told(text: str, told: str, tmp_path: Path) -> None:
    path = tmp_path / "fridge.urdf"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        urdf_box(path, unit)
    assert str(caught.value).startswith(f"{path}: ")
    assert told in str(caught.value)


def unit(folder: Path, name: str) -> Bounds:
    assert name == "m.glb"
    return np.zeros(3), np.ones(3)
