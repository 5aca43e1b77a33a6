"""Makes a model of ours from a scan that stands in our frame: its record and its files."""

from __future__ import annotations

import io
import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sdgen.catalog.records import Category
from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing.bake import Baked, baked, kept
from sdgen.importing.categorise import Choice
from sdgen.importing.convex import convex_pieces
from sdgen.importing.glb_file import model_glb
from sdgen.importing.licences import Terms
from sdgen.importing.receptacles import behind_doors, open_hollow, supports_of
from sdgen.importing.scan import Piece, Scan
from sdgen.importing.simplify import Solid, light, welded
from sdgen.library.meshes import MeshData
from sdgen.library.plausible import DENSITY_KG_M3, inconsistencies
from sdgen.library.poses import resting_poses
from sdgen.library.records import Asset, Container, Joint, Part, StateRule, Support
from sdgen.library.shape import centre_of_mass, corners_of, hull_volume, see_through
from sdgen.vocabulary import UNCATEGORISED

#: As :mod:`sdgen.validate.models` has it: faces of small things, of others, and what is small.
SMALL_FACES, LARGE_FACES, SMALL_M = 800, 2500, 0.6
#: Things this small need less than the whole texture.
_TINY_M, _TINY_TEXTURE = 0.06, 256
#: How far sizes of furniture, which rooms are laid out by, and of small things may be off.
FURNITURE_OFF, SMALL_OFF = 1.3, 3.5
#: From how far on a door or a drawer counts as open: a fridge shows its inside later.
_OPEN_RAD, _FRIDGE_RAD, _OPEN_M, _SHUT = 0.15, 0.3, 0.05, 0.03
#: No leaf needs to open further, radians.
_WIDEST_RAD = 1.9
#: Mass of what no category knows, kg/m3 of its hull.
_DENSITY = 250.0
_QUALITY = 90
_NAME = re.compile(r"[^A-Za-z0-9_.-]+")
#: Sliding friction of things of a home, and that of a model that says none (see ``Asset``).
FRICTION, FRICTION_UNSAID = (0.2, 1.2), 0.6
#: Characters of an id, which has 100 with the source's name before and a number after it.
_LONGEST_ID = 70


@dataclass(frozen=True)
class Budget:
    """How light models are made: faces of small and of large things (None: as ``validate`` asks),
    pixels a side of the texture."""

    faces: int | None = None
    texture_px: int = 512

    def most_faces(self, size_m: float) -> int:
        """Faces that a model of this longest side may have."""
        if self.faces is not None:
            return self.faces
        return SMALL_FACES if size_m <= SMALL_M else LARGE_FACES


@dataclass(frozen=True)
class Made:
    """A model: its record and its files' bytes by their names in the library."""

    asset: Asset
    files: Mapping[str, bytes]


def make_model(
    asset_id: str,
    source: str,
    title: str,
    scan: Scan,
    choice: Choice,
    category: Category | None,
    terms: Terms,
    budget: Budget,
    notes: list[str],
) -> Made:
    """The model of a scan. Raises AssetError where no good one can be made of it."""
    size = scan.extents_m
    faces = budget.most_faces(float(size.max()))
    side = budget.texture_px
    if size.max() < _TINY_M:
        side = min(side, _TINY_TEXTURE)
    groups = by_link(scan)
    look = painted(groups, faces, side, notes)
    broken: Baked | None = None
    if scan.broken:
        broken = painted({"broken": scan.broken}, faces, side, notes)
        broken = _laid_down(broken)
    meshes = _snapped(look.meshes, size if not scan.joints else None)
    joints = _joints(scan, category)
    joint_of = {"body": None} | {name: name for name in meshes if name != "body"}
    pieces = {name: _pieces_of(mesh) for name, mesh in meshes.items()}
    supports, containers = _receptacles(scan, category, meshes, joints, joint_of)
    body = [piece for group in pieces.values() for piece in group]
    rules = [rule for joint in joints for rule in _rules(joint, category)]
    variants: dict[str, tuple[str, ...]] = {"default": tuple(meshes)}
    rules += [StateRule(state=s, variants=("default",), parts=("body",)) for s in choice.states]
    parts = [_part(name, mesh, joint_of[name]) for name, mesh in meshes.items()]
    if broken is not None:
        parts.append(
            _part("broken", broken.meshes["broken"], None, f"textures/{asset_id}_broken.jpg")
        )
        variants["broken"] = ("broken",)
        rules.append(StateRule(state="BROKEN", variants=("broken",), parts=("broken",)))
        mesh = broken.meshes["broken"]
        pieces["broken"] = _pieces_of(mesh)
    corners = corners_of(list(meshes.values())).reshape(-1, 3)
    extents = np.round(corners.max(axis=0) - corners.min(axis=0), 4)
    asset = Asset(
        id=asset_id,
        category=UNCATEGORISED if category is None else category.name,
        title=title,
        licence=terms.licence,
        source=source,
        attribution=terms.attribution,
        extents_m=(float(extents[0]), float(extents[1]), float(extents[2])),
        mass_kg=_mass(scan, choice, category, corners, extents),
        friction=_friction(scan.friction),
        parts=tuple(parts),
        joints=joints,
        variants=variants,
        states=tuple(rules),
        supports=supports,
        containers=containers,
        resting=resting_poses(body, centre_of_mass(body)),
        mesh=f"meshes/{asset_id}.glb",
        hulls=f"meshes/{asset_id}.hulls.json",
        texture=f"textures/{asset_id}.jpg",
    )
    wrong = [text for _, text in inconsistencies(asset)]
    if wrong:
        raise AssetError(wrong)
    drawn = {**meshes, **(broken.meshes if broken is not None else {})}
    files = {
        asset.mesh: model_glb(drawn, f"../textures/{asset_id}.jpg"),
        asset.hulls: hulls_text(pieces),
        asset.texture: jpeg(look),
    }
    if broken is not None:
        files[f"textures/{asset_id}_broken.jpg"] = jpeg(broken)
    return Made(asset, files)


