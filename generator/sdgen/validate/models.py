"""Is a model of a library what it should be? One function a question; each yields what is wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image
from shapely.geometry import Polygon

from sdgen.catalog.records import Category
from sdgen.geometry import Array, apply
from sdgen.library import Library
from sdgen.library.alone import MODEL_ID, alone_on_floor
from sdgen.library.drawn import drawn
from sdgen.library.records import Asset
from sdgen.library.shape import corners_of, hull_volume, outside_share, see_through, surface_points
from sdgen.library.states import object_from_part
from sdgen.library.supports import carried_share, find_supports, headroom_m
from sdgen.physics.bodies import object_pieces
from sdgen.physics.client import Client
from sdgen.physics.overlap import deepest_overlap_m
from sdgen.physics.settle import settle_scene
from sdgen.vocabulary import UNCATEGORISED

#: Faces a variant may have; things longer than this are furniture.
SMALL_FACES, LARGE_FACES, SMALL_M = 800, 2500, 0.6
#: Tolerances chosen so that what is wrong at sight is found and the models shipped, looked at one
#: by one, pass. Sizes are stored to the millimetre.
_SIZE_SLACK_M = 0.002
#: Share of a view that may show back faces: thin edges do.
_SEEN_THROUGH = 0.03
#: Fewer is paint, not material.
_COLOURS = 8
#: Share of the surface outside the hulls, by how much (share of the diagonal, metres at least), and
#: how many times the volume of the mesh the hulls may have.
_HULL_OUTSIDE, _HULL_SLACK, _HULL_SLACK_M, _HULL_EXCESS = 0.2, 0.05, 0.006, 1.6
#: How far a moving part may cut deeper than at rest, and positions of its joint looked at.
_CUT_M, _CUT_STEPS = 0.02, 4
#: Share of a support with mesh below it, and what its headroom may be less than promised.
_CARRIED, _HEADROOM_SLACK_M = 0.05, 0.02
#: A level surface so large, with so much room above it and so high must have a support.
_LARGE_M2, _ROOMY_M, _SAME_LEVEL_M, _LOW_M = 0.08, 0.15, 0.04, 0.05
#: The sheet turned down over a blanket is of one piece with it: supports end 2 cm before its step,
#: that nothing lies across it. Boards between two compartments part theirs by 4 cm.
_ONE_PIECE_M = 0.03
#: A thing tipped, or sunk into the floor.
_TIPPED_RAD, _SANK_M = 0.5, 0.01


@dataclass(frozen=True)
class Model:
    """A model under test: its record, its library, its category (None: no catalogue has it)."""

    asset: Asset
    library: Library
    category: Category | None

    @property
    def drawn(self) -> tuple[str, ...]:
        """Parts of the default variant."""
        return self.asset.variants["default"]

    def triangles(self, parts: Sequence[str]) -> Array:
        """Corners (N, 3, 3) of some parts, joints at 0."""
        meshes = self.library.mesh(self.asset.id)
        return corners_of([meshes[part] for part in parts])


def size(model: Model, client: Client) -> Iterator[str]:
    """Real size and mass, by the category's range; the mesh as large as the record says."""
    asset, category = model.asset, model.category
    points = model.triangles(model.drawn).reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    if np.abs((high - low) - np.array(asset.extents_m)).max() > _SIZE_SLACK_M:
        yield f"the mesh measures {_metres(high - low)}, the record says {_metres(asset.extents_m)}"
    if np.abs((low + high)[:2] / 2).max() > _SIZE_SLACK_M or abs(low[2]) > _SIZE_SLACK_M:
        yield "the origin is not the middle of the bottom"
    if category is None:
        if asset.category != UNCATEGORISED:
            yield f"no catalogue gives a size for the category {asset.category!r}"
        return
    for axis, value, least, most in zip(
        ("deep", "wide", "high"),
        asset.extents_m,
        category.extents_min_m,
        category.extents_max_m,
        strict=True,
    ):
        if not least - _SIZE_SLACK_M <= value <= most + _SIZE_SLACK_M:
            yield f"{value:.3f} m {axis}; a {category.name} has {least:g} to {most:g} m"
    if not category.mass_min_kg <= asset.mass_kg <= category.mass_max_kg:
        yield (
            f"{asset.mass_kg:g} kg; a {category.name} has "
            f"{category.mass_min_kg:g} to {category.mass_max_kg:g} kg"
        )


