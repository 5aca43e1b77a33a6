"""A catalogue that is not meant to be read ends in a clear error, soon."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from sdgen.catalog import load
from sdgen.catalog.cases import cases, placements
from sdgen.catalog.load import extension_names, load_catalog
from sdgen.catalog.records import PlaceRecipe, SetRecipe

from .worlds import HAZARD, problems, write

ANOMALY = "  - {place: vase, relation: ON, target: coffee_table}\n"
#: Seconds: ten times what each of these takes.
SOON = 20.0


@pytest.fixture(autouse=True)
def soon() -> Iterator[None]:
    start = time.monotonic()
    yield
    assert time.monotonic() - start < SOON


def test_ten_thousand_hazards(tmp_path: Path) -> None:
    folder = tmp_path / "hazards"
    folder.mkdir()
    for number in range(10_000):
        (folder / f"h{number:05}.yaml").write_text(HAZARD.replace("wobbly_vase", f"h{number:05}"))
    found = problems(tmp_path)
    assert found == (
        f"{folder}: holds more than 500 files",
        f"{folder}/h00487.yaml:1: is one hazard too many: a catalogue has at most 500",
    )


def test_hazards_are_counted_over_all_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(load, "MAX_HAZARDS", len(load_catalog().hazards) + 1)
    one = write(tmp_path / "a", hazards__a=HAZARD.replace("wobbly_vase", "a"))
    two = write(tmp_path / "b", hazards__b=HAZARD.replace("wobbly_vase", "b"))
    load_catalog([one])
    (found,) = problems(one, two)
    assert found.startswith(f"{two}/hazards/b.yaml:1: is one hazard too many")


def test_ten_thousand_categories(tmp_path: Path) -> None:
    line = "g{}: {{superclass: Props, size_m: [[1, 1, 1], [1, 1, 1]], mass_kg: [1, 1]}}\n"
    several = {
        f"categories__c{part}": "".join(line.format(part * 5000 + k) for k in range(5000))
        for part in range(2)
    }
    (found,) = problems(write(tmp_path, **several))
    assert "is one category too many: a catalogue has at most 2000" in found


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            ANOMALY,
            ANOMALY * 10_000,
            ":12: anomalies: expected at least one recipe, and at most 1000",
        ),
        (
            "remedy:",
            f"lookalikes:\n{ANOMALY * 10_000}remedy:",
            "lookalikes: expected at most 1000 recipes, got 10000 items",
        ),
        (
            "  relation: ON\nrelation",
            "  all:\n" + "    - {relation: ON}\n" * 10_000 + "relation",
            ": the predicate has more than 1000 terms",
        ),
    ],
    ids=["recipes", "lookalikes", "terms"],
)
def test_ten_thousand_of_a_hazard(tmp_path: Path, old: str, new: str, told: str) -> None:
    assert old in HAZARD
    found = problems(write(tmp_path, hazards__wobbly_vase=HAZARD.replace(old, new, 1)))
    assert len(found) <= 2
    assert any(told in line for line in found), found
    assert all(line.startswith(f"{tmp_path}/hazards/wobbly_vase.yaml:") for line in found)


def test_few_words_that_stand_for_very_many_placements(tmp_path: Path) -> None:
    names = ", ".join(category.name for category in load_catalog().categories)
    lines = [f"  - {{place: &a [{names}], relation: ON, target: &b [{names}]}}\n"]
    lines += ["  - {place: *a, relation: ON, target: *b}\n"] * 100
    text = HAZARD.replace(ANOMALY, "".join(lines))
    (found,) = problems(write(tmp_path, hazards__wobbly_vase=text))
    assert ":12: anomalies: its recipes stand for 10" in found
    assert "placements; at most 20000 will do" in found


def test_placements_are_counted_over_all_hazards(tmp_path: Path) -> None:
    names = [category.name for category in load_catalog().categories][:120]
    text = HAZARD.replace("category: vase", f"category: [{', '.join(names)}]").replace(
        ANOMALY,
        f"  - {{place: [{', '.join(names)}], relation: ON, target: [{', '.join(names)}]}}\n",
    )
    several = {f"hazards__h{k}": text.replace("wobbly_vase", f"h{k}") for k in range(5)}
    found = problems(write(tmp_path, **several))
    assert "with it, all recipes stand for more than 50000 placements" in found[0]


def test_an_activity_of_very_many_placements(tmp_path: Path) -> None:
    names = ", ".join(category.name for category in load_catalog().categories)
    text = f"all: {{at: [{names}], members: [{{thing: [{names}]}}]}}\n"
    (found,) = problems(write(tmp_path, activities__mine=text))
    assert ":1: all.members: its members stand for" in found


def test_cases_are_counted_without_being_made() -> None:
    for recipe in (
        PlaceRecipe(categories=("a", "b"), relation="ON", targets=("floor", "c"), rooms=("x", "y")),
        PlaceRecipe(categories=("a", "b"), relation="ON", targets=("floor", "c", "d")),
        SetRecipe(categories=("a", "b"), state="ON", rooms=("x", "y", "z")),
        SetRecipe(categories=("a", "b"), state="ON"),
    ):
        assert placements(recipe) == len(cases(recipe))
    for hazard in load_catalog(extensions=extension_names()).hazards:
        for recipe in hazard.anomalies:
            assert placements(recipe) == len(cases(recipe))


def test_a_folder_that_is_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = f"# {'x' * 900_000}\n"
    folder = write(tmp_path, **{f"categories__c{k:02}": text for k in range(15)})
    found = problems(folder)
    assert f"{tmp_path.name}: its files have more than 10 MB" in found


def test_what_is_no_file_is_told_and_never_waited_for(tmp_path: Path) -> None:
    folder = tmp_path / "hazards"
    folder.mkdir()
    os.mkfifo(folder / "pipe.yaml")
    (folder / "zero.yaml").symlink_to("/dev/zero")
    (folder / "folder.yaml").mkdir()
    (folder / "gone.yaml").symlink_to(tmp_path / "none")
    (folder / "nul.yaml").write_bytes(b"id: a\x00b\n")
    (folder / "endless").symlink_to("/")
    found = problems(tmp_path)
    for told in (
        "folder.yaml: is a folder, not a file",
        "gone.yaml: no such file",
        "pipe.yaml: is a FIFO, not a file",
        "zero.yaml: is a device, not a file",
        "endless: folders in it are not read; move its files up",
        "nul.yaml:1: not valid YAML",
    ):
        assert any(line.startswith(f"{folder}/{told}") for line in found), (told, found)
