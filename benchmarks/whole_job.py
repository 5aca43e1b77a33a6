"""The whole job beside bare rendering, measured in one run.

Run: ``python benchmarks/whole_job.py [--n 200] [--workers 2] [--beside TREE] [--json FILE]``.

1. The whole job: ``sdgen build`` with all sensors as a user starts it, on an empty model cache:
   imports, start of the workers and cold caches are part of it. Wall time, core time, memory of
   all its processes together (shared pages once), workers replaced.
2. Bare frames: the same frames again, by the renderer alone (colours, depth, masks) with all
   loaded and its light found, in as many processes. What they take together is divided evenly among
   the processes, as if none ever waited: the least that drawing could cost. (Up to 2026-11-28 they
   were Bullet's ``getCameraImage``.) How long loading took, light included, is told beside it.
3. Content: the same scenes made again without drawing, encoding or writing, in as many processes;
   core seconds of each, the first one of a process (which reads its models) included in the mean.

With ``--beside TREE`` another source tree (the state before a change, a git worktree) does the
same: its whole job after ours, its content scene by scene in turn with ours, so that a busy
machine is busy for both. A fixed piece of work is timed before, between and after: where ``spin``
differs, the machine was not ours alone. Prints a table and JSON.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
OURS = HERE.parent
BUILD = "from sdgen.cli.main import main; main()"
#: Seconds between two looks at the memory of a build: a look at 2 GB takes the kernel 7 ms, and ten
#: times as many took a fiftieth of two cores from what is measured.
LOOK_S = 5.0


def environment(tree: Path, cache: Path) -> dict[str, str]:
    """The environment in which Python imports a tree's package and unpacks models into a cache."""
    # As many processes as cores: more threads in Mesa would only get in each other's way.
    threads = {"LP_NUM_THREADS": "1"}
    paths = {"PYTHONPATH": str(tree / "generator"), "SDGEN_CACHE": str(cache)}
    return {**os.environ, **threads, **paths}


def in_tree(
    tree: Path, cache: Path, *words: object, stdin: int | None = subprocess.DEVNULL
) -> subprocess.Popen[str]:
    """A process of ``in_tree.py`` with a tree's package."""
    command = [sys.executable, str(HERE / "in_tree.py"), *map(str, words)]
    return subprocess.Popen(
        command, env=environment(tree, cache), text=True, stdin=stdin, stdout=subprocess.PIPE
    )


def answers(process: subprocess.Popen[str]) -> Iterator[dict[str, Any]]:
    """The JSON lines of a process; SystemExit when it failed. Bullet's own words are left out."""
    assert process.stdout is not None
    for line in process.stdout:
        if line.startswith("{"):
            yield json.loads(line)
    if process.wait() != 0:
        raise SystemExit(f"{process.args} failed with {process.returncode}")


def spin_s(workers: int) -> float:
    """Seconds a fixed piece of work takes in as many processes at once, the median of them."""
    running = [in_tree(OURS, OURS, "spin") for _ in range(workers)]
    return statistics.median(found["spin_s"] for one in running for found in answers(one))


def family(parent: int) -> list[int]:
    """A process and all that descend from it."""
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                above = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            except OSError:
                continue
            children.setdefault(above, []).append(int(entry.name))
    found = [parent]
    for one in found:
        found += children.get(one, [])
    return found


def held_mb(process: int) -> tuple[float, float]:
    """Megabytes of a process: its share of what it shares with others, and its resident ones."""
    try:
        text = Path(f"/proc/{process}/smaps_rollup").read_text()
    except OSError:
        return 0.0, 0.0
    sizes = {key: int(value) / 1024 for key, value in re.findall(r"^(\w+): +(\d+) kB", text, re.M)}
    return sizes.get("Pss", 0.0), sizes.get("Rss", 0.0)


@contextmanager
def memory_watched(
    process: subprocess.Popen[str], every_s: float = LOOK_S
) -> Iterator[dict[str, float]]:
    """Fills in the most a process and its descendants hold together, and the largest of them."""
    most = {"together": 0.0, "largest": 0.0}
    over = threading.Event()

    def look() -> None:
        while not over.wait(every_s):
            held = [held_mb(one) for one in family(process.pid)]
            most["together"] = max(most["together"], sum(pss for pss, _ in held))
            most["largest"] = max(most["largest"], *(rss for _, rss in held))

    watcher = threading.Thread(target=look, daemon=True)
    watcher.start()
    try:
        yield most
    finally:
        over.set()
        watcher.join()


