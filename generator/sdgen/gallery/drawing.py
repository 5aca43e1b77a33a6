"""A home seen from above, as shapes for an SVG."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from sdgen.geometry import Vec2, apply, box_corners
from sdgen.library.records import AssetInfo
from sdgen.scene import Camera, ObjectInstance, Scene
from sdgen.vocabulary import OPENINGS

#: SVG units a metre. Letters and lines (style.css.j2) are measured in these units: homes of 6 to
#: 12 m are 340 to 750 of them wide, about the pixels of their column on the page.
SCALE = 60.0
#: Around the rooms' outlines: windows reach 0.14 m beyond them, the rest is air.
MARGIN_M = 0.3


@dataclass(frozen=True)
class Shape:
    """A polygon of the drawing: what it is, its corners in SVG units, a tooltip, and of which
    object it is (None: of none)."""

    kind: str
    corners: tuple[Vec2, ...]
    title: str
    object_id: int | None = None

    @property
    def points(self) -> str:
        """The corners as SVG text."""
        return " ".join(f"{x},{y}" for x, y in self.corners)

    @property
    def middle(self) -> Vec2:
        """The middle of its box, in SVG units."""
        xs, ys = zip(*self.corners, strict=True)
        return round((min(xs) + max(xs)) / 2, 1), round((min(ys) + max(ys)) / 2, 1)


@dataclass(frozen=True)
class Mark:
    """A camera: where it stands and where it looks, in SVG units."""

    x: float
    y: float
    to_x: float
    to_y: float
    title: str


@dataclass(frozen=True)
class Drawing:
    """A home drawn from above: size in SVG units, shapes from the floor up, room names, cameras."""

    width: float
    height: float
    shapes: tuple[Shape, ...]
    names: tuple[tuple[float, float, str], ...]
    cameras: tuple[Mark, ...]
    corner_m: Vec2

    def at(self, point: Vec2) -> Vec2:
        """Where a point of the world is in the drawing."""
        (x, y), (x0, y1) = point, self.corner_m
        return round((x - x0) * SCALE, 1), round((y1 - y) * SCALE, 1)


def draw_home(
    scene: Scene,
    infos: Mapping[str, AssetInfo],
    cameras: tuple[Camera, ...],
    anomalies: Collection[int],
    lookalikes: Collection[int],
) -> Drawing:
    """A scene drawn from above, north up."""
    corners = [point for room in scene.home.rooms for point in room.polygon_m]
    x0 = min(x for x, _ in corners) - MARGIN_M
    y1 = max(y for _, y in corners) + MARGIN_M
    x1 = max(x for x, _ in corners) + MARGIN_M
    y0 = min(y for _, y in corners) - MARGIN_M

    def at(x: float, y: float) -> tuple[float, float]:
        return round((x - x0) * SCALE, 1), round((y1 - y) * SCALE, 1)

    def drawn(points: Sequence[Vec2]) -> tuple[Vec2, ...]:
        return tuple(at(x, y) for x, y in points)

    shapes = [Shape("room", drawn(room.polygon_m), room.type) for room in scene.home.rooms]
    shapes += [
        Shape("walkway", drawn(z.polygon_m), z.kind) for z in scene.zones if z.kind == "walkway"
    ]
    late = []

    def height(item: ObjectInstance) -> tuple[float, float, int]:
        """What lies below is drawn first: of what stands on the floor, the rugs."""
        return item.pose.position_m[2], infos[item.asset].extents_m[2], item.id

    for item in sorted(scene.objects, key=height):
        x, y, _ = infos[item.asset].extents_m
        box = box_corners((-x / 2, -y / 2, 0.0), (x / 2, y / 2, 0.0))[[0, 2, 6, 4]]
        world = item.pose.matrix()
        outline = [(float(p[0]), float(p[1])) for p in apply(world, box)]
        kind = "opening" if item.category in OPENINGS else "fixed" if item.fixed else "loose"
        shape = Shape(kind, drawn(outline), f"{item.category} {item.id}", item.id)
        if item.id in anomalies or item.id in lookalikes:
            marked = "anomaly" if item.id in anomalies else "lookalike"
            late.append(replace(shape, kind=marked))
        else:
            shapes.append(shape)
    return Drawing(
        width=round((x1 - x0) * SCALE, 1),
        height=round((y1 - y0) * SCALE, 1),
        shapes=tuple(shapes + late),
        names=tuple(_name(room.polygon_m, room.type, at) for room in scene.home.rooms),
        cameras=tuple(_mark(camera, at) for camera in cameras),
        corner_m=(x0, y1),
    )


def _name(
    outline: tuple[tuple[float, float], ...],
    name: str,
    at: Callable[[float, float], tuple[float, float]],
) -> tuple[float, float, str]:
    # Of a room that is no rectangle the corner of its box may lie in another room.
    y = max(p[1] for p in outline)
    x = min(p[0] for p in outline if p[1] == y)
    left, top = at(x, y)
    return left + 6, top + 16, name.replace("_", " ")


def _mark(camera: Camera, at: Callable[[float, float], tuple[float, float]]) -> Mark:
    pose = camera.world_from_camera
    x, y = pose[0][3], pose[1][3]
    here, there = at(x, y), at(x + 0.45 * pose[0][2], y + 0.45 * pose[1][2])
    return Mark(*here, *there, f"view {camera.index} ({camera.kind})")
