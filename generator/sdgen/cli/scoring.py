"""The command that scores what a detector has just said."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdgen.dataset import Dataset


def scoring(data: Dataset, output: Path) -> str:
    """``sdgen evaluate`` of predictions, over the scenes that were looked at and no others."""
    split = ["--split", data.split] if data.split else []
    return shlex.join(["sdgen", "evaluate", str(data.path), str(output), *split])
