"""Hatchling hook: put the data folders into the wheel as ``sdgen/_data``, without litter."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

FOLDERS = {"hazard_catalog": "hazard_catalog", "assets": "assets", "output/schema": "schema"}
LITTER = {"__pycache__", ".DS_Store", ".mypy_cache", ".ruff_cache"}


class DataHook(BuildHookInterface[Any]):
    """Adds each data file by name; an editable install reads them from the checkout."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        root = Path(self.root)
        for folder, name in FOLDERS.items():
            files = [path for path in sorted((root / folder).rglob("*")) if path.is_file()]
            if not files:
                raise FileNotFoundError(f"{folder}: no data to put into the wheel")
            for path in files:
                parts = path.relative_to(root / folder).parts
                if not LITTER.intersection(parts):
                    target = "/".join(("sdgen", "_data", name, *parts))
                    build_data["force_include"][str(path)] = target
