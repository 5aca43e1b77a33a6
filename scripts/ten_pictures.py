"""Draw the pictures of docs/ten-pictures.md from a data set with twins and its gallery.

Run: ``sdgen build --n 100 --seed 4051 --twins --out homes``, then
``python scripts/ten_pictures.py homes`` (needs Chromium for the last three).
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import sdgen
from PIL import Image, ImageDraw, ImageFont
from sdgen.dataset import SceneItem
from sdgen.gallery import write_gallery
from sdgen.gallery.plan_picture import plan_picture

OUT = Path(__file__).resolve().parent.parent / "docs" / "images" / "ten"
RED, BLUE, GAP = (214, 40, 40), (30, 100, 210), 6
#: What a crop shows around its box, as a share of the box; and at least so many pixels.
AROUND, LEAST = 0.8, 110
Picture = Image.Image


def grid(pictures: Sequence[Picture], columns: int, size: tuple[int, int]) -> Picture:
    """Pictures of one size in rows."""
    rows = -(-len(pictures) // columns)
    width, height = size
    sheet = Image.new(
        "RGB", (columns * (width + GAP) - GAP, rows * (height + GAP) - GAP), "white"
    )
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


def best_view(item: SceneItem, number: int) -> tuple[int, int]:
    """The pixels of an object where most of it is seen whole, and that view."""
    found = [
        (one.pixels if one.fraction > 0.9 else 0, v.view)
        for v in item.visibility.views
        for one in v.objects
        if one.object_id == number
    ]
    return max(found, default=(0, 0))


def homes(data: sdgen.Dataset) -> Picture:
    """One overview each of six homes, of six kinds of rooms."""
    kinds = ("kitchen", "living_room", "bedroom", "bathroom", "child_room", "hallway")
    found: dict[str, Picture] = {}
    for item in data:
        for camera in item.cameras:
            room = next((r for r in item.scene.home.rooms if r.id == camera.room_id), None)
            free = camera.kind == "room" and room is not None and room.type not in found
            if free and room is not None and room.type in kinds:
                found[room.type] = named(view(item, camera.index), room.type.replace("_", " "))
                break
    return grid([found[kind] for kind in kinds if kind in found], 3, (480, 360))


def sensors(item: SceneItem, k: int) -> Picture:
    """A view's colours, depth, objects and parts."""
    depth = item.depth(k)
    near = np.interp(depth, (depth[depth > 0].min(), depth.max()), (1, 0.1)) * (depth > 0)
    grey = Image.fromarray((near * 255).astype(np.uint8))
    ids, parts = item.instance(k).astype(np.uint32), item.part(k).astype(np.uint32)
    pictures = [view(item, k), grey, _coloured(ids), _coloured(ids * 16 + parts)]
    words = ("rgb", "depth", "instance", "part")
    return grid(
        [named(p, w) for p, w in zip(pictures, words, strict=True)], 2, (480, 360)
    )


def _coloured(ids: np.ndarray) -> Picture:
    mixed = (ids * 2654435761) & 0xFFFFFF
    colours = np.stack([mixed >> 16 & 255, mixed >> 8 & 255, mixed & 255], axis=-1)
    return Image.fromarray((colours * 0.8 + 40).clip(0, 255).astype(np.uint8))


def hazards(data: sdgen.Dataset) -> Picture:
    """The best picture of each hazard."""
    best: dict[str, tuple[int, Callable[[], Picture]]] = {}
    for item in data:
        for anomaly in item.anomalies.anomalies:
            pixels, k = best_view(item, anomaly.object_id)
            # What fills a picture is no longer told by what is around it.
            pixels = pixels if pixels < 60_000 else 60_000 - pixels
            if pixels > best.get(anomaly.hazard, (0, None))[0]:
                best[anomaly.hazard] = (
                    pixels,
                    lambda item=item, k=k, number=anomaly.object_id: crop(item, k, number),
                )
    tiles = [
        named(best[name][1]().resize((300, 300)), name.replace("_", " ")) for name in sorted(best)
    ]
    return grid(tiles, 5, (300, 300))


