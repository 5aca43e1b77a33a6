"""One unique anomaly by itself in one home: put there, let settle, proved, seen and undone.

As in a scene, but nothing everyday is added: anomalies come before clutter, which makes way. And
a home has no views of its own, which by chance look elsewhere: a thing must be seen from around it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import compress

import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.choice import shows
from sdgen.cameras.parts import part_points
from sdgen.cameras.posts import views_of
from sdgen.cameras.view import View, clear
from sdgen.catalog.records import UniqueAnomaly
from sdgen.facts import Facts
from sdgen.hazards.inject import inject_unique
from sdgen.hazards.labels import anomaly_records
from sdgen.hazards.placing import Injected
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.physics.world import World
from sdgen.pipeline.attempt import Proved, prove
from sdgen.pipeline.contents import Contents, culprits
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.overlook import marked_as
from sdgen.pipeline.spec import node_ids
from sdgen.pipeline.undoing import check_standing, check_undone
from sdgen.rejection import Rejection, reject
from sdgen.scene import Anomaly, Household
from sdgen.seeding import Rng

#: Eyes around a thing: where some of them stand behind furniture, others see it.
EYES = 8


@dataclass(frozen=True)
class Fits:
    """An anomaly in its place: the facts of the scene that holds it, its record, and views that
    show it."""

    facts: Facts
    anomaly: Anomaly
    views: tuple[View, ...]


class TrialHome:
    """A furnished home in which anomalies are tried one after another, each from
    the home as it stands.

    ``clients`` are two: one for what moves, one for what is asked of the scene at rest.
    """

    def __init__(
        self,
        home: FurnishedHome,
        household: Household,
        library: Library,
        clients: tuple[Client, Client],
    ) -> None:
        self.home = home
        self._household = household
        self._library = library
        self._own, self._client = clients

    @cached_property
    def _free(self) -> BaseGeometry:
        """Where eyes may stand."""
        free = shapely.union_all([Polygon(ring) for ring in self.home.free_space])
        shapely.prepare(free)
        return free

    def attempt(self, unique: UniqueAnomaly, rng: Rng) -> Fits | Rejection | None:
        """Try to make this anomaly here, once; None where the home has nothing for it."""
        home = self.home
        layout = home.layout.copy(node_ids(rng, taken=home.ids))
        for item in home.things.items:
            layout.put(item, home.things.intents.get(item.id))
        injected = inject_unique(unique, layout, home.context, rng)
        if injected is None or isinstance(injected, Rejection):
            return injected
        labelled = [Injected(name, key, None) for key, name in home.things.anomalies.items()]
        anomalies = culprits([*labelled, injected])
        contents = Contents(dict(layout.items), dict(layout.intents), anomalies, lookalikes={})
        # A world of its own: where things come to rest follows from nothing tried before.
        world = World(self._library, self._own)
        proved = prove(0, home, contents, self._library, world)
        if isinstance(proved, Rejection):
            return proved
        return self._finished(proved, (injected.object_id, unique.hazard), rng)

    def _finished(self, proved: Proved, pair: tuple[int, str], rng: Rng) -> Fits | Rejection:
        """What remains of a scene's checks: it can be seen, and its twin is sound."""
        home, library, facts = self.home, self._library, proved.facts
        catalog, scene = home.context.catalog, facts.scene
        anomalies = anomaly_records(
            proved.surveyed.positives, facts, catalog, self._household, proved.drawn
        )
        asked = anomalies[[(one.object_id, one.hazard) for one in anomalies].index(pair)]
        views = self._views(facts, anomalies, asked, rng)
        if not views:
            return reject("views", "unseen", hazard=asked.hazard, objects=(asked.object_id,))
        undone = check_undone(scene, anomalies, catalog, library.infos, facts)
        if isinstance(undone, Rejection):
            return undone
        broken = check_standing(scene, undone[0], library, self._client)
        if broken is not None:
            return broken
        return Fits(facts, asked, views)

    def _views(
        self, facts: Facts, anomalies: Sequence[Anomaly], asked: Anomaly, rng: Rng
    ) -> tuple[View, ...]:
        """Views from around the thing that was asked for that show all that is to be seen."""
        library, scene = self._library, facts.scene
        points = part_points(library, scene.object(asked.object_id), asked.evidence_parts)
        views = views_of(points, self._free, rng, EYES)
        with RayWorld(library, scene, self._client.still) as world:
            views = list(compress(views, clear(world.cast, views)))
            marked = [marked_as(one) for one in anomalies]
            shown = shows(library, scene, world.cast, views, marked)
        return tuple(view for view, row in zip(views, shown, strict=True) if row.all())
