"""Scripts that hold nothing but data: pages opened from disk can load them, and nothing else."""

from __future__ import annotations

import json
from typing import Any


def call(name: str, *values: Any) -> bytes:
    """A script that hands JSON to a function of the page: ``sdgen.name(...)``.

    ASCII alone, without ``<``: nothing in it can end a script or begin a tag.
    """
    texts = [json.dumps(value, separators=(",", ":"), allow_nan=False) for value in values]
    safe = ",".join(texts).replace("<", "\\u003c")
    return f"sdgen.{name}({safe});\n".encode("ascii")
