"""An agent's walk and the places from which an anomaly can be seen, drawn on the plan."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from PIL import Image, ImageDraw

from sdgen.gallery.drawing import draw_home
from sdgen.gallery.plan_picture import ZOOM, plan_picture
from sdgen.geometry import Vec2
from sdgen.library.records import AssetInfo
from sdgen.scene import Scene
from sdgen.truth.observable import Observability, seen_at

#: Of anomalies in their order, and then again.
_COLOURS = ("#c0392b", "#2471a3", "#1e8449", "#8e44ad", "#d68910", "#117a65", "#7b241c", "#566573")
_WALK, _NOWHERE = "#1c1c1c", "#c9c2b4"
_DOT, _WIDE = 4, 3


def certificate_plan(
    scene: Scene,
    infos: Mapping[str, AssetInfo],
    found: Observability | None = None,
    walk: Sequence[Vec2] = (),
) -> Image.Image:
    """The plan of a scene: of each place of the certificates' lattice a dot for each anomaly that
    can be seen from there, side by side in the anomaly's colour, in grey where none can; a ring of
    that colour about each anomaly's object; and a walk as a line from its dot on."""
    image = plan_picture(scene, infos)
    pen = ImageDraw.Draw(image)
    drawing = draw_home(scene, infos, (), (), ())

    def at(point: Sequence[float]) -> tuple[float, float]:
        x, y = drawing.at((point[0], point[1]))
        return x * ZOOM, y * ZOOM

    if found is not None:
        _dots(pen, found, at)
        for k, one in enumerate(found.anomalies):
            x, y = at(scene.object(one.object_id).pose.position_m)
            colour = _COLOURS[k % len(_COLOURS)]
            for r in (13, 14, 15):
                pen.ellipse((x - r, y - r, x + r, y + r), outline=colour)
    if walk:
        pen.line([at(point) for point in walk], fill=_WALK, width=_WIDE, joint="curve")
        x, y = at(walk[0])
        pen.ellipse((x - 7, y - 7, x + 7, y + 7), fill=_WALK)
    return image


def _dots(
    pen: ImageDraw.ImageDraw,
    found: Observability,
    at: Callable[[Sequence[float]], tuple[float, float]],
) -> None:
    views = [np.asarray(seen_at(found, one.seen).any(axis=(1, 2))) for one in found.anomalies]
    for place, point in enumerate(found.positions_m):
        x, y = at(point)
        colours = [_COLOURS[k % len(_COLOURS)] for k, view in enumerate(views) if view[place]]
        for k, colour in enumerate(colours or [_NOWHERE]):
            middle = x + (k - (max(1, len(colours)) - 1) / 2) * 2 * _DOT
            r = _DOT if colours else _DOT / 2
            pen.ellipse((middle - r, y - r, middle + r, y + r), fill=colour)
