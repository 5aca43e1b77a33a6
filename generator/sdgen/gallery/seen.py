"""Which views show the anomalies of a scene, and which shows them best."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from sdgen.dataset import SceneItem
from sdgen.gallery.pictures import Box
from sdgen.truth.visibility import shows

#: By anomaly and view, whether all that is needed shows, and its evidence's pixels.
SeenIn = Mapping[str, list[tuple[bool, int]]]


class Best(NamedTuple):
    """The view that shows most of an anomaly, the evidence's pixels there and the object's box."""

    view: int
    pixels: int
    box: Box


def seen_in(item: SceneItem) -> SeenIn:
    """Per anomaly, view by view: whether all that is needed shows, and its evidence's pixels."""
    labels = {anomaly.id: anomaly for anomaly in item.anomalies.anomalies}
    size = (item.cameras[0].width, item.cameras[0].height) if item.cameras else (0, 0)
    return {
        seen.anomaly_id: [
            (shows(view, labels[seen.anomaly_id], *size), pixels)
            for view, pixels in zip(item.visibility.views, seen.evidence_pixels, strict=True)
        ]
        for seen in item.visibility.anomalies
    }


def best_views(item: SceneItem, shown: SeenIn) -> dict[str, Best]:
    """Per anomaly the view that shows most of its evidence; first of those that show it by all
    that is needed. Those that no view shows are left out."""
    best = {}
    labels = {anomaly.id: anomaly for anomaly in item.anomalies.anomalies}
    for anomaly_id, views in shown.items():
        if not views:
            continue
        view = max(range(len(views)), key=lambda k: (*views[k], -k))
        for thing in item.visibility.views[view].objects:
            if thing.object_id == labels[anomaly_id].object_id:
                best[anomaly_id] = Best(view, views[view][1], thing.bbox)
    return best


def cover(shown: SeenIn, views: int) -> int:
    """The view that stands for a scene: it shows most anomalies and, of several that do, most of
    their evidence. The first where there is nothing to show."""

    def value(k: int) -> tuple[int, int, int]:
        # A build without pictures says of no view what it shows.
        seen = [of_views[k] for of_views in shown.values() if of_views]
        return sum(whole for whole, _ in seen), sum(pixels for _, pixels in seen), -k

    return max(range(views), key=value, default=0)
