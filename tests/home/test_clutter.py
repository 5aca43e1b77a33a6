"""Everyday things: a small home is lived in as well."""

from __future__ import annotations

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.hazards.splits import SplitModels
from sdgen.home.clutter import LEAST_THINGS, add_clutter
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.seeding import lane

from tests.shipped import shipped_library


@pytest.mark.parametrize("home", ["three_room_flat_2", "apartment_1"])
def test_every_home_holds_sixty_things(home):
    catalog, library = load_catalog(), shipped_library()
    models = SplitModels(library, "test")
    base = next(h for h in catalog.homes if h.id == home)
    for seed in range(3):
        ids = iter(range(1, 60000))
        stage = furnished_home(base, catalog, library, models, ids, lane(seed, 0, "furnish"))
        assert isinstance(stage, FurnishedHome)
        layout = stage.layout.copy()
        add_clutter(layout, stage.context, lane(seed, 0, "place"))
        small = [item for item in layout.items.values() if not item.fixed]
        assert len(small) >= LEAST_THINGS > 60
