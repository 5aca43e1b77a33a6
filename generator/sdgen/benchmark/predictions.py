"""``predictions.jsonl``: one line a scene, read strictly.

An error (about a hundred of them at once, ``file:line: key path: problem``): text that is no JSON,
unknown or missing keys, wrong types, a label or notify outside the vocabulary, a scene the data set
does not have (twins are scenes, too), a scene on two lines, an object id the scene's graph does not
have, an object twice in a scene. No error: a scene without a line (nothing detected there), any
order of lines and reports, a wall or a floor among the objects (a false alarm like any other).
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from sdgen.dataset import Dataset
from sdgen.dataset.output_file import write_output
from sdgen.dataset.records import Prediction, Predictions, Report
from sdgen.dataset.text import compact, numbered_lines, to_record
from sdgen.errors import SHOWN, InputError, did_you_mean


def read_predictions(path: str | Path, data: Dataset) -> dict[str, tuple[Report, ...]]:
    """Reports by scene id. Raises InputError with the problems, located; it stops reading where
    there are too many."""
    path = Path(path)
    out: dict[str, tuple[Report, ...]] = {}
    line_of: dict[str, int] = {}
    problems: list[str] = []
    for number, line in numbered_lines(path, str(path)):
        where = f"{path}:{number}"
        if len(problems) >= SHOWN:
            problems.append(f"{where}: not read further: too many problems")
            break
        try:
            prediction = to_record(Prediction, line, where)
        except InputError as error:
            problems.extend(error.problems)
            continue
        if prediction.scene in line_of:
            first = line_of[prediction.scene]
            problems.append(f"{where}: scene: {prediction.scene!r} is on line {first} already")
            continue
        line_of[prediction.scene] = number
        problems.extend(_check(prediction, data, where))
        out[prediction.scene] = prediction.reports
    if problems:
        raise InputError(problems)
    return out


def _check(prediction: Prediction, data: Dataset, where: str) -> Iterable[str]:
    try:
        item = data.scene(prediction.scene)
    except InputError:
        hint = did_you_mean(prediction.scene, [entry.id for entry in data.entries])
        yield f"{where}: scene: no scene {prediction.scene!r}{hint}"
        return
    ids = {node.id for node in item.scene_graph.nodes}
    seen: set[int] = set()
    for k, report in enumerate(prediction.reports):
        path = f"{where}: reports[{k}].object_id"
        if report.object_id not in ids:
            yield f"{path}: scene {prediction.scene} has no object {report.object_id}"
        if report.object_id in seen:
            yield f"{path}: object {report.object_id} appears twice"
        seen.add(report.object_id)


def write_predictions(path: str | Path, predictions: Predictions) -> None:
    """Write predictions' file, whole or not at all.

    Raises SdgenError rather than write over a file of a data set or what is no plain file.
    """
    write_output(Path(path), prediction_bytes(predictions))


def prediction_bytes(predictions: Predictions) -> bytes:
    """Predictions as the bytes of their file, sorted by scene and object."""
    return b"".join(_line(scene, predictions[scene]) for scene in sorted(predictions))


def _line(scene: str, reports: Iterable[Report]) -> bytes:
    # A detector that does not say how sure it is writes no null, as in files of older versions.
    said = [
        report.model_dump(exclude_none=True)
        for report in sorted(reports, key=lambda r: r.object_id)
    ]
    return (compact({"scene": scene, "reports": said}) + "\n").encode("utf-8")
