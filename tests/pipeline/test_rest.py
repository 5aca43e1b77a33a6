"""What does not stand as it was meant to is named, furniture too."""

import pytest
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.world import World
from sdgen.pipeline.contents import Contents
from sdgen.pipeline.rest import come_to_rest
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Cause


@pytest.fixture(scope="module")
def home(catalog, library):
    return furnish_for(draw_spec(3, catalog, BuildOptions(n=9, seed=5)), 0, catalog, library)


def rested(home, library, items):
    with Client() as client:
        contents = Contents(items, {}, {}, {})
        return come_to_rest(0, home, contents, False, library, World(library, client))


def test_furniture_as_it_was_arranged_stands(home, library):
    assert rested(home, library, home.layout.items).offenders == {}


def test_furniture_in_the_air_is_an_offence(home, library):
    items = dict(home.layout.items)
    key, item = next((k, item) for k, item in items.items() if item.category == "wardrobe")
    x, y, z = item.pose.position_m
    pose = item.pose.model_copy(update={"position_m": (x, y, z + 0.04)})
    items[key] = item.model_copy(update={"pose": pose})
    (offence,) = rested(home, library, items).offenders.values()
    assert offence.cause == Cause("physics", "in_the_air", None, "wardrobe")
    assert offence.objects == (key,)
    assert offence.measured is not None
    assert offence.measured > offence.limit
