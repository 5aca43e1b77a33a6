"""An evaluation as a page: scores, plots, base rates, and the worst scenes with pictures."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from urllib.parse import quote

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from sdgen.benchmark.base_rates import BaseRates
from sdgen.benchmark.collect import Collected
from sdgen.benchmark.compare import comparisons
from sdgen.benchmark.metrics import Evaluation, evaluation
from sdgen.benchmark.plot import curve_panel, recall_panel, svg
from sdgen.benchmark.scores import Score
from sdgen.benchmark.tables import CUTS, MICRO, ROWS, in_words, over_in_words, p_in_words
from sdgen.benchmark.worst import SceneOnPage, worst_scenes
from sdgen.dataset.disk import remove_tree
from sdgen.dataset.output_file import write_output
from sdgen.errors import SdgenError
from sdgen.gallery.files import INDEX, STYLE, begin_page, put, refuse_foreign
from sdgen.gallery.words import plain

#: How the style of such a page begins.
MARK = b"/* sdgen evaluate */"
NUMBERS, RECALL, CURVE, PICTURES = "evaluation.json", "recall.svg", "curve.svg", "pictures"
_OURS = frozenset({INDEX, STYLE, NUMBERS, RECALL, CURVE, PICTURES})
WORST = 12


@dataclass(frozen=True)
class ReportOptions:
    """``worst``: how many scenes are shown. ``gallery``: the folder or address of the data set's
    gallery, whose pages are linked. ``notes``: what else is to be said, a line each."""

    worst: int = WORST
    gallery: str | None = None
    notes: tuple[str, ...] = ()


def write_report(
    found: Collected,
    rates: Mapping[str, BaseRates],
    out: Path,
    options: ReportOptions | None = None,
) -> Path:
    """Write the page of one or several detectors into the folder ``out``; its index.

    An older report there is replaced, once the new one is whole. ``rates`` may be empty. Raises
    SdgenError when ``out`` holds anything else, InputError for a broken scene; then nothing
    changes.
    """
    check_report(out)
    out = Path(os.path.abspath(out))  # "." has no name of its own
    options = options or ReportOptions()
    out.parent.mkdir(parents=True, exist_ok=True)
    partial, old = (out.with_name(f".{out.name}.{word}") for word in ("partial", "old"))
    remove_tree(partial)  # of a run that was killed
    try:
        begin_page(partial, MARK)
        _write(found, rates, partial, out, options)
        check_report(out)
        if out.exists():
            remove_tree(old)
            os.replace(out, old)
        os.replace(partial, out)
        remove_tree(old)
    finally:
        remove_tree(partial)
    return out / INDEX


def check_report(out: Path) -> None:
    """Raises SdgenError unless a report may be written there: nothing is there, an empty folder, or
    an older report and nothing else."""
    refuse_foreign(out, MARK)
    if not out.is_dir():
        return
    pictures = out / PICTURES
    within = list(pictures.iterdir()) if pictures.is_dir() and not pictures.is_symlink() else []
    others = [p.name for p in out.iterdir() if p.name not in _OURS or p.is_symlink()]
    others += [p.name for p in within if not (p.name[:-4].isdigit() and p.suffix == ".jpg")]
    if others:
        name = sorted(others)[0]
        raise SdgenError(f"{out}: holds {name!r}, which is of no report; choose another place")


def _write(
    found: Collected,
    rates: Mapping[str, BaseRates],
    folder: Path,
    out: Path,
    options: ReportOptions,
) -> None:
    scores = {name: evaluation(found, name) for name in found.outcomes}
    compared = comparisons(found)
    put(folder / RECALL, svg([recall_panel(scores)]).encode("utf-8"))
    if rates:
        put(folder / CURVE, svg([curve_panel(rates)]).encode("utf-8"))
    (folder / PICTURES).mkdir()
    scenes: list[dict[str, Any]] = []
    pictures = 0
    for scene in worst_scenes(found, options.worst):
        things = []
        for thing in scene.things:
            link = None
            if thing.picture is not None:
                link = f"{PICTURES}/{pictures:04d}.jpg"
                put(folder / link, thing.picture)
                pictures += 1
            things.append((replace(thing, picture=None), link))
        scenes.append({"scene": scene, "things": things, "link": _link(scene, out, options)})
    numbers = {
        "detectors": {name: one.model_dump(mode="json") for name, one in scores.items()},
        "base_rates": {name: one.model_dump(mode="json") for name, one in rates.items()},
        "compared": [one.model_dump(mode="json") for one in compared],
    }
    put(folder / NUMBERS, (json.dumps(numbers, indent=1) + "\n").encode("utf-8"))
    text = (
        _templates()
        .get_template("report.html.j2")
        .render(
            data=found.data,
            names=list(scores),
            groups=_tables(scores),
            compared=compared,
            titles={name: title for title, name in ROWS.items()},
            rates=rates,
            setting=next(iter(rates.values()), None),
            scenes=scenes,
            notes=options.notes,
            total=len(found.data),
            several=len(scores) > 1,
        )
    )
    write_output(folder / INDEX, text.encode("utf-8"))


def _tables(scores: Mapping[str, Evaluation]) -> list[tuple[str, list[tuple[str, list[Score]]]]]:
    """Tables of scores: a title, and rows with a score for each detector."""
    every = list(scores.values())
    out = [("", [(title, [getattr(one, name) for one in every]) for title, name in ROWS.items()])]
    out[0][1].extend((title, [one.micro[key] for one in every]) for title, key in MICRO.items())
    for title, field in CUTS.items():
        keys = list(dict.fromkeys(key for one in every for key in getattr(one, field)))
        rows = []
        for key in keys:
            found = [getattr(one, field).get(key) for one in every]
            if any(one is not None and one.n for one in found):
                empty = Score(mean=None, se=None, n=0)
                rows.append((plain(key), [one if one is not None else empty for one in found]))
        if rows:
            out.append((title, rows))
    return out


def _link(scene: SceneOnPage, out: Path, options: ReportOptions) -> str | None:
    """The scene's page in the gallery, from the report's own."""
    if options.gallery is None:
        return None
    tail = f"{quote(scene.id)}/{INDEX}"
    if options.gallery.startswith(("http://", "https://")):
        return f"{options.gallery.rstrip('/')}/{tail}"
    relative = os.path.relpath(Path(options.gallery).resolve(), out.resolve())
    return f"{quote(Path(relative).as_posix())}/{tail}"


def _templates() -> Environment:
    environment = Environment(
        loader=PackageLoader("sdgen.benchmark", "templates"),
        autoescape=select_autoescape(default=True, default_for_string=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(score=in_words, over=over_in_words, p=p_in_words, words=plain)
    return environment
