"""What becomes of an anomaly in a home does not depend on what was tried there before."""

from __future__ import annotations

import pytest
from sdgen.catalog.enumeration import enumerate_anomalies
from sdgen.catalog.load import load_catalog
from sdgen.engines.trials import in_words
from sdgen.hazards.splits import SplitModels
from sdgen.physics.client import Client
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.pipeline.spec import node_ids
from sdgen.pipeline.trial import Fits, TrialHome
from sdgen.scene import Household
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
UNIQUE = {in_words(one): one for one in enumerate_anomalies(CATALOG)}


@pytest.mark.slow
def test_an_anomaly_rests_where_it_would_had_nothing_been_tried_before() -> None:
    """Things that roll tell: what a world remembers would move them."""
    library = shipped_library()
    ids = node_ids(lane(3, 0, "ids:0"))
    home = furnished_home(
        CATALOG.homes[0],
        CATALOG,
        library,
        SplitModels(library, "test"),
        ids,
        lane(3, 0, "furnish"),
    )
    assert isinstance(home, FurnishedHome)
    nobody = Household(template="test", members=(), notifications={})
    names = [
        "broken_item: BROKEN beer_bottle ON coffee_table",
        "choking_hazard: marbles ON coffee_table",
        "broken_item: BROKEN beer_bottle ON bookshelf",
    ]

    def tried(order: list[str]) -> dict[str, object]:
        with Client() as own, Client() as client:
            trial = TrialHome(home, nobody, library, (own, client))
            out: dict[str, object] = {}
            for name in order:
                for k in range(4):
                    found = trial.attempt(UNIQUE[name], lane(3, k, name))
                    out[f"{name} {k}"] = found.facts.scene if isinstance(found, Fits) else found
            return out

    forwards = tried(names)
    assert sum(not hasattr(one, "cause") and one is not None for one in forwards.values()) >= 4
    assert tried(names[::-1]) == forwards
