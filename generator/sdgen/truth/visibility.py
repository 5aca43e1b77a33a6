"""What the views show of each object, and of each anomaly's evidence."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from sdgen.cameras.outdoors import STRIP_PIXELS, in_strips, outer_openings, passes
from sdgen.scene import (
    Anomaly,
    AnomalyVisibility,
    Camera,
    Frame,
    Opening,
    Scene,
    ViewVisibility,
    Visibility,
    VisibleObject,
)
from sdgen.vocabulary import EVIDENCE_PIXELS, REFERENCE_SIZE

#: What is seen at all is never written as nothing: one pixel of a wall that fills the view.
LEAST_FRACTION = 1e-4

Box = tuple[int, int, int, int]


def evidence_pixels_needed(width: int, height: int, needed: int = EVIDENCE_PIXELS) -> int:
    """Pixels that count as seen at this picture size where ``needed`` do at the reference size."""
    return math.ceil(needed * width * height / math.prod(REFERENCE_SIZE))


def part_names(scene: Scene) -> dict[int, tuple[str, ...]]:
    """Drawn parts of every object, in the order that the part mask's values (from 1) follow."""
    return {item.id: item.parts for item in scene.objects}


def measure_masks(
    instance: npt.NDArray[np.uint16],
    part: npt.NDArray[np.uint8] | None,
    parts_of: Mapping[int, Sequence[str]],
) -> dict[int, tuple[Box, int, dict[str, int]]]:
    """Box ``[x, y, w, h]``, pixels and pixels by part of every id in a mask (0 left out).

    ``instance`` and ``part`` have shape (H, W). Pixels whose part value names no drawn part
    count for the object only.
    """
    height, width = instance.shape
    key = instance.astype(np.uint32) << 8
    if part is not None:
        key |= part
    flat = key.reshape(-1)
    # A mask is a few thousand runs of equal pixels (cut at row ends): count those, not pixels.
    begins = np.empty(flat.size, dtype=bool)
    np.not_equal(flat[1:], flat[:-1], out=begins[1:])
    begins[::width] = True
    starts = np.flatnonzero(begins)
    lengths = np.diff(starts, append=height * width)
    owners, parts = flat[starts] >> 8, flat[starts] & 0xFF
    y, x = np.divmod(starts, width)
    ids = np.flatnonzero(np.bincount(owners))
    rank = np.searchsorted(ids, owners)
    pixels = np.bincount(rank, weights=lengths).astype(np.int64)
    cells = np.bincount(rank * 256 + parts, weights=lengths, minlength=256 * len(ids))
    by_part = cells.astype(np.int64).reshape(len(ids), 256)
    # Runs of one id together, for the corners of its box.
    order = np.argsort(rank, kind="stable")
    first = np.searchsorted(rank[order], np.arange(len(ids)))
    low = np.stack([np.minimum.reduceat(v[order], first) for v in (x, y)], axis=1)
    high = np.stack([np.maximum.reduceat(v[order], first) for v in (x + lengths, y + 1)], axis=1)
    out: dict[int, tuple[Box, int, dict[str, int]]] = {}
    for k, node_id in enumerate(ids.tolist()):
        if node_id == 0:
            continue
        (x0, y0), (x1, y1) = low[k].tolist(), high[k].tolist()
        names = enumerate(parts_of.get(node_id, ()), start=1)
        shown = {name: int(by_part[k, value]) for value, name in names if by_part[k, value]}
        out[node_id] = ((x0, y0, x1 - x0, y1 - y0), int(pixels[k]), shown)
    return out


