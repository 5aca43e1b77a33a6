"""sdgen: procedural, certified homes with household hazards.

Importing this package only defines names; what they name is loaded on first use.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdgen.benchmark import evaluate as evaluate
    from sdgen.catalog.load import load_catalog as load_catalog
    from sdgen.dataset import Dataset as Dataset
    from sdgen.engines.build import build as build
    from sdgen.library import load_library as load_library
    from sdgen.options import BuildOptions as BuildOptions
    from sdgen.perception import Perception as Perception
    from sdgen.pipeline import make_scene as make_scene

__version__ = "0.2.0"

__all__ = [
    "BuildOptions",
    "Dataset",
    "Perception",
    "__version__",
    "build",
    "evaluate",
    "load_catalog",
    "load_library",
    "make_scene",
]

_HOME_OF_NAME = {
    "BuildOptions": "sdgen.options",
    "Dataset": "sdgen.dataset",
    "Perception": "sdgen.perception",
    "build": "sdgen.engines.build",
    "evaluate": "sdgen.benchmark",
    "load_catalog": "sdgen.catalog.load",
    "load_library": "sdgen.library",
    "make_scene": "sdgen.pipeline",
}


def __getattr__(name: str) -> object:
    """Load a public name on first use (PEP 562)."""
    if name not in _HOME_OF_NAME:
        raise AttributeError(f"module 'sdgen' has no attribute {name!r}")
    from importlib import import_module

    value: object = getattr(import_module(_HOME_OF_NAME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(set(globals()) | set(__all__))
