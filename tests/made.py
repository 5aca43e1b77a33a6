"""Scenes as they are built, made once a run for all tests that only look at them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import pytest
from sdgen.cameras.choice import Sight
from sdgen.cameras.pinhole import matrix4
from sdgen.catalog.records import Catalog
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene
from sdgen.scene import SceneBundle

from tests.shared import Shared

OPTIONS = BuildOptions(n=60, seed=7)


@dataclass(frozen=True)
class Made:
    """A scene, and what each of its near cameras was pointed at (by the camera's index)."""

    bundle: SceneBundle
    targets: dict[int, int]


def made_scenes(
    shared: Shared, catalog: Catalog, library: Library, indices: Iterable[int]
) -> list[Made]:
    """These scenes of :data:`OPTIONS`, without pictures."""
    found: dict[object, int] = {}
    near = Sight.near

    def noted(sight: Sight, object_id: int, parts: tuple[str, ...] = (), rounds: int = 1) -> object:
        view = near(sight, object_id, parts, rounds)
        if view is not None:
            found[matrix4(view.world_from_camera)] = object_id
        return view

    with pytest.MonkeyPatch.context() as patch, Client() as client:
        patch.setattr(Sight, "near", noted)

        def make(name: str) -> Made:
            found.clear()
            bundle = make_scene(int(name.split("-")[-1]), catalog, library, OPTIONS, client)
            near_ones = [camera for camera in bundle.cameras if camera.kind == "near"]
            return Made(bundle, {c.index: found[c.world_from_camera] for c in near_ones})

        return shared.values([f"scene-{index}" for index in indices], make)
