"""The card of a folder of Parquet files: which table is where, then the data set's own card."""

from __future__ import annotations

from collections.abc import Mapping

import yaml

from sdgen.dataset import Dataset
from sdgen.dataset.card import card as own_card

_HOW = """
## Load this folder
```python
from datasets import load_dataset

views = load_dataset("path/to/this/folder", "{first}", split="{split}")
views[0]["{column}"]
scenes = load_dataset("path/to/this/folder", "scenes", split="{split}")
scenes[0]["anomalies"]
```
`views` has a row a view: its pictures, its camera, and of each object it shows the box, the pixels
and what it is a hazard or a near miss of. `scenes` has a row a scene: household, rooms, objects,
anomalies, lookalikes, and the scene graph as JSON. Masks hold the ids of objects, depth is in
millimetres, both with 16 bits. Tables whose name begins with `twin_` or `toggle_` have the same
homes with all anomalies, or one of them, undone.
"""


def card(data: Dataset, files: Mapping[str, Mapping[str, str]]) -> str:
    """Markdown with the front matter that ``datasets`` reads. ``files`` has the pattern of each
    split of each table."""
    assets = data.infos.values()
    head, body = _split(own_card(data.info, data.entries, assets, data.catalog))
    head["configs"] = [
        {
            "config_name": name,
            "data_files": [{"split": split, "path": path} for split, path in of.items()],
            **({"default": True} if name == next(iter(files)) else {}),
        }
        for name, of in files.items()
    ]
    first = next(iter(files), "scenes")
    split = next(iter(files.get(first, {})), "train")
    column = "image" if first == "views" and "rgb" in data.info.options.sensors else "scene"
    front = yaml.safe_dump(head, sort_keys=False, allow_unicode=True)
    how = _HOW.format(first=first, split=split, column=column)
    return f"---\n{front}---\n{body.rstrip()}\n{how}"


def _split(text: str) -> tuple[dict[str, object], str]:
    _, front, body = text.split("---\n", 2)
    return yaml.safe_load(front), body
