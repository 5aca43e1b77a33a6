"""Which renderer is used, and that another one needs no more than its class and its line."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import ClassVar

import numpy as np
import numpy.typing as npt
import pytest
from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.physics.bullet import quiet
from sdgen.render import registry
from sdgen.render.frames import render_frames
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.raster import renderer as raster
from sdgen.render.raster.renderer import INSTALL_HINT, GlRenderer
from sdgen.render.registry import RENDERERS, choose_renderer, open_renderer, renderer_type
from sdgen.scene import Camera, Scene
from sdgen.scratch import clear_dead

from tests.fakes import box_room, camera_at, thing


def refuse(monkeypatch: pytest.MonkeyPatch, reason: str) -> None:
    refused = Probe(False, reason=reason, hint=INSTALL_HINT)
    monkeypatch.setattr(GlRenderer, "probe", staticmethod(lambda: refused))


def test_without_egl_auto_takes_the_cpu_and_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    refuse(monkeypatch, "no display.")
    choice = choose_renderer("auto")
    assert choice.kind == "cpu"
    assert choice.note == (
        "EGL does not start (no display); going on with the CPU renderer. "
        "On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri libgl1"
    )
    with pytest.raises(RendererError, match=r"EGL .* start: no display\. .*libegl1 libgl1-mesa"):
        choose_renderer("egl")


def test_an_unknown_renderer_is_one_clear_error() -> None:
    with pytest.raises(RendererError, match=r"no renderer 'elg' .did you mean 'egl'"):
        open_renderer("elg")


@pytest.mark.parametrize("kind", RENDERERS)
def test_every_registered_renderer_has_a_name_and_says_whether_it_starts(kind: str) -> None:
    made_by = renderer_type(kind)
    found = made_by.probe()
    assert made_by.name
    assert found.renderer_string if found.works else found.reason


def test_a_probe_that_dies_is_an_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    probe = "print('failed to open display', flush=True); import os; os.abort()"
    monkeypatch.setattr(raster, "_PROBE", probe)
    found = GlRenderer.probe()
    assert not found.works
    assert "failed to open display" in found.reason


def test_quiet_catches_what_c_prints(capfd: pytest.CaptureFixture[str]) -> None:
    with quiet() as caught:
        os.write(1, b"from below\n")
    os.write(1, b"afterwards\n")
    assert caught.text == "from below\n"
    assert capfd.readouterr().out == "afterwards\n"


def test_rendering_prints_nothing() -> None:
    code = "from sdgen.render import open_renderer\nwith open_renderer('auto'): pass"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
    assert done.stdout + done.stderr == b""


def test_choosing_a_name_imports_no_simulator() -> None:
    """The command line lists the renderers, and must start at once."""
    code = "import sys, sdgen.render\nprint({'pybullet', 'numpy'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


@pytest.mark.parametrize("end", ["renderer.close()", "os._exit(9)"])
def test_no_folder_stays_after_a_renderer(
    end: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Closed, it takes its folder away; killed, the next owner of one does."""
    code = (
        f"import os\nfrom sdgen.render import open_renderer\nrenderer = open_renderer('cpu')\n{end}"
    )
    subprocess.run(
        [sys.executable, "-c", code], check=False, env={**os.environ, "TMPDIR": str(tmp_path)}
    )
    assert len(list(tmp_path.iterdir())) == (1 if "_exit" in end else 0)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    clear_dead()
    assert list(tmp_path.iterdir()) == []


class FlatRenderer(Renderer):
    """Sees the scene's first object in the left half of every picture, 2 m away."""

    name: ClassVar[str] = "the flat renderer"
    renderer_string = "flat"

    def __init__(self) -> None:
        self.closed = False

    @staticmethod
    def probe() -> Probe:
        return Probe(True, "flat")

    def load(self, library: Library, scene: Scene) -> None:
        self._id = scene.objects[0].id

    def draw(self, camera: Camera, colours: bool = True) -> Picture:
        instance = np.zeros((camera.height, camera.width), dtype=np.uint16)
        instance[:, : camera.width // 2] = self._id
        return Picture(
            rgb=self.draw_colours(camera, 1),
            depth_m=np.full(instance.shape, 2.0),
            instance=instance,
            part=(instance > 0).astype(np.uint8),
        )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        return np.full((camera.height * factor, camera.width * factor, 3), 90, dtype=np.uint8)

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def flat(monkeypatch: pytest.MonkeyPatch) -> Iterator[Renderer]:
    monkeypatch.setattr(registry, "RENDERERS", {"flat": f"{__name__}:FlatRenderer"})
    with open_renderer("auto") as renderer:
        yield renderer
    assert isinstance(renderer, FlatRenderer)
    assert renderer.closed


@pytest.mark.parametrize("supersample", [1, 2])
def test_another_renderer_needs_its_class_and_a_line(
    flat: Renderer, library: Library, supersample: int
) -> None:
    scene = box_room([thing(10, "cube_01", (0.5, 0, 0))])
    view = camera_at((-1.5, 0, 0.25), (1, 0, 0.1), (32, 24))
    (frame,) = render_frames(flat, library, scene, [view], supersample=supersample)
    assert (frame.depth_mm[:, :16] == 2000).all()
    assert (frame.depth_mm[:, 16:] == 0).all()
    assert (frame.rgb == 90).all()
    # Seen in half the picture, and it would cover a little on the right of it besides.
    assert frame.alone_pixels[10] > 16 * 24
