"""The formats a data set can be exported to: name -> what writes it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from sdgen.dataset import Dataset
from sdgen.errors import UsageError, did_you_mean
from sdgen.export.tar import export_tar

#: ``(data set, output, on_scene)`` -> None.
Exporter = Callable[[Dataset, Path, Callable[[int, int], None] | None], None]

FORMATS: Mapping[str, Exporter] = {"tar": export_tar}


def export(
    data: Dataset,
    name: str,
    output: Path,
    on_scene: Callable[[int, int], None] | None = None,
) -> None:
    """Export a data set. UsageError for a format nobody knows."""
    if name not in FORMATS:
        raise UsageError(f"no format {name!r}{did_you_mean(name, list(FORMATS))}")
    FORMATS[name](data, output, on_scene)
