"""A model of the library as a USD layer of its own, which the scenes refer to.

``/Model`` has an Xform for each link (``base``, and one for each joint), in the object's frame with
all joints at 0; below it the drawn parts as meshes, the convex pieces as colliders (purpose
``guide``), mass and inertia. ``/Model/joints`` has the joints, ``/Model/materials`` what parts
wear.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from sdgen.export.links import Link, links_of
from sdgen.export.model_files import ModelFiles, hull_mesh
from sdgen.geometry import Array
from sdgen.library import Library, MeshData
from sdgen.library.records import Joint
from sdgen.scene import ObjectInstance

BASE = "base"


def model_layer(library: Library, files: ModelFiles, folder: Path, item: ObjectInstance) -> str:
    """Name of the layer in ``folder`` of the model of an object as it is drawn, made when it is
    asked for first."""
    name = f"{item.asset}.{item.variant}.usdc"
    path = folder / name
    if not path.exists():
        _Made(library, files, path, item).write()
    return name


class _Made:
    """A layer in the making."""

    def __init__(
        self, library: Library, files: ModelFiles, path: Path, item: ObjectInstance
    ) -> None:
        from pxr import Usd, UsdGeom

        self._library = library
        self._files = files
        self._item = item
        self._asset = library.assets[item.asset]
        self._materials: dict[object, Any] = {}
        self._stage: Any = Usd.Stage.CreateNew(str(path))
        set_units(self._stage)
        root = UsdGeom.Xform.Define(self._stage, "/Model").GetPrim()
        Usd.ModelAPI(root).SetKind("component")
        self._stage.SetDefaultPrim(root)

    def write(self) -> None:
        """Write everything."""
        from pxr import UsdGeom

        for link in links_of(self._library, self._item):
            path = f"/Model/{link.joint or BASE}"
            UsdGeom.Xform.Define(self._stage, path)
            self._mass(path, link)
            for part in link.parts:
                self._part(f"{path}/{part}", part)
            for number in link.hulls:
                self._hull(f"{path}/hull{number}", number)
            if link.joint is not None:
                self._joint(self._asset.joint(link.joint))
        self._stage.Save()

    def _mass(self, path: str, link: Link) -> None:
        from pxr import Gf, UsdPhysics

        mass = UsdPhysics.MassAPI.Apply(self._stage.GetPrimAtPath(path))
        mass.CreateMassAttr(link.mass_kg)
        mass.CreateCenterOfMassAttr(Gf.Vec3f(*map(float, link.centre_m)))
        mass.CreateDiagonalInertiaAttr(Gf.Vec3f(*map(float, link.inertia)))
        mass.CreatePrincipalAxesAttr(Gf.Quatf(1))

    def _part(self, path: str, part: str) -> None:
        from pxr import UsdShade

        mesh = define_mesh(self._stage, path, self._library.mesh(self._item.asset)[part])
        asset = self._asset
        texture = self._library.file(asset.id, asset.part(part).texture or asset.texture)
        colour = tuple(min(1.0, value) for value in asset.part(part).rgba)
        key = (texture, colour)
        if key not in self._materials:
            place = f"/Model/materials/{part}"
            file = self._files.texture(texture, asset.id)
            self._materials[key] = define_material(self._stage, place, f"./{file}", colour)
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(self._materials[key])

    def _hull(self, path: str, number: int) -> None:
        from pxr import UsdGeom, UsdPhysics

        points, faces = hull_mesh(self._library.hulls(self._item.asset)[number].vertices_m)
        mesh = UsdGeom.Mesh.Define(self._stage, path)
        set_faces(mesh, points, faces)
        mesh.CreatePurposeAttr(UsdGeom.Tokens.guide)
        UsdPhysics.CollisionAPI.Apply(mesh.GetPrim())
        collider = UsdPhysics.MeshCollisionAPI.Apply(mesh.GetPrim())
        collider.CreateApproximationAttr(UsdPhysics.Tokens.convexHull)

    def _joint(self, joint: Joint) -> None:
        from pxr import Gf, UsdGeom, UsdPhysics

        UsdGeom.Scope.Define(self._stage, "/Model/joints")
        path = f"/Model/joints/{joint.name}"
        turns = joint.type == "revolute"
        kind = UsdPhysics.RevoluteJoint if turns else UsdPhysics.PrismaticJoint
        made = kind.Define(self._stage, path)
        made.CreateAxisAttr("X")
        made.CreateBody0Rel().SetTargets([f"/Model/{BASE}"])
        made.CreateBody1Rel().SetTargets([f"/Model/{joint.name}"])
        # Limits are degrees for hinges, metres for slides.
        scale = float(np.degrees(1.0)) if turns else 1.0
        made.CreateLowerLimitAttr(joint.lower * scale)
        made.CreateUpperLimitAttr(joint.upper * scale)
        origin = Gf.Vec3f(*map(float, joint.origin_m))
        turn = Gf.Rotation(Gf.Vec3d(1, 0, 0), Gf.Vec3d(*map(float, joint.axis))).GetQuat()
        for place, rotation in (
            (made.CreateLocalPos0Attr(), made.CreateLocalRot0Attr()),
            (made.CreateLocalPos1Attr(), made.CreateLocalRot1Attr()),
        ):
            place.Set(origin)
            rotation.Set(Gf.Quatf(turn))


def set_units(stage: Any) -> None:
    """Metres, kilograms, Z up."""
    from pxr import UsdGeom, UsdPhysics

    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)


def define_mesh(stage: Any, path: str, data: MeshData) -> Any:
    """A triangle mesh with normals and texture coordinates."""
    from pxr import Sdf, UsdGeom, Vt

    mesh = UsdGeom.Mesh.Define(stage, path)
    set_faces(mesh, data.vertices, data.faces)
    mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(data.normals, np.float32)))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    st = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
        "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.vertex
    )
    st.Set(Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(data.uvs, np.float32)))
    return mesh


def set_faces(mesh: Any, points: Array, faces: Any) -> None:
    """Points (N, 3) and triangles (M, 3) of a mesh, and the box they fill."""
    from pxr import UsdGeom, Vt

    corners = np.ascontiguousarray(points, np.float32)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(corners))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray([3] * len(faces)))
    indices = np.ascontiguousarray(np.asarray(faces).ravel(), np.int32)
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(indices))
    box = np.array([corners.min(axis=0), corners.max(axis=0)])
    mesh.CreateExtentAttr(Vt.Vec3fArray.FromNumpy(box))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)


def define_material(stage: Any, path: str, texture: str, rgba: tuple[float, ...]) -> Any:
    """A UsdPreviewSurface that wears a texture, dyed by a colour."""
    from pxr import Gf, Sdf, UsdShade

    material = UsdShade.Material.Define(stage, path)
    surface = UsdShade.Shader.Define(stage, f"{path}/surface")
    surface.CreateIdAttr("UsdPreviewSurface")
    surface.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(0.8)
    surface.CreateInput("opacity", Sdf.ValueTypeNames.Float).Set(float(rgba[3]))
    coordinates = UsdShade.Shader.Define(stage, f"{path}/st")
    coordinates.CreateIdAttr("UsdPrimvarReader_float2")
    coordinates.CreateInput("varname", Sdf.ValueTypeNames.String).Set("st")
    picture = UsdShade.Shader.Define(stage, f"{path}/texture")
    picture.CreateIdAttr("UsdUVTexture")
    picture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(texture)
    for wrap in ("wrapS", "wrapT"):
        picture.CreateInput(wrap, Sdf.ValueTypeNames.Token).Set("repeat")
    picture.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(*rgba[:3], 1.0))
    picture.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(
        coordinates.CreateOutput("result", Sdf.ValueTypeNames.Float2)
    )
    surface.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).ConnectToSource(
        picture.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
    )
    material.CreateSurfaceOutput().ConnectToSource(
        surface.CreateOutput("surface", Sdf.ValueTypeNames.Token)
    )
    return material
