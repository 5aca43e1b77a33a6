"""Graphs of others as a data set of scenes without pictures, for ``detect`` and ``evaluate``.

Every label is what our catalogue's predicates say of the boxes, and nothing else: an anomaly where
they surely hold, none where they surely do not; what lies between two limits is told. Households
are drawn, for the graphs have none.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sdgen.catalog.records import Catalog, Category, HouseholdTemplate, canonical_sha256
from sdgen.dataset import DatasetWriter
from sdgen.errors import InputError, did_you_mean
from sdgen.facts import Facts, bodies_of
from sdgen.freespace import free_shape, random_point, rounded_rings
from sdgen.hazards.certify import Survey, certificate, facts_of, survey
from sdgen.hazards.labels import anomaly_records
from sdgen.hazards.splits import split_of_home
from sdgen.households import draw_template, sample_household
from sdgen.importing.graphs.virtualhome import ReadGraph, read_graph
from sdgen.library.records import AssetInfo
from sdgen.options import MAX_SCENES, BuildOptions
from sdgen.scene import (
    AgentStart,
    Anomalies,
    Contact,
    Household,
    PhysicsReport,
    Scene,
    SceneBundle,
)
from sdgen.seeding import lane
from sdgen.truth import build_graph, visibility_of
from sdgen.zones import derive_zones, floor_obstacles

#: Format -> what reads a file of it.
READERS: Mapping[str, Callable[[Path, str, Catalog], ReadGraph]] = {"virtualhome": read_graph}


@dataclass
class Imported:
    """What became of the graphs: how many, anomalies by hazard, and by file what was told of it."""

    scenes: int = 0
    anomalies: Counter[str] = field(default_factory=Counter)
    undecided: Counter[str] = field(default_factory=Counter)
    told: dict[str, list[str]] = field(default_factory=dict)


def import_graphs(
    format_: str,
    paths: Sequence[Path],
    out: Path,
    catalog: Catalog,
    seed: int = 0,
    household: str | None = None,
    on_scene: Callable[[int, int], None] | None = None,
) -> Imported:
    """Write the graphs, in this order, as the data set ``out``.

    ``household`` names the kind that lives in all of them; one is drawn for each without it. Raises
    InputError, located, for a graph that cannot be read, SdgenError for a bad place.
    """
    if not 0 < len(paths) <= MAX_SCENES:
        raise InputError([f"{len(paths)} graphs: 1 to {MAX_SCENES} expected"])
    template = None if household is None else _template(catalog, household)
    graphs = [
        READERS[format_](path, f"{path.stem}_{k:06d}", catalog) for k, path in enumerate(paths)
    ]
    catalog = _with_categories(catalog, graphs)
    infos = {
        name: info.model_copy(update={"id": name})
        for k, graph in enumerate(graphs)
        for name, info in ((f"{key}_{k}", one) for key, one in graph.infos.items())
    }  # a box of its own for each thing of each home
    records = {name: info.model_dump(mode="json") for name, info in infos.items()}
    assets_sha256 = canonical_sha256(records)
    options = BuildOptions(n=len(paths), seed=seed, homes="imported", views=0, sensors=())
    found = Imported()
    with DatasetWriter.open(out, options, catalog, infos, assets_sha256) as writer:
        for index, (path, graph) in enumerate(zip(paths, graphs, strict=True)):
            scene = _scene(index, graph, infos, catalog, seed)
            facts = facts_of(scene, infos, catalog)
            result = survey(facts, catalog)
            who = _household(index, catalog, template, seed)
            made = _bundle(scene, facts, result, who, infos, catalog, assets_sha256)
            with writer.scene_writer.begin(made) as folder:
                size = options.width, options.height
                folder.finish(visibility_of(scene, made.anomalies.anomalies, (), *size))
            found.scenes += 1
            found.anomalies.update(a.hazard for a in made.anomalies.anomalies)
            unsure = [one for one in result.positives if not one.verdict.sure]
            found.undecided.update(one.hazard for one in unsure)
            found.told[str(path)] = graph.told
            if on_scene is not None:
                on_scene(index + 1, len(paths))
        writer.finish()
    return found


def _template(catalog: Catalog, name: str) -> HouseholdTemplate:
    known = {one.name: one for one in catalog.households}
    if name not in known:
        raise InputError([f"no household {name!r}{did_you_mean(name, sorted(known))}"])
    return known[name]


def _with_categories(catalog: Catalog, graphs: Sequence[ReadGraph]) -> Catalog:
    more: dict[str, Category] = {}
    for graph in graphs:
        more |= {name: one for name, one in graph.categories.items() if name not in more}
    if not more:
        return catalog
    return catalog.model_copy(update={"categories": (*catalog.categories, *more.values())})


def _scene(
    index: int,
    graph: ReadGraph,
    infos: Mapping[str, AssetInfo],
    catalog: Catalog,
    seed: int,
) -> Scene:
    home = graph.home()
    objects = tuple(
        sorted(
            (one.model_copy(update={"asset": f"{one.asset}_{index}"}) for one in graph.objects),
            key=lambda one: one.id,
        )
    )
    furniture = bodies_of([one for one in objects if one.fixed], infos)
    traits = {category.name: category.properties for category in catalog.categories}
    free = free_shape(home, floor_obstacles(furniture))
    rng = lane(seed, index, "graph:start")
    start = random_point(free, rng) or home.rooms[0].polygon_m[0]
    return Scene(
        id=f"{index:06d}",
        index=index,
        home=home,
        zones=derive_zones(home, furniture, free, traits),
        free_space=rounded_rings(free),
        agent_start=AgentStart(
            position_m=(round(start[0], 3), round(start[1], 3), 0.0),
            yaw_rad=round(float(rng.uniform(-np.pi, np.pi)), 4),
            room_id=_nearest_room(graph, start),
        ),
        objects=objects,
    )


def _nearest_room(graph: ReadGraph, point: tuple[float, float]) -> int:
    from shapely.geometry import Point, Polygon

    here = Point(point)
    return min(graph.rooms, key=lambda room: Polygon(room.polygon_m).distance(here)).id


def _household(
    index: int, catalog: Catalog, template: HouseholdTemplate | None, seed: int
) -> Household:
    rng = lane(seed, index, "graph:household")
    return sample_household(catalog, template or draw_template(catalog, rng), rng)


def _bundle(
    scene: Scene,
    facts: Facts,
    result: Survey,
    household: Household,
    infos: Mapping[str, AssetInfo],
    catalog: Catalog,
    assets_sha256: str,
) -> SceneBundle:
    sure = [one for one in result.positives if one.verdict.sure and one.verdict.value]
    loose = [one for one in scene.objects if not one.fixed]
    touching = {
        (min(one.id, held.target_id), max(one.id, held.target_id))
        for one in loose
        for held in (*facts.on(one.id), *facts.inside(one.id))
    }
    return SceneBundle(
        scene=scene,
        graph=build_graph(scene, infos, catalog, facts),
        anomalies=Anomalies(
            anomalies=anomaly_records(sure, facts, catalog, household, ()),
            lookalikes=(),
            certificate=certificate(catalog, assets_sha256, Survey(tuple(sure), result.pairs)),
        ),
        household=household,
        physics=PhysicsReport(
            settled_drift_m={str(one.id): 0.0 for one in loose},
            contacts=tuple(Contact(a=a, b=b, distance_m=0.0) for a, b in sorted(touching)),
            steps=0,
            home_attempts=1,
            placement_attempts=1,
            rejections=(),
            taken_away=(),
        ),
        split=split_of_home(scene.home.id),
        cameras=(),
    )
