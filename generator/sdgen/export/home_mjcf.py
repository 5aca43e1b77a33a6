"""A scene as MJCF: an XML file for MuJoCo, and a folder of meshes and textures beside it.

Bodies are named ``category_id``, floors, walls and ceilings ``floor_12_kitchen``, as in the GLB.
What is fixed in our scenes is fixed; the rest has a free joint. Hinges and slides stand as they do
in the scene, at their values. What no shape tells is ``custom`` text (:mod:`sdgen.home.notes`).
"""

from __future__ import annotations

import json
import xml.etree.ElementTree as Tree
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from sdgen.catalog.records import HomeSpec
from sdgen.export.links import Link, links_of
from sdgen.export.model_files import ModelFiles, numbers
from sdgen.geometry import Array, quat_from_matrix
from sdgen.home.notes import KEY, home_note, thing_notes
from sdgen.library import Library
from sdgen.library.records import Asset, Joint
from sdgen.library.states import object_from_part
from sdgen.scene import Box, ObjectInstance, Scene, Structure

#: What holds a leaf where it stands against its own weight, and how much slower it gets.
_HOLDS, _DAMPING = 1.5, 0.5
#: Of MuJoCo's torsional and rolling friction: bottles and balls lie still as in our physics.
_TURNS, _ROLLS = 0.005, 0.0005
_GRAVITY = 9.81
_TYPES = {"revolute": "hinge", "prismatic": "slide"}


def write_home_mjcf(
    scene: Scene, library: Library, files: ModelFiles, assets: str, spec: HomeSpec | None = None
) -> bytes:
    """The XML of a scene; ``files`` takes its meshes and textures, into a folder that the XML knows
    as ``assets`` beside it. ``spec`` is what the home was made from, where it is at hand."""
    made = _Made(library, files, assets, scene.home.id)
    note = home_note(scene, spec)
    made.text(KEY, note.model_dump(mode="json"))
    names = {room.id: room.name for room in scene.home.rooms}
    for structure in scene.home.structures:
        made.structure(structure, names[structure.room_id])
    for item, said in thing_notes(scene):
        made.thing(item)
        made.text(_name(item), said.model_dump(mode="json", exclude_defaults=True))
    return made.document()


def _name(item: ObjectInstance) -> str:
    return f"{item.category}_{item.id}"


