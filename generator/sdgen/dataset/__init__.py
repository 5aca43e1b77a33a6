"""Data sets on disk: the writer a build uses, and the reader everybody uses."""

from sdgen.dataset.frames import Frames
from sdgen.dataset.item import SceneItem
from sdgen.dataset.reader import Dataset
from sdgen.dataset.records import DatasetInfo, ManifestEntry
from sdgen.dataset.tables import Table
from sdgen.dataset.writer import DatasetWriter

__all__ = [
    "Dataset",
    "DatasetInfo",
    "DatasetWriter",
    "Frames",
    "ManifestEntry",
    "SceneItem",
    "Table",
]
