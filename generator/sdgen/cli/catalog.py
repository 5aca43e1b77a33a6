"""``sdgen catalog``: what can go wrong, and whether a catalogue of one's own is good."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click

from sdgen.catalog.advice import advice, home_advice
from sdgen.catalog.enumeration import enumerate_anomalies
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog, Hazard, Near, PlaceRecipe, Recipe
from sdgen.cli.catalog_categories import list_categories
from sdgen.cli.catalog_new import new_hazard
from sdgen.cli.catalog_propose import propose
from sdgen.cli.catalog_test import test_hazards
from sdgen.cli.group import NamedGroup
from sdgen.cli.params import split_names
from sdgen.cli.shared_options import CATALOGS, EXTENSIONS
from sdgen.errors import InputError, UsageError, did_you_mean
from sdgen.library import load_library
from sdgen.options import BuildOptions

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON.")


def _sources(command: Callable[..., Any]) -> Callable[..., Any]:
    """The options that say which catalogue is meant."""
    return CATALOGS(EXTENSIONS(command))


def _load(catalogs: Sequence[Path], extensions: tuple[str, ...]) -> Catalog:
    return load_catalog(catalogs, extensions=split_names(extensions))


@click.group(cls=NamedGroup)
def catalog() -> None:
    """List, show and check what can go wrong.

    Example: sdgen catalog list
    """


catalog.add_command(list_categories)
catalog.add_command(new_hazard)
catalog.add_command(propose)
catalog.add_command(test_hazards)


@catalog.command("list")
@_sources
@_JSON
def list_hazards(catalogs: tuple[Path, ...], extensions: tuple[str, ...], as_json: bool) -> None:
    """List every hazard.

    Example: sdgen catalog list --json
    """
    found = _load(catalogs, extensions)
    counts: dict[str, int] = {}
    for item in enumerate_anomalies(found):
        counts[item.hazard] = counts.get(item.hazard, 0) + 1
    rows: list[dict[str, Any]] = [
        {
            "id": hazard.id,
            "title": hazard.title,
            "group": hazard.group,
            "label": hazard.label,
            "unique_anomalies": counts.get(hazard.id, 0),
        }
        for hazard in found.hazards
    ]
    if as_json:
        click.echo(json.dumps(rows, indent=1, ensure_ascii=False))
        return
    for row in rows:
        click.echo(
            f"{row['id']:24} {row['group']:13} {row['unique_anomalies']:5} unique  {row['title']}"
        )
    click.echo(f"{len(rows)} hazards, {sum(counts.values())} unique anomalies")


@catalog.command("show")
@_sources
@_JSON
@click.argument("hazard_id", metavar="HAZARD")
def show_hazard(
    catalogs: tuple[Path, ...], extensions: tuple[str, ...], as_json: bool, hazard_id: str
) -> None:
    """Show all of one hazard.

    Example: sdgen catalog show stove_on
    """
    found = _load(catalogs, extensions)
    known = [hazard.id for hazard in found.hazards]
    if hazard_id not in known:
        raise UsageError(f"no hazard {hazard_id!r}{did_you_mean(hazard_id, known)}")
    hazard = found.hazard(hazard_id)
    if as_json:
        click.echo(json.dumps(hazard.model_dump(mode="json"), indent=1, ensure_ascii=False))
        return
    for line in _sheet(hazard):
        click.echo(line)


@catalog.command("enumerate")
@_sources
@_JSON
def enumerate_all(catalogs: tuple[Path, ...], extensions: tuple[str, ...], as_json: bool) -> None:
    """List every unique anomaly: hazard, category, state, relation, target.

    Example: sdgen catalog enumerate --json
    """
    found = enumerate_anomalies(_load(catalogs, extensions))
    if as_json:
        click.echo(json.dumps([item.model_dump(mode="json") for item in found], indent=1))
        return
    for item in found:
        words = (item.hazard, item.category, item.state, item.relation, item.target)
        click.echo("  ".join(f"{word or '-':18}" for word in words).rstrip())
    click.echo(f"{len(found)} unique anomalies")


@catalog.command("validate")
@EXTENSIONS
@click.option(
    "--assets",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Extra asset folder; repeatable.",
)
@click.argument("paths", metavar="PATH...", nargs=-1, type=click.Path(path_type=Path))
def validate_paths(
    extensions: tuple[str, ...], assets: tuple[Path, ...], paths: tuple[Path, ...]
) -> None:
    """Check catalogue folders or files, together with the shipped catalogue and the models.

    What is sound is then tried as a build tries it first: each hazard is placed in up to twelve
    furnished homes, twenty tries each, without physics, and named if it fits nowhere, is always
    another hazard too, or is true of the furniture of most homes before anything is done (of some
    homes: a warning). What its recipes leave to chance is a warning, too. That takes a second or
    two, and about as long again per such hazard.

    Example: sdgen catalog validate my_hazards/
    """
    from sdgen.engines.fit import check_buildable, misfits
    from sdgen.home.drawing_check import check_drawings

    found = _load(paths, extensions)
    library = load_library(assets)
    check_drawings(found, library, paths)
    check_buildable(found, library)
    trial = misfits(found, library, BuildOptions(extensions=split_names(extensions)))
    chances = [line for hazard in found.hazards for line in advice(hazard)]
    dark = [line for home in found.homes for line in home_advice(home)]
    for line in (*chances, *dark, *trial.warnings):
        click.echo(f"warning: {line}", err=True)
    if trial.problems:
        raise InputError(list(trial.problems))
    unique = len(enumerate_anomalies(found))
    click.echo(
        f"good: {len(found.hazards)} hazards, {unique} unique anomalies, "
        f"{len(found.categories)} categories, {len(found.room_types)} room types, "
        f"{len(found.households)} households, {len(found.homes)} homes"
    )


def _sheet(hazard: Hazard) -> list[str]:
    who = hazard.concerns
    concerns = "everyone"
    if who.who == "children":
        concerns = f"households with a child up to {who.max_age}"
        concerns += " that can reach it" if who.by_reach else ""
    elif who.min_age is not None:
        concerns = f"households with somebody of {who.min_age} or older"
    elif who.living_with:
        concerns = f"households with: {', '.join(who.living_with)}"
    if who.rooms:
        concerns += f", in these rooms alone: {', '.join(who.rooms)}"
    severity = "-"
    if hazard.severity is not None:
        severity = f"{hazard.severity.harm} ({hazard.severity.source})"
    rows = [
        ("group", f"{hazard.group} ({hazard.label})"),
        ("paper class", hazard.paper_class or "-"),
        ("concerns", concerns),
        ("urgency", hazard.urgency),
        ("message", hazard.message),
        ("made by", [_recipe_line(item) for item in hazard.anomalies]),
        ("lookalikes", [_recipe_line(item) for item in hazard.lookalikes]),
        ("remedy", [" ".join((r.action, *r.targets)) for r in hazard.remedy]),
        ("holds when", hazard.predicate.in_words()),
        ("severity", severity),
        ("source", [str(one) for one in hazard.guidance] or hazard.source),
    ]
    lines = [f"{hazard.id}: {hazard.title}"]
    for name, value in rows:
        listed = value if isinstance(value, list) else [value]
        for index, text in enumerate(listed):
            lines.append(f"  {name if index == 0 else '':12} {text}")
    return lines


def _near_words(near: Near) -> str:
    state = f"{near.to_state.lower()} " if near.to_state else ""
    many = f"{near.count} of " if near.count > 1 else ""
    others = f"{many}{state}{' or '.join(near.to)}"
    seen = " seen from above" if near.from_above else ""
    brought = ", which it brings along" if near.bring else ""
    return f"within {near.max_m:g} m{seen} of {others}{brought}"


def _recipe_line(recipe: Recipe) -> str:
    things = ", ".join(recipe.categories)
    if not isinstance(recipe, PlaceRecipe):
        near = f" {_near_words(recipe.near)}" if recipe.near is not None else ""
        return f"set {things} {recipe.state}{near}"
    text = f"{recipe.state.lower() + ' ' if recipe.state else ''}{things} {recipe.relation} "
    text += ", ".join(recipe.targets)
    if recipe.zone:
        text += f" {'across' if recipe.across else 'in'} a {' or '.join(recipe.zone)}"
    if recipe.avoid_zones:
        text += f" clear of {', '.join(recipe.avoid_zones)}"
    if recipe.near is not None:
        text += f" {_near_words(recipe.near)}"
    if recipe.before is not None:
        text += f" at most {recipe.before.max_m:g} m before a {' or '.join(recipe.before.of)}"
    if recipe.over_edge is not None:
        text += " reaching {:g} to {:g} m over the edge".format(*recipe.over_edge)
    if recipe.min_height_m is not None:
        text += f" at {recipe.min_height_m:g} m or higher"
    if recipe.max_height_m is not None:
        text += f" at {recipe.max_height_m:g} m or lower"
    return text