class _Made:
    """A MuJoCo model in the making."""

    def __init__(self, library: Library, files: ModelFiles, assets: str, name: str) -> None:
        self._library = library
        self._files = files
        self._known: dict[object, str] = {}
        self._hulls: dict[str, Sequence[str]] = {}
        self._root = Tree.Element("mujoco", model=name)
        add = Tree.SubElement
        add(self._root, "compiler", angle="radian", meshdir=assets, texturedir=assets)
        # Elliptic cones and a high ratio: what leans or lies on a slope does not creep away.
        cones = {"cone": "elliptic", "impratio": "10"}
        option = add(self._root, "option", cones, timestep="0.002", integrator="implicitfast")
        # Solved island by island, MuJoCo 4.0 throws things out of a drawer of towels; as a whole
        # they lie still, for the same time.
        add(option, "flag", island="disable")
        add(self._root, "size", memory="256M")
        add(self._root, "statistic", extent="8")
        self._defaults()
        self._custom = add(self._root, "custom")
        self._asset = add(self._root, "asset")
        self._world = add(self._root, "worldbody")
        add(self._world, "light", pos="0 0 12", dir="0.1 0.1 -1", directional="true")
        self._contact = add(self._root, "contact")

    def _defaults(self) -> None:
        """Classes of geoms. What is fixed, with its leaves, meets only what is loose: in our homes
        doors lie flush in their frames, which would push each other about."""
        add = Tree.SubElement
        main = add(self._root, "default")
        # Visual meshes may be open sheets: their own inertia is never used, bodies have theirs.
        add(main, "mesh", inertia="shell")
        classes: Mapping[str, Mapping[str, str]] = {
            "visual": {"type": "mesh", "contype": "0", "conaffinity": "0", "group": "2"},
            "collision": {"type": "mesh", "contype": "1", "conaffinity": "0", "group": "3"},
            "loose": {"type": "mesh", "contype": "1", "conaffinity": "1", "group": "3"},
            "shell": {"type": "box", "contype": "1", "conaffinity": "0", "group": "1"},
            # Of a group of its own, so that a viewer can look in from above.
            "ceiling": {"type": "box", "contype": "1", "conaffinity": "0", "group": "4"},
        }
        for name, given in classes.items():
            kind = add(main, "default", {"class": name})
            # Nothing rolls or spins for ever: friction against that, too, as in our physics.
            more = {"condim": "6"} if name == "loose" else {}
            add(kind, "geom", {**given, **more})

    def text(self, name: str, said: object) -> None:
        """Add a note under a name."""
        data = json.dumps(said, ensure_ascii=False, separators=(",", ":"))
        Tree.SubElement(self._custom, "text", name=name, data=data)

    def document(self) -> bytes:
        """The model as XML."""
        Tree.indent(self._root)
        return bytes(Tree.tostring(self._root, encoding="utf-8", xml_declaration=True)) + b"\n"

    # --- rooms -----------------------------------------------------------------------------------

    def structure(self, structure: Structure, room: str) -> None:
        """Add a floor, wall or ceiling: a body of boxes."""
        name = f"{structure.category}_{structure.id}_{room}"
        body = Tree.SubElement(self._world, "body", name=name)
        material = self._surface(structure.surface)
        kind = "ceiling" if structure.category == "ceiling" else "shell"
        for number, piece in enumerate(structure.pieces):
            self._box(body, f"{name}/{number}", piece, kind, material)

    def _box(self, body: Tree.Element, name: str, piece: Box, kind: str, material: str) -> None:
        Tree.SubElement(
            body,
            "geom",
            {"class": kind},
            name=name,
            pos=numbers(piece.center_m),
            size=numbers(side / 2 for side in piece.size_m),
            material=material,
        )

    def _surface(self, surface: str) -> str:
        key = ("surface", surface)
        if key not in self._known:
            texture = self._texture(self._library.surface_texture(surface), f"surface.{surface}")
            times = numbers([1 / self._library.tile_m(surface)] * 2)
            self._known[key] = name = f"surface.{surface}"
            Tree.SubElement(
                self._asset,
                "material",
                name=name,
                texture=texture,
                texuniform="true",
                texrepeat=times,
            )
        return self._known[key]

    # --- things ----------------------------------------------------------------------------------

    def thing(self, item: ObjectInstance) -> None:
        """Add an object as it stands, its leaves, lids and drawers as bodies of their own."""
        asset = self._library.assets[item.asset]
        name = _name(item)
        body = _body(self._world, name, item.pose.matrix())
        if not item.fixed:
            Tree.SubElement(body, "freejoint", name=f"{name}/free")
        leaves = []
        for link in links_of(self._library, item):
            if link.joint is None:
                self._filled(body, item, asset, link)
                continue
            leaf = f"{name}/{link.joint}"
            below = _body(body, leaf, object_from_part(asset, link.parts[0], item.joints))
            value = item.joints.get(link.joint, 0.0)
            _joint(below, leaf, asset.joint(link.joint), value, link)
            self._filled(below, item, asset, link)
            leaves.append(leaf)
        if not item.fixed:
            self._apart([name, *leaves])

    def _apart(self, bodies: Sequence[str]) -> None:
        """Say that these bodies of one thing do not collide."""
        for k, first in enumerate(bodies):
            for second in bodies[:k]:
                Tree.SubElement(self._contact, "exclude", body1=second, body2=first)

    def _filled(self, body: Tree.Element, item: ObjectInstance, asset: Asset, link: Link) -> None:
        """Give a body its parts: what is drawn, what collides, what they weigh."""
        Tree.SubElement(
            body,
            "inertial",
            pos=numbers(link.centre_m),
            mass=f"{link.mass_kg:.6g}",
            diaginertia=" ".join(f"{value:.6g}" for value in link.inertia),
        )
        for part in link.parts:
            mesh, material = self._drawn(item.asset, part)
            Tree.SubElement(body, "geom", {"class": "visual"}, mesh=mesh, material=material)
        friction = numbers((asset.friction, _TURNS, _ROLLS))
        kind = "collision" if item.fixed else "loose"
        pieces = self._pieces(item.asset)
        for number in link.hulls:
            geom = {"class": kind}
            Tree.SubElement(body, "geom", geom, mesh=pieces[number], friction=friction)

    def _drawn(self, asset_id: str, part: str) -> tuple[str, str]:
        """Mesh and material of a part; models of one shape in several colours share the mesh."""
        asset = self._library.assets[asset_id]
        key = (self._library.folder_of(asset_id), asset.mesh, part)
        if key not in self._known:
            self._known[key] = name = f"{asset_id}.{part}"
            Tree.SubElement(self._asset, "mesh", name=name, file=self._files.mesh(asset_id, part))
        texture = self._library.file(asset_id, asset.part(part).texture or asset.texture)
        rgba = tuple(min(1.0, value) for value in asset.part(part).rgba)
        worn = (texture, rgba)
        if worn not in self._known:
            self._known[worn] = material = f"{asset_id}.{part}"
            image = self._texture(texture, asset_id)
            Tree.SubElement(
                self._asset, "material", name=material, texture=image, rgba=numbers(rgba)
            )
        return self._known[key], self._known[worn]

    def _pieces(self, asset_id: str) -> Sequence[str]:
        """Names of a model's convex pieces, in their order."""
        key = (self._library.folder_of(asset_id), self._library.assets[asset_id].hulls)
        if key not in self._known:
            self._known[key] = asset_id
            self._hulls[asset_id] = list(self._hulled(asset_id))
        return self._hulls[self._known[key]]

    def _hulled(self, asset_id: str) -> Iterator[str]:
        # Of points alone MuJoCo makes the hull itself.
        for number, hull in enumerate(self._library.hulls(asset_id)):
            name = f"{asset_id}.hull{number}"
            points = numbers(hull.vertices_m.ravel())
            Tree.SubElement(self._asset, "mesh", name=name, vertex=points)
            yield name

    def _texture(self, path: Path, name: str) -> str:
        """Name of a texture; it is a PNG, as MuJoCo reads no JPEG."""
        if path not in self._known:
            file = self._files.texture(path, name)
            self._known[path] = name = file.removesuffix(".png")
            Tree.SubElement(self._asset, "texture", name=name, type="2d", file=file)
        return self._known[path]


