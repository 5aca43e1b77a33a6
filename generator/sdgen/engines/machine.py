"""What the machine has: cores, and the memory that processes hold and may hold."""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
from collections.abc import Iterator
from pathlib import Path

#: What a worker holds with the whole library loaded, with room to grow within a scene. Replacing
#: it below that would only make it load everything again.
WORKER_MB = 1600.0
#: The parent, with the catalogue and the records of all models.
PARENT_MB = 600.0
#: Of the free memory a build plans with; the rest is for the page cache, which holds the
#: library's files and what is being written, and for other programs.
USABLE = 0.8


def usable_cores() -> int:
    """Cores this process may use (a container may see more than it has)."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def default_workers() -> int:
    """One worker a core, fewer where the memory is too small for that many."""
    return min(usable_cores(), workers_that_fit(free_mb()))


def held_mb(process: int | str = "self") -> float:
    """Memory that a process alone holds now, megabytes; 0 when nobody can tell (without ``/proc``,
    as on macOS, the most that this process ever held, and of others nothing).

    Pages of mapped files are left out: all workers share them, and the system can drop them.
    """
    try:
        with open(f"/proc/{process}/statm", encoding="ascii") as file:
            fields = file.read().split()
        return (int(fields[1]) - int(fields[2])) * os.sysconf("SC_PAGE_SIZE") / 1e6
    except (OSError, ValueError, IndexError):
        return _ever_mb() if process == "self" else 0.0


def give_back() -> None:
    """Give the system what was freed but lies between what is still held; glibc alone can.

    It keeps such pages otherwise: 370 of 1,500 MB after 90 scenes. Takes 5 to 15 ms.
    """
    with contextlib.suppress(OSError, AttributeError):
        ctypes.CDLL(None).malloc_trim(0)


def peak_mb() -> float:
    """The most memory this process has held since the last call (on Linux; else ever).

    Unlike :func:`held_mb` with the pages of mapped files, as the kernel's mark has them: summed
    over workers they count once for each.
    """
    peak = held_mb()
    with contextlib.suppress(OSError, ValueError):
        with open("/proc/self/status", encoding="ascii", errors="replace") as file:
            lines = [line for line in file if line.startswith("VmHWM:")]
        peak = max([peak, *(int(line.split()[1]) * 1024 / 1e6 for line in lines)])
        reset_high_water_mark = "5"
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write(reset_high_water_mark)
    return peak


def _ever_mb() -> float:
    try:
        import resource
    except ImportError:  # Windows
        return 0.0
    unit = 1 if sys.platform == "darwin" else 1024  # bytes there, kilobytes elsewhere
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6


def free_mb(root: Path = Path("/")) -> float:
    """Memory this process and its children may still take: the machine's, or what the control
    groups around it (containers, SLURM jobs) leave. 0 when nobody can tell."""
    limits = [*_machine_mb(root), *_groups_mb(root)]
    return max(0.0, min(limits)) if limits else 0.0


def worker_share_mb(workers: int, free: float) -> float:
    """Memory each of ``workers`` may hold before it is replaced, when ``free`` megabytes are.

    Each has an equal share of what the build may use, so that all together fit. Never less than
    WORKER_MB; without a limit when nobody can tell what is free.
    """
    if free <= 0.0:
        return float("inf")
    return max(WORKER_MB, (USABLE * free - PARENT_MB) / max(1, workers))


def workers_that_fit(free: float) -> int:
    """Workers whose least memory fits into ``free`` megabytes, at least one."""
    if free <= 0.0:
        return 1_000_000
    return max(1, int((USABLE * free - PARENT_MB) / WORKER_MB))


def _machine_mb(root: Path) -> Iterator[float]:
    with contextlib.suppress(OSError, ValueError, IndexError):
        for line in (root / "proc/meminfo").read_text(encoding="ascii").splitlines():
            if line.startswith("MemAvailable:"):
                yield int(line.split()[1]) * 1024 / 1e6


def _groups_mb(root: Path) -> Iterator[float]:
    """What each control group from this process's own up to the root leaves (versions 2 and 1)."""
    try:
        lines = (root / "proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return
    for line in lines:
        _, controllers, path = (*line.split(":", 2), "", "")[:3]
        if controllers == "":
            base, names = root / "sys/fs/cgroup", ("memory.max", "memory.current")
        elif "memory" in controllers.split(","):
            base = root / "sys/fs/cgroup/memory"
            names = ("memory.limit_in_bytes", "memory.usage_in_bytes")
        else:
            continue
        parts = [part for part in path.split("/") if part not in ("", "..")]
        for depth in range(len(parts), -1, -1):
            yield from _group_mb(base.joinpath(*parts[:depth]), names)


def _group_mb(folder: Path, names: tuple[str, str]) -> Iterator[float]:
    # "max" is no number: no limit. Files that were read once count as used, but can be dropped.
    with contextlib.suppress(OSError, ValueError):
        limit = int((folder / names[0]).read_text(encoding="ascii"))
        used = int((folder / names[1]).read_text(encoding="ascii"))
        dropped = 0
        for line in (folder / "memory.stat").read_text(encoding="ascii").splitlines():
            if line.split()[0] in ("inactive_file", "total_inactive_file"):
                dropped = max(dropped, int(line.split()[1]))
        yield (limit - used + dropped) / 1e6
