"""Where the data folders are: inside the wheel (``sdgen/_data``) or beside a checkout."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def data_path(*parts: str) -> Path:
    """Path of a shipped data file or folder, for example ``data_path("assets", "manifest.yaml")``.

    First part: ``hazard_catalog``, ``assets`` or ``schema``.
    """
    shipped = _PACKAGE / "_data"
    if shipped.is_dir():
        return shipped.joinpath(*parts)
    root = _PACKAGE.parent.parent
    if parts and parts[0] == "schema":
        return root.joinpath("output", *parts)
    return root.joinpath(*parts)
