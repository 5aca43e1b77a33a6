"""Perceived things as the records of a scene, so that all that reads a scene reads them."""

from __future__ import annotations

import numpy as np
import shapely

from sdgen.geometry import Array, Vec3, round_position, round_quat, vec3
from sdgen.library.records import AssetInfo, Container, Joint, Part, StateRule, Support
from sdgen.perception.things import Piece, Thing
from sdgen.scene import ObjectInstance, Pose

#: Every perceived thing has a model of its own: boxes and outlines, no mesh.
SOURCE = "perceived"
#: Records store surfaces drawn in by so much, metres, and let them out again.
DRAWN_IN_M = 0.01
_OPEN = "open"


def records_of(thing: Thing) -> tuple[ObjectInstance, AssetInfo]:
    """A perceived thing as an object (its room still to be found) and its model."""
    turn = thing.turn
    corners = _corners(thing.body)
    local = corners @ turn
    low, high = local.min(axis=0), local.max(axis=0)
    origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    position = round_position(turn @ origin)
    moved = np.asarray(position)

    def own(points: Array) -> Array:
        """World points in the object's frame."""
        return np.asarray((points - moved) @ turn)

    parts = [Part(name="body", faces=12)]
    outlines = {"body": (_tuples(own(corners)),)}
    joints: dict[str, float] = {}
    drawn_joints = []
    containers = []
    for k, leaf in enumerate(thing.leaves):
        # A leaf lies where a joint has moved it, from the middle of the body: so the body's middle
        # is that of the whole when shut, as it is of real models.
        name = f"leaf_{k}"
        points = own(_corners(leaf))
        a, b = points.min(axis=0), points.max(axis=0)
        way = (a + b) / 2 - (0.0, 0.0, (high[2] - low[2]) / 2)
        far = max(float(np.linalg.norm(way)), 1e-3)
        parts.append(Part(name=name, faces=12, joint=name))
        outlines[name] = (_tuples(points - way),)
        joints[name] = far
        drawn_joints.append(_joint(name, vec3(way / far), far))
        if leaf.slides:
            containers.append(_container(f"drawer_{k}", a, b))
    size = high - low
    is_open = "OPEN" in thing.states
    # One sees into what stands open, whether its state is told or not.
    seen_into = is_open or any(not leaf.slides for leaf in thing.leaves)
    for hollow in thing.kind.hollows:
        if hollow.shut and not seen_into:
            continue
        a = np.array([-size[0] / 2, -size[1] / 2, 0.0]) + hollow.low * size
        b = np.array([-size[0] / 2, -size[1] / 2, 0.0]) + hollow.high * size
        containers.append(_container(hollow.name, a, b, _OPEN if hollow.shut and is_open else None))
    if is_open:
        joints[_OPEN] = 1.0
        drawn_joints.append(_joint(_OPEN))
    rules = [
        StateRule(state=name, joint=_OPEN, min=0.5)
        if name == "OPEN"
        else StateRule(state=name, variants=("default",))
        for name in thing.states
    ]
    info = AssetInfo(
        id=f"{SOURCE}_{thing.id}",
        category=thing.name,
        licence="CC0-1.0",
        source=SOURCE,
        extents_m=vec3(np.maximum(size, 1e-4)),
        outlines_m=outlines,
        mass_kg=1.0,
        parts=tuple(parts),
        joints=tuple(drawn_joints),
        variants={"default": tuple(part.name for part in parts)},
        states=tuple(rules),
        supports=tuple(_supports(thing, moved)),
        containers=tuple(containers),
    )
    item = ObjectInstance(
        id=thing.id,
        category=thing.name,
        asset=info.id,
        pose=Pose(position_m=position, quat_xyzw=round_quat(thing.quat)),
        room_id=0,
        joints=joints,
        states=thing.states,
        parts=info.variants["default"],
        fixed=thing.fixed,
    )
    return item, info


def _joint(name: str, axis: Vec3 = (1.0, 0.0, 0.0), far_m: float = 1.0) -> Joint:
    return Joint(name=name, type="prismatic", origin_m=(0, 0, 0), axis=axis, lower=0.0, upper=far_m)


def _container(name: str, low: Array, high: Array, shut_by: str | None = None) -> Container:
    size = np.maximum(high - low, 1e-4)
    return Container(
        name=name,
        part="body",
        center_m=vec3((low + high) / 2),
        size_m=vec3(size),
        closed_by=shut_by,
    )


def _supports(thing: Thing, origin: Array) -> list[Support]:
    if not thing.upright:
        return []
    out = []
    for k, level in enumerate(thing.levels):
        inner = level.outline.buffer(-DRAWN_IN_M, join_style="mitre")
        if inner.geom_type != "Polygon" or inner.is_empty:
            continue
        ring = shapely.get_coordinates(inner.exterior)[:-1]
        flat = np.column_stack([ring, np.full(len(ring), level.z_m)])
        own = (flat - origin) @ thing.turn
        polygon = tuple((float(x), float(y)) for x, y in own[:, :2])
        z = float(own[0, 2])
        out.append(Support(name=f"level_{k}", part="body", z_m=z, polygon_m=polygon))
    return out


def _corners(piece: Piece) -> Array:
    """The corners of a prism, (N, 3)."""
    ring = shapely.get_coordinates(piece.outline.exterior)[:-1]
    ends = [np.column_stack([ring, np.full(len(ring), z)]) for z in (piece.low, piece.high)]
    return np.concatenate(ends)


def _tuples(points: Array) -> tuple[tuple[float, float, float], ...]:
    return tuple(vec3(np.round(point, 5)) for point in points)
