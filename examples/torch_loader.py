"""Batches of views for PyTorch: colours, depth, masks, and where the anomalies are.

    python examples/torch_loader.py homes

``sdgen.Dataset`` is a map-style data set of scenes and imports no torch; this makes one of views.
It needs torch (``pip install torch``) and a data set with all three sensors.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import sdgen

try:
    import torch
    from torch.utils.data import DataLoader
except ImportError:
    sys.exit("this example needs PyTorch: pip install torch")


class Views:
    """All views of a split, one after another. Picklable: workers open the files themselves."""

    def __init__(self, path: str, split: str | None = None) -> None:
        self.homes = sdgen.Dataset(path, split=split)
        self.hazards = self.homes.info.hazards_enabled
        self.where = [(k, v) for k, item in enumerate(self.homes) for v in range(item.entry.views)]

    def __len__(self) -> int:
        return len(self.where)

    def __getitem__(self, index: int) -> dict[str, Any]:
        scene, view = self.where[index]
        item = self.homes[scene]
        ids = item.instance(view)
        # 0: nothing wrong; k: shows an anomaly of the k-th hazard. Small enough for every batch.
        target = np.zeros(ids.shape, dtype=np.int64)
        for anomaly in item.anomalies.anomalies:
            target[ids == anomaly.object_id] = 1 + self.hazards.index(anomaly.hazard)
        return {
            "rgb": torch.from_numpy(item.rgb(view).copy()).permute(2, 0, 1).float() / 255,
            "depth_m": torch.from_numpy(item.depth(view)),
            "target": torch.from_numpy(target),
            "scene": item.id,
            "view": view,
        }


def main(path: str, workers: int = 2) -> None:
    """Print what the first batches hold."""
    views = Views(path)
    print(f"{len(views)} views of {views.homes!r}")
    loader = DataLoader(views, batch_size=4, shuffle=True, num_workers=workers)
    for batch in loader:
        wrong = (batch["target"] > 0).float().mean()
        print(tuple(batch["rgb"].shape), f"{wrong:.2%} of the pixels show an anomaly")


if __name__ == "__main__":
    main(*sys.argv[1:2])
