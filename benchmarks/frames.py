"""How long one picture takes: the bare frame, and the frame with all that sdgen makes of it.

Run: ``python benchmarks/frames.py [--index 0] [--seed 7] [--renderer auto] [--size 640x480]``.
Loading a scene finds its light. The bare frame is the renderer's alone, without colours and with
them; the full one adds depth in millimetres and the pixels of every object alone.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Callable

from sdgen.catalog.load import load_catalog
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.render import AUTO, RENDERERS, open_renderer
from sdgen.render.frames import render_frames


def median_ms(work: Callable[[], object], rounds: int) -> float:
    """Median time of one call in milliseconds, after one call to warm up."""
    work()
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return 1000 * statistics.median(times)


def main() -> None:
    """Print the medians."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--index", type=int, default=0)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--renderer", choices=[AUTO, *RENDERERS], default="auto")
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--rounds", type=int, default=5)
    args = parser.parse_args()
    width, height = (int(v) for v in args.size.split("x"))
    library = load_library()
    options = BuildOptions(seed=args.seed, width=width, height=height)
    bundle = make_scene(args.index, load_catalog(), library, options)
    scene, cameras = bundle.scene, bundle.cameras
    with open_renderer(args.renderer) as renderer:
        load = median_ms(lambda: renderer.load(library, scene), args.rounds)

        def drawn(colours: bool) -> None:
            for camera in cameras:
                renderer.draw(camera, colours)

        def full(scale: int) -> None:
            for _ in render_frames(renderer, library, scene, cameras, supersample=scale):
                pass

        count = len(cameras)
        rows = {
            "load the scene": load,
            "masks and depth": median_ms(lambda: drawn(False), args.rounds) / count,
            "bare frame": median_ms(lambda: drawn(True), args.rounds) / count,
            "full frame": (median_ms(lambda: full(1), args.rounds) - load) / count,
            "full frame, supersampled": (median_ms(lambda: full(2), args.rounds) - load) / count,
        }
        out = sys.stdout.write
        out(
            f"{renderer.renderer_string}, {len(scene.objects)} objects, {count} views {args.size}\n"
        )
        for name, value in rows.items():
            out(f"{name:<26}{value:8.1f} ms\n")


if __name__ == "__main__":
    main()
