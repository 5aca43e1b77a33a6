"""What the record of an anomaly says."""

from sdgen.hazards.certify import facts_of, survey
from sdgen.hazards.labels import anomaly_records

from tests import toy


def test_what_is_only_set_is_related_as_its_hazard_asks():
    """A stove that is on stands on the floor: its label says so when the hazard does."""
    scene = toy.scene(1)
    facts = facts_of(scene, toy.infos(), toy.catalog())
    positives = survey(facts, toy.catalog()).positives
    plain = anomaly_records(positives, facts, toy.catalog(), toy.household())
    assert [(record.relation, record.target_id) for record in plain] == [(None, None)]

    changes = {"relation": "ON", "message": "The {object} on the {target} is on."}
    asking = toy.catalog().hazard("stove_on").model_copy(update=changes)
    catalog = toy.catalog().model_copy(update={"hazards": (asking,)})
    (record,) = anomaly_records(positives, facts, catalog, toy.household())
    assert record.relation == "ON"
    assert facts.category(record.target_id) == "floor"
    assert record.message == "The stove on the floor is on."
