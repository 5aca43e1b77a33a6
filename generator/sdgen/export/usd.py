"""Scenes as USD: ``000041.usda`` each, metres and Z up, and one folder of models for all.

``/World/building`` are floors, walls and ceilings, ``/World/things/category_id`` refer to the
models (:mod:`sdgen.export.usd_model`) where they stand. What is loose is a rigid body, furniture a
collider that stays, doors, lids and drawers are rigid bodies on joints. Categories are semantic
labels. Physics: https://openusd.org/release/api/usd_physics_page_front.html
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.output_folder import output_folder
from sdgen.export.each_scene import each_scene
from sdgen.export.formats import OnScene
from sdgen.export.links import links_of
from sdgen.export.mjcf import ASSETS
from sdgen.export.model_files import ModelFiles
from sdgen.export.usd_model import (
    BASE,
    define_material,
    define_mesh,
    model_layer,
    set_units,
)
from sdgen.geometry import Array
from sdgen.library import Library, MeshData
from sdgen.library.states import object_from_part
from sdgen.render.shell import Face, structure_faces
from sdgen.scene import ObjectInstance, Structure


def export_usd(data: Dataset, output: Path, library: Library, on_scene: OnScene = None) -> None:
    """Write a USD a scene into a new folder, and what they share into ``assets`` there.

    Raises SdgenError for a bad place, InputError for scenes whose files disagree or that other
    models were built of, ModuleNotFoundError without usd-core (pip install sdgen[usd]).
    """
    import pxr  # noqa: F401  (before the work)

    with output_folder(output) as folder:
        (folder / ASSETS).mkdir()
        files = ModelFiles(library, folder / ASSETS)

        def write(item: SceneItem) -> None:
            _Made(library, files, folder, item).write()

        each_scene(data, library, on_scene, write)


class _Made:
    """A scene's layer in the making."""

    def __init__(self, library: Library, files: ModelFiles, folder: Path, item: SceneItem) -> None:
        from pxr import Gf, Usd, UsdGeom, UsdPhysics

        self._library = library
        self._files = files
        self._assets = folder / ASSETS
        self._scene = item.scene
        self._surfaces: dict[str, Any] = {}
        self._stage: Any = Usd.Stage.CreateNew(str(folder / f"{item.id}.usda"))
        set_units(self._stage)
        root = UsdGeom.Xform.Define(self._stage, "/World").GetPrim()
        Usd.ModelAPI(root).SetKind("assembly")
        self._stage.SetDefaultPrim(root)
        physics = UsdPhysics.Scene.Define(self._stage, "/World/physics")
        physics.CreateGravityDirectionAttr(Gf.Vec3f(0, 0, -1))
        physics.CreateGravityMagnitudeAttr(9.81)
        for group in ("building", "things"):
            place = UsdGeom.Xform.Define(self._stage, f"/World/{group}")
            Usd.ModelAPI(place.GetPrim()).SetKind("group")
        UsdGeom.Scope.Define(self._stage, "/World/surfaces")

    def write(self) -> None:
        """Write everything."""
        for structure in self._scene.home.structures:
            self._structure(structure)
        for thing in self._scene.objects:
            self._thing(thing)
        self._stage.Save()

    def _structure(self, structure: Structure) -> None:
        from pxr import UsdGeom, UsdShade

        path = f"/World/building/{structure.category}_{structure.id}"
        prim = UsdGeom.Xform.Define(self._stage, path).GetPrim()
        _label(prim, structure.category)
        groups: dict[str, list[Face]] = {}
        for face in structure_faces(structure, self._library.tile_m):
            groups.setdefault(face.surface, []).append(face)
        for number, (surface, faces) in enumerate(groups.items()):
            mesh = define_mesh(self._stage, f"{path}/face{number}", _mesh_of(faces))
            UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(self._surface(surface))
        for number, piece in enumerate(structure.pieces):
            self._box(f"{path}/piece{number}", piece.center_m, piece.size_m)

    def _box(self, path: str, centre: tuple[float, ...], size: tuple[float, ...]) -> None:
        """A box to collide with, not drawn."""
        from pxr import Gf, UsdGeom, UsdPhysics

        cube = UsdGeom.Cube.Define(self._stage, path)
        cube.CreateSizeAttr(1.0)
        cube.CreateExtentAttr([Gf.Vec3f(-0.5), Gf.Vec3f(0.5)])
        cube.CreatePurposeAttr(UsdGeom.Tokens.guide)
        cube.AddTranslateOp().Set(Gf.Vec3d(*centre))
        cube.AddScaleOp().Set(Gf.Vec3f(*size))
        UsdPhysics.CollisionAPI.Apply(cube.GetPrim())

    def _surface(self, surface: str) -> Any:
        if surface not in self._surfaces:
            file = self._files.texture(self._library.surface_texture(surface), f"surface.{surface}")
            path = f"/World/surfaces/surface{len(self._surfaces)}"
            texture = f"./{ASSETS}/{file}"
            self._surfaces[surface] = define_material(self._stage, path, texture, (1, 1, 1, 1))
        return self._surfaces[surface]

    def _thing(self, item: ObjectInstance) -> None:
        from pxr import UsdGeom, UsdPhysics

        path = f"/World/things/{item.category}_{item.id}"
        thing = UsdGeom.Xform.Define(self._stage, path)
        prim = thing.GetPrim()
        name = model_layer(self._library, self._files, self._assets, item)
        prim.GetReferences().AddReference(f"./{ASSETS}/{name}")
        thing.AddTransformOp().Set(_matrix(item.pose.matrix()))
        _label(prim, item.category)
        asset = self._library.assets[item.asset]
        jointed = False
        for link in links_of(self._library, item):
            over = self._stage.OverridePrim(f"{path}/{link.joint or BASE}")
            if link.joint is not None:
                jointed = True
                where = object_from_part(asset, link.parts[0], item.joints)
                UsdGeom.Xform(over).AddTransformOp().Set(_matrix(where))
            if link.joint is not None or not item.fixed:
                UsdPhysics.RigidBodyAPI.Apply(over)
        if jointed and not item.fixed:
            UsdPhysics.ArticulationRootAPI.Apply(prim)


def _label(prim: Any, category: str) -> None:
    """What it is, for who trains on it (UsdSemantics, since OpenUSD 24.11)."""
    from pxr import UsdSemantics

    UsdSemantics.LabelsAPI.Apply(prim, "category").CreateLabelsAttr([category])


def _matrix(target_from_source: Array) -> Any:
    """A 4x4 as USD has it: for row vectors."""
    from pxr import Gf

    return Gf.Matrix4d(*map(float, target_from_source.T.ravel()))


def _mesh_of(faces: list[Face]) -> MeshData:
    """Quads as one mesh of triangles."""
    vertices = np.concatenate([face.vertices_m for face in faces])
    corners = np.arange(0, len(vertices), 4)[:, None] + (0, 1, 2, 0, 2, 3)
    first, second, last = vertices[0::4], vertices[1::4], vertices[3::4]
    across = np.cross(second - first, last - first)
    normals = across / np.linalg.norm(across, axis=1, keepdims=True)
    return MeshData(
        vertices=vertices,
        normals=np.repeat(normals, 4, axis=0),
        uvs=np.concatenate([face.uvs for face in faces]),
        faces=corners.reshape(-1, 3),
    )