def _body(parent: Tree.Element, name: str, parent_from_body: Array) -> Tree.Element:
    x, y, z, w = quat_from_matrix(parent_from_body[:3, :3])
    place = {"pos": numbers(parent_from_body[:3, 3]), "quat": numbers((w, x, y, z))}
    return Tree.SubElement(parent, "body", place, name=name)


def _joint(body: Tree.Element, name: str, joint: Joint, value: float, link: Link) -> None:
    """Add a joint to a body that stands where ``value`` puts it. A point of the hinge, and its
    axis, are where they were: the leaf turns about them."""
    arm = 1.0
    if joint.type == "revolute":
        arm = float(np.linalg.norm(link.centre_m - joint.origin_m))
    holds = link.mass_kg * _GRAVITY * arm * _HOLDS
    Tree.SubElement(
        body,
        "joint",
        name=name,
        type=_TYPES[joint.type],
        pos=numbers(joint.origin_m),
        axis=numbers(joint.axis),
        limited="true",
        range=numbers((joint.lower, joint.upper)),
        ref=numbers([value]),
        frictionloss=f"{holds:.4g}",
        # Nearly hard: a lid that stands half open would sink through softer friction.
        solimpfriction="0.99 0.9999 0.001",
        solreffriction="0.004 1",
        damping=f"{holds * _DAMPING:.4g}",
    )
