"""One scene, from its number to everything that is written of it.

The draw comes first and survives every retry; a rejected try changes where things are, never what
is asked for. At most ``HOME_ATTEMPTS`` homes with ``PLACEMENT_ATTEMPTS`` tries each.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from sdgen.cameras import Sight, choose_views, unseen
from sdgen.catalog.load import catalog_sha256
from sdgen.catalog.records import Catalog
from sdgen.errors import SceneRejected
from sdgen.hazards.draw import draw
from sdgen.hazards.labels import anomaly_records, lookalike_records
from sdgen.hazards.splits import SplitModels, split_of_home
from sdgen.households import sample_household
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline.attempt import Proved, attempt
from sdgen.pipeline.stage import pick_home, stage_home
from sdgen.scene import (
    Anomalies,
    Certificate,
    PhysicsReport,
    SceneBundle,
)
from sdgen.seeding import Rng, lane

HOME_ATTEMPTS = 5
PLACEMENT_ATTEMPTS = 20


def make_scene(
    index: int,
    catalog: Catalog,
    library: Library,
    options: BuildOptions,
    client: Client | None = None,
) -> SceneBundle:
    """Scene ``index`` with labels, household and cameras; no pixel is looked at.

    Depends on (catalogue, library, content options, seed, index) alone; the cameras also on the
    view options. ``client`` lets a worker reuse its physics client. Raises SceneRejected when
    all attempts are spent.
    """
    if client is None:
        with Client() as own:
            return make_scene(index, catalog, library, options, own)
    hazards = draw(
        options.seed,
        index,
        [h.id for h in catalog.hazards],
        options.hazards_min,
        options.hazards_max,
        options.draw,
    )
    choice = pick_home(catalog, options, index)
    split = split_of_home(choice.id)
    models = SplitModels(library, split)
    household = sample_household(catalog, lane(options.seed, index, "household"))
    reasons: Counter[str] = Counter()
    tries = 0
    for home_attempt in range(HOME_ATTEMPTS):
        ids = _ids(lane(options.seed, index, f"ids:{home_attempt}"))
        base = choice.plan(catalog, lane(options.seed, index, f"plan:{home_attempt}"))
        if base is None:
            reasons["home: no floor plan"] += 1
            continue
        rng = lane(options.seed, index, f"furnish:{home_attempt}")
        stage = stage_home(base, catalog, library, models, ids, rng)
        if isinstance(stage, str):
            reasons[stage] += 1
            continue
        for placement in range(PLACEMENT_ATTEMPTS):
            tries += 1
            rng = lane(options.seed, index, f"place:{home_attempt}:{placement}")
            proved = attempt(index, stage, hazards, split == "train", library, client, rng)
            if isinstance(proved, str):
                reasons[proved] += 1
                continue
            anomalies = anomaly_records(proved.positives, proved.facts, catalog, household)
            with RayWorld(library, proved.scene, client) as world:
                sight = Sight(library, proved.scene, world.cast, options.seed)
                hidden = unseen(sight, anomalies)
                if hidden is not None:
                    reasons[hidden] += 1
                    continue
                lookalikes = lookalike_records(proved.lookalikes, proved.facts, catalog)
                cameras = choose_views(sight, catalog, anomalies, lookalikes, options)
            return SceneBundle(
                scene=proved.scene,
                anomalies=Anomalies(
                    anomalies=anomalies,
                    lookalikes=lookalikes,
                    certificate=Certificate(
                        hazards_enabled=tuple(sorted(h.id for h in catalog.hazards)),
                        catalogue_sha256=catalog_sha256(catalog),
                        assets_sha256=library.sha256,
                        pairs_checked=proved.pairs,
                        pairs_positive=len(anomalies),
                    ),
                ),
                household=household,
                physics=_report(proved, reasons, home_attempt, tries),
                split=split,
                cameras=cameras,
            )
    raise SceneRejected(f"{index:06d}", dict(reasons))


def _ids(rng: Rng) -> Iterator[int]:
    """Node ids 1 … 65535 in a random order, so that neither id nor order says anything."""
    return iter((rng.permutation(65535) + 1).tolist())


def _report(proved: Proved, reasons: Counter[str], home_attempt: int, tries: int) -> PhysicsReport:
    present = {item.id for item in proved.scene.objects}
    rejections = Counter(reasons)
    rejections.update({f"clutter {why}": n for why, n in proved.removed.items()})
    return PhysicsReport(
        settled_drift_m={
            str(k): round(v, 5) for k, v in sorted(proved.settled.drift_m.items()) if k in present
        },
        contacts=tuple(
            c.model_copy(update={"distance_m": round(c.distance_m, 5)})
            for c in proved.settled.contacts
        ),
        steps=proved.settled.steps,
        home_attempts=home_attempt + 1,
        placement_attempts=tries,
        rejections=dict(sorted(rejections.items())),
    )
