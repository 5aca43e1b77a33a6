"""An agent's walk and the places from which an anomaly can be seen, drawn on the plan."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from sdgen.gallery.drawing import draw_home
from sdgen.gallery.plan_picture import ZOOM, plan_picture
from sdgen.geometry import Vec2
from sdgen.library.records import AssetInfo
from sdgen.scene import Scene
from sdgen.truth.observable import Observability, seen_at
from sdgen.vocabulary import OVERHEAD_M

#: Of anomalies in their order, and then again.
_COLOURS = ("#c0392b", "#2471a3", "#1e8449", "#8e44ad", "#d68910", "#117a65", "#7b241c", "#566573")
_WALK, _NOWHERE = "#1c1c1c", "#c9c2b4"
_DOT, _WIDE = 4, 3
#: Of the names below the plan.
_LINE, _LETTERS = 26, 18


def certificate_plan(
    scene: Scene,
    infos: Mapping[str, AssetInfo],
    found: Observability | None = None,
    walk: Sequence[Vec2] = (),
) -> Image.Image:
    """The plan of a scene: of each place of the certificates' lattice a dot for each anomaly that
    can be seen from there, side by side in the anomaly's colour, in grey where none can; a ring of
    that colour about each anomaly's object, with its name below the plan; and a walk as a line from
    a dot to a ring. What hangs overhead is left out."""
    below = tuple(item for item in scene.objects if item.pose.position_m[2] < OVERHEAD_M)
    image = plan_picture(scene.model_copy(update={"objects": below}), infos)
    pen = ImageDraw.Draw(image)
    drawing = draw_home(scene, infos, (), (), ())

    def at(point: Sequence[float]) -> tuple[float, float]:
        x, y = drawing.at((point[0], point[1]))
        return x * ZOOM, y * ZOOM

    named = []
    if found is not None:
        _dots(pen, found, at)
        for k, one in enumerate(found.anomalies):
            item, colour = scene.object(one.object_id), _COLOURS[k % len(_COLOURS)]
            _ring(pen, at(item.pose.position_m), 15, colour)
            named.append((colour, f"{one.anomaly_id}: {item.category.replace('_', ' ')} {item.id}"))
    if walk:
        pen.line([at(point) for point in walk], fill=_WALK, width=_WIDE, joint="curve")
        x, y = at(walk[0])
        pen.ellipse((x - 7, y - 7, x + 7, y + 7), fill=_WALK)
        _ring(pen, at(walk[-1]), 9, _WALK)
        named.append((_WALK, "the walk, from the dot to the ring"))
    return _with_legend(image, named)


def _ring(pen: ImageDraw.ImageDraw, at: tuple[float, float], radius: int, colour: str) -> None:
    x, y = at
    for r in range(radius - 2, radius + 1):
        pen.ellipse((x - r, y - r, x + r, y + r), outline=colour)


def _with_legend(image: Image.Image, named: Sequence[tuple[str, str]]) -> Image.Image:
    """The plan with a line below it for each colour."""
    out = Image.new("RGB", (image.width, image.height + _LINE * len(named)), "white")
    out.paste(image)
    pen = ImageDraw.Draw(out)
    font = ImageFont.load_default(_LETTERS)
    for k, (colour, text) in enumerate(named):
        y = image.height + _LINE * k + _LINE // 2
        pen.ellipse((20, y - 6, 32, y + 6), fill=colour)
        pen.text((42, y), text, _WALK, font, "lm")
    return out


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
