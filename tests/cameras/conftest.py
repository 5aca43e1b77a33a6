from pathlib import Path

import pytest
from sdgen.library import Library

from tests.fakes import fake_library


@pytest.fixture(scope="session")
def library(tmp_path_factory: pytest.TempPathFactory) -> Library:
    folder: Path = tmp_path_factory.mktemp("library") / "assets"
    return fake_library(folder)