def outdoors_seen(
    instance: npt.NDArray[np.uint16], camera: Camera, openings: Sequence[Opening]
) -> dict[int, int]:
    """Pixels of nothing in a mask (H, W) that are seen through each of the openings, in strips wide
    enough to tell, by the id of what fills it; those with any."""
    rows, columns = np.nonzero(instance == 0)
    if len(rows) == 0:
        return {}
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    local = np.ones((len(rows), 3))
    local[:, 0] = (columns - k[0, 2]) / k[0, 0]
    local[:, 1] = (rows - k[1, 2]) / k[1, 1]
    directions = local @ pose[:3, :3].T
    least = STRIP_PIXELS * camera.width / REFERENCE_SIZE[0]
    counts = {}
    for opening in openings:
        through = np.zeros(instance.shape, dtype=np.bool_)
        through[rows, columns] = passes(opening, pose[:3, 3], directions)
        counts[opening.object_id] = int(in_strips(through, least).sum())
    return {key: counts[key] for key in sorted(counts) if counts[key]}


def view_visibility(
    frame: Frame, parts_of: Mapping[int, Sequence[str]], openings: Sequence[Opening] = ()
) -> ViewVisibility:
    """The objects (structures left out) one frame shows, sorted by id, and what it shows of the
    outdoors through these openings."""
    objects = []
    for node_id, (box, pixels, parts) in measure_masks(
        frame.instance, frame.part, parts_of
    ).items():
        if node_id not in parts_of:
            continue
        alone = max(frame.alone_pixels.get(node_id, pixels), pixels)
        objects.append(
            VisibleObject(
                object_id=node_id,
                bbox=box,
                pixels=pixels,
                fraction=max(round(pixels / alone, 4), LEAST_FRACTION),
                parts=parts,
            )
        )
    return ViewVisibility(
        view=frame.camera.index,
        objects=tuple(objects),
        outdoors=outdoors_seen(frame.instance, frame.camera, openings),
    )


def evidence_pixels(view: ViewVisibility, anomaly: Anomaly) -> int:
    """Pixels of an anomaly's evidence parts in a view; of the whole object when none is named."""
    for item in view.objects:
        if item.object_id == anomaly.object_id:
            if not anomaly.evidence_parts:
                return item.pixels
            return sum(item.parts.get(name, 0) for name in anomaly.evidence_parts)
    return 0


def shows(view: ViewVisibility, anomaly: Anomaly, width: int, height: int) -> bool:
    """True when a view shows what makes an anomaly one, and enough of the object and of what makes
    it one together with it."""
    needed = evidence_pixels_needed(width, height, anomaly.evidence_pixels_needed)
    outdoors = evidence_pixels_needed(width, height, anomaly.evidence_outdoors_needed)
    if (view.outdoors or {}).get(anomaly.object_id, 0) < outdoors:
        return False
    pixels = {item.object_id: item.pixels for item in view.objects}
    whole = evidence_pixels_needed(width, height)
    return evidence_pixels(view, anomaly) >= needed and all(
        pixels.get(key, 0) >= whole for key in (anomaly.object_id, *anomaly.evidence_objects)
    )


def all_visible(
    views: Sequence[ViewVisibility], anomalies: Iterable[Anomaly], width: int, height: int
) -> bool:
    """True when some view shows every anomaly."""
    return all(any(shows(view, one, width, height) for view in views) for one in anomalies)


def visibility_of(
    scene: Scene,
    anomalies: Sequence[Anomaly],
    frames: Iterable[Frame],
    width: int,
    height: int,
) -> Visibility:
    """``visibility.json`` of a scene from its frames (consumed one at a time, kept by nobody)."""
    parts_of = part_names(scene)
    openings = outer_openings(scene.home)
    views = tuple(view_visibility(frame, parts_of, openings) for frame in frames)
    return assemble(views, anomalies, width, height)


def assemble(
    views: Sequence[ViewVisibility], anomalies: Sequence[Anomaly], width: int, height: int
) -> Visibility:
    """``visibility.json`` from what each view shows."""
    shown = tuple(
        AnomalyVisibility(
            anomaly_id=anomaly.id,
            object_id=anomaly.object_id,
            evidence_pixels=tuple(evidence_pixels(view, anomaly) for view in views),
        )
        for anomaly in anomalies
    )
    return Visibility(
        views=tuple(views),
        anomalies=shown,
        evidence_pixels_needed=evidence_pixels_needed(width, height),
        all_visible=all_visible(views, anomalies, width, height),
    )
