"""From where an anomaly can be seen: proved by rays, pose by pose of the free space."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.cameras.gazes import (
    Glimpse,
    glimpse,
    most_pixels,
    of_parts,
    outdoors_glimpse,
    turns_of,
)
from sdgen.cameras.lens import Lens
from sdgen.cameras.outdoors import outer_opening
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.portals import Portals
from sdgen.cameras.sight import Cast, Hits
from sdgen.catalog.records import Catalog
from sdgen.freespace import lattice_points
from sdgen.geometry import Array, Vec2
from sdgen.hazards.twin import undone
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.physics.still import Still
from sdgen.scene import Anomaly, Scene
from sdgen.truth.observable import Observability, Observable
from sdgen.truth.visibility import evidence_pixels_needed
from sdgen.vocabulary import EVIDENCE_PIXELS

Bools = npt.NDArray[np.bool_]

#: The lattice of poses: places so far apart, looking in so many directions, level and down and up.
SPACING_M = 0.5
HEADINGS = 12
PITCHES_DEG = (-30.0, 0.0, 30.0)
#: Rays that end nearer to each other than this, metres, saw the same surface.
_SAME_M = 0.01
#: In place of no distance at all.
_FAR_M = 1e3
#: So many times the pixels that are needed are surely enough, however a picture's pixels fall.
SURELY = 1.5


@dataclass(frozen=True)
class Evidence:
    """What must be seen of an anomaly: glimpses, each with the pixels that are needed of it."""

    glimpses: tuple[tuple[Glimpse, int], ...]

    def shown(self, turns: Array, lens: Lens) -> Array:
        """How many times what is needed of it is seen from each eye with each camera's axes,
        (E, P): of the least of its parts, 1 and more is enough."""
        times = [found.pixels(turns, lens) / needed for found, needed in self.glimpses]
        return np.asarray(np.stack(times).min(axis=0))


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
    far, other_far = (np.minimum(hits.distance_m, _FAR_M) for hits in (one, other))
    same = (one.object_id == other.object_id) & (one.part == other.part)
    return np.asarray(~(same & (np.abs(far - other_far) < _SAME_M)))


def lattice(scene: Scene, spacing_m: float = SPACING_M) -> tuple[Vec2, ...]:
    """Places of the free space on a square lattice, and one of each piece that none lies in."""
    rings = [Polygon(ring).buffer(0) for ring in scene.free_space]
    shape = shapely.union_all(rings)
    points = [(round(x, 3), round(y, 3)) for x, y in lattice_points(shape, spacing_m)]
    for room in scene.home.rooms:
        part = shape.intersection(Polygon(room.polygon_m))
        if not part.is_empty and not any(shapely.intersects_xy(part, *point) for point in points):
            middle = part.representative_point()
            points.append((round(middle.x, 3), round(middle.y, 3)))
    return tuple(sorted(points))


def observability(
    library: Library,
    scene: Scene,
    anomalies: Sequence[Anomaly],
    catalog: Catalog,
    lens: Lens | None = None,
    still: Still | None = None,
    spacing_m: float = SPACING_M,
    headings: int = HEADINGS,
    pitches_deg: Sequence[float] = PITCHES_DEG,
) -> Observability:
    """The certificates of a scene's anomalies for a camera (the usual one when None). ``still``
    lends a world to cast rays in."""
    lens = lens or Lens()
    places = lattice(scene, spacing_m)
    eyes = np.array([(*place, lens.height_m) for place in places]).reshape(-1, 3)
    yaws = [k * 2 * math.pi / headings for k in range(headings)]
    turns = turns_of(yaws, [math.radians(pitch) for pitch in pitches_deg])
    grid = len(places), len(pitches_deg), headings
    out = []
    if anomalies:
        portals = Portals(scene.home)
        rooms = [portals.rooms_around(place) for place in places]
        with RayWorld(library, scene, still) as world:
            for anomaly in anomalies:
                twin = undone(scene, [anomaly], catalog, library.infos)
                with RayWorld(library, twin) as other:
                    near = _near_enough(library, scene, anomaly, eyes, rooms, lens)
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
    library: Library,
    scene: Scene,
    anomaly: Anomaly,
    eyes_m: Array,
    rooms: Sequence[frozenset[int]],
    lens: Lens,
) -> npt.NDArray[np.int64]:
    """Indices of the eyes from which enough of an anomaly could be seen, if no furniture hid it;
    ``rooms`` are those of which each sees something."""
    item = scene.object(anomaly.object_id)
    points = part_points(library, item, anomaly.evidence_parts)
    needed = evidence_pixels_needed(lens.width, lens.height, anomaly.evidence_pixels_needed)
    (x0, y0), (x1, y1) = points[:, :2].min(axis=0).tolist(), points[:, :2].max(axis=0).tolist()
    around = set(Portals(scene.home).around((x0, y0), (x1, y1), item.room_id))
    open_to = np.array([not around.isdisjoint(seen) for seen in rooms], dtype=np.bool_)
    return np.flatnonzero(open_to & (most_pixels(eyes_m, points, lens) >= needed))


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
    headings = grid[2]
    times, other = seen.shown(turns, lens), differs.shown(turns, lens) >= 1.0
    enough = times >= 1.0
    best = None
    if enough.any():
        row, column = np.unravel_index(int(times.argmax()), times.shape)
        pitch, heading = divmod(int(column), headings)
        best = (int(near[row]), pitch, heading)
    return Observable(
        anomaly_id=anomaly.id,
        object_id=anomaly.object_id,
        seen=_packed(enough, near, grid),
        sure=_packed(times >= SURELY, near, grid),
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