def faces(model: Model, client: Client) -> Iterator[str]:
    """Face budget of every variant."""
    limit = SMALL_FACES if max(model.asset.extents_m) <= SMALL_M else LARGE_FACES
    for variant, parts in model.asset.variants.items():
        count = sum(model.asset.part(part).faces for part in parts)
        if count > limit:
            yield f"variant {variant!r} has {count} faces, at most {limit}"


def closed(model: Model, client: Client) -> Iterator[str]:
    """No variant shows holes, unless a part of it is declared open."""
    for variant, parts in model.asset.variants.items():
        if any(model.asset.part(part).open for part in parts):
            continue
        share = see_through(model.triangles(parts))
        if share > _SEEN_THROUGH:
            yield (
                f"variant {variant!r} shows its back faces in {share:.0%} of a view: close the "
                "mesh, or declare the part open"
            )


def texture(model: Model, client: Client) -> Iterator[str]:
    """A texture of more than one colour, and UVs that spread every part over it."""
    files = {model.asset.texture, *(p.texture for p in model.asset.parts if p.texture)}
    for name in sorted(files):
        with Image.open(model.library.file(model.asset.id, name)) as image:
            colours = image.convert("RGB").resize((64, 64)).getcolors(64 * 64) or []
        if len(colours) < _COLOURS:
            yield f"{name}: {len(colours)} colours: a texture shows material"
    for part, mesh in model.library.mesh(model.asset.id).items():
        corners = mesh.uvs[mesh.faces]
        sides = corners[:, 1:] - corners[:, :1]
        area = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]) / 2
        if area.sum() < 1e-6:
            yield f"part {part!r} has no texture coordinates"


def collision(model: Model, client: Client) -> Iterator[str]:
    """Collision pieces that fill the visual mesh and no more."""
    item = alone_on_floor(model.library, model.asset.id).object(MODEL_ID)
    pieces = object_pieces(model.library, item)
    triangles = model.triangles(model.drawn)
    points, _ = surface_points(triangles, 3000)
    slack = max(_HULL_SLACK_M, _HULL_SLACK * float(np.linalg.norm(model.asset.extents_m)))
    share = outside_share(points, pieces, slack)
    if share > _HULL_OUTSIDE:
        yield f"{share:.0%} of the surface lies more than {slack * 1000:.0f} mm outside the hulls"
    ratio = hull_volume(np.concatenate(pieces)) / max(hull_volume(points), 1e-9)
    if ratio > _HULL_EXCESS and float(np.cbrt(ratio) - 1) * max(model.asset.extents_m) > slack:
        yield f"the hulls reach around {ratio:.1f} times the volume of the mesh"


def rest(model: Model, client: Client) -> Iterator[str]:
    """Stands where it is put: upright on a floor it neither tips, sinks nor rolls away."""
    category = model.category
    if model.asset.category == UNCATEGORISED:
        return  # builds do not place it
    if category is not None and (category.kind == "opening" or "HANGABLE" in category.properties):
        return
    scene = alone_on_floor(model.library, model.asset.id)
    settled = settle_scene(model.library, scene, {MODEL_ID}, client)
    if settled.tilt_rad[MODEL_ID] > _TIPPED_RAD:
        yield f"tips over by {np.degrees(settled.tilt_rad[MODEL_ID]):.0f} degrees"
    elif MODEL_ID in settled.unstable:
        yield "does not come to rest"
        return
    pose = settled.poses[MODEL_ID]
    outline = drawn(model.library.info(model.asset.id), "default", {}).points_m
    lowest = apply(pose.matrix(), outline)[:, 2].min()
    if lowest < -_SANK_M - _HULL_SLACK * max(model.asset.extents_m):
        yield f"sinks {-lowest * 1000:.0f} mm into the floor"


