"""How much disk a build needs, and whether it is there."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from sdgen.errors import SdgenError
from sdgen.options import BuildOptions

#: Bytes of a scene's own files, of a view's small change (its camera, half-filled disk blocks),
#: and a pixel by what is written. Measured on 640x480 builds and rounded up; ``instance`` holds
#: the parts too.
SCENE_BYTES = 330_000
VIEW_BYTES = 12_000
PIXEL_BYTES = {"png": 1.2, "jpg": 0.3, "depth": 0.3, "instance": 0.065}

#: Estimates are rough: refuse only when less than this part of the need is free.
HOPELESS = 0.5


def bytes_needed(options: BuildOptions, scenes: int) -> int:
    """About how many bytes ``scenes`` scenes will take under these options."""
    pixels = float(options.views_about * options.width * options.height)
    stitched = 0.0
    if options.stitches:
        # Imported here: it knows of floors and furniture, which --help should not.
        from sdgen.cameras.turn import ROOM_TURN, panorama_width

        stitched = options.views_about / ROOM_TURN * panorama_width(options.width) ** 2 / 2
    each = 0.0
    for sensor in options.sensors:
        of_each = pixels if sensor == "depth" else pixels + stitched
        each += of_each * PIXEL_BYTES[options.rgb if sensor == "rgb" else sensor]
    anomalies = (options.hazards_min + options.hazards_max) / 2 if options.toggles else 0
    folders = 1 + options.twins + anomalies
    views = options.views_about * VIEW_BYTES if options.sensors else 0
    return round(scenes * folders * (SCENE_BYTES + views + each))


def nearest_folder(path: Path) -> Path:
    """The deepest part of ``path`` that exists."""
    path = path.absolute()
    while not path.exists():
        path = path.parent
    return path


def check_destination(out: Path) -> None:
    """Raise SdgenError when ``out`` can't become a data set folder: a file, or not writable."""
    place = nearest_folder(out)
    if not place.is_dir():
        raise SdgenError(f"--out {out}: {place} is a file, not a folder; choose another --out")
    if not os.access(place, os.W_OK | os.X_OK):
        raise SdgenError(f"--out {out}: may not write in {place}; choose another --out")


def disk_line(out: Path, needed: int) -> str:
    """What to tell the user before a build starts; SdgenError when the disk can't hold it."""
    free = shutil.disk_usage(nearest_folder(out)).free
    if needed and free < HOPELESS * needed:
        raise SdgenError(
            f"--out {out}: about {human_bytes(needed)} needed, {human_bytes(free)} free; "
            "choose another --out, fewer --views, a smaller --size or --rgb jpg"
        )
    tight = "; that is tight" if free < 1.2 * needed else ""
    return f"needs about {human_bytes(needed)} on disk, {human_bytes(free)} free{tight}"


def human_bytes(count: float) -> str:
    """``1.4 GB``: powers of 1000."""
    for unit in ("B", "kB", "MB", "GB"):
        if count < 999.5:
            return f"{count:.0f} {unit}" if count >= 10 or unit == "B" else f"{count:.1f} {unit}"
        count /= 1000.0
    return f"{count:.1f} TB"
