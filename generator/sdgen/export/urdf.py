"""Scenes as URDF: ``000041.urdf`` each, and one folder of meshes and textures for all.

The root link is the world; every floor, wall and thing is a link ``category_id``, furniture on
fixed joints, loose things on floating ones, doors, lids and drawers on revolute and prismatic
joints. URDF has no joint values: ``000041.joints.json`` beside it has those at which a joint is not
at 0. PyBullet takes a floating joint for a fixed one; Drake, MuJoCo and yourdfpy let things fall.
"""

from __future__ import annotations

import xml.etree.ElementTree as Tree
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.text import pretty
from sdgen.export.each_scene import each_scene
from sdgen.export.formats import OnScene
from sdgen.export.links import Link, links_of
from sdgen.export.mjcf import ASSETS
from sdgen.export.model_files import ModelFiles, numbers, obj
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.library.records import Joint
from sdgen.scene import ObjectInstance, Structure

WORLD = "world"
#: Of doors and drawers: what a person's hand does, newtons and metres a second.
_EFFORT, _VELOCITY = 50.0, 2.0


def export_urdf(data: Dataset, output: Path, library: Library, on_scene: OnScene = None) -> None:
    """Write a URDF a scene into a new folder, and what they share into ``assets`` there.

    Raises SdgenError for a bad place, InputError for scenes whose files disagree or that other
    models were built of.
    """
    with output_folder(output) as folder:
        (folder / ASSETS).mkdir()
        files = ModelFiles(library, folder / ASSETS)

        def write(item: SceneItem) -> None:
            made = _Made(library, files, item.id)
            rooms = {room.id: room.name for room in item.scene.home.rooms}
            for structure in item.scene.home.structures:
                made.structure(structure, rooms[structure.room_id])
            for thing in item.scene.objects:
                made.thing(thing)
            (folder / f"{item.id}.urdf").write_bytes(made.document())
            joints = pretty({"joints": made.joints}) + "\n"
            (folder / f"{item.id}.joints.json").write_text(joints, encoding="utf-8")

        each_scene(data, library, on_scene, write)


