"""Can somebody who sees the pictures alone tell hazards from their near misses, and which they are?

``blind_hazards.py draw DATASET FOLDER [--packs] [--each 130]`` draws so many anomalies and so many
lookalikes of the thirteen classes, or with ``--packs`` of the extension packs, hazard after hazard
in turn, by sha256 of what they are; each in the view that shows most of it, boxed, with the box
enlarged beside. The pictures are numbered in an order that says nothing; ``classes.txt`` says what
each class means, by its title and its predicate; the key goes beside the folder. Somebody who sees
the folder alone writes ``answers.jsonl``, one line ``{"n": 1, "answer": "candle_on"}`` a picture,
or ``"none"`` where the boxed thing is no hazard. ``blind_hazards.py score FOLDER`` counts: an
anomaly is right by any of the classes that its object is labelled with, a lookalike by ``none``.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from PIL import Image, ImageDraw
from sdgen import Dataset

EACH, LEAST_PIXELS, ZOOM = 130, 100, 480
NONE = "none"


class Shown(NamedTuple):
    """Something of a data set, the picture that shows most of it and its box there."""

    hazard: str
    kind: str
    scene: str
    object_id: int
    category: str
    labels: tuple[str, ...]
    picture: Path
    box: tuple[int, int, int, int]

    @property
    def rank(self) -> str:
        """Orders things in a way that nobody chose."""
        return hashlib.sha256(f"{self.scene}/{self.object_id}/{self.hazard}".encode()).hexdigest()


def shown(folder: Path) -> Iterator[Shown]:
    """A scene's anomalies and lookalikes that some view shows."""
    labels = json.loads((folder / "anomalies.json").read_text())
    visible = json.loads((folder / "visibility.json").read_text())
    things = {one["id"]: one for one in json.loads((folder / "scene.json").read_text())["objects"]}
    evidence = {one["anomaly_id"]: one["evidence_pixels"] for one in visible["anomalies"]}
    named: dict[int, list[str]] = defaultdict(list)
    for one in labels["anomalies"]:
        named[one["object_id"]].append(one["hazard"])
    pixels = [{o["object_id"]: o for o in view["objects"]} for view in visible["views"]]
    rows = [
        *((one["hazard"], "anomaly", one, evidence.get(one["id"])) for one in labels["anomalies"]),
        *((one["near_miss_of"], "lookalike", one, None) for one in labels["lookalikes"]),
    ]
    for hazard, kind, one, seen in rows:
        key = one["object_id"]
        count = seen or [view.get(key, {}).get("pixels", 0) for view in pixels]
        best = max(range(len(count)), key=count.__getitem__)
        if key not in pixels[best] or (seen is None and count[best] < LEAST_PIXELS):
            continue
        (picture,) = sorted((folder / "views" / f"{best:02d}").glob("rgb.*"))
        box = tuple(pixels[best][key]["bbox"])
        category = things[key]["category"]
        yield Shown(hazard, kind, folder.name, key, category, tuple(named[key]), picture, box)


def drawn(rows: list[Shown], hazards: list[str], each: int) -> list[Shown]:
    """``each`` anomalies and as many lookalikes, the hazards in turn; an object once."""
    out: list[Shown] = []
    for kind in ("anomaly", "lookalike"):
        of = {
            name: sorted(
                (r for r in rows if (r.hazard, r.kind) == (name, kind)), key=lambda r: r.rank
            )
            for name in hazards
        }
        turns = sorted(
            (turn, row.rank, row) for found in of.values() for turn, row in enumerate(found)
        )
        taken: set[tuple[str, int]] = set()
        for _, _, row in turns:
            if len(taken) < each and (row.scene, row.object_id) not in taken:
                taken.add((row.scene, row.object_id))
                out.append(row)
    return sorted(out, key=lambda row: row.rank[::-1])


