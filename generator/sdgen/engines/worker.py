"""What a worker process does with a scene number: have it made, draw it, write it."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from sdgen.cameras.lens import Lens
from sdgen.catalog.records import Catalog
from sdgen.closing import Closing
from sdgen.dataset.scene_folder import SceneFolder, SceneWriter
from sdgen.errors import SdgenError, os_error_in_words
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene
from sdgen.rejection import Causes
from sdgen.render import Choice, open_renderer
from sdgen.render.frames import render_frames
from sdgen.render.looks import as_seen
from sdgen.render.stitching import Stitching
from sdgen.scene import Frame, SceneBundle, causes_of
from sdgen.truth import visibility_of
from sdgen.truth.observability import observability
from sdgen.truth.observable import Observability


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
    rejections: Causes
    all_visible: bool


class SceneWorker(Closing):
    """Makes scenes one after another with one physics client and one renderer."""

    def __init__(self, setup: WorkerSetup) -> None:
        if setup.one_thread:
            # As many workers as cores: more threads in Mesa would only get in each other's way.
            os.environ.setdefault("LP_NUM_THREADS", "1")
        self._setup = setup
        self._library = Library(setup.library_folders, setup.library_sha256)
        self._client = Client()
        self._renderer = open_renderer(setup.choice) if setup.choice is not None else None

    def __call__(self, index: int) -> SceneResult:
        """Make, draw and write scene ``index`` (and its twins).

        Raises SceneRejected, and SdgenError when a disk is full or a folder gone.
        """
        start = time.monotonic()
        setup = self._setup
        with _refused(f"scene {index:06d} cannot be made"):
            bundle = make_scene(index, setup.catalog, self._library, setup.options, self._client)
        with _refused(f"scene {index:06d} cannot be written", setup.writer.root):
            # Its twins first: a scene that is there has them beside it.
            for twin in bundle.twins:
                self._draw_and_write(twin)
            all_visible = self._draw_and_write(bundle)
        drawn = len(bundle.cameras) if self._renderer is not None else 0
        return SceneResult(
            scene_id=bundle.scene.id,
            hazards=tuple(a.hazard for a in bundle.anomalies.anomalies),
            frames=drawn * (1 + len(bundle.twins)),
            seconds=time.monotonic() - start,
            home_attempts=bundle.physics.home_attempts,
            placement_attempts=bundle.physics.placement_attempts,
            rejections=causes_of(bundle.physics.rejections),
            all_visible=all_visible,
        )

    def close(self) -> None:
        """Let go of simulator and renderer."""
        self._client.close()
        if self._renderer is not None:
            self._renderer.close()

    def _draw_and_write(self, bundle: SceneBundle) -> bool:
        """One scene's folder; True when its views show every anomaly."""
        options = self._setup.options
        with self._setup.writer.begin(bundle) as folder:
            visibility = visibility_of(
                bundle.scene,
                bundle.anomalies.anomalies,
                self._drawn(bundle, folder),
                options.width,
                options.height,
            )
            folder.finish(visibility, self._observability(bundle))
        return visibility.all_visible

    def _observability(self, bundle: SceneBundle) -> Observability | None:
        """From where an agent could see the anomalies, if that is asked for."""
        setup = self._setup
        if not setup.options.observability:
            return None
        return observability(
            self._library,
            bundle.scene,
            bundle.anomalies.anomalies,
            setup.catalog,
            Lens(height_m=setup.options.eye_height_m),
            still=self._client.still,
        )

    def _drawn(self, bundle: SceneBundle, folder: SceneFolder) -> Iterator[Frame]:
        """The scene's frames one at a time, each written on its way, and its panoramas."""
        if self._renderer is None:
            return
        options = self._setup.options
        stitching = Stitching(bundle.panoramas, options.sensors)
        frames = render_frames(
            self._renderer,
            self._library,
            bundle.scene,
            stitching.cameras(bundle.cameras),
            options.sensors,
            options.supersample,
        )
        while True:
            with _refused(f"scene {bundle.scene.id} cannot be drawn"):
                frame = next(frames, None)
            if frame is None:
                return
            done = stitching.add(frame)
            if done is not None:
                folder.add_panorama(*done)
            if stitching.wants_only(frame):
                continue
            if "rgb" in options.sensors:
                frame = replace(frame, rgb=as_seen(frame.rgb, frame.camera.look))
            folder.add(frame)
            yield frame


@contextmanager
def _refused(what: str, place: Path | None = None) -> Iterator[None]:
    """Says what the system refuses, and where: ``place`` (None: the temporary files) unless the
    error names a file itself."""
    try:
        yield
    except OSError as error:
        where = os_error_in_words(error, place or tempfile.gettempdir())
        raise SdgenError(
            f"{what}: {where}; what is finished is kept, the same command goes on"
        ) from None