def whole_job(tree: Path, out: Path, cache: Path, options: Sequence[str]) -> dict[str, float]:
    """Time, memory and replaced workers of one build from a cold start."""
    command = [sys.executable, "-c", BUILD, "build", *options, "--out", str(out)]
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    build = subprocess.Popen(
        command,
        env=environment(tree, cache),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    with memory_watched(build) as most:
        said = build.communicate()[0]
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if build.returncode != 0:
        raise SystemExit(f"{' '.join(command)} failed with {build.returncode}\n{said[-2000:]}")
    lines = (out / "manifest.jsonl").read_text(encoding="utf-8").splitlines()
    entries = [json.loads(line) for line in lines]
    core = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {
        "scenes": len(entries),
        "frames": sum(entry["views"] for entry in entries),
        "objects_median": statistics.median(entry["objects"] for entry in entries),
        "whole_wall_s": wall,
        "homes_per_hour": 3600 * len(entries) / wall,
        "whole_core_s_a_scene": core / len(entries),
        "workers_replaced": len(re.findall(r"worker replaced", said)),
        "peak_memory_mb": most["together"],
        "largest_process_mb": most["largest"],
    }


def bare_frames(out: Path, cache: Path, workers: int) -> dict[str, float]:
    """Bare frames of a data set: in all, divided evenly among the processes."""
    running = [in_tree(OURS, cache, "bare", out, k, workers) for k in range(workers)]
    found = [record for one in running for record in answers(one)]
    seconds = [second for record in found for second in record["frames"]]
    return {
        "bare_wall_s": sum(seconds) / workers,
        "bare_frame_mean_ms": 1000 * statistics.mean(seconds),
        "bare_frame_median_ms": 1000 * statistics.median(seconds),
        "load_median_s": statistics.median(record["load"] for record in found),
        "faces_a_view_median": statistics.median(record["faces"] for record in found),
        "faces_a_view_most": max(record["faces"] for record in found),
    }


def content(
    trees: Sequence[Path], caches: Sequence[Path], count: int, seed: int, workers: int
) -> list[dict[str, float]]:
    """Core seconds of the content of the first ``count`` scenes, tree by tree in turn."""
    found: list[list[float]] = [[] for _ in trees]
    ready: list[list[float]] = [[] for _ in trees]
    with ExitStack() as stack:
        crews = []
        for tree, cache, times in zip(trees, caches, ready, strict=True):
            crew = [
                in_tree(tree, cache, "content", seed, stdin=subprocess.PIPE) for _ in range(workers)
            ]
            for one in crew:
                stack.callback(one.wait)
                stack.callback(one.stdin.close)  # type: ignore[union-attr]
            replies = [answers(one) for one in crew]
            times += [next(reply)["ready"] for reply in replies]
            crews.append(list(zip(crew, replies, strict=True)))
        for first in range(0, count, workers):
            for crew_now, times in zip(crews, found, strict=True):
                block = list(zip(range(first, min(first + workers, count)), crew_now, strict=False))
                for index, (process, _) in block:
                    assert process.stdin is not None
                    process.stdin.write(f"{index}\n")
                    process.stdin.flush()
                times += [next(reply)["core_s"] for _, (_, reply) in block]
    return [
        {
            "content_scenes": count,
            "content_core_s_a_scene": statistics.mean(times),
            "content_core_s_median": statistics.median(times),
            "content_core_s_second_half": statistics.mean(times[len(times) // 2 :]),
            "start_core_s_a_process": statistics.mean(start),
        }
        for times, start in zip(found, ready, strict=True)
    ]


def measure(args: argparse.Namespace) -> dict[str, Any]:
    """All numbers of one run."""
    trees = [OURS] + ([args.beside.resolve()] if args.beside else [])
    names = ["this", "beside"][: len(trees)]
    options = ["--n", args.n, "--seed", args.seed, "--workers", args.workers]
    options = [str(o) for o in (*options, "--size", args.size, "--views", args.views)]
    spins = [spin_s(args.workers)]
    results: list[dict[str, float]] = []
    bare: list[dict[str, float]] = []
    with tempfile.TemporaryDirectory(prefix="sdgen-whole-job-") as name:
        caches = [Path(name) / f"cache-{tree}" for tree in names]
        for tree, label, cache in zip(trees, names, caches, strict=True):
            results.append(whole_job(tree, Path(name) / label, cache, options))
            spins.append(spin_s(args.workers))
            # Right after each job, so that both meet the same machine; always of our own frames,
            # since another tree's files may be of another format.
            bare.append(bare_frames(Path(name) / "this", caches[0], args.workers))
            spins.append(spin_s(args.workers))
        made = content(trees, caches, args.content or args.n, args.seed, args.workers)
        spins.append(spin_s(args.workers))
    for result, frames, scenes in zip(results, bare, made, strict=True):
        # A frame costs what ours cost next to this job; the number of frames is the job's own.
        wall = frames["bare_frame_mean_ms"] / 1000 * result["frames"] / args.workers
        result |= {**frames, "bare_wall_s": wall, **scenes}
        result["whole_over_bare"] = result["whole_wall_s"] / wall
        drawing = frames["bare_frame_mean_ms"] / 1000 * result["frames"] / result["scenes"]
        result["drawing_core_s_a_scene"] = drawing
        rest = result["whole_core_s_a_scene"] - result["content_core_s_a_scene"] - drawing
        result["rest_core_s_a_scene"] = rest  # masks, encoding, writing, start
    return {
        "machine": {
            "processor": platform.processor() or platform.machine(),
            "cores": os.cpu_count(),
            "workers": args.workers,
            "load_at_the_end": os.getloadavg()[0],
            "spin_s": [round(value, 3) for value in spins],
        },
        **{
            label: {key: round(value, 3) for key, value in result.items()}
            for label, result in zip(names, results, strict=True)
        },
    }


def main() -> None:
    """Print the table and the JSON."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--n", type=int, default=200, help="scenes; fewer measure the start")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--views", type=int, default=8)
    parser.add_argument("--content", type=int, help="scenes whose content is timed [default: n]")
    parser.add_argument("--beside", type=Path, metavar="TREE", help="another source tree")
    parser.add_argument("--json", type=Path, help="write the numbers here too")
    args = parser.parse_args()
    if args.beside and not (args.beside / "generator" / "sdgen").is_dir():
        parser.error(f"{args.beside} is no source tree of sdgen")
    found = measure(args)
    labels = [label for label in ("this", "beside") if label in found]
    sys.stdout.write(f"| what | {' | '.join(labels)} |\n|---|{'---|' * len(labels)}\n")
    for key in found["this"]:
        row = " | ".join(f"{found[label][key]:g}" for label in labels)
        sys.stdout.write(f"| {key.replace('_', ' ')} | {row} |\n")
    text = json.dumps(found, indent=1)
    sys.stdout.write(text + "\n")
    if args.json is not None:
        args.json.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
