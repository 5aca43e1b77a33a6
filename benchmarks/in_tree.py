"""What ``whole_job.py`` runs inside a source tree's own package; not to be called by hand.

``in_tree.py content SEED`` makes the scenes whose numbers it reads from standard input, one a
line, and answers each with a line of JSON: core seconds of content alone (home, hazards, physics,
proof, cameras; nothing drawn, encoded or written). ``in_tree.py bare DATASET SHARE SHARES`` draws
the frames of a share of a data set's scenes with all loaded and its light found, and nothing else.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import Any


def say(record: dict[str, Any]) -> None:
    """One line of JSON to whoever started us."""
    sys.stdout.write(json.dumps(record) + "\n")
    sys.stdout.flush()


def content(seed: int) -> None:
    """Core seconds of the content of every scene asked for, and of getting ready."""
    from sdgen.catalog.load import load_catalog
    from sdgen.errors import SceneRejected
    from sdgen.library import load_library
    from sdgen.options import BuildOptions
    from sdgen.physics.client import Client
    from sdgen.pipeline import make_scene

    catalog, library = load_catalog(), load_library()
    options = BuildOptions(seed=seed)
    with Client() as client:
        say({"ready": time.process_time()})
        for line in sys.stdin:
            start, homes = time.process_time(), 0
            try:
                homes = make_scene(
                    int(line), catalog, library, options, client
                ).physics.home_attempts
            except SceneRejected:
                homes = -1
            say({"index": int(line), "core_s": time.process_time() - start, "homes": homes})


def faces_drawn(library: Any, scene: Any) -> int:
    """Triangles of all that is drawn of a scene."""
    from sdgen.render.shell import structure_faces

    # An earlier tree is given the size itself.
    tile_m = getattr(library, "tile_m", 1.0)
    shell = sum(
        len(face.vertices_m) // 2
        for s in scene.home.structures
        for face in structure_faces(s, tile_m)
    )
    shown = 0
    for item in scene.objects:
        info = library.info(item.asset)
        shown += sum(info.part(name).faces for name in info.variants[item.variant])
    return shell + shown


def bare(folder: Path, share: int, shares: int) -> None:
    """Seconds of loading each of a share of the scenes, of each of its frames, and its faces."""
    from sdgen import Dataset
    from sdgen.library import load_library
    from sdgen.render import open_renderer

    library = load_library()
    scenes = [item for item in Dataset(folder) if item.scene.twin_of is None]
    with open_renderer("auto") as renderer:
        for item in scenes[share::shares]:
            start = time.perf_counter()
            renderer.load(library, item.scene)
            loaded, seconds = time.perf_counter() - start, []
            for camera in item.cameras:
                start = time.perf_counter()
                renderer.draw(camera)
                seconds.append(time.perf_counter() - start)
            say({"load": loaded, "frames": seconds, "faces": faces_drawn(library, item.scene)})


def spin() -> None:
    """How long a fixed piece of Python and numpy takes: tells a busy machine from a free one."""
    import numpy as np

    rows = np.sin(np.arange(200_000.0))
    start = time.perf_counter()
    for _ in range(60):
        sum(k * k for k in range(30_000))
        rows = np.sort(np.sin(100.0 * rows))  # no matrix products, which would start threads
    say({"spin_s": time.perf_counter() - start})


if __name__ == "__main__":
    role, *rest = sys.argv[1:]
    if role == "content":
        content(int(rest[0]))
    elif role == "bare":
        bare(Path(rest[0]), int(rest[1]), int(rest[2]))
    else:
        spin()