def tile(row: Shown) -> Image.Image:
    """The whole view with the thing boxed, and the box with what is around it enlarged."""
    x, y, w, h = row.box
    with Image.open(row.picture) as image:
        whole = image.convert("RGB")
    half = max(w, h, 40) * 0.8
    middle_x, middle_y = x + w / 2, y + h / 2
    corners = (middle_x - half, middle_y - half, middle_x + half, middle_y + half)
    near = whole.crop(tuple(map(round, corners))).resize((ZOOM, ZOOM), Image.Resampling.LANCZOS)
    ImageDraw.Draw(whole).rectangle(
        (x - 3, y - 3, x + w + 2, y + h + 2), outline=(255, 0, 0), width=2
    )
    out = Image.new("RGB", (whole.width + ZOOM + 8, max(whole.height, ZOOM)), (255, 255, 255))
    out.paste(whole, (0, 0))
    out.paste(near, (whole.width + 8, 0))
    return out


def draw(dataset: Path, folder: Path, packs: bool, each: int) -> None:
    """Write the pictures, what the classes mean, and the key."""
    catalogue = json.loads((dataset / "catalogue.json").read_text())
    of = [one for one in catalogue["hazards"] if (one["pack"] != "core") == packs]
    rows = [row for scene in sorted((dataset / "scenes").iterdir()) for row in shown(scene)]
    chosen = drawn(rows, [one["id"] for one in of], each)
    folder.mkdir(parents=True)
    with folder.with_name(f"{folder.name}_key.csv").open("w", newline="") as stream:
        key = csv.writer(stream)
        key.writerow(("n", "kind", "hazard", "labels", "category", "scene", "object", "picture"))
        for n, row in enumerate(chosen, 1):
            tile(row).save(folder / f"{n:03d}.png")
            where = row.picture.relative_to(dataset).as_posix()
            labels = " ".join(row.labels)
            key.writerow(
                (n, row.kind, row.hazard, labels, row.category, row.scene, row.object_id, where)
            )
    meant = {one.id: one for one in Dataset(dataset).catalog.hazards}
    words = [f"{one['id']}: {one['title']}. {meant[one['id']].predicate.in_words()}" for one in of]
    (folder / "classes.txt").write_text("\n".join(words) + "\n")
    print(f"{len(chosen)} pictures in {folder}")


def score(folder: Path) -> None:
    """Compare ``answers.jsonl`` with the key; writes ``results.csv`` beside it."""
    said = {
        one["n"]: str(one["answer"]).strip()
        for line in (folder / "answers.jsonl").read_text().splitlines()
        if line.strip()
        for one in [json.loads(line)]
    }
    with folder.with_name(f"{folder.name}_key.csv").open() as stream:
        key = list(csv.DictReader(stream))
    counts: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0])
    with (folder / "results.csv").open("w", newline="") as stream:
        out = csv.writer(stream)
        out.writerow(("n", "kind", "hazard", "labels", "category", "answer", "right"))
        for row in key:
            answer = said.get(int(row["n"]), "")
            labels = row["labels"].split()
            right = answer in labels if labels else answer == NONE
            apart = (answer not in ("", NONE)) == bool(labels)
            for name in (row["kind"], "all"):
                counts[name][0] += 1
                counts[name][1] += right
                counts[name][2] += apart
            out.writerow(
                (
                    row["n"],
                    row["kind"],
                    row["hazard"],
                    row["labels"],
                    row["category"],
                    answer,
                    right,
                )
            )
            if not right:
                print(
                    row["n"],
                    row["kind"],
                    row["hazard"],
                    row["category"],
                    "->",
                    answer or "no answer",
                )
    for name, (total, right, apart) in counts.items():
        print(
            f"{name}: {right} of {total} named ({right / total:.1%}), "
            f"{apart} told apart ({apart / total:.1%})"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw")
    drawing.add_argument("dataset", type=Path)
    drawing.add_argument("folder", type=Path)
    drawing.add_argument("--packs", action="store_true")
    drawing.add_argument("--each", type=int, default=EACH)
    commands.add_parser("score").add_argument("folder", type=Path)
    args = parser.parse_args()
    if args.command == "draw":
        draw(args.dataset, args.folder, args.packs, args.each)
    else:
        score(args.folder)


if __name__ == "__main__":
    main()
