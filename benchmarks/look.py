"""Draws a scene's views side by side, to look at: ``python benchmarks/look.py --index 3``.

Near views have a white frame. Prints the anomalies and where they can be seen.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from sdgen.catalog.load import load_catalog
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames


def main() -> None:
    """Write the sheet."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--index", type=int, default=0)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--columns", type=int, default=4)
    parser.add_argument("--supersample", type=int, choices=[1, 2], default=2)
    parser.add_argument("-o", "--out", type=Path, default=Path("look.png"))
    args = parser.parse_args()
    library = load_library()
    bundle = make_scene(args.index, load_catalog(), library, BuildOptions(seed=args.seed))
    with open_renderer("auto") as renderer:
        frames = list(
            render_frames(
                renderer, library, bundle.scene, bundle.cameras, supersample=args.supersample
            )
        )
    for anomaly in bundle.anomalies.anomalies:
        seen = [int((frame.instance == anomaly.object_id).sum()) for frame in frames]
        sys.stdout.write(f"{anomaly.hazard}: {anomaly.category} {anomaly.object_id}: {seen}\n")
    pictures = []
    for frame in frames:
        picture = frame.rgb.copy()
        if frame.camera.kind == "near":
            picture[:4], picture[-4:], picture[:, :4], picture[:, -4:] = 255, 255, 255, 255
        pictures.append(picture)
    while len(pictures) % args.columns:
        pictures.append(np.zeros_like(pictures[0]))
    rows = [
        np.concatenate(pictures[k : k + args.columns], axis=1)
        for k in range(0, len(pictures), args.columns)
    ]
    Image.fromarray(np.concatenate(rows)).save(args.out)


if __name__ == "__main__":
    main()
