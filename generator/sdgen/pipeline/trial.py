"""One unique anomaly by itself in one home: put there, let settle, proved, seen and undone.

As in a scene, but nothing everyday is added: anomalies come before clutter, which makes way.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from sdgen.cameras.cover import CANONICAL
from sdgen.cameras.framing import Bools
from sdgen.cameras.view import View
from sdgen.catalog.records import UniqueAnomaly
from sdgen.facts import Facts
from sdgen.hazards.inject import inject_unique
from sdgen.hazards.labels import anomaly_records
from sdgen.hazards.placing import Injected
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.physics.world import World
from sdgen.pipeline.attempt import Proved, prove
from sdgen.pipeline.contents import Contents, culprits
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.overlook import shown_by_views
from sdgen.pipeline.spec import node_ids
from sdgen.pipeline.undoing import check_standing, check_undone
from sdgen.rejection import Rejection
from sdgen.scene import Anomaly, Household
from sdgen.seeding import Rng


@dataclass(frozen=True)
class Fits:
    """An anomaly in its place: the facts of the scene that holds it, its record, and the views of
    its home that show it."""

    facts: Facts
    anomaly: Anomaly
    views: tuple[View, ...]


class TrialHome:
    """A furnished home with its views, in which anomalies are tried one after another, each from
    the home as it stands.

    ``clients`` are two: the home stays loaded in the first, so that nobody else may use that.
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
    def _world(self) -> World:
        return World(self._library, self._own)

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
        # What a home draws itself is loose, too, and would be where the last try left it.
        world = World(self._library, self._own) if home.things.items else self._world
        proved = prove(0, home, contents, self._library, world)
        if isinstance(proved, Rejection):
            return proved
        return self._finished(proved, (injected.object_id, unique.hazard))

    def _finished(self, proved: Proved, asked: tuple[int, str]) -> Fits | Rejection:
        """What remains of a scene's checks: its views show it, and its twin is sound."""
        home, library, facts = self.home, self._library, proved.facts
        catalog, scene = home.context.catalog, facts.scene
        anomalies = anomaly_records(
            proved.surveyed.positives, facts, catalog, self._household, proved.drawn
        )
        shown = shown_by_views(home, facts, anomalies, (), self._client)
        if isinstance(shown, Rejection):
            return shown
        undone = check_undone(scene, anomalies, catalog, library.infos, facts)
        if isinstance(undone, Rejection):
            return undone
        broken = check_standing(scene, undone[0], library, self._client)
        if broken is not None:
            return broken
        number = [(one.object_id, one.hazard) for one in anomalies].index(asked)
        return Fits(facts, anomalies[number], _showing(home, shown, number))


def _showing(home: FurnishedHome, shown: Bools, number: int) -> tuple[View, ...]:
    pairs = zip(home.views[:CANONICAL], shown[:, number].tolist(), strict=True)
    return tuple(view for view, shows in pairs if shows)
