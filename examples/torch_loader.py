"""Batches of views for PyTorch: colours, depth, masks, and where the anomalies are.

    python examples/torch_loader.py homes

``sdgen.Dataset(...).frames()`` is a map-style data set of views and imports no torch. This needs
torch (``pip install torch``) and a data set with all three sensors.
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


class Target:
    """What a network learns from one view. Picklable: workers get a copy."""

    def __init__(self, hazards: tuple[str, ...]) -> None:
        self.hazards = hazards

    def __call__(self, frame: dict[str, Any]) -> dict[str, Any]:
        # 0: nothing wrong; k: shows an anomaly of the k-th hazard. Small enough for every batch.
        target = np.zeros(frame["instance"].shape, dtype=np.int64)
        for number, hazards in zip(frame["object_ids"], frame["hazards"], strict=True):
            for hazard in hazards:
                target[frame["instance"] == number] = 1 + self.hazards.index(hazard)
        return {
            "rgb": torch.from_numpy(frame["rgb"]).permute(2, 0, 1).float() / 255,
            "depth_m": torch.from_numpy(frame["depth"]),
            "target": torch.from_numpy(target),
            "scene": frame["scene"],
            "view": frame["view"],
        }


def main(path: str, workers: int = 2) -> None:
    """Print what the first batches hold."""
    homes = sdgen.Dataset(path)
    target = Target(homes.info.hazards_enabled)
    views = homes.frames(pixels=("rgb", "depth", "instance"), transform=target)
    print(f"{len(views)} views of {homes!r}")
    loader = DataLoader(views, batch_size=4, shuffle=True, num_workers=workers)
    for batch in loader:
        wrong = (batch["target"] > 0).float().mean()
        print(tuple(batch["rgb"].shape), f"{wrong:.2%} of the pixels show an anomaly")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: torch_loader.py DATASET")
    main(sys.argv[1])
