"""The whole job beside bare rendering, measured in one run.

Run: ``python benchmarks/whole_job.py [--n 24] [--workers 2] [--json FILE]``. Builds a data set with
all sensors; draws the same frames again with Bullet's ``getCameraImage`` alone, all bodies loaded,
in as many processes; and makes some of the scenes once more in as many processes to tell the core
time of drawing from all the rest (content, encoding, writing). Prints a table, and JSON.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from sdgen import Dataset
from sdgen.catalog.load import load_catalog
from sdgen.dataset.scene_folder import SceneWriter
from sdgen.engines import local
from sdgen.engines.worker import SceneWorker, WorkerSetup
from sdgen.library import Library, load_library
from sdgen.options import BuildOptions
from sdgen.physics.bullet import pb
from sdgen.render.backend import Choice, choose_renderer
from sdgen.render.frames import Renderer, drawing_shift
from sdgen.render.opengl import projection_matrix, view_matrix
from sdgen.render.shell import LIGHT_M, structure_faces
from sdgen.scene import Scene


def faces_drawn(library: Library, scene: Scene) -> int:
    """Triangles that Bullet draws in every view of a scene: those of all its bodies."""
    shell = sum(
        len(face.vertices_m) // 2 for s in scene.home.structures for face in structure_faces(s, 1.0)
    )
    shown = 0
    for item in scene.objects:
        info = library.info(item.asset)
        shown += sum(info.part(name).faces for name in info.variants[item.variant])
    return shell + shown


def bare_frames(folder: Path, choice: Choice, share: slice) -> dict[str, list[float]]:
    """Seconds of every bare frame of a share of a data set's scenes, and faces a view."""
    library = load_library()
    egl = choice.kind == "egl"
    seconds: list[float] = []
    faces: list[float] = []
    with Renderer(choice) as renderer:
        for home in list(Dataset(folder))[share]:
            scene = home.scene
            renderer.load(library, scene)
            faces.append(faces_drawn(library, scene))
            for camera in home.cameras:
                pose = drawing_shift(scene) @ np.asarray(camera.world_from_camera)
                size = (camera.width, camera.height)
                k = np.asarray(camera.K)
                lens = projection_matrix(k, 0, 0, *size, camera.near_m, camera.far_m)
                start = time.perf_counter()
                pb.getCameraImage(
                    *size,
                    view_matrix(pose),
                    lens,
                    lightDirection=LIGHT_M,
                    renderer=pb.ER_BULLET_HARDWARE_OPENGL if egl else pb.ER_TINY_RENDERER,
                    physicsClientId=renderer.client,
                )
                seconds.append(time.perf_counter() - start)
    return {"frame": seconds, "faces": faces}


def core_times(setup: WorkerSetup, indices: list[int]) -> dict[str, list[float]]:
    """Core seconds a scene takes in a worker, drawing counted apart."""
    worker = SceneWorker(setup)
    drawing = 0.0
    plain = pb.getCameraImage

    def timed(*args: Any, **named: Any) -> Any:
        nonlocal drawing
        start = time.process_time()
        try:
            return plain(*args, **named)
        finally:
            drawing += time.process_time() - start

    pb.getCameraImage = timed
    rest: list[float] = []
    drawn: list[float] = []
    try:
        worker(indices[0])  # the first scene reads models; the others show what a scene takes
        for index in indices[1:]:
            drawing, start = 0.0, time.process_time()
            worker(index)
            rest.append(time.process_time() - start - drawing)
            drawn.append(drawing)
    finally:
        pb.getCameraImage = plain
        worker.close()
    return {"rest": rest, "drawing": drawn}


def _in_processes(work: Any, jobs: list[tuple[Any, ...]]) -> list[dict[str, list[float]]]:
    with multiprocessing.get_context("spawn").Pool(len(jobs)) as pool:
        return pool.starmap(work, jobs)


def measure(n: int, seed: int, workers: int, size: tuple[int, int], views: int) -> dict[str, float]:
    """All numbers of one run."""
    catalog, library = load_catalog(), load_library()
    options = BuildOptions(n=n, seed=seed, width=size[0], height=size[1], views=views)
    choice = choose_renderer("auto")
    with tempfile.TemporaryDirectory() as name:
        out, aside = Path(name) / "set", Path(name) / "aside"
        report = local.build(options, out, catalog, library, workers=workers)
        objects = [len(home.scene.objects) for home in Dataset(out)]
        bare = _in_processes(
            bare_frames, [(out, choice, slice(k, None, workers)) for k in range(workers)]
        )
        (aside / ".build").mkdir(parents=True)
        setup = WorkerSetup(
            catalog=catalog,
            library_folders=library.folders,
            library_sha256=library.sha256,
            options=options,
            writer=SceneWriter(aside, options),
            choice=choice,
            one_thread=True,
        )
        made = sorted({home.scene.index for home in Dataset(out)})
        cores = _in_processes(core_times, [(setup, made[k::workers]) for k in range(workers)])
    frames = [value for one in bare for value in one["frame"]]
    faces = [value for one in bare for value in one["faces"]]
    bare_wall = max(sum(one["frame"]) for one in bare)
    rest = statistics.median(value for one in cores for value in one["rest"])
    drawing = statistics.median(value for one in cores for value in one["drawing"])
    return {
        "scenes": report.made,
        "frames": report.frames,
        "workers": workers,
        "objects_median": statistics.median(objects),
        "whole_wall_s": report.seconds,
        "bare_wall_s": bare_wall,
        "whole_over_bare": report.seconds / bare_wall,
        "bare_frame_median_ms": 1000 * statistics.median(frames),
        "core_s_a_scene_without_drawing": rest,
        "core_s_a_scene_drawing": drawing,
        "faces_a_view_median": statistics.median(faces),
        "faces_a_view_most": max(faces),
        "homes_per_hour": report.homes_per_hour,
    }


def main() -> None:
    """Print the table and the JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--n", type=int, default=24, help="at least two a worker")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--views", type=int, default=8)
    parser.add_argument("--json", type=Path, help="write the numbers here too")
    args = parser.parse_args()
    # As many processes as cores: more threads in Mesa would only get in each other's way.
    os.environ.setdefault("LP_NUM_THREADS", "1")
    width, height = (int(v) for v in args.size.split("x"))
    found = measure(args.n, args.seed, args.workers, (width, height), args.views)
    rounded = {key: round(value, 3) for key, value in found.items()}
    text = json.dumps(rounded, indent=1)
    sys.stdout.write("| what | measured |\n|---|---|\n")
    for key, value in rounded.items():
        sys.stdout.write(f"| {key.replace('_', ' ')} | {value:g} |\n")
    sys.stdout.write(text + "\n")
    if args.json is not None:
        args.json.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
