"""From where an anomaly can be seen: proved by rays, pose by pose of the free space."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from pydantic import Field
from shapely.geometry import Polygon

from sdgen.cameras.gazes import (
    Glimpse,
    glimpse,
    most_pixels,
    of_parts,
    outdoors_glimpse,
    turns_of,
)
from sdgen.cameras.lens import Gaze, Lens
from sdgen.cameras.outdoors import outer_opening
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.sight import Cast, Hits
from sdgen.catalog.records import Catalog
from sdgen.geometry import Array, Vec2
from sdgen.hazards.twin import undone
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.scene import Anomaly, Coordinate, Record, Scene
from sdgen.truth.visibility import evidence_pixels_needed
from sdgen.vocabulary import EVIDENCE_PIXELS

Bools = npt.NDArray[np.bool_]

#: The lattice of poses: places so far apart, looking in so many directions, level and down and up.
SPACING_M = 0.5
HEADINGS = 12
PITCHES_DEG = (-30.0, 0.0, 30.0)
#: Rays that end nearer to each other than this, metres, saw the same surface.
_SAME_M = 0.01
OBSERVABILITY_FILE = "observability.json"


class Observable(Record):
    """From which poses one anomaly can be seen, and from which its twin looks different.

    Of each pitch, in the order of ``pitches_deg``, and of each place, in the order of
    ``positions_m``, a number: bit *k* says whether it is so for the heading k · 360° / ``headings``
    (counter-clockwise from x). ``best``: the pose that shows most of the evidence, as indices of
    place, pitch and heading; None where no pose of the lattice shows enough.
    """

    anomaly_id: str
    object_id: int
    seen: tuple[tuple[int, ...], ...]
    differs: tuple[tuple[int, ...], ...]
    poses_seen: int = Field(ge=0)
    poses_differ: int = Field(ge=0)
    best: tuple[int, int, int] | None


class Observability(Record):
    """``observability.json``: a certificate for each anomaly, for a camera like ``lens``."""

    lens: Lens
    spacing_m: Coordinate
    headings: int = Field(ge=1)
    pitches_deg: tuple[Coordinate, ...]
    positions_m: tuple[Vec2, ...]
    anomalies: tuple[Observable, ...]


@dataclass(frozen=True)
class Evidence:
    """What must be seen of an anomaly: glimpses, each with the pixels that are needed of it."""

    glimpses: tuple[tuple[Glimpse, int], ...]

    def shown(self, turns: Array, lens: Lens) -> tuple[Bools, Array]:
        """Whether all of it is seen from each eye with each camera's axes, (E, P), and how many
        pixels are of the first."""
        counts = [(found.pixels(turns, lens), needed) for found, needed in self.glimpses]
        enough = [pixels >= needed for pixels, needed in counts]
        return np.logical_and.reduce(enough), counts[0][0]


def evidence_from(
    library: Library, scene: Scene, cast: Cast, anomaly: Anomaly, eyes_m: Array, lens: Lens
) -> Evidence:
    """What of an anomaly is to be seen from eyes (E, 3), by rays: as
    :func:`~sdgen.truth.visibility.shows` asks for it of pictures."""

    def needed(pixels: int) -> int:
        return evidence_pixels_needed(lens.width, lens.height, pixels)

    def of(object_id: int, parts: Sequence[str]) -> Glimpse:
        item = scene.object(object_id)
        points, numbers = part_points(library, item, parts), part_numbers(library, item, parts)
        return glimpse(of_parts(cast, object_id, numbers), eyes_m, points)

    key = anomaly.object_id
    found = [(of(key, anomaly.evidence_parts), needed(anomaly.evidence_pixels_needed))]
    if anomaly.evidence_parts and anomaly.evidence_pixels_needed < EVIDENCE_PIXELS:
        found.append((of(key, ()), needed(EVIDENCE_PIXELS)))
    found += [(of(other, ()), needed(EVIDENCE_PIXELS)) for other in anomaly.evidence_objects]
    opening = outer_opening(scene.home, key)
    if anomaly.evidence_outdoors_needed and opening is not None:
        outdoors = outdoors_glimpse(cast, eyes_m, opening)
        found.append((outdoors, needed(anomaly.evidence_outdoors_needed)))
    return Evidence(tuple(found))


def differing(
    library: Library,
    scenes: tuple[Scene, Scene],
    casts: tuple[Cast, Cast],
    anomaly: Anomaly,
    eyes_m: Array,
    lens: Lens,
) -> Evidence:
    """What looks different from eyes (E, 3) where this anomaly is undone, around its object."""
    points = np.concatenate(
        [
            part_points(library, item, ())
            for scene in scenes
            for item in scene.objects
            if item.id == anomaly.object_id
        ]
    )

    def met(origins: Array, targets: Array) -> Bools:
        one, other = (cast(origins, targets) for cast in casts)
        return _differ(one, other)

    needed = evidence_pixels_needed(lens.width, lens.height, anomaly.evidence_pixels_needed)
    return Evidence(((glimpse(met, eyes_m, points), needed),))


def _differ(one: Hits, other: Hits) -> Bools:
    apart = np.nan_to_num(np.abs(one.distance_m - other.distance_m), nan=0.0)
    same = (one.object_id == other.object_id) & (one.part == other.part) & (apart < _SAME_M)
    return np.asarray(~same)


def lattice(scene: Scene, spacing_m: float = SPACING_M) -> tuple[Vec2, ...]:
    """Places of the free space on a square lattice, and one of each piece that none lies in."""
    rings = [Polygon(ring).buffer(0) for ring in scene.free_space]
    shape = shapely.union_all(rings)
    x0, y0, x1, y1 = shape.bounds
    xs = np.arange(math.ceil(x0 / spacing_m), math.floor(x1 / spacing_m) + 1) * spacing_m
    ys = np.arange(math.ceil(y0 / spacing_m), math.floor(y1 / spacing_m) + 1) * spacing_m
    x, y = (axis.ravel() for axis in np.meshgrid(xs, ys, indexing="ij"))
    inside = shapely.contains_xy(shape, x, y)
    points = [(round(a, 3), round(b, 3)) for a, b in zip(x[inside], y[inside], strict=True)]
    for room in scene.home.rooms:
        part = shape.intersection(Polygon(room.polygon_m))
        if not part.is_empty and not any(
            shapely.intersects_xy(part, *point) for point in points
        ):
            middle = part.representative_point()
            points.append((round(middle.x, 3), round(middle.y, 3)))
    return tuple(sorted(points))


def observability(
    library: Library,
    scene: Scene,
    anomalies: Sequence[Anomaly],
    catalog: Catalog,
    lens: Lens | None = None,
    spacing_m: float = SPACING_M,
    headings: int = HEADINGS,
    pitches_deg: Sequence[float] = PITCHES_DEG,
) -> Observability:
    """The certificates of a scene's anomalies for a camera (usual one when None)."""
    lens = lens or Lens()
    places = lattice(scene, spacing_m)
    eyes = np.array([(*place, lens.height_m) for place in places]).reshape(-1, 3)
    yaws = [k * 2 * math.pi / headings for k in range(headings)]
    turns = turns_of(yaws, [math.radians(pitch) for pitch in pitches_deg])
    grid = len(places), len(pitches_deg), headings
    out = []
    if anomalies:
        with RayWorld(library, scene) as world:
            for anomaly in anomalies:
                twin = undone(scene, [anomaly], catalog, library.infos)
                with RayWorld(library, twin) as other:
                    near = _near_enough(library, scene, anomaly, eyes, lens)
                    seen = evidence_from(library, scene, world.cast, anomaly, eyes[near], lens)
                    casts, scenes = (world.cast, other.cast), (scene, twin)
                    differs = differing(library, scenes, casts, anomaly, eyes[near], lens)
                    out.append(_record(anomaly, near, seen, differs, turns, grid, lens))
    return Observability(
        lens=lens,
        spacing_m=spacing_m,
        headings=headings,
        pitches_deg=tuple(pitches_deg),
        positions_m=places,
        anomalies=tuple(out),
    )


