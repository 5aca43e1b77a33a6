"""A furnished home that recipes are tried in."""

from __future__ import annotations

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.hazards.splits import SplitModels
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.pipeline.spec import node_ids
from sdgen.seeding import lane

from tests.shipped import shipped_library


@pytest.fixture(scope="package")
def home() -> FurnishedHome:
    """The first base home that can be furnished; nobody changes it."""
    catalog, library = load_catalog(), shipped_library()
    models = SplitModels(library, "test")
    for base in catalog.homes:
        ids = node_ids(lane(3, 0, "ids:0"))
        made = furnished_home(base, catalog, library, models, ids, lane(3, 0, "furnish"))
        if isinstance(made, FurnishedHome):
            return made
    raise AssertionError("no base home can be furnished")
