"""Whether a scene whose anomalies are undone is sound: benign by its facts, standing in Bullet."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import compress

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts, unheld
from sdgen.geometry import Array
from sdgen.hazards.certify import Survey, facts_of, survey
from sdgen.hazards.twin import undone
from sdgen.library import Library
from sdgen.library.records import AssetInfo
from sdgen.physics.checks import penetrations, unsupported
from sdgen.physics.client import Client
from sdgen.physics.world import standing
from sdgen.rejection import Rejection, reject
from sdgen.scene import Anomaly, Scene

#: Collision pieces reach less far than this beyond what is drawn, metres, and contacts are looked
#: for within less.
_AROUND_M = 0.1


def check_undone(
    before: Scene,
    anomalies: Sequence[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    known: Facts | None = None,
) -> tuple[Facts, Survey] | Rejection:
    """Facts and survey of a scene with its anomalies undone; rejected when some hazard still
    holds, or may, or when something has lost what it stood on. ``known`` are the facts of the
    scene before."""
    scene = undone(before, anomalies, catalog, infos, known)
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
    boxes = [facts.bounding_box(key) for key in moved]
    return near_boxes([(np.array(middle), np.array(size)) for middle, size in boxes], facts)


def near_boxes(wanted: Sequence[tuple[Array, Array]], facts: Facts) -> Scene:
    """What of a scene comes so near to one of these boxes (middle and size, metres) that it could
    be touched from there."""
    scene, home = facts.scene, facts.scene.home
    boxes = {key: np.array(facts.bounding_box(key)) for key in (*facts.structures, *facts.bodies)}
    middles, sizes = np.stack(list(boxes.values()), axis=1)
    near: set[int] = set()
    for middle, size in wanted:
        apart = np.abs(middles - middle) - (sizes + size) / 2
        near.update(compress(boxes, (apart.max(axis=1) <= _AROUND_M).tolist()))
    structures = tuple(one for one in home.structures if one.id in near)
    return scene.model_copy(
        update={
            "home": home.model_copy(update={"structures": structures}),
            "objects": tuple(item for item in scene.objects if item.id in near),
        }
    )
