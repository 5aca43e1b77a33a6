"""Which cameras a scene gets, and whether every anomaly can be seen; by rays, never by pixels.

A fixed number of near views a scene, hazard-free ones too: first every anomaly, then benign
things of the categories that anomalies have. Each benign view draws a hazard class, whether or not
the scene has it, and then a thing like that class's anomalies; so neither the number of near views
nor what they are centred on tells anything.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sdgen.cameras.near import PIXELS_NEEDED, Target, best_near_pose
from sdgen.cameras.overview import room_views
from sdgen.cameras.parts import part_area
from sdgen.cameras.sight import Cast
from sdgen.cameras.view import View, to_cameras
from sdgen.catalog.records import Catalog, Hazard
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M, BuildOptions
from sdgen.scene import Anomaly, Camera, Lookalike, Scene
from sdgen.seeding import Rng, lane, weighted_keys

#: Near views are what small anomalies are seen in; the rest are overviews, which place them.
NEAR_SHARE = 2 / 3
#: How often a benign near view prefers a lookalike: as often as not, so that neither is a sign.
LOOKALIKE_SHARE = 0.5
#: Surface of a small thing, a knife or a mug; larger ones must show more pixels.
SMALL_M2 = 0.02
#: Enough to tell a wardrobe: 2 % of a picture of 640x480. More would refuse most views of it.
GLANCE_MOST = 6000.0
#: Anomalies lie lower than this, and so must the benign things that share their near views: else
#: upturned cameras would tell how few anomalies a scene has. One more near view, the same in every
#: scene, is for what lies higher: knives on a shelf, open wall cabinets.
LOW_M = 1.25
#: High things looked at before their view becomes one more overview.
HIGH_TRIED = 8
#: Overviews that a scene keeps when it gets that view.
OVERVIEWS_KEPT = 2
#: Draws of candidate views of an anomaly before its scene is thrown away, which costs a hundred
#: times more. Of benign things there are others.
ANOMALY_ROUNDS = 3
#: Things looked for: like one class's anomalies, and in all before near views are given up.
CLASS_TRIED = 4
BENIGN_TRIED = 40


def near_count(options: BuildOptions) -> int:
    """Near views of every scene: two thirds, enough for the most anomalies, one overview left."""
    wanted = max(round(options.views * NEAR_SHARE), options.hazards_max)
    return max(0, min(options.views - 1, wanted))


def high_count(options: BuildOptions) -> int:
    """Near views of things that lie higher than :data:`LOW_M` in every scene."""
    return 1 if options.views - near_count(options) > OVERVIEWS_KEPT else 0


def glance_pixels(surface_m2: float) -> float:
    """Pixels at 640x480 that tell a thing at a glance, in proportion to what can be seen of it.

    A quarter of its surface is what a convex thing shows on average. Twice the promised 100 for
    small things; large ones must show more than a sliver.
    """
    shown = surface_m2 / 4
    return min(max(PIXELS_NEEDED, PIXELS_NEEDED * shown / SMALL_M2), GLANCE_MOST)


class Sight:
    """Near views of one scene's objects, each from a random lane of its own, found once."""

    def __init__(
        self,
        library: Library,
        scene: Scene,
        cast: Cast,
        seed: int,
        eye_height_m: float = EYE_HEIGHT_M,
    ) -> None:
        self._library = library
        self._scene = scene
        self._cast = cast
        self._seed = seed
        self._eye_height_m = eye_height_m
        self._found: dict[tuple[int, tuple[str, ...], int], View | None] = {}

    @property
    def scene(self) -> Scene:
        """What is looked at."""
        return self._scene

    def at(self, eye_height_m: float) -> Sight:
        """The same from another eye height."""
        if eye_height_m == self._eye_height_m:
            return self
        return Sight(self._library, self._scene, self._cast, self._seed, eye_height_m)

    def anomaly(self, anomaly: Anomaly) -> View | None:
        """The best near view of an anomaly's evidence, searched for longer than others."""
        return self.near(anomaly.object_id, anomaly.evidence_parts, ANOMALY_ROUNDS)

    def near(self, object_id: int, parts: tuple[str, ...] = (), rounds: int = 1) -> View | None:
        """The best near view of an object's parts, or None when ``rounds`` of candidates show too
        little."""
        key = (object_id, parts, rounds)
        if key not in self._found:
            self._found[key] = best_near_pose(
                self._library,
                self._scene,
                self._cast,
                Target(object_id, parts),
                lane(self._seed, self._scene.index, f"near:{object_id}"),
                self._eye_height_m,
                glance_pixels(part_area(self._library, self._scene.object(object_id), parts)),
                rounds,
            )
        return self._found[key]

    def rooms(self, count: int, rng: Rng) -> tuple[View, ...]:
        """Overviews of the rooms in turn."""
        return room_views(self._scene, self._cast, count, rng, self._eye_height_m)


