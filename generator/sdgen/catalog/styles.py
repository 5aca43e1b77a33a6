"""Styles against the library: whether the surfaces and suites that they name are there."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from sdgen.catalog.records import Catalog, Style
from sdgen.errors import InputError, did_you_mean


def check_styles(
    catalog: Catalog, surfaces: Mapping[str, str], suites: Collection[str], tags: Collection[str]
) -> None:
    """Check that every style can be had with the models there are.

    ``surfaces`` maps those of the library to their kind; ``suites`` and ``tags`` are what its
    models say. Raises InputError with all names that are not there.
    """
    problems = [
        problem
        for style in catalog.styles
        for problem in (*_surfaces(style, surfaces), *_words(style, suites, tags))
    ]
    if problems:
        raise InputError(problems)


def _surfaces(style: Style, surfaces: Mapping[str, str]) -> Iterator[str]:
    named = {
        "floor": style.floors,
        "wall": style.walls,
        "ceiling": style.ceilings,
        "skirting": style.skirtings,
        "splashback": style.splashbacks,
    }
    for kind, choices in named.items():
        # A band of a wall may wear what a whole wall can.
        kinds = (kind, "wall") if kind == "splashback" else (kind,)
        known = sorted(name for name, found in surfaces.items() if found in kinds)
        for index, choice in enumerate(choices):
            for name in choice.of:
                if name not in known:
                    where = f"style {style.name}: {kind}s[{index}]"
                    near = did_you_mean(name, known)
                    yield f"{where}: the library has no {kind} surface {name!r}{near}"


def _words(style: Style, suites: Collection[str], tags: Collection[str]) -> Iterator[str]:
    for part, names in style.suites:
        for name in names:
            if name not in suites:
                near = did_you_mean(name, sorted(suites))
                yield f"style {style.name}: suites.{part}: no model is of suite {name!r}{near}"
    for tag in style.tags:
        if tag not in tags:
            near = did_you_mean(tag, sorted(tags))
            yield f"style {style.name}: no model has the tag {tag!r}{near}"
