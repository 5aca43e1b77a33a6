"""One scene's records against each other: everything that follows is derived again."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import islice

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset
from sdgen.dataset.item import SceneItem
from sdgen.facts import Facts, bodies_of
from sdgen.freespace import free_shape, rounded_rings
from sdgen.geometry import QUATERNION_STEP, round_position
from sdgen.hazards.certify import Survey, facts_of, survey
from sdgen.hazards.labels import anomaly_records, with_ids_of
from sdgen.library.records import AssetInfo
from sdgen.library.states import derive_states
from sdgen.scene import LARGEST_ID, ObjectInstance, Scene
from sdgen.truth import graph_nodes
from sdgen.validate.problems import SHOWN, Problem, differences
from sdgen.validate.standing import check_standing
from sdgen.zones import derive_zones, floor_obstacles


def check_scene(
    item: SceneItem, infos: Mapping[str, AssetInfo], catalog: Catalog, version: str
) -> Iterator[Problem]:
    """``scene.json`` on its own: ids, poses, variants, joints, states; nothing may dangle.
    ``version`` is the format that the data set says it has."""
    scene, entry, where = item.scene, item.entry, item.where("scene.json")

    def problem(text: str) -> Problem:
        return Problem("scene", f"{where}: {text}")

    stated = (scene.id, scene.index, scene.twin_of, scene.home.id, len(scene.objects))
    if stated != (entry.id, entry.index, entry.twin_of, entry.home, entry.objects):
        yield problem("id, index, home or number of objects are not the manifest's")
    if scene.format_version != version:
        yield problem(f"format_version: {scene.format_version!r}, expected {version!r}")
    rooms = [room.id for room in scene.home.rooms]
    objects = [thing.id for thing in scene.objects]
    ids = [*rooms, *(s.id for s in scene.home.structures), *objects]
    for node_id, times in sorted(Counter(ids).items()):
        if times > 1:
            yield problem(f"id {node_id} is used {times} times")
        if not 1 <= node_id <= LARGEST_ID:
            yield problem(f"id {node_id} is not in 1 to {LARGEST_ID}")
    if objects != sorted(objects):
        yield problem("objects are not sorted by id")
    for opening in scene.home.openings:
        if opening.object_id not in objects or not set(opening.room_ids) <= set(rooms):
            yield problem(f"home.openings: object {opening.object_id} or its rooms do not exist")
    for room_id in [
        *(s.room_id for s in scene.home.structures),
        *(zone.room_id for zone in scene.zones),
        scene.agent_start.room_id,
    ]:
        if room_id not in rooms:
            yield problem(f"room {room_id} does not exist")
    known = {category.name for category in catalog.categories}
    for thing in scene.objects:
        yield from (
            problem(f"object {thing.id} ({thing.category}): {text}")
            for text in _thing(thing, infos, known, rooms)
        )


def _thing(
    thing: ObjectInstance, infos: Mapping[str, AssetInfo], known: set[str], rooms: list[int]
) -> Iterator[str]:
    if thing.category not in known:
        yield "category: not in catalogue.json"
    if thing.room_id not in rooms:
        yield f"room_id: no room {thing.room_id}"
    if thing.pose.position_m != round_position(thing.pose.position_m):
        yield f"pose.position_m: {thing.pose.position_m} is not rounded to 1e-5 m"
    quat = thing.pose.quat_xyzw
    if abs(math.hypot(*quat) - 1) > 4 * QUATERNION_STEP:
        yield f"pose.quat_xyzw: {quat} is no unit quaternion"
    if quat != tuple(round(v, 6) for v in quat):
        yield f"pose.quat_xyzw: {quat} is not rounded to 1e-6"
    info = infos.get(thing.asset)
    if info is None:
        yield f"asset: {thing.asset!r} is not in assets.jsonl"
        return
    if info.category != thing.category:
        yield f"category: its asset is a {info.category}"
    if thing.variant not in info.variants:
        yield f"variant: {thing.variant!r} is none of the asset's"
        return
    if thing.parts != info.variants[thing.variant]:
        yield f"parts: not those of variant {thing.variant!r}"
    if sorted(thing.joints) != sorted(joint.name for joint in info.joints):
        yield "joints: not exactly those of the asset"
        return
    for joint in info.joints:
        if not joint.lower - 1e-6 <= thing.joints[joint.name] <= joint.upper + 1e-6:
            yield f"joints.{joint.name}: {thing.joints[joint.name]} is beyond its limits"
    derived = derive_states(info, thing.variant, thing.joints)
    if thing.states != derived:
        yield f"states: {list(thing.states)} stored, {list(derived)} derived"


def check_zones(
    item: SceneItem, infos: Mapping[str, AssetInfo], catalog: Catalog
) -> Iterator[Problem]:
    """Zones and free space, derived again from the home and its furniture."""
    scene = item.scene
    traits = {category.name: category.properties for category in catalog.categories}
    hazard_only = {c.name for c in catalog.categories if c.kind == "hazard_only"}
    # As nobody left it: what stands open now is no part of the home.
    furniture = bodies_of(
        [
            at_rest(thing, infos[thing.asset])
            for thing in scene.objects
            if thing.fixed and thing.category not in hazard_only
        ],
        infos,
    )
    free = free_shape(scene.home, floor_obstacles(furniture))
    zones = derive_zones(scene.home, furniture, free, traits)
    stored = {zone.name: zone for zone in scene.zones}
    derived = {zone.name: zone for zone in zones}
    for text in islice(differences(stored, derived, "zones"), SHOWN):
        yield Problem("scene", f"{item.where('scene.json')}: {text}")
    if rounded_rings(free) != scene.free_space:
        text = "free_space: not what the home and its furniture leave free"
        yield Problem("scene", f"{item.where('scene.json')}: {text}")


def check_labels(
    data: Dataset, item: SceneItem, infos: Mapping[str, AssetInfo], catalog: Catalog
) -> Iterator[Problem]:
    """Graph, anomalies, lookalikes, certificate and the household's choices, all derived again."""
    facts = facts_of(item.scene, infos, catalog)
    result = survey(facts, catalog)
    if data.info.options.homes == "imported":
        # Things of others stand as they stand; what is in doubt is not labelled.
        sure = tuple(positive for positive in result.positives if positive.verdict.sure)
        result = Survey(sure, result.pairs)
    else:
        yield from check_standing(item, facts)
    yield from _graph(item, infos, catalog, facts)
    yield from _anomalies(item, catalog, facts, result)
    yield from _lookalikes(item, catalog, facts, result)
    certificate = item.anomalies.certificate
    derived = certificate.model_copy(
        update={
            "hazards_enabled": data.info.hazards_enabled,
            "catalogue_sha256": data.info.catalogue_sha256,
            "assets_sha256": data.info.assets_sha256,
            "pairs_checked": result.pairs,
            "pairs_positive": len(item.anomalies.anomalies),
        }
    )
    for text in islice(differences(certificate, derived, "certificate"), SHOWN):
        yield Problem("label", f"{item.where('anomalies.json')}: {text}")
    yield from _entry(item)


