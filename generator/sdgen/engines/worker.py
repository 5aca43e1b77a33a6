"""What a worker process does with a scene number: make it, draw it, write it."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from sdgen.catalog.records import Catalog
from sdgen.dataset.scene_folder import SceneWriter
from sdgen.errors import SdgenError
from sdgen.hazards.certify import certify, facts_of
from sdgen.hazards.twin import physics_of_twin, undone
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene
from sdgen.render.backend import Choice
from sdgen.render.frames import Renderer
from sdgen.scene import Frame, SceneBundle, ViewVisibility
from sdgen.truth.graph import build_graph
from sdgen.truth.visibility import assemble, part_names, view_visibility


@dataclass(frozen=True)
class WorkerSetup:
    """Everything a worker needs; small and picklable."""

    catalog: Catalog
    library_folders: tuple[Path, ...]
    library_sha256: str
    options: BuildOptions
    writer: SceneWriter
    choice: Choice | None
    one_thread: bool


@dataclass(frozen=True)
class SceneResult:
    """What the parent hears of a scene that is in place."""

    scene_id: str
    hazards: tuple[str, ...]
    frames: int
    seconds: float
    home_attempts: int
    placement_attempts: int
    rejections: dict[str, int]
    all_visible: bool


class SceneWorker:
    """Makes scenes one after another with one physics client and one renderer."""

    def __init__(self, setup: WorkerSetup) -> None:
        if setup.one_thread:
            # As many workers as cores: more threads in Mesa would only get in each other's way.
            os.environ.setdefault("LP_NUM_THREADS", "1")
        self._setup = setup
        self._library = Library(setup.library_folders, setup.library_sha256)
        self._client = Client()
        self._renderer = Renderer(setup.choice) if setup.choice is not None else None

    def __call__(self, index: int) -> SceneResult:
        """Make, draw and write scene ``index`` (and its twin). Raises SceneRejected."""
        start = time.monotonic()
        setup = self._setup
        bundle = make_scene(index, setup.catalog, self._library, setup.options, self._client)
        try:
            # The twin first: a scene that is there has its twin beside it.
            frames = self._write_scene(self._twin(bundle))[1] if setup.options.twins else 0
            all_visible, drawn = self._write_scene(bundle)
        except OSError as error:
            raise SdgenError(
                f"{setup.writer.root}: scene {bundle.scene.id} cannot be written: "
                f"{error.strerror or error}; what is finished is kept, the same command goes on"
            ) from None
        return SceneResult(
            scene_id=bundle.scene.id,
            hazards=tuple(a.hazard for a in bundle.anomalies.anomalies),
            frames=frames + drawn,
            seconds=time.monotonic() - start,
            home_attempts=bundle.physics.home_attempts,
            placement_attempts=bundle.physics.placement_attempts,
            rejections=bundle.physics.rejections,
            all_visible=all_visible,
        )

    def close(self) -> None:
        """Let go of simulator and renderer."""
        self._client.close()
        if self._renderer is not None:
            self._renderer.close()

    def _write_scene(self, bundle: SceneBundle) -> tuple[bool, int]:
        setup = self._setup
        infos = self._library.infos
        facts = facts_of(bundle.scene, infos, setup.catalog)
        graph = build_graph(bundle.scene, infos, setup.catalog, facts)
        parts_of = part_names(bundle.scene)
        views: list[ViewVisibility] = []
        anomalies = bundle.anomalies.anomalies
        with setup.writer.begin(bundle, graph) as folder:
            for frame in self._frames(bundle):
                folder.add(frame)
                views.append(view_visibility(frame, parts_of))
            visibility = assemble(views, anomalies, setup.options.width, setup.options.height)
            folder.finish(visibility)
        return visibility.all_visible, len(views)

    def _frames(self, bundle: SceneBundle) -> Iterator[Frame]:
        if self._renderer is None:
            return
        options = self._setup.options
        yield from self._renderer.render(
            self._library, bundle.scene, bundle.cameras, options.sensors, options.supersample
        )

    def _twin(self, bundle: SceneBundle) -> SceneBundle:
        catalog, infos = self._setup.catalog, self._library.infos
        scene = undone(bundle.scene, bundle.anomalies.anomalies, catalog, infos)
        left = certify(scene, infos, catalog)
        assert not left, f"the twin of {bundle.scene.id} is not benign: {left}"
        benign = bundle.anomalies.model_copy(
            update={
                "anomalies": (),
                "certificate": bundle.anomalies.certificate.model_copy(
                    update={
                        "pairs_checked": len(scene.objects) * len(catalog.hazards),
                        "pairs_positive": 0,
                    }
                ),
            }
        )
        return SceneBundle(
            scene=scene,
            anomalies=benign,
            household=bundle.household,
            physics=physics_of_twin(scene, bundle.physics),
            split=bundle.split,
            cameras=bundle.cameras,
        )
