"""A page of what became of the unique anomalies of a catalogue: those that fit nowhere first."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sdgen.catalog.records import Catalog
from sdgen.dataset.output_file import write_output
from sdgen.engines.trials import Tried, in_words, why_not
from sdgen.gallery.files import INDEX, begin_page, refuse_foreign, templates
from sdgen.library import Library
from sdgen.rejection import most_frequent

#: How the style of such a page begins.
MARK = b"/* sdgen catalog test */"
PICTURES, REPORT = "pictures", "report.json"


def begin_trials(out: Path) -> Path:
    """Make the folder of a page, and in it the one of its pictures, which is returned.

    Raises SdgenError when ``out`` holds something else.
    """
    refuse_foreign(out, MARK)
    begin_page(out, MARK)
    pictures = out / PICTURES
    pictures.mkdir(exist_ok=True)
    for old in pictures.glob("[0-9]*.jpg"):
        old.unlink()
    return pictures


def write_trials(tried: Sequence[Tried], catalog: Catalog, library: Library, out: Path) -> Path:
    """Write the page and the report of a folder that :func:`begin_trials` made; the page."""
    report = trials_report(tried, library)
    write_output(out / REPORT, (json.dumps(report, indent=1) + "\n").encode("utf-8"))
    titles = {hazard.id: hazard.title for hazard in catalog.hazards}
    groups: dict[str, list[Tried]] = {}
    for one in tried:
        groups.setdefault(one.unique.hazard, []).append(one)
    text = (
        templates()
        .get_template("trials.html.j2")
        .render(
            report=report,
            groups=[(name, titles[name], some) for name, some in groups.items()],
            failed=[(in_words(one.unique), why_not(one, library)) for one in tried if not one.fits],
            in_words=in_words,
            pictures=PICTURES,
        )
    )
    write_output(out / INDEX, text.encode("utf-8"))
    return out / INDEX


def trials_report(tried: Sequence[Tried], library: Library) -> dict[str, Any]:
    """What became of them, for programs: totals, by hazard, and one by one."""
    by_hazard: dict[str, dict[str, int]] = {}
    for one in tried:
        counts = by_hazard.setdefault(one.unique.hazard, {"tried": 0, "fit": 0})
        counts["tried"] += 1
        counts["fit"] += one.fits
    fit = sum(one.fits for one in tried)
    return {
        "tried": len(tried),
        "fit": fit,
        "rate": fit / len(tried) if tried else 1.0,
        "by_hazard": by_hazard,
        "anomalies": [_record(one, library) for one in tried],
    }


def _record(one: Tried, library: Library) -> dict[str, Any]:
    return {
        **one.unique.model_dump(mode="json"),
        "fits": one.fits,
        "home": one.home,
        "homes": one.homes,
        "tries": one.tries,
        "why_not": None if one.fits else why_not(one, library),
        "causes": [
            {**cause._asdict(), "count": count} for cause, count in most_frequent(one.causes)
        ],
        "message": one.message,
        "picture": one.picture and f"{PICTURES}/{one.picture}",
    }
