"""What the pipeline's tests share: the shipped catalogue and library, and scenes made of them."""

import pytest
from sdgen.catalog.load import load_catalog

from tests.made import made_scenes
from tests.shipped import shipped_library


@pytest.fixture(scope="session")
def catalog():
    return load_catalog()


@pytest.fixture(scope="session")
def library():
    return shipped_library()


@pytest.fixture(scope="session")
def scene_bundle(shared, catalog, library):
    """Scene ``index`` of ``tests.made.OPTIONS``, made by one of the workers."""

    def made(index):
        return made_scenes(shared, catalog, library, [index])[0].bundle

    return made
