"""Questions as files that harnesses for language models read, in one folder.

``questions.jsonl`` has a line a question and ``images/`` their pictures, the box drawn in;
``sdgen_questions.tsv`` is the same as VLMEvalKit reads it, pictures inside. ``inspect_task.py`` is
a task for inspect-ai, ``lmms_eval/`` one for lmms-eval.
"""

from __future__ import annotations

import base64
import csv
import io
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from string import ascii_uppercase
from typing import IO, Any

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw

from sdgen.dataset import Dataset
from sdgen.dataset.derived import derived_from
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.text import compact
from sdgen.errors import SdgenError
from sdgen.export.formats import OnScene
from sdgen.export.questions import Bbox, Question, questions_of
from sdgen.export.shards import groups, scenes_in

TSV = "sdgen_questions.tsv"
#: Most options of a question.
LETTERS = ascii_uppercase[:4]
_COLUMNS = (
    *("index", "image", "question", "hint", *LETTERS, "answer", "category", "split"),
    *("id", "scene", "view", "object_id", "box", "hazard", "twin"),
)
#: Files of the package -> where they go.
HARNESS = {
    "inspect_task.py": "inspect_task.py",
    "lmms_utils.py": "lmms_eval/utils.py",
    "lmms_task.yaml": "lmms_eval/sdgen_questions.yaml",
}


def export_questions(data: Dataset, output: Path, on_scene: OnScene = None) -> None:
    """Write questions into a new folder; the same bytes for the same data set and Pillow.

    Raises SdgenError for a bad place or a data set without colours and masks, InputError for a file
    that is missing or changed.
    """
    if not {"rgb", "instance"} <= set(data.info.options.sensors):
        raise SdgenError(f"{data.path}: questions need the sensors rgb and instance")
    total, done, index = scenes_in(data), 0, 0
    with output_folder(output) as folder:
        (folder / "images").mkdir()
        for name, place in HARNESS.items():
            (folder / place).parent.mkdir(exist_ok=True)
            code = (
                files("sdgen.export").joinpath("harness").joinpath(name).read_text(encoding="utf-8")
            )
            (folder / place).write_text(code, encoding="utf-8")
        with (
            (folder / TSV).open("x", encoding="utf-8", newline="") as table,
            (folder / "questions.jsonl").open("x", encoding="utf-8") as lines,
        ):
            rows = csv.DictWriter(table, _COLUMNS, delimiter="\t", lineterminator="\n")
            rows.writeheader()
            for kind, _, items in groups(data):
                for item in items:
                    if kind == "scene":
                        with derived_from(data, item):
                            for question in questions_of(data, item):
                                _write(folder, question, index, rows, lines)
                                index += 1
                    done += 1
                    if on_scene is not None:
                        on_scene(done, total)


def _write(
    folder: Path, question: Question, index: int, rows: csv.DictWriter[str], lines: IO[str]
) -> None:
    # One for all questions about it.
    name = f"images/{question.item.id}-{question.view:02d}-{question.object_id}.jpg"
    picture = boxed(question)
    (folder / name).write_bytes(picture)
    row: Mapping[str, Any] = {
        "index": index,
        "question": question.text,
        "hint": question.hint,
        "answer": LETTERS[question.answer],
        "split": question.item.entry.split,
        "id": question.id,
        "scene": question.item.id,
        "view": question.view,
        "object_id": question.object_id,
        "hazard": question.hazard,
    }
    options = dict(zip(LETTERS, question.options, strict=False))
    rows.writerow(
        {
            **row,
            **options,
            "image": base64.b64encode(picture).decode("ascii"),
            "category": question.kind,
            "box": compact(list(question.bbox)),
            "twin": question.pair or "",
        }
    )
    said = {
        **row,
        "image": name,
        "kind": question.kind,
        "box": list(question.bbox),
        "options": list(question.options),
        "twin": question.pair,
    }
    lines.write(compact(said) + "\n")


def boxed(question: Question) -> bytes:
    """The picture of a question as JPEG, a red frame around its box."""
    item, view = question.item, question.view
    image = Image.fromarray(framed(item.rgb(view), question.bbox))
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=92)
    return buffer.getvalue()


def framed(rgb: npt.NDArray[np.uint8], bbox: Bbox) -> npt.NDArray[np.uint8]:
    """(H, W, 3) with a frame outside the box, so that nothing in it is hidden: red between white,
    or it would not show on red things."""
    image = Image.fromarray(rgb)
    draw = ImageDraw.Draw(image)
    x, y, width, height = bbox
    for far, colour in ((5, "white"), (4, "red"), (3, "red"), (2, "white")):
        draw.rectangle(
            (x - far, y - far, x + width - 1 + far, y + height - 1 + far), outline=colour
        )
    return np.asarray(image)
