"""``predictions.jsonl``: one line a scene, read strictly, or leniently where that is asked for.

An error (about a hundred of them at once, ``file:line: key path: problem``): text that is no JSON,
unknown or missing keys, wrong types, a label or notify outside the vocabulary, a scene the data set
does not have (twins are scenes, too), a scene on two lines, an object id the scene's graph does not
have, an object twice in a scene. No error: a scene without a line (nothing detected there), any
order of lines and reports, a wall or a floor among the objects (a false alarm like any other).

Leniently, for what language models write: all this is skipped and counted, but an object that does
not exist stays, as the false alarm of its scene that it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from sdgen.benchmark.truth import unknown_objects
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.output_file import write_output
from sdgen.dataset.records import Prediction, Predictions, Report
from sdgen.dataset.text import compact, numbered_lines, parse, to_record
from sdgen.errors import SHOWN, InputError, did_you_mean

#: Unknown scenes for which the nearest known one is looked up, which takes long among many.
_HINTS, _HINTS_AMONG = 5, 20_000

#: What a lenient reader leaves out or notes, in words: (of one, of several).
SKIPPED: Mapping[str, tuple[str, str]] = {
    "broken_lines": ("line that is no prediction was skipped", "lines that are no predictions"),
    "unknown_scenes": ("line of an unknown scene was skipped", "lines of unknown scenes"),
    "repeated_scenes": ("further line of a scene was skipped", "further lines of scenes"),
    "bad_reports": ("report of another shape was skipped", "reports of another shape"),
    "repeated_objects": ("further report of an object was skipped", "further reports of objects"),
    "unknown_objects": (
        "report of an object that does not exist counts as false alarm",
        "reports of objects that do not exist count as false alarms",
    ),
}


@dataclass(frozen=True)
class Lenient:
    """Predictions as far as they could be read, and how many of what is in ``SKIPPED`` there
    were."""

    predictions: dict[str, tuple[Report, ...]]
    counts: Mapping[str, int]

    def notes(self) -> Iterator[str]:
        """What was skipped, in words."""
        for key, (one, several) in SKIPPED.items():
            count = self.counts.get(key, 0)
            if count == 1:
                yield f"1 {one}"
            elif count:
                verb = "" if key == "unknown_objects" else " were skipped"
                yield f"{count} {several}{verb}"


def silence(predictions: Predictions, data: Dataset) -> str:
    """What to say of scenes without a line; empty where each has one."""
    missing = sum(entry.id not in predictions for entry in data.shown)
    said = f"no line for {missing} of {len(data)} scenes, which counts as silence"
    return said if missing else ""


def read_predictions(path: str | Path, data: Dataset) -> dict[str, tuple[Report, ...]]:
    """Reports by scene id. Raises InputError with the problems, located; it stops reading where
    there are too many."""
    path = Path(path)
    out: dict[str, tuple[Report, ...]] = {}
    line_of: dict[str, int] = {}
    problems: list[str] = []
    known = {entry.id for entry in data.entries}
    unknown = 0
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
        scene = prediction.scene
        if scene in line_of:
            problems.append(f"{where}: scene: {scene!r} is on line {line_of[scene]} already")
            continue
        line_of[scene] = number
        if scene not in known:
            unknown += 1
            asked = unknown <= _HINTS and len(known) <= _HINTS_AMONG
            hint = did_you_mean(scene[:80], sorted(known)) if asked else ""
            problems.append(f"{where}: scene: no scene {scene[:80]!r}{hint}")
            continue
        found = _check(prediction.reports, data.scene(scene), where)
        problems.extend(islice(found, SHOWN))
        out[scene] = prediction.reports
    if problems:
        raise InputError(problems)
    return out


def _check(reports: Sequence[Report], item: SceneItem, where: str) -> Iterator[str]:
    unknown = unknown_objects(item, (report.object_id for report in reports))
    seen: set[int] = set()
    for k, report in enumerate(reports):
        path = f"{where}: reports[{k}].object_id"
        if report.object_id in unknown:
            yield f"{path}: scene {item.id} has no object {report.object_id}"
        if report.object_id in seen:
            yield f"{path}: object {report.object_id} appears twice"
        seen.add(report.object_id)


def read_leniently(path: str | Path, data: Dataset) -> Lenient:
    """Reports by scene id of whatever can be read, and counts of the rest. Raises InputError for a
    file that cannot be read at all, and for a broken data set."""
    path = Path(path)
    known = {entry.id for entry in data.entries}
    counts: Counter[str] = Counter()
    out: dict[str, tuple[Report, ...]] = {}
    for number, line in numbered_lines(path, str(path)):
        try:
            value = parse(line, f"{path}:{number}", any_number=True)
        except InputError:
            value = None
        scene = value.get("scene") if isinstance(value, dict) else None
        said = value.get("reports") if isinstance(value, dict) else None
        if not isinstance(scene, str) or not isinstance(said, list):
            counts["broken_lines"] += 1
        elif scene not in known:
            counts["unknown_scenes"] += 1
        elif scene in out:
            counts["repeated_scenes"] += 1
        else:
            out[scene] = _reports(said, data.scene(scene), counts)
    return Lenient(out, {key: counts[key] for key in SKIPPED})


def _reports(said: Iterable[Any], item: SceneItem, counts: Counter[str]) -> tuple[Report, ...]:
    out: dict[int, Report] = {}
    for one in said:
        try:
            report = Report.model_validate(one, strict=True)
        except ValueError:
            counts["bad_reports"] += 1
            continue
        if report.object_id in out:
            counts["repeated_objects"] += 1
            continue
        out[report.object_id] = report
    counts["unknown_objects"] += len(unknown_objects(item, out))
    return tuple(out.values())


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
