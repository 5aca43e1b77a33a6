"""A scene worker on another machine: it makes sure that machine would make the same bytes, and
sends finished scenes home where it cannot write to the data set's folder itself."""

from __future__ import annotations

import dataclasses
import tempfile
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.dataset.transfer import PackedScene, pack, unpack
from sdgen.dataset.versions import package_versions
from sdgen.engines.worker import SceneResult, SceneWorker, WorkerSetup
from sdgen.errors import SdgenError, os_error_in_words
from sdgen.library import Library
from sdgen.render import choose_renderer
from sdgen.resources import data_path

#: A file in the folder of the build: who finds it there with the right words shares the folder.
PROBE = "shared"


@dataclass(frozen=True)
class Order:
    """What a remote worker is set up with.

    ``versions`` decide bytes and must be the same there; ``shipped`` is where the sender's own
    models lie, which need not be the same; ``probe`` is what PROBE holds, None when scenes shall
    be sent home in any case; ``workers`` is the most that the build has, None: one a core.
    """

    setup: WorkerSetup
    versions: dict[str, str]
    shipped: Path
    probe: str | None
    workers: int | None = None


@dataclass(frozen=True)
class Sent:
    """A scene's result with its folders as bytes, its twins' first."""

    result: SceneResult
    scenes: tuple[PackedScene, ...]


class RemoteWorker:
    """Makes scenes for a build elsewhere. Raises SdgenError when this machine cannot."""

    def __init__(self, order: Order) -> None:
        setup = order.setup
        _same_versions(order.versions, package_versions())
        folders = tuple(
            data_path("assets") if folder == order.shipped else folder
            for folder in setup.library_folders
        )
        if Library(folders).sha256 != setup.library_sha256:
            raise SdgenError(f"other models than the build has: {', '.join(map(str, folders))}")
        choice = choose_renderer(setup.options.renderer) if setup.choice is not None else None
        writer = dataclasses.replace(
            setup.writer, renderer=choice.renderer_string if choice is not None else None
        )
        self._away: Path | None = None
        if order.probe is None or not _shared(setup.writer.root, order.probe):
            self._away = Path(tempfile.mkdtemp(prefix="scenes-"))
            writer = dataclasses.replace(writer, root=self._away)
        self._work = SceneWorker(
            dataclasses.replace(
                setup, library_folders=folders, writer=writer, choice=choice, one_thread=True
            )
        )

    def __call__(self, index: int) -> SceneResult | Sent:
        """Make, draw and write scene ``index``, here or into the shared folder."""
        result = self._work(index)
        if self._away is None:
            return result
        entries = (self._away / BUILD_FOLDER / "entries").glob("*.json")
        # "000001-twin" before "000001": a scene that is there has its twins beside it.
        names = sorted((path.stem for path in entries), reverse=True)
        return Sent(result, tuple(pack(self._away, name) for name in names))

    def close(self) -> None:
        """Let go of simulator and renderer."""
        self._work.close()


def receive(root: Path, result: SceneResult | Sent) -> SceneResult:
    """Put what a worker sent into the data set at ``root``. SdgenError on a full disk."""
    if isinstance(result, SceneResult):
        return result
    try:
        for packed in result.scenes:
            unpack(root, packed)
    except OSError as error:
        raise SdgenError(
            f"scene {result.result.scene_id} cannot be written: {os_error_in_words(error, root)}; "
            "what is finished is kept, the same command goes on"
        ) from None
    return result.result


def _same_versions(there: dict[str, str], here: dict[str, str]) -> None:
    others = [
        f"{name} {here.get(name, 'none')} (the build has {there.get(name, 'none')})"
        for name in sorted({*there, *here})
        if here.get(name) != there.get(name)
    ]
    if others:
        raise SdgenError(f"a machine of the cluster would make other bytes: {'; '.join(others)}")


def _shared(root: Path, probe: str) -> bool:
    try:
        return (root / BUILD_FOLDER / PROBE).read_text(encoding="ascii") == probe
    except (OSError, UnicodeDecodeError):
        return False
