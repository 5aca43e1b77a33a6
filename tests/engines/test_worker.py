"""What a worker says of a full disk or a folder that is gone: which one, and that it can go on."""

import errno
import shutil
import tempfile

import pytest
from sdgen.engines import worker
from sdgen.engines.worker import SceneWorker, WorkerSetup
from sdgen.errors import SdgenError
from sdgen.render import Choice

from tests import toy
from tests.fakes import fake_library

FULL = OSError(errno.ENOSPC, "No space left on device")
GOES_ON = "; what is finished is kept, the same command goes on"


class Renderer:
    """Draws nothing."""

    def close(self) -> None:
        pass


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    """The folder for temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


@pytest.fixture
def scenes(tmp_path, temporary, monkeypatch):
    """A worker whose pictures come from a renderer that draws nothing, and its data set."""
    monkeypatch.setattr(worker, "open_renderer", lambda choice: Renderer())
    library = fake_library(tmp_path / "library")
    with toy.open_writer(tmp_path / "set") as writer:
        setup = WorkerSetup(
            catalog=toy.catalog(),
            library_folders=library.folders,
            library_sha256=library.sha256,
            options=writer.build.options,
            writer=toy.painter(writer),
            choice=Choice("painted", "painted"),
            one_thread=False,
        )
        with SceneWorker(setup) as made:
            yield made


def said(scenes: SceneWorker) -> str:
    with pytest.raises(SdgenError) as caught:
        scenes(0)
    return str(caught.value)


def test_the_temporary_files_are_named_when_a_scene_is_made(scenes, temporary, monkeypatch):
    def on_a_full_disk(index, catalog, library, options, client):
        raise FULL

    monkeypatch.setattr(worker, "make_scene", on_a_full_disk)
    assert said(scenes) == f"scene 000000 cannot be made: {temporary}: {FULL.strerror}{GOES_ON}"

    def without_its_folder(index, catalog, library, options, client):
        shutil.rmtree(temporary)
        client.convex("o p0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")

    monkeypatch.setattr(worker, "make_scene", without_its_folder)
    text = said(scenes)
    assert text.startswith(f"scene 000000 cannot be made: {temporary}/sdgen-scratch-")
    assert text.endswith(f".obj: No such file or directory{GOES_ON}")


def test_the_disk_that_is_full_is_named_whether_a_scene_is_drawn_or_written(
    scenes, tmp_path, temporary, monkeypatch
):
    monkeypatch.setattr(worker, "make_scene", lambda index, *rest: toy.bundle(index))

    def full_while_drawing(*args):
        raise FULL
        yield

    monkeypatch.setattr(worker, "render_frames", full_while_drawing)
    assert said(scenes) == f"scene 000000 cannot be drawn: {temporary}: {FULL.strerror}{GOES_ON}"

    def full_while_written(folder, frame):
        raise FULL

    monkeypatch.setattr(worker, "render_frames", lambda *args: iter(toy.frames(toy.bundle(0))))
    monkeypatch.setattr("sdgen.dataset.scene_folder.SceneFolder.add", full_while_written)
    root = tmp_path / "set"
    assert said(scenes) == f"scene 000000 cannot be written: {root}: {FULL.strerror}{GOES_ON}"
    assert not (root / "scenes").exists()