def with_twin(data: sdgen.Dataset, wanted: Sequence[str]) -> Picture:
    """Views of anomalies beside the same views where they were undone."""
    tiles: list[Picture] = []
    for hazard in wanted:
        found = []
        for item in data.filter(hazard=hazard, twin=True):
            for anomaly in item.anomalies.anomalies:
                if anomaly.hazard == hazard:
                    pixels, k = best_view(item, anomaly.object_id)
                    found.append((min(pixels, 25_000), item.id, item, k, anomaly.object_id))
        _, _, item, k, number = max(found, key=lambda one: one[:2])
        twin = item.twin
        assert twin is not None
        tiles += [named(boxed(item, k, {number: RED}), hazard), named(view(twin, k), "twin")]
    return grid(tiles, 2, (480, 360))


def near_misses(data: sdgen.Dataset, wanted: Sequence[str]) -> Picture:
    """A hazard beside what looks like it."""
    tiles: list[Picture] = []
    for hazard in wanted:
        wrong = _largest(
            (item, a.object_id) for item in data for a in item.anomalies.anomalies if a.hazard == hazard
        )
        right = _largest(
            (item, a.object_id)
            for item in data
            for a in item.anomalies.lookalikes
            if a.near_miss_of == hazard
        )
        tiles.append(named(crop(*wrong).resize((360, 360)), hazard))
        tiles.append(named(crop(*right).resize((360, 360)), "near miss"))
    return grid(tiles, 4, (360, 360))


def _largest(things: Iterable[tuple[SceneItem, int]]) -> tuple[SceneItem, int, int]:
    found = []
    for item, number in things:
        pixels, k = best_view(item, number)
        found.append((min(pixels, 9_000), item.id, number, item, k))
    _, _, number, item, k = max(found, key=lambda one: one[:3])
    return item, k, number


def everything(item: SceneItem, k: int) -> Picture:
    """A view with everything in it that is told apart, and what it is."""
    picture = view(item, k).resize((1280, 960), Image.Resampling.LANCZOS)
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(17)
    wrong = {a.object_id for a in item.anomalies.anomalies}
    categories = {one.id: one.category for one in item.scene.objects}
    for one in sorted(seen(item, k).values(), key=lambda one: -one.pixels):
        if one.object_id not in categories or one.pixels < 150:
            continue
        colour = RED if one.object_id in wrong else (40, 140, 90)
        x, y, w, h = (2 * v for v in one.bbox)
        pen.rectangle((x, y, x + w, y + h), outline=colour, width=2)
        pen.text((x + 3, max(y - 19, 0)), categories[one.object_id], fill=colour, font=font)
    return picture


def shot(page: Path, part: str, size: tuple[int, int], wait_ms: int = 8000) -> Picture:
    """What Chromium shows of a page of the gallery."""
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        sys.exit("the last pictures need Chromium")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "shot.png"
        subprocess.run(
            [
                browser,
                "--headless",
                "--no-sandbox",
                "--use-gl=angle",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--hide-scrollbars",
                f"--window-size={size[0]},{size[1]}",
                f"--virtual-time-budget={wait_ms}",
                f"--screenshot={out}",
                page.resolve().as_uri() + part,
            ],
            check=True,
            capture_output=True,
        )
        return Image.open(out).convert("RGB").copy()


def main(path: str) -> None:
    """Draw all ten."""
    data = sdgen.Dataset(path)
    rooms = [i for i in data if len(i.anomalies.anomalies) >= 2 and "stove_on" in i.entry.hazards]
    item = rooms[0] if rooms else data[0]
    k = item.best_view()
    gallery = write_gallery(data, data.path / "view", library=sdgen.load_library()).index
    number = item.anomalies.anomalies[0].object_id
    pictures = {
        "homes": homes(data),
        "sensors": sensors(item, k),
        "hazards": hazards(data),
        "twins": with_twin(data, ("spill", "fridge_open")),
        "near-misses": near_misses(data, ("poison_medication", "candle_on", "broken_item", "choking_hazard")),
        "everything": everything(item, k),
        "plan": plan_picture(item.scene, data.infos, item.cameras),
        "gallery": shot(gallery, "", (1280, 900)),
        "scene": shot(gallery.parent / item.id / "index.html", "", (1280, 1000)),
        "in-3d": shot(gallery.parent / item.id / "index.html", f"#3d={number}", (1280, 900), 20000),
    }
    OUT.mkdir(parents=True, exist_ok=True)
    for name, picture in pictures.items():
        picture.thumbnail((1280, 1280))
        picture.save(OUT / f"{name}.jpg", quality=82, optimize=True)
        print(OUT / f"{name}.jpg", picture.size)


if __name__ == "__main__":
    main(sys.argv[1])
