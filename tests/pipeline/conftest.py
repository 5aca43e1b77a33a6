"""What the pipeline's tests share: the shipped catalogue and library, and a small build."""

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.library import load_library


@pytest.fixture(scope="session")
def catalog():
    return load_catalog()


@pytest.fixture(scope="session")
def library():
    return load_library()
