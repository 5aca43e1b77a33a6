"""A proved scene made whole: labels, views, graph and twins, or why it cannot be."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from sdgen.cameras.nearest import drawn_boxes, with_near_planes
from sdgen.hazards.certify import certificate
from sdgen.hazards.labels import anomaly_records, lookalike_records
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.settle import Settled
from sdgen.pipeline.attempt import Proved
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.overlook import looked_at
from sdgen.pipeline.spec import SceneSpec
from sdgen.pipeline.turns import turned, with_looks
from sdgen.pipeline.twins import Twins
from sdgen.pipeline.undoing import check_standing, check_undone
from sdgen.rejection import Causes, Rejection
from sdgen.scene import Anomalies, PhysicsReport, SceneBundle, cause_counts
from sdgen.truth.graph import build_graph


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
    # Whether or not it is written: what a scene holds does not depend on --twins. Where things
    # would go by their remedies is only looked for when it is; nothing is rejected for that.
    undone_soundly = check_undone(scene, anomalies, catalog, library.infos, facts)
    if isinstance(undone_soundly, Rejection):
        return undone_soundly
    broken = check_standing(scene, undone_soundly[0], library, client)
    if broken is not None:
        return broken
    # Scene and twin are drawn from the same depth on, or what is the same in both would differ by
    # a rounding of the depth buffer. Again whether or not there is a twin.
    boxes = [drawn_boxes(library, one) for one in (scene, undone_soundly[0].scene)]
    bundle = replace(bundle, cameras=with_near_planes(bundle.cameras, np.concatenate(boxes)))
    twins = Twins(bundle, facts, undone_soundly, home, library, client, spec.lane)
    if options.twins:
        bundle = replace(bundle, twin=twins.benign())
    if options.toggles:
        bundle = replace(bundle, toggles=twins.toggles())
    if options.views_mode == "panorama":
        boxes += [drawn_boxes(library, one.scene) for one in bundle.twins]
        lane = spec.lane("turns")
        bundle = turned(bundle, home, np.concatenate(boxes), options, client, lane)
    return with_looks(bundle, options, spec.lane)


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


def with_history(
    bundle: SceneBundle, home_attempts: int, placement_attempts: int, rejections: Causes
) -> SceneBundle:
    """The bundle with the tries it took; a twin does not tell why they failed."""
    history = {"home_attempts": home_attempts, "placement_attempts": placement_attempts}
    whole_history = {**history, "rejections": cause_counts(rejections)}

    def told(twin: SceneBundle) -> SceneBundle:
        return replace(twin, physics=twin.physics.model_copy(update=history))

    return replace(
        bundle,
        physics=bundle.physics.model_copy(update=whole_history),
        twin=bundle.twin and told(bundle.twin),
        toggles=tuple(told(toggle) for toggle in bundle.toggles),
    )
