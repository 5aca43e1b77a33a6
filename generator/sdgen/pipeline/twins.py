"""The twins of a scene: the benign one, and one for each anomaly in which it alone is undone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts
from sdgen.hazards.certify import Survey, certificate
from sdgen.hazards.labels import anomaly_records, measured_again, with_ids_of
from sdgen.hazards.twin import physics_of_twin, plain_records, plainly
from sdgen.library import Library
from sdgen.library.records import AssetInfo
from sdgen.physics.client import Client
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.remedied import Remedied, Tools, by_remedy, undone_records
from sdgen.scene import Anomaly, SceneBundle, Undone, toggle_id, twin_id
from sdgen.seeding import Rng
from sdgen.truth.graph import build_graph


@dataclass(frozen=True)
class Twins:
    """Makes the twins of a finished scene.

    ``facts`` are the scene's own; ``plain`` are facts and survey of the scene undone the plain way,
    known to be sound: what is left where remedies fail.
    """

    bundle: SceneBundle
    facts: Facts
    plain: tuple[Facts, Survey]
    home: FurnishedHome
    library: Library
    client: Client
    lane: Callable[[str], Rng]

    def benign(self) -> SceneBundle:
        """The twin with all anomalies undone, by their remedies as far as that can be done."""
        return self._undone(twin_id(self.bundle.scene.id), self.bundle.anomalies.anomalies)

    def toggles(self) -> tuple[SceneBundle, ...]:
        """For each anomaly the scene with that one undone. Where it cannot be undone alone, others
        of its object are undone with it, else those of other objects that go with it, else all."""
        scene_id = self.bundle.scene.id
        return tuple(
            self._undone(toggle_id(scene_id, anomaly.id), [anomaly])
            for anomaly in self.bundle.anomalies.anomalies
        )

    def _undone(self, new_id: str, anomalies: Sequence[Anomaly]) -> SceneBundle:
        every = self.bundle.anomalies.anomalies
        ids = {one.id for one in anomalies}
        staying = [one for one in every if one.id not in ids]
        scene = self.bundle.scene.model_copy(update={"id": new_id, "twin_of": self.bundle.scene.id})
        context, infos = self.home.context, self.library.infos
        tools = Tools(context, self.home.layout, self.library, self.client, self.bundle.cameras)
        apart = [one for one in staying if not _same_object(one, anomalies)]
        for keep in (staying, apart, []) if staying else ([],):
            found = by_remedy(scene, self.facts, anomalies, keep, tools, self.lane)
            if found is not None:
                records = undone_records(every, found)
                return twin_with(self.bundle, context.catalog, infos, found, records)
        facts, surveyed = self.plain
        plain = twin_of(self.bundle, context.catalog, infos, facts, surveyed)
        return replace(plain, scene=plain.scene.model_copy(update={"id": new_id}))


def _same_object(one: Anomaly, others: Sequence[Anomaly]) -> bool:
    return any(one.object_id == other.object_id for other in others)


def twin_of(
    bundle: SceneBundle,
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    facts: Facts,
    surveyed: Survey,
) -> SceneBundle:
    """The benign twin whose anomalies are undone the plain way; facts and survey as
    :func:`~sdgen.pipeline.undoing.check_undone` has found them."""
    anomalies = bundle.anomalies.anomalies
    after = plainly(bundle.scene, anomalies, catalog, infos)
    records = plain_records(anomalies, after, catalog)
    return twin_with(bundle, catalog, infos, Remedied(facts, surveyed), records)


def twin_with(
    bundle: SceneBundle,
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    found: Remedied,
    undone: tuple[Undone, ...],
) -> SceneBundle:
    """The bundle of a twin: the scene's own but for what was ``found`` and is ``undone``."""
    records, facts, surveyed = bundle.anomalies, found.facts, found.surveyed
    scene = facts.scene
    # What a remedy has shut is no near miss any more.
    lookalikes = [one for one in records.lookalikes if one.object_id not in found.altered]
    drawn = {(one.object_id, one.hazard) for one in bundle.anomalies.anomalies if one.drawn}
    left = anomaly_records(surveyed.positives, facts, catalog, bundle.household, drawn)
    return replace(
        bundle,
        scene=scene,
        graph=build_graph(scene, infos, catalog, facts),
        anomalies=records.model_copy(
            update={
                "anomalies": with_ids_of(left, records.anomalies),
                "lookalikes": measured_again(lookalikes, facts, catalog),
                "certificate": certificate(catalog, records.certificate.assets_sha256, surveyed),
                "undone": undone,
            }
        ),
        physics=physics_of_twin(
            scene,
            bundle.physics,
            {key: rest.drift_m for key, rest in found.rests.items()},
            [contact for rest in found.rests.values() for contact in rest.contacts],
        ),
        twin=None,
        toggles=(),
    )
