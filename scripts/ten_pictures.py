"""Draw the pictures of docs/ten-pictures.md from a data set with twins and its gallery.

Run: ``sdgen build --n 100 --seed 4051 --twins --out homes``, then
``python scripts/ten_pictures.py homes`` (needs Chromium for the last three).
"""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import sdgen
from PIL import Image, ImageDraw, ImageFont
from sdgen.dataset import SceneItem
from sdgen.gallery import write_gallery
from sdgen.gallery.plan_picture import plan_picture

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from tests.browser import browser

OUT = Path(__file__).resolve().parent.parent / "docs" / "images" / "ten"
RED, BLUE, GAP = (214, 40, 40), (30, 100, 210), 6
#: What a crop shows around its box, as a share of the box; and at least so many pixels.
AROUND, LEAST = 0.8, 110
Picture = Image.Image


def grid(pictures: Sequence[Picture], columns: int, size: tuple[int, int]) -> Picture:
    """Pictures of one size in rows."""
    rows = -(-len(pictures) // columns)
    width, height = size
    sheet = Image.new("RGB", (columns * (width + GAP) - GAP, rows * (height + GAP) - GAP), "white")
    for k, one in enumerate(pictures):
        shown = one.convert("RGB").resize(size, Image.Resampling.LANCZOS)
        sheet.paste(shown, (k % columns * (width + GAP), k // columns * (height + GAP)))
    return sheet


def named(picture: Picture, words: str) -> Picture:
    """The picture with words in its lower left corner."""
    picture = picture.convert("RGB")
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(max(14, picture.width // 26))
    _, _, width, height = pen.textbbox((0, 0), words, font=font)
    top = picture.height - height - 8
    pen.rectangle((0, top, width + 10, picture.height), fill="black")
    pen.text((5, top + 2), words, fill="white", font=font)
    return picture


def view(item: SceneItem, k: int) -> Picture:
    """The colours of a view."""
    return Image.fromarray(item.rgb(k))


def seen(item: SceneItem, k: int) -> dict[int, Any]:
    """What a view shows, by id."""
    return {one.object_id: one for one in item.visibility.views[k].objects}


def boxed(item: SceneItem, k: int, colours: dict[int, tuple[int, int, int]]) -> Picture:
    """A view with boxes around some of its objects."""
    picture = view(item, k)
    pen = ImageDraw.Draw(picture)
    shown = seen(item, k)
    for number, colour in colours.items():
        if number in shown:
            x, y, w, h = shown[number].bbox
            pen.rectangle((x - 2, y - 2, x + w + 1, y + h + 1), outline=colour, width=3)
    return picture


def crop(item: SceneItem, k: int, number: int) -> Picture:
    """An object and a square of what is around it."""
    x, y, w, h = seen(item, k)[number].bbox
    picture = view(item, k)
    side = min(max((1 + AROUND) * max(w, h), LEAST), picture.height)
    left = min(max(x + w / 2 - side / 2, 0), picture.width - side)
    top = min(max(y + h / 2 - side / 2, 0), picture.height - side)
    return picture.crop((round(left), round(top), round(left + side), round(top + side)))


#: How large a thing should be for a crop to show it and what is around it, in pixels.
BEST_PIXELS = 20_000
#: And in a view beside its twin.
SMALL_PIXELS = 8_000


def best_view(item: SceneItem, number: int, wanted: int = BEST_PIXELS) -> tuple[float, int]:
    """How well the view that shows an object best does, 1 at most, and that view."""
    found = [(0.0, 0)]
    for k, shown in enumerate(item.visibility.views):
        for one in shown.objects:
            if one.object_id == number:
                x, y, w, h = one.bbox
                camera = item.cameras[k]
                whole = min(x, y, camera.width - x - w, camera.height - y - h) > 4
                size = min(one.pixels / wanted, wanted / one.pixels)
                found.append((size * one.fraction * (1 if whole else 0.2), k))
    return max(found)


def homes(data: sdgen.Dataset) -> Picture:
    """The overview that shows most of each kind of room."""
    kinds = ("kitchen", "living_room", "bedroom", "bathroom", "child_room", "hall")
    best: dict[str, tuple[int, str, SceneItem, int]] = {}
    for item in data:
        rooms = {room.id: room.type for room in item.scene.home.rooms}
        for camera in item.cameras:
            kind = rooms.get(camera.room_id, "")
            one = (_told_apart(item, camera.index), item.id, item, camera.index)
            if camera.kind == "room" and kind in kinds and one[:2] > best.get(kind, (0, ""))[:2]:
                best[kind] = one
    tiles = [named(view(*best[kind][2:]), kind.replace("_", " ")) for kind in kinds if kind in best]
    return grid(tiles, 3, (480, 360))


def _told_apart(item: SceneItem, k: int) -> int:
    """How many things a view shows well; none where one of them fills it."""
    shown = seen(item, k).values()
    camera = item.cameras[k]
    if max(one.pixels for one in shown) > camera.width * camera.height / 3:
        return 0
    return sum(one.pixels >= 300 for one in shown)


def sensors(item: SceneItem, k: int) -> Picture:
    """A view's colours, depth, objects and parts."""
    depth = item.depth(k)
    near = np.interp(depth, (depth[depth > 0].min(), depth.max()), (1, 0.1)) * (depth > 0)
    grey = Image.fromarray((near * 255).astype(np.uint8))
    ids, parts = item.instance(k).astype(np.uint32), item.part(k).astype(np.uint32)
    pictures = [view(item, k), grey, _coloured(ids), _coloured(ids * 16 + parts)]
    words = ("rgb", "depth", "instance", "part")
    return grid([named(p, w) for p, w in zip(pictures, words, strict=True)], 2, (480, 360))


def _coloured(ids: np.ndarray) -> Picture:
    mixed = (ids * 2654435761) & 0xFFFFFF
    colours = np.stack([mixed >> 16 & 255, mixed >> 8 & 255, mixed & 255], axis=-1)
    return Image.fromarray((colours * 0.8 + 40).clip(0, 255).astype(np.uint8))


def hazards(data: sdgen.Dataset) -> Picture:
    """The best picture of each hazard."""
    tiles = []
    for hazard in sorted(data.info.hazards_enabled):
        found = [
            (*best_view(item, one.object_id), item.id, item, one.object_id)
            for item in data.filter(hazard=hazard)
            for one in item.anomalies.anomalies
            if one.hazard == hazard
        ]
        _, k, _, item, number = max(found, key=lambda one: (one[0], one[2]))
        tiles.append(named(crop(item, k, number).resize((300, 300)), hazard.replace("_", " ")))
    return grid(tiles, 5, (300, 300))


def with_twin(data: sdgen.Dataset, wanted: Sequence[str]) -> Picture:
    """Views of anomalies beside the same views where they were undone."""
    tiles: list[Picture] = []
    for hazard in wanted:
        found = [
            (*best_view(item, one.object_id, SMALL_PIXELS), item.id, item, one.object_id)
            for item in data.filter(hazard=hazard, twin=True)
            for one in item.anomalies.anomalies
            if one.hazard == hazard
        ]
        _, k, _, item, number = max(found, key=lambda one: (one[0], one[2]))
        twin = item.twin
        assert twin is not None
        tiles += [named(boxed(item, k, {number: RED}), hazard.replace("_", " "))]
        tiles += [named(view(twin, k), "twin")]
    return grid(tiles, 2, (480, 360))


def near_misses(data: sdgen.Dataset, wanted: Sequence[str]) -> Picture:
    """A hazard beside a thing of the same category that is none."""
    tiles: list[Picture] = []
    for hazard in wanted:
        wrong: dict[str, tuple[Any, ...]] = {}
        right: dict[str, tuple[Any, ...]] = {}
        for item in data:
            category = {one.id: one.category for one in item.scene.objects}
            told = [(wrong, a.object_id, a.hazard) for a in item.anomalies.anomalies]
            told += [(right, a.object_id, a.near_miss_of) for a in item.anomalies.lookalikes]
            for best, number, what in told:
                score, k = best_view(item, number)
                one = (score, item.id, k, item, number)
                if what == hazard and one[:2] > best.get(category[number], (0.0, ""))[:2]:
                    best[category[number]] = one
        name = max(wrong.keys() & right.keys(), key=lambda one: min(wrong[one][0], right[one][0]))
        for best, words in ((wrong, hazard.replace("_", " ")), (right, "none")):
            _, _, k, item, number = best[name]
            tiles.append(named(crop(item, k, number).resize((360, 360)), words))
    return grid(tiles, 4, (360, 360))


def everything(item: SceneItem, k: int) -> Picture:
    """A view with everything in it that is told apart, and what it is."""
    picture = view(item, k).resize((1280, 960), Image.Resampling.LANCZOS)
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(17)
    wrong = {a.object_id for a in item.anomalies.anomalies}
    categories = {one.id: one.category for one in item.scene.objects}
    for one in sorted(seen(item, k).values(), key=lambda one: -one.pixels):
        if one.object_id not in categories or one.pixels < 400:
            continue
        colour = RED if one.object_id in wrong else (40, 140, 90)
        x, y, w, h = (2 * v for v in one.bbox)
        pen.rectangle((x, y, x + w, y + h), outline=colour, width=2)
        pen.text((x + 3, max(y - 19, 0)), categories[one.object_id], fill=colour, font=font)
    return picture


def shots(gallery: Path, item: SceneItem, number: int) -> dict[str, Picture]:
    """What Chromium shows of the gallery."""
    page_of_scene = gallery.parent / item.id / "index.html"
    out = {}
    with browser() as page:
        for name, size, part in (
            ("gallery", (1280, 900), ""),
            ("scene", (1280, 1000), ""),
            ("in-3d", (1280, 860), f"#3d={number}"),
        ):
            page.size(*size)
            where = gallery if name == "gallery" else page_of_scene
            page.open(where.resolve().as_uri() + part)
            if part:
                page.until("!!document.getElementById('stage').dataset.ready")
                page.run("document.getElementById('space').scrollIntoView()")
            page.run("new Promise(done => setTimeout(done, 1500))")
            out[name] = Image.open(io.BytesIO(page.picture())).convert("RGB")
    return out


def main(path: str) -> None:
    """Draw all ten."""
    data = sdgen.Dataset(path)
    views = ((_told_apart(i, k), i.id, k, i) for i in data for k in range(len(i.cameras)))
    full = sorted((v for v in views if len(v[3].anomalies.anomalies) >= 2), key=lambda one: one[:2])
    _, _, k, item = next(
        one
        for one in reversed(full)
        if sum(a.object_id in seen(one[3], one[2]) for a in one[3].anomalies.anomalies) >= 2
    )
    gallery = write_gallery(data, data.path / "view", library=sdgen.load_library()).index
    number = item.anomalies.anomalies[0].object_id
    wanted = ("candle_on", "sharp_object", "expired_produce", "poison_cleaning")
    pictures = {
        "homes": homes(data),
        "sensors": sensors(item, k),
        "hazards": hazards(data),
        "twins": with_twin(data, ("spill", "fridge_open")),
        "near-misses": near_misses(data, wanted),
        "everything": everything(item, k),
        "plan": plan_picture(item.scene, data.infos, item.cameras),
        **shots(gallery, item, number),
    }
    OUT.mkdir(parents=True, exist_ok=True)
    for name, picture in pictures.items():
        picture.thumbnail((1280, 1280))
        picture.save(OUT / f"{name}.jpg", quality=82, optimize=True)
        print(OUT / f"{name}.jpg", picture.size)


if __name__ == "__main__":
    main(sys.argv[1])
