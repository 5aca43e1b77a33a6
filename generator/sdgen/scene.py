"""The frozen records everything speaks in, from home to frame.

A record that reaches a file is a pydantic model (strict, frozen, tuples); its JSON Schema is
committed under ``output/schema``. Numpy arrays live in :class:`Frame` only.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt
from pydantic import BaseModel, ConfigDict, Field

from sdgen.geometry import Array, Coordinate, Quat, Vec2, Vec3, matrix
from sdgen.rejection import Cause, Causes
from sdgen.rejection import Stage as PipelineStage
from sdgen.vocabulary import (
    EVIDENCE_PIXELS,
    DayTime,
    Facing,
    OpeningKind,
    Season,
    StructureKind,
    Weather,
    ZoneKind,
)

FORMAT_VERSION = "1.1"

Notify = Literal["now", "summary", "silent"]
EvidenceValue = bool | int | float | str

#: Ids of nodes are pixels of the instance mask: 16 bits wide, 0 is nothing.
LARGEST_ID = 65535


def twin_id(scene_id: str) -> str:
    """The id of a scene's benign twin."""
    return f"{scene_id}-twin"


def anomaly_id(number: int) -> str:
    """The id of a scene's anomaly by its number, from 0."""
    return f"a{number:02d}"


def toggle_id(scene_id: str, anomaly_id: str) -> str:
    """The id of the scene in which this anomaly alone is undone."""
    return f"{scene_id}-undo-{anomaly_id}"


