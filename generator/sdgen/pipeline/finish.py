"""A proved scene made whole: labels, views, graph and benign twin, or why it cannot be."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from itertools import compress

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts, unheld
from sdgen.hazards.certify import Survey, facts_of, survey
from sdgen.hazards.labels import anomaly_records, lookalike_records
from sdgen.hazards.twin import physics_of_twin, undone
from sdgen.library import Library
from sdgen.library.records import AssetInfo
from sdgen.options import BuildOptions
from sdgen.physics.checks import penetrations, unsupported
from sdgen.physics.client import Client
from sdgen.physics.settle import Settled
from sdgen.physics.world import standing
from sdgen.pipeline.attempt import Proved
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.overlook import looked_at
from sdgen.pipeline.spec import SceneSpec
from sdgen.rejection import Causes, Rejection, reject
from sdgen.scene import (
    Anomalies,
    Certificate,
    PhysicsReport,
    Scene,
    SceneBundle,
    cause_counts,
)
from sdgen.truth.graph import build_graph

#: Collision pieces reach less far than this beyond what is drawn, metres, and contacts are looked
#: for within less.
_AROUND_M = 0.1


def finish(
    spec: SceneSpec,
    home: FurnishedHome,
    proved: Proved,
    library: Library,
    options: BuildOptions,
    client: Client,
) -> SceneBundle | Rejection:
    """The bundle of a proved scene, as if it were the first try."""
    catalog = home.context.catalog
    facts, scene = proved.facts, proved.facts.scene
    anomalies = anomaly_records(
        proved.surveyed.positives, facts, catalog, spec.household, proved.drawn
    )
    looked = looked_at(
        home, facts, anomalies, proved.lookalikes, options, client, spec.lane("cameras")
    )
    if isinstance(looked, Rejection):
        return looked
    lookalikes = lookalike_records(looked.lookalikes, facts, catalog)
    bundle = SceneBundle(
        scene=scene,
        graph=build_graph(scene, library.infos, catalog, facts),
        anomalies=Anomalies(
            anomalies=anomalies,
            lookalikes=lookalikes,
            certificate=certificate(catalog, library.sha256, proved.surveyed),
        ),
        household=spec.household,
        physics=physics_report(proved.settled, proved.taken_away, facts.bodies),
        split=spec.split,
        cameras=looked.cameras,
    )
    # Whether or not it is written: what a scene holds does not depend on --twins.
    undone_soundly = check_undone(bundle, catalog, library.infos, facts)
    if isinstance(undone_soundly, Rejection):
        return undone_soundly
    broken = check_standing(scene, undone_soundly[0], library, client)
    if broken is not None:
        return broken
    if not options.twins:
        return bundle
    return replace(bundle, twin=twin_of(bundle, catalog, library.infos, *undone_soundly))


def certificate(catalog: Catalog, assets_sha256: str, surveyed: Survey) -> Certificate:
    """What was checked of a scene whose survey holds nothing in doubt."""
    return Certificate(
        hazards_enabled=tuple(sorted(hazard.id for hazard in catalog.hazards)),
        catalogue_sha256=catalog.sha256,
        assets_sha256=assets_sha256,
        pairs_checked=surveyed.pairs,
        pairs_positive=len(surveyed.positives),
    )


def physics_report(settled: Settled, taken_away: Causes, present: Collection[int]) -> PhysicsReport:
    """How a scene came to rest, as the outcome of a first try."""
    return PhysicsReport(
        settled_drift_m={
            str(k): round(v, 5) for k, v in sorted(settled.drift_m.items()) if k in present
        },
        contacts=tuple(
            c.model_copy(update={"distance_m": round(c.distance_m, 5)}) for c in settled.contacts
        ),
        steps=settled.steps,
        home_attempts=1,
        placement_attempts=1,
        rejections=(),
        taken_away=cause_counts(taken_away),
    )


def check_undone(
    bundle: SceneBundle,
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    known: Facts | None = None,
) -> tuple[Facts, Survey] | Rejection:
    """Facts and survey of the scene with its anomalies undone; rejected when some hazard still
    holds, or may, or when something has lost what it stood on. ``known`` are the facts of the
    bundle's own scene."""
    scene = undone(bundle.scene, bundle.anomalies.anomalies, catalog, infos, known)
    facts = facts_of(scene, infos, catalog, known)
    surveyed = survey(facts, catalog)
    for left in surveyed.positives:
        check = "not_benign" if left.verdict.sure else "in_doubt"
        category = facts.category(left.object_id)
        return reject(
            "twin", check, category=category, other=left.hazard, objects=(left.object_id,)
        )
    for key in unheld(facts):
        category = facts.category(key)
        return reject("twin", "lost_its_support", category=category, objects=(key,))
    return facts, surveyed