def slug(name: str) -> str:
    """A name as ids have it: letters, digits and ``_ . -``."""
    return _NAME.sub("_", name).strip("_.-")[:_LONGEST_ID].strip("_.-") or "model"


def by_link(scan: Scan) -> dict[str, list[Piece]]:
    """Pieces by part: the body first, then what each joint moves."""
    groups: dict[str, list[Piece]] = {"body": []}
    names = {joint.name: slug(joint.name) for joint in scan.joints}
    for piece in scan.pieces:
        groups.setdefault(names.get(piece.link, "body"), []).append(piece)
    if not groups["body"]:
        raise AssetError(["all of it moves: nothing stands"])
    return groups


def painted(
    groups: Mapping[str, Sequence[Piece]], faces: int, side: int, notes: list[str]
) -> Baked:
    """Pieces by part as meshes of at most so many faces, and their one texture."""
    solids = {name: welded(group) for name, group in groups.items()}
    if any(len(solid.faces) == 0 for solid in solids.values()):
        raise AssetError(["its triangles have no area"])
    thin = light(solids, faces)
    whole = all(_count(thin[name]) == len(solids[name].faces) for name in solids)
    doubled = any(solid.doubled for solid in thin.values())
    if doubled:
        notes.append("single-sided: doubled, so that no view shows holes")
    if whole and not doubled and _alike(solids, groups):
        found = kept(groups, False, side)
        if found is not None and see_through(corners_of(list(found.meshes.values()))) < 0.03:
            return found
    return baked([piece for group in groups.values() for piece in group], thin, side)


def _alike(solids: Mapping[str, Solid], groups: Mapping[str, Sequence[Piece]]) -> bool:
    """True when welding took no face away."""
    return all(
        len(solids[name].faces) == sum(len(piece.faces) for piece in group)
        for name, group in groups.items()
    )


def _count(solid: Solid) -> int:
    return len(solid.faces) // 2 if solid.doubled else len(solid.faces)


def _snapped(meshes: Mapping[str, MeshData], size: Array | None) -> dict[str, MeshData]:
    """The meshes with the middle of the bottom at the origin, as large as ``size``: thinning cuts
    the outermost corners by up to a few hundredths."""
    points = corners_of(list(meshes.values())).reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    grown = np.ones(3) if size is None else np.clip(size / np.maximum(high - low, 1e-9), 0.9, 1.1)
    return {
        name: replace(mesh, vertices=(mesh.vertices - shift) * grown)
        for name, mesh in meshes.items()
    }


def _laid_down(look: Baked) -> Baked:
    """What is left of a broken thing, lying as it comes to rest, in the middle."""
    (name, mesh), *_ = look.meshes.items()
    pieces = _pieces_of(mesh)
    up = np.array(resting_poses(pieces, centre_of_mass(pieces))[0].up)
    side = np.cross(up, [1.0, 0, 0] if abs(up[0]) < 0.9 else [0, 1.0, 0])
    side /= np.linalg.norm(side)
    turn = np.stack([side, np.cross(up, side), up])
    moved = mesh.vertices @ turn.T
    low, high = moved.min(axis=0), moved.max(axis=0)
    moved = moved - [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]
    laid = replace(mesh, vertices=moved, normals=mesh.normals @ turn.T)
    return Baked({name: laid}, look.texture)


def _pieces_of(mesh: MeshData) -> list[Array]:
    """Convex pieces of a mesh; of faces that look both ways one is enough."""
    solid = welded([Piece(mesh.vertices, mesh.faces)])
    _, first = np.unique(np.sort(solid.faces, axis=1), axis=0, return_index=True)
    return convex_pieces(solid.vertices, solid.faces[np.sort(first)])


