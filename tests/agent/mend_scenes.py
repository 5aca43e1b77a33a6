"""Three made scenes that hold all thirteen hazards, to be mended."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sdgen.agent.mend import Mending, Pair
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene
from sdgen.scene import Household, Member, SceneBundle

from tests.shared import Shared
from tests.shipped import shipped_library

CATALOG = load_catalog()
OPTIONS = BuildOptions(n=3, seed=6, hazards_min=5, hazards_max=5, views=1)
TODDLER = Household(
    template="test", members=(Member(role="adult", age=36), Member(role="child", age=2))
)
ADULTS = Household(template="test", members=(Member(role="adult", age=36),))


def made(shared: Shared, client: Client) -> list[SceneBundle]:
    """The scenes."""
    return shared.values(
        [f"mend-{index}" for index in range(OPTIONS.n)],
        lambda name: make_scene(int(name[-1]), CATALOG, shipped_library(), OPTIONS, client),
    )


def holding(scenes: list[SceneBundle], hazard: str) -> tuple[SceneBundle, Pair]:
    """A scene with an anomaly of a hazard, and that anomaly."""
    return next(
        (scene, (one.object_id, hazard))
        for scene in scenes
        for one in scene.anomalies.anomalies
        if one.hazard == hazard
    )


def mending(
    scene: SceneBundle,
    client: Client,
    household: Household | None = None,
    catalog: Catalog = CATALOG,
    seed: int = 0,
) -> Mending:
    """A scene to be mended."""
    who = household or scene.household
    return Mending(scene.scene, who, catalog, shipped_library(), client, seed)


@contextmanager
def scenes_and_client(shared: Shared) -> Iterator[tuple[list[SceneBundle], Client]]:
    """The scenes, and a client to mend them with."""
    with Client() as client:
        yield made(shared, client), client
