"""The survey asks a hazard only of categories it can concern: the same as asking it of all."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen import Dataset
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog
from sdgen.catalog.terms import AllTerm, AnyTerm, CategoryTerm, HeightTerm, NotTerm, Predicate
from sdgen.hazards.certify import Positive, facts_of, survey

from tests.shipped import shipped_library

SAMPLE = Path(__file__).resolve().parents[2] / "output" / "sample"
#: True of everything in a home, so that categories alone tell the objects apart.
LOW = HeightTerm(max_m=5.0)


def packed(catalog: Catalog, scene_categories: list[str]) -> Catalog:
    """The catalogue with hazards whose predicates name categories in every position."""
    some, more = (
        CategoryTerm(any_of=(scene_categories[0],)),
        CategoryTerm(any_of=(scene_categories[1],)),
    )
    predicates: dict[str, Predicate] = {
        "either": AnyTerm(terms=(some, LOW)),
        "one_of_two": AllTerm(terms=(AnyTerm(terms=(some, more)), LOW)),
        "not_that": AllTerm(terms=(NotTerm(term=some), LOW)),
        "both": AllTerm(terms=(some, more)),
        "nested": AllTerm(terms=(AllTerm(terms=(some, LOW)), LOW)),
    }
    first = catalog.hazards[0]
    added = [first.model_copy(update={"id": k, "predicate": v}) for k, v in predicates.items()]
    return catalog.model_copy(update={"hazards": (*catalog.hazards, *added)})


@pytest.mark.parametrize("index", range(3))
def test_the_survey_finds_what_asking_every_hazard_of_every_object_finds(index: int) -> None:
    scene = Dataset(SAMPLE)[index].scene
    catalog = packed(load_catalog(), sorted({item.category for item in scene.objects}))
    facts = facts_of(scene, shipped_library().infos, catalog)
    expected = []
    for item in scene.objects:
        for hazard in catalog.hazards:
            verdict = hazard.predicate.evaluate(item.id, facts)
            if verdict.value or not verdict.sure:
                expected.append(Positive(item.id, hazard.id, verdict))
    result = survey(facts, catalog)
    assert result.positives == tuple(expected)
    assert result.pairs == len(scene.objects) * len(catalog.hazards)
    assert {"either", "one_of_two", "not_that", "nested"} <= {p.hazard for p in expected}
