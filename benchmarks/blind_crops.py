"""Can somebody who does not know the labels name imported models where they stand in pictures?

``blind_crops.py draw DATASET LIBRARY FOLDER`` cuts 40 things of models of LIBRARY out of the views
of a data set that was built with them onto numbered sheets without names; the key goes beside them.
Cut are things of which nine tenths are seen, with 1,000 pixels and more, whose box touches no edge
of its picture, in the views that come first by sha256(model + view): every model once, then again
until there are 40. A reviewer who sees only the sheets writes ``names.txt``, one line
``number: answer`` a picture. ``blind_crops.py score FOLDER`` compares that with the synonyms
written down before (docs/blind-naming/synonyms.yaml, and crops.yaml beside it: what some scans
are).
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
import re
from pathlib import Path

import numpy as np
import yaml
from PIL import Image, ImageDraw
from sdgen.gallery.sheet import contact_sheet

WORDS = Path(__file__).resolve().parent.parent / "docs" / "blind-naming"
COUNT, PER_PAGE, COLUMNS, SIZE, MARGIN = 40, 20, 5, 320, 0.8
LEAST_PIXELS, LEAST_SHARE = 1000, 0.9


def candidates(dataset: Path, models: set[str]) -> dict[str, list[tuple[Path, list[int]]]]:
    """Model -> pictures of it with its box (x, y, wide, high)."""
    found: dict[str, list[tuple[Path, list[int]]]] = {}
    for folder in sorted((dataset / "scenes").iterdir()):
        scene = json.loads((folder / "scene.json").read_text())
        model_of = {thing["id"]: thing.get("asset") for thing in scene["objects"]}
        for view in json.loads((folder / "visibility.json").read_text())["views"]:
            picture = folder / "views" / f"{view['view']:02d}" / "rgb.png"
            with Image.open(picture) as image:
                width, height = image.size
            for thing in view["objects"]:
                x, y, w, h = thing["bbox"]
                inside = x > 1 and y > 1 and x + w < width - 1 and y + h < height - 1
                seen = thing["pixels"] >= LEAST_PIXELS and thing["fraction"] >= LEAST_SHARE
                model = model_of.get(thing["object_id"])
                if inside and seen and model in models:
                    found.setdefault(model, []).append((picture, thing["bbox"]))
    return found


def crop(picture: Path, box: list[int]) -> Image.Image:
    """A square around a thing, the thing framed."""
    x, y, w, h = box
    half = max(w, h) * (0.5 + MARGIN)
    with Image.open(picture) as image:
        rgb = image.convert("RGB")
    ImageDraw.Draw(rgb).rectangle((x - 2, y - 2, x + w + 1, y + h + 1), outline=(255, 0, 0))
    left, top = x + w / 2 - half, y + h / 2 - half
    corners = (round(left), round(top), round(left + 2 * half), round(top + 2 * half))
    return rgb.crop(corners).resize((SIZE, SIZE), Image.Resampling.LANCZOS)


def draw(dataset: Path, library: Path, folder: Path) -> None:
    """Write the sheets and the key."""
    listed = yaml.safe_load((library / "manifest.yaml").read_text())["assets"]
    category = {asset["id"]: asset["category"] for asset in listed}
    found = candidates(dataset, set(category))

    def rank(text: str) -> str:
        return hashlib.sha256(text.encode()).hexdigest()

    turns = []
    for model, seen in found.items():
        seen.sort(key=lambda item: rank(f"{model}{item[0].relative_to(dataset)}"))
        turns += [(turn, rank(model), model, *item) for turn, item in enumerate(seen)]
    folder.mkdir(parents=True)
    rows, tiles = [], []
    for number, (_, _, model, picture, box) in enumerate(sorted(turns)[:COUNT], 1):
        tiles.append((f"{number}", np.asarray(crop(picture, box))))
        rows.append((number, model, category[model], picture.relative_to(dataset), *box))
    for page in range(0, len(tiles), PER_PAGE):
        sheet = contact_sheet(tiles[page : page + PER_PAGE], COLUMNS)
        Image.fromarray(sheet).save(folder / f"sheet_{page // PER_PAGE + 1}.png")
    with folder.with_name(f"{folder.name}_key.csv").open("w", newline="") as stream:
        csv.writer(stream).writerows([("number", "model", "category", "picture", *"xywh"), *rows])
    print(f"{len(rows)} crops of {len(found)} models in {folder}")


def score(folder: Path) -> None:
    """Compare ``names.txt`` with the synonyms; the results go to ``crops.csv``."""
    synonyms = yaml.safe_load((WORDS / "synonyms.yaml").read_text())
    scans = yaml.safe_load((WORDS / "crops.yaml").read_text())
    lines = (folder / "names.txt").read_text().splitlines()
    said = dict(line.split(":", 1) for line in lines if ":" in line)
    with folder.with_name(f"{folder.name}_key.csv").open() as stream:
        key = list(csv.DictReader(stream))
    rows, right = [], 0
    for row in key:
        answer = said.get(row["number"], "").strip().casefold()
        words = [*synonyms.get(row["category"], [row["category"]]), *scans.get(row["model"], [])]
        hit = any(re.search(rf"\b{re.escape(word.casefold())}\b", answer) for word in words)
        right += hit
        rows.append((row["number"], row["model"], row["category"], answer, "yes" if hit else "no"))
    with (folder / "crops.csv").open("w", newline="") as stream:
        csv.writer(stream).writerows([("number", "model", "category", "answer", "right"), *rows])
    for row in rows:
        if row[-1] == "no":
            print(*row)
    print(f"{right} of {len(rows)}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw")
    drawing.add_argument("dataset", type=Path)
    drawing.add_argument("library", type=Path)
    drawing.add_argument("folder", type=Path)
    commands.add_parser("score").add_argument("folder", type=Path)
    args = parser.parse_args()
    if args.command == "draw":
        draw(args.dataset, args.library, args.folder)
    else:
        score(args.folder)


if __name__ == "__main__":
    main()
