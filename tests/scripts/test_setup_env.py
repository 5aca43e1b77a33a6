"""The set-up script finds the right Python and says clearly when there is none."""

from __future__ import annotations

import importlib.util
import stat
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent


@pytest.fixture
def setup_env(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("setup_env", ROOT / "scripts" / "setup_env.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.delenv("PYTHON", raising=False)
    monkeypatch.setenv("PYENV_ROOT", str(tmp_path / "none"))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(module.sys, "executable", str(tmp_path / "gone"))
    return module


def interpreter(folder: Path, name: str, says: str) -> None:
    """A program that answers the version probe with ``says``, or fails like a broken shim."""
    path = folder / name
    path.write_text(f"#!/bin/sh\n{says}\n", encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)


def test_prefers_a_python_that_has_wheels(setup_env: ModuleType, tmp_path: Path) -> None:
    interpreter(tmp_path, "python3", "echo 3.13")
    interpreter(tmp_path, "python3.12", "echo 3.12")
    interpreter(tmp_path, "python3.10", "echo 3.10")
    assert setup_env.find_python() == (str(tmp_path / "python3.10"), (3, 10))
    interpreter(tmp_path, "python3.11", "echo 3.11")
    assert setup_env.find_python() == (str(tmp_path / "python3.11"), (3, 11))


def test_broken_shims_and_old_versions_are_passed_over(
    setup_env: ModuleType, tmp_path: Path
) -> None:
    interpreter(tmp_path, "python3.11", "echo 'command not found' >&2; exit 127")
    interpreter(tmp_path, "python3.10", "echo 3.9")
    interpreter(tmp_path, "python3", "echo 3.12")
    assert setup_env.find_python() == (str(tmp_path / "python3"), (3, 12))


def test_the_user_has_the_last_word(
    setup_env: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    interpreter(tmp_path, "python3.11", "echo 3.11")
    interpreter(tmp_path, "mine", "echo 3.13")
    monkeypatch.setenv("PYTHON", str(tmp_path / "mine"))
    assert setup_env.find_python() == (str(tmp_path / "mine"), (3, 13))


def test_no_usable_python_is_one_clear_line(
    setup_env: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    interpreter(tmp_path, "python3", "echo 3.8")
    with pytest.raises(SystemExit) as stopped:
        setup_env.find_python()
    assert stopped.value.code == 1
    assert "apt-get install python3.11" in capsys.readouterr().err


def test_a_stamp_holds_for_the_same_files_and_fewer_extras(
    setup_env: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(setup_env, "STAMP", str(tmp_path / "stamp.json"))
    monkeypatch.setattr(setup_env, "PYTHON", sys.executable)
    wanted = setup_env.wanted_stamp(["dev"])
    assert not setup_env.up_to_date(wanted)
    (tmp_path / "stamp.json").write_text(setup_env.json.dumps(wanted), encoding="utf-8")
    monkeypatch.setattr(setup_env, "version_of", lambda _: (3, 11))
    assert setup_env.up_to_date(wanted)
    assert setup_env.up_to_date(setup_env.wanted_stamp([]))
    assert not setup_env.up_to_date(setup_env.wanted_stamp(["dev", "assets"]))
    assert not setup_env.up_to_date({**wanted, "sha256": "other"})
