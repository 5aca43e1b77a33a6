import os
import subprocess
import sys

import pytest
from sdgen.errors import RendererError
from sdgen.physics.bullet import quiet
from sdgen.render import backend
from sdgen.render.backend import EglProbe, choose_renderer


def test_without_egl_auto_takes_the_cpu_and_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "probe_egl", lambda: EglProbe(False, reason="no display"))
    choice = choose_renderer("auto")
    assert (choice.kind, choice.reason) == ("cpu", "no display")
    with pytest.raises(RendererError, match="libegl1 libgl1-mesa-dri libgl1"):
        choose_renderer("egl")


def test_a_probe_that_dies_is_an_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "_PROBE", "print('failed to open display'); import os; os.abort()")
    found = backend.probe_egl()
    assert not found.works
    assert "failed to open display" in found.reason


def test_a_pybullet_without_the_plugin(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "plugin_path", lambda: None)
    assert choose_renderer("auto").kind == "cpu"


def test_quiet_catches_what_c_prints(capfd: pytest.CaptureFixture[str]) -> None:
    with quiet() as caught:
        os.write(1, b"from below\n")
    os.write(1, b"afterwards\n")
    assert caught.text == "from below\n"
    assert capfd.readouterr().out == "afterwards\n"


def test_rendering_prints_nothing() -> None:
    code = "from sdgen.render.frames import Renderer\nwith Renderer('auto'): pass"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True)
    assert done.stdout + done.stderr == b""