class _Made:
    """A URDF in the making."""

    def __init__(self, library: Library, files: ModelFiles, name: str) -> None:
        self._library = library
        self._files = files
        self._root = Tree.Element("robot", name=f"scene_{name}")
        Tree.SubElement(self._root, "link", name=WORLD)
        self.joints: dict[str, float] = {}

    def document(self) -> bytes:
        """The URDF as XML."""
        Tree.indent(self._root)
        return bytes(Tree.tostring(self._root, encoding="utf-8", xml_declaration=True)) + b"\n"

    def structure(self, structure: Structure, room: str) -> None:
        """Add a floor, wall or ceiling: a link of boxes."""
        name = f"{structure.category}_{structure.id}_{room}"
        link = Tree.SubElement(self._root, "link", name=name)
        for piece in structure.pieces:
            for kind in ("visual", "collision"):
                shape = Tree.SubElement(link, kind)
                Tree.SubElement(shape, "origin", xyz=numbers(piece.center_m))
                geometry = Tree.SubElement(shape, "geometry")
                Tree.SubElement(geometry, "box", size=numbers(piece.size_m))
                if kind == "visual":
                    colour = Tree.SubElement(shape, "material", name=structure.surface)
                    rgba = self._library.surfaces[structure.surface]
                    texture = self._library.surface_texture(rgba.id)
                    file = self._files.texture(texture, f"surface.{rgba.id}")
                    Tree.SubElement(colour, "texture", filename=f"{ASSETS}/{file}")
        self._joint(f"{name}.place", WORLD, name, "fixed", np.eye(4))

    def thing(self, item: ObjectInstance) -> None:
        """Add an object as it stands, its leaves, lids and drawers as links of their own."""
        asset = self._library.assets[item.asset]
        name = f"{item.category}_{item.id}"
        for link in links_of(self._library, item):
            if link.joint is None:
                self._link(name, item, link, np.zeros(3))
                kind = "fixed" if item.fixed else "floating"
                self._joint(f"{name}.place", WORLD, name, kind, item.pose.matrix())
                continue
            joint = asset.joint(link.joint)
            leaf = f"{name}.{link.joint}"
            origin = np.asarray(joint.origin_m)
            self._link(leaf, item, link, origin)
            where = np.eye(4)
            where[:3, 3] = origin
            self._joint(f"{leaf}.joint", name, leaf, joint.type, where, joint)
            if value := item.joints.get(link.joint, 0.0):
                self.joints[f"{leaf}.joint"] = value

    def _link(self, name: str, item: ObjectInstance, link: Link, origin: Array) -> None:
        """A link whose frame lies at ``origin`` of the object's."""
        made = Tree.SubElement(self._root, "link", name=name)
        inertial = Tree.SubElement(made, "inertial")
        Tree.SubElement(inertial, "origin", xyz=numbers(link.centre_m - origin))
        Tree.SubElement(inertial, "mass", value=f"{link.mass_kg:.6g}")
        ixx, iyy, izz = (f"{value:.6g}" for value in link.inertia)
        Tree.SubElement(inertial, "inertia", ixx=ixx, iyy=iyy, izz=izz, ixy="0", ixz="0", iyz="0")
        moved = numbers(-origin)
        for part in link.parts:
            visual = Tree.SubElement(made, "visual")
            Tree.SubElement(visual, "origin", xyz=moved)
            geometry = Tree.SubElement(visual, "geometry")
            Tree.SubElement(geometry, "mesh", filename=f"{ASSETS}/{self._drawn(item, part)}")
        for number in link.hulls:
            collision = Tree.SubElement(made, "collision")
            Tree.SubElement(collision, "origin", xyz=moved)
            geometry = Tree.SubElement(collision, "geometry")
            file = self._files.hull(item.asset, number)
            Tree.SubElement(geometry, "mesh", filename=f"{ASSETS}/{file}")

    def _drawn(self, item: ObjectInstance, part: str) -> str:
        """The OBJ of a part in its colours, which names a material beside it: URDF's own would give
        a whole link one."""
        asset = self._library.assets[item.asset]
        texture = self._library.file(item.asset, asset.part(part).texture or asset.texture)
        red, green, blue, alpha = (min(1.0, value) for value in asset.part(part).rgba)
        picture = self._files.texture(texture, item.asset)
        name = f"{item.asset}.{part}"
        text = (
            f"newmtl {name}\nKd {red:.4g} {green:.4g} {blue:.4g}\nd {alpha:.4g}\nmap_Kd {picture}\n"
        )
        material = self._files.once(("mtl", name), f"{name}.mtl", text.encode())
        content = obj(self._library.mesh(item.asset)[part], material)
        return self._files.once(("obj", name), f"{name}.obj", content)

    def _joint(
        self,
        name: str,
        parent: str,
        child: str,
        kind: str,
        parent_from_child: Array,
        joint: Joint | None = None,
    ) -> None:
        made = Tree.SubElement(self._root, "joint", name=name, type=kind)
        Tree.SubElement(made, "parent", link=parent)
        Tree.SubElement(made, "child", link=child)
        where = {"xyz": numbers(parent_from_child[:3, 3]), "rpy": numbers(_rpy(parent_from_child))}
        Tree.SubElement(made, "origin", where)
        if joint is not None:
            Tree.SubElement(made, "axis", xyz=numbers(joint.axis))
            Tree.SubElement(
                made,
                "limit",
                lower=numbers([joint.lower]),
                upper=numbers([joint.upper]),
                effort=numbers([_EFFORT]),
                velocity=numbers([_VELOCITY]),
            )


def _rpy(matrix: Array) -> Sequence[float]:
    """Roll, pitch and yaw of a rotation: Rz(yaw) Ry(pitch) Rx(roll), as URDF has them."""
    import trimesh

    roll, pitch, yaw = trimesh.transformations.euler_from_matrix(matrix, "sxyz")  # type: ignore[no-untyped-call]
    return float(roll), float(pitch), float(yaw)