def _near_enough(
    library: Library, scene: Scene, anomaly: Anomaly, eyes_m: Array, lens: Lens
) -> npt.NDArray[np.int64]:
    """Indices of the eyes from which enough of an anomaly could be seen, if nothing hid it."""
    points = part_points(library, scene.object(anomaly.object_id), anomaly.evidence_parts)
    needed = evidence_pixels_needed(lens.width, lens.height, anomaly.evidence_pixels_needed)
    return np.flatnonzero(most_pixels(eyes_m, points, lens) >= needed)


def _record(
    anomaly: Anomaly,
    near: npt.NDArray[np.int64],
    seen: Evidence,
    differs: Evidence,
    turns: Array,
    grid: tuple[int, int, int],
    lens: Lens,
) -> Observable:
    """One certificate; ``grid`` counts places, pitches and headings."""
    places, pitches, headings = grid
    enough, pixels = seen.shown(turns, lens)
    other, _ = differs.shown(turns, lens)
    best = None
    if enough.any():
        row, column = np.unravel_index(int(np.where(enough, pixels, -1.0).argmax()), enough.shape)
        pitch, heading = divmod(int(column), headings)
        best = (int(near[row]), pitch, heading)
    return Observable(
        anomaly_id=anomaly.id,
        object_id=anomaly.object_id,
        seen=_packed(enough, near, grid),
        differs=_packed(other, near, grid),
        poses_seen=int(enough.sum()),
        poses_differ=int(other.sum()),
        best=best,
    )


def _packed(
    shown: Bools, near: npt.NDArray[np.int64], grid: tuple[int, int, int]
) -> tuple[tuple[int, ...], ...]:
    places, pitches, headings = grid
    bits = np.zeros((places, pitches), dtype=np.int64)
    each = shown.reshape(len(near), pitches, headings).astype(np.int64)
    bits[near] = each @ (1 << np.arange(headings, dtype=np.int64))
    return tuple(tuple(column) for column in bits.T.tolist())


def seen_at(found: Observability, rows: Sequence[Sequence[int]]) -> Bools:
    """The numbers of a certificate's poses as (places, pitches, headings)."""
    bits = np.array(rows, dtype=np.int64).reshape(len(found.pitches_deg), -1).T
    return np.asarray((bits[..., None] >> np.arange(found.headings)) & 1 == 1)


def gaze_of(found: Observability, pose: tuple[int, int, int]) -> Gaze:
    """A pose of the lattice by its indices of place, pitch and heading."""
    place, pitch, heading = pose
    yaw = math.remainder(heading * 2 * math.pi / found.headings, 2 * math.pi)
    return Gaze(*found.positions_m[place], yaw, math.radians(found.pitches_deg[pitch]))
