"""COLLADA files come in with their units, and without what leads nowhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.errors import AssetError
from sdgen.importing.mesh_files import read_mesh
from sdgen.importing.tree import References

FILE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset>{asset}</asset>
 <library_images><image id="picture"><init_from>{image}</init_from></image></library_images>
 <library_effects>
  <effect id="painted-fx"><profile_COMMON>
   <newparam sid="s"><surface type="2D"><init_from>picture</init_from></surface></newparam>
   <newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
   <technique sid="c"><lambert><diffuse><texture texture="t" texcoord="UV"/></diffuse></lambert>
   </technique></profile_COMMON></effect>
  <effect id="red-fx"><profile_COMMON><technique sid="c"><lambert><diffuse>
   <color>1 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect>
 </library_effects>
 <library_materials>
  <material id="painted"><instance_effect url="#painted-fx"/></material>
  <material id="red"><instance_effect url="#{effect}"/></material>
 </library_materials>
 <library_geometries>
  {geometries}
 </library_geometries>
 <library_visual_scenes><visual_scene id="v">
  <node><instance_geometry url="#a"><bind_material><technique_common>
   <instance_material symbol="m" target="#painted"/></technique_common></bind_material>
   </instance_geometry></node>
  <node><instance_geometry url="#b"><bind_material><technique_common>
   <instance_material symbol="m" target="#red"/></technique_common></bind_material>
   </instance_geometry></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#v"/></scene>
</COLLADA>"""
GEOMETRY = """<geometry id="{id}"><mesh>
   <source id="{id}-p">
    <float_array id="{id}-pa" count="9">0 0 {z} 100 0 {z} 0 200 {z}</float_array>
    <technique_common><accessor source="#{id}-pa" count="3" stride="3">
     <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
    </accessor></technique_common></source>
   <source id="{id}-u">
    <float_array id="{id}-ua" count="6">0 0 1 0 0 1</float_array>
    <technique_common><accessor source="#{id}-ua" count="3" stride="2">
     <param name="S" type="float"/><param name="T" type="float"/>
    </accessor></technique_common></source>
   <vertices id="{id}-v"><input semantic="POSITION" source="#{id}-p"/></vertices>
   <triangles count="1" material="m"><input semantic="VERTEX" source="#{id}-v" offset="0"/>
    <input semantic="TEXCOORD" source="#{id}-u" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles>
  </mesh></geometry>"""


def write(root: Path, asset: str = "", image: str = "p.png", effect: str = "red-fx") -> Path:
    geometries = GEOMETRY.format(id="a", z=0) + GEOMETRY.format(id="b", z=50)
    path = root / "thing.dae"
    path.write_text(FILE.format(asset=asset, image=image, effect=effect, geometries=geometries))
    Image.new("RGB", (8, 8), (0, 0, 255)).save(root / "p.png")
    return path


def test_units_and_axes(tmp_path: Path) -> None:
    path = write(tmp_path, '<unit name="inch" meter="0.0254"/><up_axis>Z_UP</up_axis>')
    pieces, up = read_mesh(path, References(tmp_path, tmp_path))
    assert up == "z"
    corners = np.concatenate([piece.vertices for piece in pieces])
    assert np.allclose(corners.max(axis=0), (2.54, 5.08, 1.27))
    assert sum(piece.paint.image is not None for piece in pieces) == 1


@pytest.mark.parametrize(
    ("image", "effect", "lost"),
    [("", "red-fx", "painted"), ("p.png", "nothing", "red"), ("", "nothing", "painted, red")],
)
def test_what_has_a_broken_material_stays(
    tmp_path: Path, image: str, effect: str, lost: str
) -> None:
    references = References(tmp_path, tmp_path)
    pieces, up = read_mesh(write(tmp_path, image=image, effect=effect), references)
    assert up == "y"
    assert len(pieces) == 2
    assert references.notes[0] == f"thing.dae: materials that lead nowhere, left out: {lost}"


@pytest.mark.parametrize("metres", ["0", "-1", "nan", "inf", "a foot"])
def test_a_unit_that_is_none_is_a_metre(tmp_path: Path, metres: str) -> None:
    path = write(tmp_path, f'<unit meter="{metres}"/>')
    pieces, _ = read_mesh(path, References(tmp_path, tmp_path))
    assert np.isclose(max(piece.vertices[:, 0].max() for piece in pieces), 100)


def test_no_entities_are_read(tmp_path: Path) -> None:
    path = tmp_path / "thing.dae"
    path.write_text('<!DOCTYPE x [<!ENTITY a "b">]><COLLADA>&a;</COLLADA>')
    with pytest.raises(AssetError, match=r"thing\.dae:1: declares entities"):
        read_mesh(path, References(tmp_path, tmp_path))