def _graph(
    item: SceneItem, infos: Mapping[str, AssetInfo], catalog: Catalog, facts: Facts
) -> Iterator[Problem]:
    stored = item.scene_graph
    where = item.where("graph.json")
    ids = [node.id for node in stored.nodes]
    if ids != sorted(set(ids)):
        yield Problem("graph", f"{where}: nodes: ids are not unique and sorted")
    derived = graph_nodes(item.scene, infos, catalog, facts)
    if stored.nodes != derived:
        one, other = ({node.id: node for node in nodes} for nodes in (stored.nodes, derived))
        for text in islice(differences(one, other, "nodes"), SHOWN):
            yield Problem("graph", f"{where}: {text}")
    edges = [(e.from_id, e.to_id, e.relation_type) for e in stored.edges]
    if edges != sorted(set(edges)):
        yield Problem("graph", f"{where}: edges: not unique and sorted")
    holding = set(facts.edges())
    extra, missing = sorted(set(edges) - holding), sorted(holding - set(edges))
    for text, found in (("does not hold", extra), ("is missing", missing)):
        for a, b, relation in found[:SHOWN]:
            yield Problem("graph", f"{where}: edges: {a} {relation} {b} {text}")


def _anomalies(
    item: SceneItem, catalog: Catalog, facts: Facts, result: Survey
) -> Iterator[Problem]:
    where = item.where("anomalies.json")
    stored = {(a.object_id, a.hazard): a for a in item.anomalies.anomalies}
    if len(stored) != len(item.anomalies.anomalies):
        yield Problem("label", f"{where}: anomalies: a pair of object and hazard appears twice")
    for positive in result.positives:
        pair = f"object {positive.object_id}, {positive.hazard}"
        if not positive.verdict.sure:
            yield Problem("label", f"{where}: {pair}: lies within a dead band")
        elif (positive.object_id, positive.hazard) not in stored:
            yield Problem("label", f"{where}: {pair}: holds and is not listed")
    holding = [f for f in result.positives if f.verdict.value and (f.object_id, f.hazard) in stored]
    pairs = {(f.object_id, f.hazard) for f in holding}
    for object_id, hazard in sorted(set(stored) - pairs):
        yield Problem("label", f"{where}: object {object_id}, {hazard}: listed and does not hold")
    if pairs != set(stored):
        return
    # What a scene was asked for is in no other record.
    drawn = {pair for pair, anomaly in stored.items() if anomaly.drawn}
    derived = anomaly_records(holding, facts, catalog, item.household, drawn)
    if item.scene.twin_of is not None:  # numbered as in its scene: held against it elsewhere
        derived = with_ids_of(derived, item.anomalies.anomalies)
    for text in islice(differences(item.anomalies.anomalies, derived, "anomalies"), SHOWN):
        yield Problem("label", f"{where}: {text}")


