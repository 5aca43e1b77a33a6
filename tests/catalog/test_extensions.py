"""The shipped packs: each loads alone and with all others, in any order, and says as much of its
hazards as the thirteen classes do."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from sdgen.catalog.enumeration import check_against_library, enumerate_anomalies
from sdgen.catalog.folder import extension_names
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Hazard, PlaceRecipe
from sdgen.errors import InputError
from sdgen.resources import data_path

from tests.shipped import shipped_library

from .worlds import HAZARD, write

PACKS = tuple(extension_names())
CORE = load_catalog()
ALL = load_catalog(extensions=PACKS)
EXTRA = [hazard for hazard in ALL.hazards if hazard.pack != "core"]


def test_there_are_packs_enough_and_none_is_on_by_itself() -> None:
    assert len(PACKS) >= 7
    assert len(EXTRA) >= 24
    assert {hazard.pack for hazard in EXTRA} == set(PACKS)
    assert {hazard.pack for hazard in CORE.hazards} == {"core"}
    assert len(CORE.hazards) == 13


@pytest.mark.parametrize("pack", PACKS)
def test_a_pack_loads_alone_and_has_models_for_all_it_names(pack: str) -> None:
    catalog = load_catalog(extensions=[pack])
    assert {hazard.pack for hazard in catalog.hazards} == {"core", pack}
    library = shipped_library()
    parts = {
        category: {part.name for asset in library.by_category(category) for part in asset.parts}
        for category in library.categories
    }
    check_against_library(catalog, library.states_by_category(), parts)


def test_packs_are_merged_by_name_whichever_way_they_are_named() -> None:
    assert load_catalog(extensions=PACKS[::-1]).sha256 == ALL.sha256
    assert load_catalog(extensions=(*PACKS, PACKS[0])).sha256 == ALL.sha256
    assert all(a.id < b.id for a, b in pairwise(ALL.hazards))


@pytest.mark.parametrize("hazard", EXTRA, ids=lambda hazard: f"{hazard.pack}-{hazard.id}")
def test_a_packs_hazard_says_as_much_as_the_thirteen(hazard: Hazard) -> None:
    assert hazard.severity is not None
    assert hazard.guidance
    assert hazard.lookalikes
    assert hazard.remedy
    library = shipped_library()
    for recipe in (*hazard.anomalies, *hazard.lookalikes):
        known = [c for c in recipe.categories if library.by_category(c)]
        assert known == list(recipe.categories), recipe
        targets = recipe.targets if isinstance(recipe, PlaceRecipe) else ()
        assert all(t == "floor" or library.by_category(t) for t in targets), recipe
    found = [one for one in enumerate_anomalies(ALL) if one.hazard == hazard.id]
    assert found


def test_the_same_id_in_two_packs_is_an_error_unless_it_says_so(tmp_path: Path) -> None:
    shipped = EXTRA[0]
    mine = HAZARD.replace("wobbly_vase", shipped.id)
    folder = write(tmp_path, **{f"hazards__{shipped.id}": mine})
    with pytest.raises(InputError) as caught:
        load_catalog([folder], extensions=[shipped.pack])
    (problem,) = caught.value.problems
    assert "is already defined at hazard_catalog/extensions/" in problem
    assert "replaces: true" in problem
    write(tmp_path, **{f"hazards__{shipped.id}": mine + "replaces: true\n"})
    catalog = load_catalog([folder], extensions=[shipped.pack])
    assert catalog.hazard(shipped.id).title == "Vase at the edge"


def test_each_pack_is_a_folder_of_the_usual_layout() -> None:
    for pack in PACKS:
        names = {path.name for path in data_path("hazard_catalog", "extensions", pack).iterdir()}
        assert "hazards" in names
        assert names <= {"hazards", "categories"}
