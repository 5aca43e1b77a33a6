"""``import sdgen`` only defines names."""

from __future__ import annotations

import subprocess
import sys

import pytest
import sdgen

QUIET = """
import logging, os, sys
before = dict(os.environ)
import sdgen
heavy = {"numpy", "pybullet", "pydantic", "click", "shapely", "trimesh", "PIL", "yaml", "logging"}
heavy -= {"logging"}
print(sorted(heavy & set(sys.modules)))
print(dict(os.environ) == before, logging.getLogger().handlers, "sdgen" in dir(logging))
print(sorted(name for name in sys.modules if name.startswith("sdgen")))
"""


def test_import_loads_nothing_and_changes_nothing() -> None:
    done = subprocess.run([sys.executable, "-c", QUIET], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == ["[]", "True [] False", "['sdgen']"]
    assert done.stderr == ""


@pytest.mark.parametrize("name", sdgen.__all__)
def test_every_public_name_loads(name: str) -> None:
    assert getattr(sdgen, name) is not None
    assert name in dir(sdgen)


def test_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        sdgen.nonsense  # noqa: B018


def test_help_does_not_load_the_simulator() -> None:
    code = (
        "import sys; from sdgen.cli.main import run; run(['build', '--help']); "
        "assert not {'pybullet', 'shapely', 'trimesh'} & set(sys.modules), 'heavy'"
    )
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)
