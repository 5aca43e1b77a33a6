"""Data sets for other tools."""

from sdgen.export.formats import FORMATS, export

__all__ = ["FORMATS", "export"]
