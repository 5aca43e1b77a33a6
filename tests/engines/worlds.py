"""Catalogues for tests of what is said before a build."""

from pathlib import Path

from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog

_HAZARD = """\
id: mine
title: A hazard of a newcomer
group: safety
concerns: {{who: everyone}}
urgency: medium
message: The {{object}} in the {{room}} is not as it should be.
source: a test
predicate: {predicate}
anomalies: [{anomaly}]
remedy: [{{action: close}}]
"""


def with_hazard(folder: Path, predicate: str, anomaly: str) -> Catalog:
    """The shipped catalogue and a hazard ``mine`` of this predicate and recipe (YAML)."""
    return load_catalog([write_hazard(folder, predicate, anomaly)])


def write_hazard(folder: Path, predicate: str, anomaly: str) -> Path:
    """A catalogue folder with the hazard ``mine``."""
    path = folder / "mine" / "hazards" / "mine.yaml"
    path.parent.mkdir(parents=True)
    path.write_text(_HAZARD.format(predicate=predicate, anomaly=anomaly))
    return folder / "mine"
