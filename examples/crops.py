"""Cut every anomaly out of the view that shows it best: a folder of pictures with captions.

    python examples/crops.py homes crops

Shows how visibility, masks and pictures go together. ``sdgen.Dataset`` has a length and an index,
so ``torch.utils.data.DataLoader`` takes it as it is.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import sdgen
from PIL import Image
from sdgen.dataset import SceneItem

MARGIN = 0.5


def crops(item: SceneItem, out: Path) -> list[Path]:
    """Write the crops of one scene; anomalies that no view shows are left out."""
    written = []
    shown = {seen.anomaly_id: seen for seen in item.visibility.anomalies}
    for anomaly in item.anomalies.anomalies:
        pixels = shown[anomaly.id].evidence_pixels
        view = int(np.argmax(pixels)) if pixels else 0
        if not pixels or pixels[view] == 0:
            continue
        rows, columns = np.nonzero(item.instance(view) == anomaly.object_id)
        pad = int(MARGIN * max(np.ptp(rows), np.ptp(columns), 20))
        top, left = max(rows.min() - pad, 0), max(columns.min() - pad, 0)
        picture = item.rgb(view)[top : rows.max() + pad, left : columns.max() + pad]
        path = out / f"{item.id}_{anomaly.hazard}_{anomaly.object_id}.png"
        Image.fromarray(picture).save(path)
        written.append(path)
    return written


def main(dataset: str, out: str) -> None:
    """Crops of all scenes, and what each shows."""
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for item in sdgen.Dataset(dataset):
        for path in crops(item, folder):
            print(path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: crops.py DATASET OUT")
    main(sys.argv[1], sys.argv[2])
