"""What a new hazard begins with can be used at once."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.load import check_against_library, load_catalog
from sdgen.catalog.starter import Kind, check_new_name, starter_files
from sdgen.errors import UsageError

from tests.shipped import shipped_library


def written(folder: Path, name: str, kind: Kind) -> Path:
    for path, text in starter_files(name, kind, "my_hazards").items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return folder


@pytest.mark.parametrize("name", ["a", "on", "x9_" * 30 + "z"])
@pytest.mark.parametrize("kind", ["place", "set"])
def test_it_loads_as_it_is_whatever_its_name(tmp_path: Path, name: str, kind: Kind) -> None:
    catalog = load_catalog([written(tmp_path / "mine", name, kind)])
    assert catalog.hazard(name).anomalies[0].kind == kind
    assert catalog.hazard(name).lookalikes
    check_against_library(catalog, shipped_library().states_by_category())


def test_it_goes_with_every_shipped_pack(tmp_path: Path) -> None:
    from sdgen.catalog.folder import extension_names

    folder = written(written(tmp_path / "mine", "one", "place"), "two", "set")
    assert load_catalog([folder], extensions=extension_names()).hazard("two")


def test_every_field_is_explained(tmp_path: Path) -> None:
    for kind in ("place", "set"):
        text = starter_files("mine", kind, "my_hazards")["hazards/mine.yaml"]
        before = ""
        for line in text.splitlines():
            key = line[:1].isalpha() and not line.startswith(("evidence_state", "relation"))
            if key and "#" not in line:
                assert before.startswith("#"), line
            before = line


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("Glass", "is not a name"),
        ("", "is not a name"),
        ("../glass", "is not a name"),
        ("null", "is not a name"),
        ("spill", "is the name of a hazard or a pack that is shipped"),
    ],
)
def test_bad_names_are_refused(name: str, words: str) -> None:
    with pytest.raises(UsageError, match=words):
        check_new_name(name, ["spill", "heat"])
    check_new_name("glass", ["spill", "heat"])
