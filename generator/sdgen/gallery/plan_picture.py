"""A home seen from above as a picture: rooms, doors, windows, furniture with its names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PIL import Image, ImageDraw, ImageFont

from sdgen.gallery.drawing import Drawing, draw_home
from sdgen.library.records import AssetInfo
from sdgen.scene import Camera, Scene
from sdgen.vocabulary import OPENINGS

#: Pixels of a unit of the drawing (90 a metre): the names of a row of kitchen units can be read.
ZOOM = 1.5
#: Fill and outline by what a shape is; ways are left out.
_COLOURS: Mapping[str, tuple[str, str | None]] = {
    "room": ("#f6f3ec", "#3c3c3c"),
    "fixed": ("#dcc9a6", "#7a6544"),
    "loose": ("#8fb08c", None),
    "window": ("#8fc1e3", "#34506e"),
    "door": ("#b98b5e", "#5c4128"),
    "double_door": ("#b98b5e", "#5c4128"),
    "passage": ("#f6f3ec", "#b98b5e"),
    "wide_passage": ("#f6f3ec", "#b98b5e"),
    "front_door": ("#8c3b2e", "#4a1c15"),
}
_INK = "#2b2b2b"
_CAMERA = "#b3372f"
#: Size of letters in units; a name is left out where its piece is smaller than it.
_SMALL, _LARGE = 8.0, 14.0


def plan_picture(
    scene: Scene, infos: Mapping[str, AssetInfo], cameras: tuple[Camera, ...] = ()
) -> Image.Image:
    """The plan of a scene without hazards, north up, with its cameras."""
    drawing = draw_home(scene, infos, cameras, (), ())
    size = (round(drawing.width * ZOOM), round(drawing.height * ZOOM))
    image = Image.new("RGB", size, "white")
    pen = ImageDraw.Draw(image)
    for shape in drawing.shapes:
        kind = shape.title.rsplit(" ", 1)[0] if shape.kind == "opening" else shape.kind
        if kind not in _COLOURS:
            continue
        fill, line = _COLOURS[kind]
        corners = [(x * ZOOM, y * ZOOM) for x, y in shape.corners]
        pen.polygon(corners, fill=fill, outline=line, width=4 if shape.kind == "room" else 1)
    _names(pen, scene, drawing)
    for camera in drawing.cameras:
        x, y = camera.x * ZOOM, camera.y * ZOOM
        pen.line((x, y, camera.to_x * ZOOM, camera.to_y * ZOOM), fill=_CAMERA, width=2)
        pen.ellipse((x - 5, y - 5, x + 5, y + 5), fill=_CAMERA)
    return image


def _names(pen: ImageDraw.ImageDraw, scene: Scene, drawing: Drawing) -> None:
    """Names of rooms, and of the furniture that is large enough to carry its own."""
    small, large = (ImageFont.load_default(size * ZOOM) for size in (_SMALL, _LARGE))
    furniture = {
        f"{item.category} {item.id}"
        for item in scene.objects
        if item.fixed and item.category not in OPENINGS
    }
    written: list[tuple[float, ...]] = []
    for shape in reversed(drawing.shapes):  # what is on top is named first
        if shape.title not in furniture:
            continue
        xs, ys = ([v * ZOOM for v in values] for values in zip(*shape.corners, strict=True))
        name = shape.title.rsplit(" ", 1)[0].replace("_", "\n")
        middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
        box = pen.multiline_textbbox(middle, name, small, "mm", spacing=1)
        fits = box[2] - box[0] < max(xs) - min(xs) and box[3] - box[1] < max(ys) - min(ys)
        if fits and not any(_meet(box, other) for other in written):
            pen.multiline_text(middle, name, _INK, small, "mm", spacing=1, align="center")
            written.append(box)
    for x, y, name in drawing.names:
        pen.text((x * ZOOM, y * ZOOM), name, _INK, large, "ls", stroke_width=2, stroke_fill="white")


def _meet(a: Sequence[float], b: Sequence[float]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