def joints(model: Model, client: Client) -> Iterator[str]:
    """Moving parts clear the body, and the states that joints make can be reached."""
    asset = model.asset
    for rule in asset.states:
        if rule.joint is not None:
            joint = asset.joint(rule.joint)
            if (rule.min or joint.lower) > joint.upper or (
                rule.max is not None and rule.max < joint.lower
            ):
                yield f"state {rule.state} lies beyond the range of the joint {rule.joint!r}"
    hulls = model.library.hulls(asset.id)
    for joint in asset.joints:
        moving = [p for p in model.drawn if asset.part(p).joint == joint.name]
        still = [h.vertices_m for h in hulls if h.part in model.drawn and h.part not in moving]
        moved = [h for h in hulls if h.part in moving]
        if not still or not moved:
            continue
        depth = []
        for step in range(_CUT_STEPS + 1):
            value = joint.lower + (joint.upper - joint.lower) * step / _CUT_STEPS
            placed = [
                apply(object_from_part(asset, h.part, {joint.name: value}), h.vertices_m)
                for h in moved
            ]
            depth.append(deepest_overlap_m(client, still, placed))
        if max(depth[1:]) > max(depth[0], 0.0) + _CUT_M:
            worst = int(np.argmax(depth[1:])) + 1
            value = joint.lower + (joint.upper - joint.lower) * worst / _CUT_STEPS
            yield (
                f"joint {joint.name!r} cuts {max(depth[1:]) * 100:.0f} cm through the rest at "
                f"{value:.2f}"
            )


def supports(model: Model, client: Client) -> Iterator[str]:
    """Supports lie on the mesh with the headroom they promise, and no large surface lacks one."""
    everything = model.triangles(model.drawn)
    for support in model.asset.supports:
        polygon = Polygon(support.polygon_m)
        if carried_share(everything, polygon, support.z_m) < _CARRIED:
            yield f"support {support.name!r} at {support.z_m:.2f} m lies on nothing"
            continue
        free = headroom_m(everything, polygon, support.z_m)
        promised = np.inf if support.headroom_m is None else support.headroom_m
        if free is not None and free < promised - _HEADROOM_SLACK_M and support.container is None:
            yield f"support {support.name!r} has {free:.2f} m above it, not {promised:.2f}"
    if model.category is None or "SURFACES" not in model.category.properties:
        return
    meshes = model.library.mesh(model.asset.id)
    for found in find_supports({part: meshes[part] for part in model.drawn}):
        polygon = Polygon(found.polygon_m)
        roomy = found.headroom_m is None or found.headroom_m >= _ROOMY_M
        # What lies on a mat lies on the floor; slats lie under the mattress that is named.
        if polygon.area < _LARGE_M2 or not roomy or found.z_m < _LOW_M:
            continue
        if not any(
            support.z_m > found.z_m - _SAME_LEVEL_M
            and polygon.distance(Polygon(support.polygon_m)) <= _ONE_PIECE_M
            for support in model.asset.supports
        ):
            yield f"no support names the surface of {polygon.area:.2f} m² at {found.z_m:.2f} m"


#: What ``sdgen assets validate`` asks of every model, by name.
CHECKS: dict[str, Callable[[Model, Client], Iterator[str]]] = {
    "size": size,
    "faces": faces,
    "closed": closed,
    "texture": texture,
    "collision": collision,
    "rest": rest,
    "joints": joints,
    "supports": supports,
}


def check_model(model: Model, client: Client) -> list[str]:
    """Everything wrong with a model: ``id: check: problem``."""
    return [
        f"{model.asset.id} ({model.asset.source}): {name}: {text}"
        for name, check in CHECKS.items()
        for text in check(model, client)
    ]


def _metres(values: Sequence[float] | Array) -> str:
    return " x ".join(f"{float(v):.3f}" for v in values) + " m"