class Record(BaseModel):
    """Base of all records: frozen, unknown keys are errors."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Pose(Record):
    """``world_from_object``: position in metres, unit quaternion xyzw."""

    position_m: Vec3
    quat_xyzw: Quat

    def matrix(self) -> Array:
        """``world_from_object`` as a (4, 4) matrix for column vectors."""
        return matrix(self.position_m, self.quat_xyzw)


class Box(Record):
    """An axis-aligned box in the world."""

    center_m: Vec3
    size_m: Vec3


class Room(Record):
    """A room: its inner floor outline, counter-clockwise, and what it is for."""

    id: int
    name: str
    type: str
    polygon_m: tuple[Vec2, ...]
    height_m: Coordinate


class Band(Record):
    """A part of a wall that wears a surface of its own: of the faces that look ``facing``, from
    ``low_m`` to ``high_m`` (along the wall, and up), metres in the world."""

    surface: str
    facing: Facing
    low_m: Vec2
    high_m: Vec2


class Structure(Record):
    """A floor, a wall or a ceiling of one room, as boxes with openings already cut out, and of a
    wall the bands that wear another surface than the rest."""

    id: int
    category: StructureKind
    room_id: int
    surface: str
    pieces: tuple[Box, ...]
    bands: tuple[Band, ...] = ()


class Opening(Record):
    """A doorway or a window; ``object_id`` is the door or window object that fills it.

    ``room_ids`` has two rooms, or one when the other side is outdoors. ``center_m`` lies on the
    floor for doors, on the sill line for windows, in the middle of the wall; ``along`` is the
    axis of the wall it sits in.
    """

    object_id: int
    kind: OpeningKind
    room_ids: tuple[int, ...]
    center_m: Vec3
    along: Literal["x", "y"]
    width_m: Coordinate
    height_m: Coordinate


class Zone(Record):
    """A region with a meaning: an upright prism over ``polygon_m`` between two heights."""

    name: str
    kind: ZoneKind
    polygon_m: tuple[Vec2, ...]
    z_min_m: Coordinate
    z_max_m: Coordinate
    room_id: int
    source_id: int | None = None


class Outdoors(Record):
    """What is seen through the windows of a home: how high up it lies (0: at the ground), when,
    and ``variant``: which of the worlds that are so."""

    storey: int = Field(default=0, ge=0, le=20)
    season: Season = "summer"
    weather: Weather = "clear"
    variant: int = Field(default=0, ge=0)


class Daylight(Record):
    """When a home is seen, and where the sun stands then: its azimuth from +x towards +y, and how
    high it is. By night there is none, and in the evening and by night ceiling lamps are on."""

    time: DayTime = "day"
    sun_azimuth_deg: float = Field(default=225.0, ge=0.0, lt=360.0)
    sun_elevation_deg: float = Field(default=35.0, ge=0.0, le=90.0)


class Home(Record):
    """Rooms and their shell, before anything stands in them, and the style they share."""

    id: str
    kind: Literal["base", "procedural"]
    style: str = ""
    outdoors: Outdoors = Outdoors()
    daylight: Daylight = Daylight()
    rooms: tuple[Room, ...]
    structures: tuple[Structure, ...]
    openings: tuple[Opening, ...]


class ObjectInstance(Record):
    """One asset in the world. States and parts follow from variant and joints."""

    id: int
    category: str
    asset: str
    pose: Pose
    room_id: int
    joints: dict[str, Coordinate] = Field(default_factory=dict)
    variant: str = "default"
    states: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()
    fixed: bool = False


class AgentStart(Record):
    """Where an agent begins: a point of the free space and a heading."""

    position_m: Vec3
    yaw_rad: Coordinate
    room_id: int


class Scene(Record):
    """``scene.json``: everything needed to evaluate every label again, with ``assets.jsonl``."""

    format_version: str = FORMAT_VERSION
    id: str
    index: int
    home: Home
    zones: tuple[Zone, ...]
    free_space: tuple[tuple[Vec2, ...], ...]
    agent_start: AgentStart
    objects: tuple[ObjectInstance, ...]
    twin_of: str | None = None

    def object(self, object_id: int) -> ObjectInstance:
        """The object with this id (KeyError when there is none)."""
        for item in self.objects:
            if item.id == object_id:
                return item
        raise KeyError(object_id)


class Remedy(Record):
    """One step that undoes an anomaly."""

    action: str
    object_id: int
    target_id: int | None = None


class Anomaly(Record):
    """One instance of a hazard, with the measured terms that prove it.

    It is ``drawn`` when the scene was asked for it; else what was put there for another hazard is
    this one, too. A view shows it with ``evidence_pixels_needed``, at 640 x 480, of
    ``evidence_parts``, with 100 of the whole object and of each of ``evidence_objects`` (the heater
    that the laundry is near), and with ``evidence_outdoors_needed`` of the outdoors seen through
    the opening that the object fills.
    """

    id: str
    hazard: str
    group: str
    label: str
    object_id: int
    category: str
    states: tuple[str, ...]
    relation: str | None
    target_id: int | None
    room_id: int
    drawn: bool = True
    evidence: dict[str, EvidenceValue]
    evidence_parts: tuple[str, ...]
    evidence_objects: tuple[int, ...] = ()
    evidence_pixels_needed: int = Field(default=EVIDENCE_PIXELS, ge=1)
    evidence_outdoors_needed: int = Field(default=0, ge=0)
    report: bool
    notify: Notify
    reason: str
    urgency: str
    severity: str | None = None
    message: str
    remedy: tuple[Remedy, ...]


class Lookalike(Record):
    """A benign near miss of a hazard."""

    object_id: int
    near_miss_of: str
    evidence: dict[str, EvidenceValue]


class Undone(Record):
    """What became of one anomaly in a twin.

    ``action`` undid it: a word of its hazard's remedies, or ``take_away`` where none of them could
    be carried out; None where what was done to another thing was enough. ``target_id`` is what its
    object was put on or into (a floor where it was moved away); ``moved`` says that it is
    elsewhere, ``removed`` that it is gone.
    """

    anomaly_id: str
    hazard: str
    object_id: int
    action: str | None
    target_id: int | None = None
    moved: bool = False
    removed: bool = False


class Certificate(Record):
    """What was checked: every (object, enabled hazard) pair, none within the dead band."""

    hazards_enabled: tuple[str, ...]
    catalogue_sha256: str
    assets_sha256: str
    pairs_checked: int
    pairs_positive: int


class Anomalies(Record):
    """``anomalies.json``. ``undone``: of a twin, what became of the anomalies of its scene."""

    anomalies: tuple[Anomaly, ...]
    lookalikes: tuple[Lookalike, ...]
    certificate: Certificate
    undone: tuple[Undone, ...] = ()


class Member(Record):
    """Somebody who lives in the home."""

    role: str
    age: int = Field(ge=0, le=120)


class Household(Record):
    """``household.json``: who lives there and what they want reported."""

    template: str
    members: tuple[Member, ...]
    pets: tuple[str, ...] = ()
    conditions: tuple[str, ...] = ()
    notifications: dict[str, Notify] = Field(default_factory=dict)
    opt_outs: tuple[str, ...] = ()


class Look(Record):
    """What the camera of one colour picture did to the light that met it, in this order.

    In linear light: times two to the ``exposure_stops`` and the gains of red, green and blue;
    ``vignetting`` is the share that corners lose, by a cos⁴ law; a Gaussian of ``focus_px``
    (standard deviation) and a streak of ``motion_px`` along the rows blur it; noise has the
    standard deviation ``shot_noise`` × √light and ``read_noise``, both as shares of white.
    """

    exposure_stops: float = Field(ge=-3.0, le=3.0)
    white_balance: tuple[float, float, float]
    vignetting: float = Field(ge=0.0, lt=1.0)
    focus_px: float = Field(ge=0.0, le=256.0)
    motion_px: float = Field(ge=0.0, le=256.0)
    shot_noise: float = Field(ge=0.0, le=1.0)
    read_noise: float = Field(ge=0.0, le=1.0)
    noise_seed: int = Field(ge=0, lt=2**32)


class Turn(Record):
    """Which of ``of`` views a view is that one camera takes in one place, turning left by equal
    steps: ``step`` counts from 0."""

    step: int = Field(ge=0)
    of: int = Field(ge=1)


class Camera(Record):
    """``view.json``: an OpenCV camera; ``K`` is for pixel centres at integer coordinates, and
    nothing of the scene or its twins is before it at less than ``near_m``.

    ``kind``: an overview of a room, something seen from near by, or one of a ``turn`` in the middle
    of a room. ``daylight``: the hour at which it looks, and where the sun stands. ``look``: what
    the camera did to the colours; null for a perfect one.
    """

    index: int
    kind: Literal["room", "near", "turn"]
    room_id: int
    width: int
    height: int
    K: tuple[Vec3, Vec3, Vec3]
    world_from_camera: tuple[
        Quat,
        Quat,
        Quat,
        Quat,
    ]
    near_m: Coordinate
    far_m: Coordinate
    daylight: Daylight | None = None
    turn: Turn | None = None
    look: Look | None = None


class Panorama(Record):
    """``panorama.json``: all that is seen from one place, as an equirectangular picture stitched
    from the ``views`` of a turn.

    ``world_from_panorama`` is the pose of an OpenCV camera (x right, y down, z forward) that looks
    into the picture's middle. Pixel (u, v) shows what lies so far to the right of that and above
    the horizon: 2π (u − (width − 1) / 2) / width and π ((height − 1) / 2 − v) / height.
    """

    index: int
    room_id: int
    views: tuple[int, ...]
    width: int
    height: int
    world_from_panorama: tuple[Quat, Quat, Quat, Quat]
    look: Look | None = None


class VisibleObject(Record):
    """How much of an object one view shows. ``bbox`` is [x, y, w, h], half-open pixels.

    ``fraction`` = visible pixels / pixels of the object alone; ``parts`` counts pixels by part.
    """

    object_id: int
    bbox: tuple[int, int, int, int]
    pixels: int
    fraction: float
    parts: dict[str, int]


class ViewVisibility(Record):
    """The objects one view shows, sorted by id.

    ``outdoors`` counts the pixels of nothing, which is what lies outdoors, that are seen through
    openings of the outer walls, by the id of what fills the opening; those with any. Of each row
    of a picture those that lie 6 or more beside each other count (at a width of 640): narrower
    strips tell nobody that a door is open. None: an older data set does not tell.
    """

    view: int
    objects: tuple[VisibleObject, ...]
    outdoors: dict[int, int] | None = None


class AnomalyVisibility(Record):
    """Pixels of an anomaly's evidence parts in each view."""

    anomaly_id: str
    object_id: int
    evidence_pixels: tuple[int, ...]


