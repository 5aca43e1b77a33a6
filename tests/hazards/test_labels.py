"""What the record of an anomaly says."""

from typing import Any

import pytest
from sdgen.hazards.certify import facts_of, survey
from sdgen.hazards.labels import anomaly_records
from sdgen.scene import Anomaly
from sdgen.vocabulary import EVIDENCE_PIXELS

from tests import toy


@pytest.mark.parametrize(
    ("keys", "parts", "pixels"),
    [
        ({"evidence_state": "ON"}, ("glow",), 30),
        ({"evidence_state": "BROKEN"}, ("body", "glow"), EVIDENCE_PIXELS),
        ({"evidence_parts": ("flame", "glow")}, ("glow",), 30),
        # Of a model without such a part the whole is the evidence, as ever.
        ({"evidence_parts": ("flame",)}, ("body", "glow"), EVIDENCE_PIXELS),
        ({}, ("body", "glow"), EVIDENCE_PIXELS),
    ],
)
def test_labels_name_the_parts_that_show_them_and_how_many_pixels_do(
    keys: dict[str, Any], parts: tuple[str, ...], pixels: int
) -> None:
    scene = toy.scene(1)
    facts = facts_of(scene, toy.infos(), toy.catalog())
    changes = {"evidence_state": None, "evidence_pixels": 30, **keys}
    hazard = toy.catalog().hazard("stove_on").model_copy(update=changes)
    catalog = toy.catalog().model_copy(update={"hazards": (hazard,)})
    positives = survey(facts, catalog).positives
    (record,) = anomaly_records(positives, facts, catalog, toy.household(), {})
    assert (record.evidence_parts, record.evidence_pixels_needed) == (parts, pixels)


def test_labels_of_older_data_sets_are_shown_by_as_many_pixels_as_then() -> None:
    record = toy.bundle(1).anomalies.anomalies[0].model_dump()
    del record["evidence_pixels_needed"]
    assert Anomaly.model_validate(record).evidence_pixels_needed == EVIDENCE_PIXELS


def test_what_is_only_set_is_related_as_its_hazard_asks():
    """A stove that is on stands on the floor: its label says so when the hazard does."""
    scene = toy.scene(1)
    facts = facts_of(scene, toy.infos(), toy.catalog())
    positives = survey(facts, toy.catalog()).positives
    plain = anomaly_records(positives, facts, toy.catalog(), toy.household(), {})
    assert [(record.relation, record.target_id) for record in plain] == [(None, None)]

    changes = {"relation": "ON", "message": "The {object} on the {target} is on."}
    asking = toy.catalog().hazard("stove_on").model_copy(update=changes)
    catalog = toy.catalog().model_copy(update={"hazards": (asking,)})
    (record,) = anomaly_records(positives, facts, catalog, toy.household(), {})
    assert record.relation == "ON"
    assert facts.category(record.target_id) == "floor"
    assert record.message == "The stove on the floor is on."