def unseen(sight: Sight, anomalies: Sequence[Anomaly]) -> Anomaly | None:
    """The first anomaly that has no near view. ``sight`` at the usual eye height: an option of
    pictures must not decide content."""
    for anomaly in anomalies:
        if sight.anomaly(anomaly) is None:
            return anomaly
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
    for anomaly in anomalies:
        if len(views) == wanted:
            break
        view = sight.anomaly(anomaly)
        if view is not None:
            views.append(view)
    views += _benign_views(sight, catalog, anomalies, lookalikes, wanted - len(views), rng)
    if high_count(options):
        views += _high_view(sight, lookalikes, rng)
    views += sight.rooms(options.views - len(views), rng)
    return to_cameras(views, (options.width, options.height), rng)


def _benign_views(
    sight: Sight,
    catalog: Catalog,
    anomalies: Sequence[Anomaly],
    lookalikes: Sequence[Lookalike],
    count: int,
    rng: Rng,
) -> list[View]:
    """Near views of ``count`` benign things, each like the anomalies of a drawn class."""
    left = {
        item.id: item.category for item in sight.scene.objects if item.pose.position_m[2] <= LOW_M
    }
    for anomaly in anomalies:
        left.pop(anomaly.object_id, None)
    near_miss_of = {item.object_id: item.near_miss_of for item in lookalikes}
    views: list[View] = []
    tried = 0
    while len(views) < count and left and tried < BENIGN_TRIED:
        hazard = catalog.hazards[int(rng.integers(len(catalog.hazards)))]
        for object_id in like_anomalies(hazard, left, near_miss_of, rng)[:CLASS_TRIED]:
            del left[object_id]
            tried += 1
            view = sight.near(object_id)
            if view is not None:
                views.append(view)
                break
    return views


def _high_view(sight: Sight, lookalikes: Sequence[Lookalike], rng: Rng) -> list[View]:
    """A near view of something that lies high, a lookalike if there is one; none if none shows."""
    high = [item.id for item in sight.scene.objects if item.pose.position_m[2] > LOW_M]
    order = [high[k] for k in rng.permutation(len(high)).tolist()]
    near_misses = {item.object_id for item in lookalikes}
    order.sort(key=lambda object_id: object_id not in near_misses)
    for object_id in order[:HIGH_TRIED]:
        view = sight.near(object_id)
        if view is not None:
            return [view]
    return []


def like_anomalies(
    hazard: Hazard, benign: Mapping[int, str], near_miss_of: Mapping[int, str], rng: Rng
) -> list[int]:
    """Ids of ``benign`` things (id to category) in the order in which they stand in for an anomaly.

    First those of its anomalies' categories, which follow the recipes' weights as anomalies do;
    then its lookalikes, then anything.
    """
    weight: dict[str, float] = {}
    for recipe in hazard.anomalies:
        for category in recipe.categories:
            weight[category] = weight.get(category, 0.0) + recipe.weight
    lookalikes_first = rng.random() < LOOKALIKE_SHARE
    ids = sorted(benign)
    drawn = dict(zip(ids, rng.random(len(ids)).tolist(), strict=True))
    names = sorted(weight)
    keys = weighted_keys(rng, [weight[name] for name in names]).tolist()
    key_of = dict(zip(names, keys, strict=True))

    def rank(object_id: int) -> tuple[float, ...]:
        category = benign[object_id]
        if category in key_of:
            plain = (object_id not in near_miss_of) == lookalikes_first
            return (0, -key_of[category], float(plain), drawn[object_id])
        own = near_miss_of.get(object_id) == hazard.id
        return (1 if own else 2, 0.0, 0.0, drawn[object_id])

    return sorted(ids, key=rank)
