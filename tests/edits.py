"""Data sets changed as somebody would who edits them by hand."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.dataset.disk import file_sha256
from sdgen.dataset.images import gray_bytes
from sdgen.dataset.records import CONTENT_FILES
from sdgen.dataset.scene_folder import content_sha256
from sdgen.dataset.text import line_bytes

Edit = Callable[[Any], None]


def edit_json(path: Path, edit: Edit) -> None:
    """Change a JSON file in place."""
    data = json.loads(path.read_text(encoding="utf-8"))
    edit(data)
    path.write_text(json.dumps(data), encoding="utf-8")


def edit_picture(path: Path, edit: Edit) -> None:
    """Change the pixels of a 16-bit picture in place."""
    values = np.asarray(Image.open(path)).astype(np.uint16)
    edit(values)
    path.write_bytes(gray_bytes(values))


def reseal(path: Path) -> None:
    """Make the digests right again, as whoever edits with intent would."""
    data = Dataset(path)
    lines = []
    for entry in data.entries:
        folder = path / "scenes" / entry.id
        files = {
            p.relative_to(folder).as_posix(): file_sha256(p)
            for p in sorted(folder.rglob("*"))
            if p.is_file()
        }
        content = {name: (folder / name).read_bytes() for name in CONTENT_FILES}
        update = {"files": files, "content_sha256": content_sha256(content)}
        lines.append(line_bytes(entry.model_copy(update=update)))
    (path / "manifest.jsonl").write_bytes(b"".join(lines))
