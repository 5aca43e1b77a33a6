"""Articulated furniture of ReplicaCAD stands as its scenes have it, its shelves where they say."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from sdgen.errors import AssetError
from sdgen.importing.habitat import read_articulated
from sdgen.importing.tree import References

#: A chest lying on its back, 2.5 times too large: deep 1, wide 2.5 (Y), high 3 (Z) as it lies.
CHEST = """<robot name="chest"><link name="root"/>
  <joint name="turn" type="fixed"><parent link="root"/><child link="body"/>
    <origin rpy="1.5707963 0 0"/></joint>
  <link name="body"><visual><origin xyz="0 1.5 0"/><geometry><box size="1 3 2.5"/></geometry>
    </visual></link>
  <joint name="slide" type="prismatic"><parent link="body"/><child link="drawer"/>
    <origin xyz="0 1 0"/><axis xyz="1 0 0"/><limit lower="0" upper="0.5"/></joint>
  <link name="drawer"><visual><geometry><box size="0.9 0.5 2.4"/></geometry></visual></link>
</robot>"""
BOXES = {
    "receptacle_aabb_top": {"parent_link": "body", "position": [0, 3.2, 0], "scale": [0.5, 0.2, 1]},
    "receptacle_aabb_in": {"parent_link": "drawer", "position": [0, 0, 0], "scale": [1, -1, 1]},
}


def chest(root: Path, *instances: dict[str, object]) -> tuple[Path, References]:
    path = root / "urdf" / "chest" / "chest.urdf"
    path.parent.mkdir(parents=True)
    path.write_text(CHEST)
    (path.parent / "chest.ao_config.json").write_text(json.dumps({"user_defined": BOXES}))
    scenes = root / "configs" / "scenes"
    scenes.mkdir(parents=True)
    for number, instance in enumerate(instances):
        given = {"articulated_object_instances": [{"template_name": "chest"} | instance]}
        (scenes / f"s{number}.scene_instance.json").write_text(json.dumps(given))
    return path, References(root, path.parent)


def test_most_scenes_say_how_large_it_is_and_what_is_up(tmp_path: Path) -> None:
    # Both on their feet; the second turned by 137 degrees as well, which says nothing of the model.
    half = np.sqrt(0.5)
    turned = {"rotation": [0.2591, -0.2591, 0.6579, 0.6579], "uniform_scale": 0.4}
    upright = {"rotation": [-half, half, 0, 0], "uniform_scale": 0.4}
    other = {"rotation": [1, 0, 0, 0], "uniform_scale": 3}
    path, references = chest(tmp_path, other, upright, turned)
    scan = read_articulated(path, references)
    assert scan.up == "y"
    assert np.allclose(scan.extents_m, (0.4, 1.2, 1.0), atol=1e-3)
    # The box of the body lies on top, in the model's frame; what moves has none.
    (box,) = scan.receptacles
    top = scan.triangles[:, :, 1].max()
    assert np.allclose(box.center_m[1] - box.size_m[1] / 2, top, atol=1e-3)
    assert np.allclose(box.size_m, (0.4, 0.16, 0.8), atol=1e-3)
    assert references.notes == ["receptacle box in 'drawer': not used, for that moves"]
    (joint,) = scan.joints
    assert np.isclose(joint.upper, 0.2)


def test_no_scene_no_change_and_broken_scenes_say_nothing(tmp_path: Path) -> None:
    path, references = chest(
        tmp_path, {"rotation": [0, 0, 0, 0]}, {"uniform_scale": "x"}, {"rotation": 7}
    )
    (tmp_path / "configs" / "scenes" / "t.scene_instance.json").write_text("[[[")
    assert np.allclose(read_articulated(path, references).extents_m, (1, 2.5, 3), atol=1e-3)


def test_upside_down_is_turned_over(tmp_path: Path) -> None:
    path, references = chest(tmp_path, {"rotation": [0, 1, 0, 0]})
    (box,) = read_articulated(path, references).receptacles
    assert np.allclose(box.size_m, (1, 2, 0.4), atol=1e-3)
    assert box.center_m[2] < 0


@pytest.mark.parametrize("position", [None, [1, 2], ["a", 0, 0], [1e999, 0, 0], {"x": 1}])
def test_broken_boxes_are_located(tmp_path: Path, position: object) -> None:
    path, references = chest(tmp_path)
    given = {"user_defined": {"receptacle_aabb_top": {"position": position, "scale": [1, 1, 1]}}}
    (path.parent / "chest.ao_config.json").write_text(json.dumps(given))
    with pytest.raises(AssetError, match=r"^urdf/chest/chest.ao_config.json: "):
        read_articulated(path, references)