def _lookalikes(
    item: SceneItem, catalog: Catalog, facts: Facts, result: Survey
) -> Iterator[Problem]:
    where = item.where("anomalies.json")
    positive = {pair.object_id for pair in result.positives}
    hazards = {hazard.id: hazard for hazard in catalog.hazards}
    for k, lookalike in enumerate(item.anomalies.lookalikes):
        path = f"{where}: lookalikes[{k}]"
        if lookalike.object_id not in facts.bodies:
            yield Problem("label", f"{path}: no object {lookalike.object_id}")
        elif lookalike.near_miss_of not in hazards:
            yield Problem("label", f"{path}: no hazard {lookalike.near_miss_of!r}")
        elif lookalike.object_id in positive:
            yield Problem("label", f"{path}: object {lookalike.object_id} is an anomaly")
        else:
            hazard = hazards[lookalike.near_miss_of]
            derived = hazard.predicate.measure(lookalike.object_id, facts)
            for text in islice(differences(lookalike.evidence, derived, "evidence"), SHOWN):
                yield Problem("label", f"{path}: {text}")


def _entry(item: SceneItem) -> Iterator[Problem]:
    entry, records = item.entry, item.anomalies
    stated = (entry.anomalies, dict(entry.hazards), entry.lookalikes)
    counted = Counter(anomaly.hazard for anomaly in records.anomalies)
    if stated != (len(records.anomalies), dict(counted), len(records.lookalikes)):
        where = f"manifest.jsonl: scene {entry.id}"
        yield Problem("count", f"{where}: anomalies, hazards or lookalikes are not its files'")


def known_ids(scene: Scene) -> set[int]:
    """Ids that a mask may hold: structures and objects (rooms have no surface)."""
    return {s.id for s in scene.home.structures} | {item.id for item in scene.objects}
