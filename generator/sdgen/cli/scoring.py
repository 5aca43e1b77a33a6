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
    # A name that begins with a dash would be an option.
    files = [
        f"./{path}" if str(path).startswith("-") else str(path) for path in (data.path, output)
    ]
    return shlex.join(["sdgen", "evaluate", *files, *split])
