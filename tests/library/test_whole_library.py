"""All shipped models, one by one: ``make test-library``, run by CI when the library changed."""

from __future__ import annotations

import re

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.library.manifest import manifest_bytes, read_manifest
from sdgen.validate.assets import check_assets

from tests.by_path import ROOT, module_at
from tests.shipped import shipped_library

pytestmark = pytest.mark.library
SHARES = 16


@pytest.mark.parametrize("share", range(SHARES))
def test_every_model_is_sound(share: int) -> None:
    models = list(shipped_library().assets)[share::SHARES]
    assert check_assets([], load_catalog(), words=models) == []


def test_every_file_is_whole() -> None:
    library = shipped_library()
    for folder in library.folders:
        library.check_files(folder)
    (folder,) = library.folders
    found = read_manifest(folder, manifest_bytes(folder))
    assert len(found.assets) == len(library.assets)


def test_the_geometries_truly_differ(capsys: pytest.CaptureFixture[str]) -> None:
    module_at("scripts/distinct_geometries.py").main([])
    counted = int(capsys.readouterr().out.splitlines()[-1].split()[0])
    assert counted >= 600
    page = (ROOT / "docs" / "assets.md").read_text(encoding="utf-8")
    (told,) = re.findall(r"^\| geometries that differ \| (\d+) ", page, re.M)
    assert counted == int(told)
