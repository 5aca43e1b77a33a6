"""CI checks the whole library when it is not the one that was verified, and only then."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.by_path import ROOT, module_at

DIGEST = module_at("scripts/library_digest.py")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    for pattern in DIGEST.CHECKED:
        path = tmp_path / pattern.replace("*", "some")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(pattern, encoding="ascii")
    return tmp_path


def test_a_library_that_was_never_verified_is_told(
    checkout: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert DIGEST.main(checkout, "--check") == 1
    assert "make test-library" in capsys.readouterr().out


def test_what_was_verified_stays_so_until_it_changes(checkout: Path) -> None:
    assert DIGEST.main(checkout, "--record") == 0
    assert DIGEST.main(checkout, "--check") == 0
    for pattern in DIGEST.CHECKED:
        path = checkout / pattern.replace("*", "some")
        text = path.read_text(encoding="ascii")
        path.write_text("other", encoding="ascii")
        assert DIGEST.main(checkout, "--check") == 1, pattern
        path.write_text(text, encoding="ascii")
    assert DIGEST.main(checkout, "--check") == 0
    (checkout / "assets" / "meshes" / "one_more").touch()
    assert DIGEST.main(checkout, "--check") == 1


def test_all_it_covers_is_there() -> None:
    assert len(DIGEST.library_digest(ROOT)) == 64


def test_it_covers_all_that_reads_and_checks_models() -> None:
    """What the checks import of ``library``, ``physics`` and ``validate``, and what that does."""
    covered = {path for pattern in DIGEST.CHECKED for path in ROOT.glob(pattern)}
    source = ROOT / "generator" / "sdgen"
    waiting = [source / "validate" / "assets.py"]
    needed: set[Path] = set()
    while waiting:
        path = waiting.pop()
        needed.add(path)
        named = re.findall(
            r"^ *from sdgen\.((?:library|physics|validate)\.\w+) import",
            path.read_text(encoding="utf-8"),
            re.M,
        )
        found = {source / f"{name.replace('.', '/')}.py" for name in named}
        waiting += sorted(found - needed)
    assert len(needed) > 15
    assert needed <= covered