def _joints(scan: Scan, category: Category | None) -> tuple[Joint, ...]:
    """Joints of ours: 0 is shut, positive values open."""
    out = []
    for joint in scan.joints:
        axis, lower, upper = joint.axis, joint.lower, joint.upper
        if abs(lower) > abs(upper):
            axis, lower, upper = -axis, -upper, -lower
        upper = min(upper, _WIDEST_RAD) if joint.type == "revolute" else upper
        if upper < 0.02 or not math.isfinite(upper):
            raise AssetError([f"joint {joint.name!r} does not move: {lower:g} to {upper:g}"])
        out.append(
            Joint(
                name=slug(joint.name),
                type=joint.type,
                origin_m=_vec(joint.origin_m),
                axis=_vec(axis),
                lower=0.0,
                upper=round(float(upper), 4),
            )
        )
    return tuple(out)


def _rules(joint: Joint, category: Category | None) -> tuple[StateRule, StateRule]:
    cold = category is not None and category.name in ("fridge", "freezer")
    turned = _FRIDGE_RAD if cold else _OPEN_RAD
    least = min(turned if joint.type == "revolute" else _OPEN_M, joint.upper)
    return (
        StateRule(state="CLOSED", joint=joint.name, max=min(_SHUT, joint.upper / 2)),
        StateRule(state="OPEN", joint=joint.name, min=least, parts=(joint.name,)),
    )


def _receptacles(
    scan: Scan,
    category: Category | None,
    meshes: Mapping[str, MeshData],
    joints: Sequence[Joint],
    joint_of: Mapping[str, str | None],
) -> tuple[tuple[Support, ...], tuple[Container, ...]]:
    """Where things stand on it and lie in it, as far as such things hold others at all."""
    properties = () if category is None else category.properties
    furniture = category is None or category.kind == "furniture"
    supports: tuple[Support, ...] = ()
    containers: tuple[Container, ...] = ()
    if furniture or "SURFACES" in properties or scan.receptacles:
        supports = supports_of(meshes, scan.receptacles, ["body"])
    if {"RECIPIENT", "CONTAINERS", "DRINKABLE"} & set(properties) and not joints:
        hollow = open_hollow([meshes["body"]], "body")
        if hollow is not None:
            containers = (hollow,)
            supports = tuple(_in_hollow(support, hollow) for support in supports)
    elif joints:
        supports, containers = behind_doors(supports, meshes, joints, joint_of)
    return supports, containers


def _in_hollow(support: Support, hollow: Container) -> Support:
    corners = np.array(support.polygon_m).mean(axis=0)
    inside = np.abs(corners - hollow.center_m[:2]) < np.array(hollow.size_m[:2]) / 2
    low = hollow.center_m[2] - hollow.size_m[2] / 2
    deep = low - 0.02 <= support.z_m < hollow.center_m[2]
    return (
        support.model_copy(update={"container": hollow.name}) if inside.all() and deep else support
    )


def _part(name: str, mesh: MeshData, joint: str | None, texture: str | None = None) -> Part:
    return Part(name=name, faces=len(mesh.faces), joint=joint, texture=texture)


def _friction(said: float | None) -> float:
    """What a file says, if things of a home rub so: many have 0, or 100000 that nothing slips."""
    least, most = FRICTION
    return FRICTION_UNSAID if said is None or not least <= said <= most else round(said, 3)


def _mass(
    scan: Scan, choice: Choice, category: Category | None, points: Array, extents: Array
) -> float:
    """What the table or the source says, if such things have it; else by size within the range."""
    volume = float(np.maximum(extents, 1e-3).prod())
    low, high = (density * volume for density in DENSITY_KG_M3)
    least, most = (low, high) if category is None else (category.mass_min_kg, category.mass_max_kg)
    for said in (choice.mass_kg, scan.mass_kg):
        if said is not None and max(low, least) <= said <= min(high, most):
            return round(said, 4)
    if category is None:
        guess = _DENSITY * hull_volume(points)
    else:
        smallest = math.prod(max(v, 1e-3) for v in category.extents_min_m)
        largest = math.prod(max(v, 1e-3) for v in category.extents_max_m)
        share = math.log(volume / smallest) / max(math.log(largest / smallest), 1e-6)
        share = min(max(share, 0.0), 1.0)
        guess = least * (most / max(least, 1e-4)) ** share if least > 0 else most * share
    return round(float(min(max(guess, low * 1.02, least), high * 0.98)), 4)


def hulls_text(pieces: Mapping[str, Sequence[Array]]) -> bytes:
    """The hulls file of pieces by part."""
    listed = [
        {"part": part, "vertices_m": np.round(points, 4).tolist()}
        for part, group in pieces.items()
        for points in group
    ]
    return (json.dumps({"pieces": listed}, separators=(",", ":")) + "\n").encode()


def jpeg(look: Baked) -> bytes:
    """The texture as JPEG."""
    from PIL import Image

    out = io.BytesIO()
    Image.fromarray(look.texture).save(out, "JPEG", quality=_QUALITY)
    return out.getvalue()


def _vec(values: Array) -> tuple[float, float, float]:
    x, y, z = (round(float(v), 5) + 0.0 for v in values)
    return (x, y, z)
