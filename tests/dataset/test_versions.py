"""``dataset.json`` names what decides bytes."""

import json
from pathlib import Path

from sdgen.dataset.versions import OF_PICTURES, PACKAGES, package_versions

from tests import toy


def test_everything_that_decides_bytes_is_named() -> None:
    found = package_versions()
    assert set(found) == {*PACKAGES, *OF_PICTURES, "machine", "sdgen"}
    assert list(found) == sorted(found)
    assert "unknown" not in found.values()


def test_a_build_records_them(tmp_path: Path) -> None:
    with toy.open_writer(tmp_path / "out", toy.small(n=1), versions=None) as writer:
        writer.finish()
    info = json.loads((tmp_path / "out" / "dataset.json").read_text(encoding="utf-8"))
    assert info["versions"] == package_versions()