def check_standing(
    scene: Scene, benign: Facts, library: Library, client: Client
) -> Rejection | None:
    """Why the twin of a scene cannot stand where undoing moved things; None when it can.

    What is not as it was (a part was shut, and things travelled with it) must cut into nothing,
    and what is loose of it must have something under it. ``benign`` are the twin's facts.
    """
    before = {item.id: item for item in scene.objects}
    after = [body.item for body in benign.bodies.values()]
    moved = {
        item.id
        for item in after
        if (item.pose, item.joints) != (before[item.id].pose, before[item.id].joints)
    }
    if not moved:
        return None
    with standing(library, around(moved, benign), client) as world:
        for violation in (*penetrations(world, moved), *unsupported(world, moved)):
            there = [k for k in violation.objects if k in moved]
            culprit = min(there, key=lambda k: benign.bodies[k].item.fixed)
            return reject(
                "twin",
                violation.check,
                category=benign.category(culprit),
                objects=violation.objects,
                measured=violation.measured,
                limit=violation.limit,
            )
    return None


def around(moved: Collection[int], facts: Facts) -> Scene:
    """What of a scene the bodies of these ids could touch: Bullet need not know the rest."""
    scene, home = facts.scene, facts.scene.home
    boxes = {key: np.array(facts.bounding_box(key)) for key in (*facts.structures, *facts.bodies)}
    middles, sizes = np.stack(list(boxes.values()), axis=1)
    near: set[int] = set()
    for key in moved:
        middle, size = boxes[key]
        apart = np.abs(middles - middle) - (sizes + size) / 2
        near.update(compress(boxes, (apart.max(axis=1) <= _AROUND_M).tolist()))
    structures = tuple(one for one in home.structures if one.id in near)
    return scene.model_copy(
        update={
            "home": home.model_copy(update={"structures": structures}),
            "objects": tuple(item for item in scene.objects if item.id in near),
        }
    )


def twin_of(
    bundle: SceneBundle,
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    facts: Facts,
    surveyed: Survey,
) -> SceneBundle:
    """The benign twin, whose facts and survey :func:`check_undone` has found."""
    records = bundle.anomalies
    hazards = {hazard.id: hazard for hazard in catalog.hazards}
    benign = {
        "anomalies": (),
        # What is near them may be gone or have moved: measured again, as validate does.
        "lookalikes": tuple(
            one.model_copy(
                update={
                    "evidence": hazards[one.near_miss_of].predicate.measure(one.object_id, facts)
                }
            )
            for one in records.lookalikes
        ),
        "certificate": certificate(catalog, records.certificate.assets_sha256, surveyed),
    }
    return replace(
        bundle,
        scene=facts.scene,
        graph=build_graph(facts.scene, infos, catalog, facts),
        anomalies=records.model_copy(update=benign),
        physics=physics_of_twin(facts.scene, bundle.physics),
    )


def with_history(
    bundle: SceneBundle, home_attempts: int, placement_attempts: int, rejections: Causes
) -> SceneBundle:
    """The bundle with the tries it took; a twin does not tell why they failed."""
    twin = bundle.twin
    history = {"home_attempts": home_attempts, "placement_attempts": placement_attempts}
    whole_history = {**history, "rejections": cause_counts(rejections)}
    return replace(
        bundle,
        physics=bundle.physics.model_copy(update=whole_history),
        twin=twin and replace(twin, physics=twin.physics.model_copy(update=history)),
    )
