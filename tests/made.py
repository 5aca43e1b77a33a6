"""Scenes as they are built, made once a run for all tests that only look at them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from sdgen.cameras.framing import framed
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.sight import estimate_pixels
from sdgen.catalog.records import Catalog
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline import make_scene
from sdgen.scene import SceneBundle

from tests.shared import Shared

OPTIONS = BuildOptions(n=60, seed=7)
#: Rays along a side of a thing's rectangle: as many as tell about how much of it shows.
_GRID = 8


@dataclass(frozen=True)
class Made:
    """A scene, and pixels of each small thing in each view (in the cameras' order) by rays, for
    things that show at all."""

    bundle: SceneBundle
    pixels: dict[int, tuple[float, ...]]


def made_scenes(
    shared: Shared, catalog: Catalog, library: Library, indices: Iterable[int]
) -> list[Made]:
    """These scenes of :data:`OPTIONS`, without pictures."""
    with Client() as client:

        def make(name: str) -> Made:
            bundle = make_scene(int(name.split("-")[-1]), catalog, library, OPTIONS, client)
            return Made(bundle, _pixels(bundle, library, client))

        return shared.values([f"scene-{index}" for index in indices], make)


def _pixels(bundle: SceneBundle, library: Library, client: Client) -> dict[int, tuple[float, ...]]:
    poses = np.array([camera.world_from_camera for camera in bundle.cameras])
    found = {}
    with RayWorld(library, bundle.scene, client.still) as world:
        for item in bundle.scene.objects:
            middle = np.array([item.pose.position_m])
            near = np.flatnonzero(framed(poses, middle).inside.any(axis=1)).tolist()
            if item.fixed or not near:
                continue
            points, parts = part_points(library, item, ()), part_numbers(library, item, ())
            counts = estimate_pixels(world.cast, list(poses[near]), points, item.id, parts, _GRID)
            shown = dict(zip(near, counts.tolist(), strict=True))
            if any(shown.values()):
                found[item.id] = tuple(shown.get(k, 0.0) for k in range(len(poses)))
    return found