class Visibility(Record):
    """``visibility.json``."""

    views: tuple[ViewVisibility, ...]
    anomalies: tuple[AnomalyVisibility, ...]
    evidence_pixels_needed: int
    all_visible: bool


class ObjTransform(Record):
    """Where a node is; VirtualHome's keys: position in metres, rotation xyzw, scale."""

    position: Vec3
    rotation: Quat
    scale: Vec3 = (1.0, 1.0, 1.0)


class BoundingBox(Record):
    """A node's axis-aligned box in the world (metres), from the visual mesh."""

    center: Vec3
    size: Vec3


class GraphNode(Record):
    """A room, structure, door or object, with VirtualHome's keys and our ``tags``."""

    id: int = Field(ge=1, le=LARGEST_ID)
    class_name: str
    category: str
    prefab_name: str
    obj_transform: ObjTransform
    bounding_box: BoundingBox
    properties: tuple[str, ...] = ()
    states: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()


class GraphEdge(Record):
    """A relation between two nodes, with VirtualHome's keys."""

    from_id: int
    to_id: int
    relation_type: str


class Graph(Record):
    """``graph.json``: nodes sorted by id, edges by (from, to, relation)."""

    nodes: tuple[GraphNode, ...]
    edges: tuple[GraphEdge, ...]


