"""Which cameras a scene gets, and whether every anomaly can be seen; by rays, never by pixels.

A fixed number of near views a scene, hazard-free ones too: first every anomaly, then lookalikes
and ordinary things of the same kinds, in a drawn order, so that a near view tells nothing.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.rays import RayWorld
from sdgen.render.cameras import (
    EYE_HEIGHT_M,
    PIXELS_NEEDED,
    Target,
    View,
    best_near_pose,
    room_views,
    to_cameras,
)
from sdgen.render.sight import part_points
from sdgen.scene import Anomaly, Camera, Lookalike, Scene
from sdgen.seeding import Rng, lane

NEAR_SHARE = 2 / 3
LOOKALIKE_SHARE = 0.5
SMALL_M = 0.2
GLANCE_MOST = 6000.0
#: Ordinary things looked at before the fixed number of near views is given up.
ORDINARY_TRIED = 30


def near_count(options: BuildOptions) -> int:
    """Near views of every scene: two thirds, enough for the most anomalies, one overview left."""
    wanted = max(round(options.views * NEAR_SHARE), options.hazards_max)
    return max(0, min(options.views - 1, wanted))


def glance_pixels(diagonal_m: float) -> float:
    """Pixels at 640x480 that tell a thing of this size at a glance.

    Twice the promised 100 for small things; large ones must show more than a sliver.
    """
    return min(max(PIXELS_NEEDED, PIXELS_NEEDED * (diagonal_m / SMALL_M) ** 2), GLANCE_MOST)


class Sight:
    """Near views of one scene's objects, each from a random lane of its own, found once."""

    def __init__(
        self,
        library: Library,
        scene: Scene,
        world: RayWorld,
        seed: int,
        eye_height_m: float = EYE_HEIGHT_M,
    ) -> None:
        self._library = library
        self._scene = scene
        self._world = world
        self._seed = seed
        self._eye_height_m = eye_height_m
        self._found: dict[tuple[int, tuple[str, ...]], View | None] = {}

    @property
    def scene(self) -> Scene:
        """What is looked at."""
        return self._scene

    def at(self, eye_height_m: float) -> Sight:
        """The same from another eye height."""
        if eye_height_m == self._eye_height_m:
            return self
        return Sight(self._library, self._scene, self._world, self._seed, eye_height_m)

    def near(self, object_id: int, parts: tuple[str, ...] = ()) -> View | None:
        """The best near view of an object's parts, or None when none shows enough."""
        key = (object_id, parts)
        if key not in self._found:
            points = part_points(self._library, self._scene.object(object_id), parts)
            self._found[key] = best_near_pose(
                self._library,
                self._scene,
                self._world.cast,
                Target(object_id, parts),
                lane(self._seed, self._scene.index, f"near:{object_id}"),
                self._eye_height_m,
                glance_pixels(float(np.linalg.norm(np.ptp(points, axis=0)))),
            )
        return self._found[key]

    def rooms(self, count: int, rng: Rng) -> tuple[View, ...]:
        """Overviews of the rooms in turn."""
        return room_views(self._scene, self._world.cast, count, rng, self._eye_height_m)


def unseen(sight: Sight, anomalies: Sequence[Anomaly]) -> str | None:
    """Reason of rejection when some anomaly has no near view. ``sight`` at the usual eye height:
    an option of pictures must not decide content."""
    for anomaly in anomalies:
        if sight.near(anomaly.object_id, anomaly.evidence_parts) is None:
            return f"{anomaly.hazard}: cannot be seen"
    return None


def choose_views(
    sight: Sight,
    catalog: Catalog,
    anomalies: Sequence[Anomaly],
    lookalikes: Sequence[Lookalike],
    options: BuildOptions,
) -> tuple[Camera, ...]:
    """The scene's cameras, numbered in a drawn order."""
    if options.views == 0:
        return ()
    sight = sight.at(options.eye_height_m)
    rng = lane(options.seed, sight.scene.index, "cameras")
    wanted = near_count(options)
    views: list[View] = []
    for target in _targets(sight.scene, catalog, anomalies, lookalikes, rng):
        if len(views) >= wanted:
            break
        view = sight.near(target.object_id, target.parts)
        if view is not None:
            views.append(view)
    views += sight.rooms(options.views - len(views), rng)
    return to_cameras(views, (options.width, options.height), rng)


def _targets(
    scene: Scene,
    catalog: Catalog,
    anomalies: Sequence[Anomaly],
    lookalikes: Sequence[Lookalike],
    rng: Rng,
) -> list[Target]:
    """Anomalies, then lookalikes and ordinary things mixed; the latter mostly of the categories
    that hazards are about."""
    out = [Target(a.object_id, a.evidence_parts) for a in anomalies]
    taken = {a.object_id for a in anomalies} | {one.object_id for one in lookalikes}
    telling = {
        category
        for hazard in catalog.hazards
        for recipe in (*hazard.anomalies, *hazard.lookalikes)
        for category in recipe.categories
    }
    ordinary = [item for item in scene.objects if item.id not in taken]
    order = rng.permutation(len(ordinary)).tolist()
    first = [k for k in order if ordinary[k].category in telling]
    rest = [k for k in order if ordinary[k].category not in telling]
    mixed = [ordinary[k].id for pair in zip(first, rest, strict=False) for k in pair]
    benign = [one.object_id for one in lookalikes]
    benign = [benign[k] for k in rng.permutation(len(benign)).tolist()]
    plain = mixed[:ORDINARY_TRIED]
    while benign or plain:
        source = benign if benign and (not plain or rng.random() < LOOKALIKE_SHARE) else plain
        out.append(Target(source.pop(0)))
    return out