class Violation(Record):
    """A failed plausibility check, as a value."""

    check: str
    objects: tuple[int, ...]
    measured: float
    limit: float


class Contact(Record):
    """Two bodies that touch at rest."""

    a: int
    b: int
    distance_m: Coordinate


class CauseCount(Record):
    """How often one cause threw a try away, or had a small thing taken away."""

    stage: PipelineStage
    check: str
    hazard: str | None
    category: str | None
    other: str | None
    state: str | None
    count: int = Field(ge=1)


def cause_counts(causes: Causes) -> tuple[CauseCount, ...]:
    """Counted causes as they are written, sorted."""
    return tuple(
        CauseCount(**cause._asdict(), count=causes[cause])
        for cause in sorted(causes, key=Cause.sort_key)
    )


def causes_of(counts: Iterable[CauseCount]) -> Counter[Cause]:
    """Counted causes as they are added up."""
    return Counter({Cause(**c.model_dump(exclude={"count"})): c.count for c in counts})


class PhysicsReport(Record):
    """``physics.json``: how the scene came to rest, and after how many tries.

    ``rejections`` counts the tries that were thrown away, ``taken_away`` the small things and
    lookalikes that the last one lost.
    """

    settled_drift_m: dict[str, Coordinate]
    contacts: tuple[Contact, ...]
    steps: int
    home_attempts: int
    placement_attempts: int
    rejections: tuple[CauseCount, ...]
    taken_away: tuple[CauseCount, ...]


@dataclass(frozen=True)
class Frame:
    """What one camera saw.

    ``rgb`` (H, W, 3) uint8; ``depth_mm`` (H, W) uint16, planar Z, 0 = none; ``instance``
    (H, W) uint16 node ids, 0 = nothing; ``part`` (H, W) uint8, 1-based index into the object's
    drawn ``parts``, 0 for structures. ``alone_pixels`` maps object id to the pixels it would
    cover with nothing in front of it.
    """

    camera: Camera
    rgb: npt.NDArray[np.uint8]
    depth_mm: npt.NDArray[np.uint16]
    instance: npt.NDArray[np.uint16]
    part: npt.NDArray[np.uint8]
    alone_pixels: dict[int, int]


@dataclass(frozen=True)
class SceneBundle:
    """All of one finished scene but its pixels, ready to be drawn and written; ``twin`` is its
    benign one and ``toggles`` are those with one anomaly undone, where they were asked for."""

    scene: Scene
    graph: Graph
    anomalies: Anomalies
    household: Household
    physics: PhysicsReport
    split: str
    cameras: tuple[Camera, ...]
    panoramas: tuple[Panorama, ...] = ()
    twin: SceneBundle | None = None
    toggles: tuple[SceneBundle, ...] = ()

    @property
    def twins(self) -> tuple[SceneBundle, ...]:
        """All that is written beside the scene: its benign twin, and those with one undone."""
        return self.toggles if self.twin is None else (self.twin, *self.toggles)
