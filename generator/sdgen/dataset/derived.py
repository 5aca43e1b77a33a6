"""Deriving from a scene's files: those that disagree are an error of the input, located."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from shapely.errors import ShapelyError

from sdgen.dataset.item import SceneItem
from sdgen.dataset.reader import Dataset
from sdgen.errors import InputError, did_you_mean


@contextmanager
def derived_from(data: Dataset, item: SceneItem) -> Iterator[None]:
    """What is derived from a scene inside fails with InputError when its files disagree.

    Records that read well one by one may still name objects, rooms or models that are not there.
    """
    problems = list(_dangling(data, item))
    if problems:
        raise InputError(problems)
    try:
        yield
    except (LookupError, ValueError, ArithmeticError, ShapelyError) as error:
        reason = f"it names {error}, which is not there" if isinstance(error, KeyError) else error
        where = item.where("scene.json")
        raise InputError([f"{where}: cannot be evaluated: {reason} (see sdgen validate)"]) from None


def _dangling(data: Dataset, item: SceneItem) -> Iterator[str]:
    """What the objects of a scene name and the data set does not have."""
    known = {category.name for category in data.catalog.categories}
    rooms = {room.id for room in item.scene.home.rooms}
    for thing in item.scene.objects:
        where = f"{item.where('scene.json')}: object {thing.id}"
        info = data.infos.get(thing.asset)
        if info is None:
            hint = did_you_mean(thing.asset, list(data.infos))
            yield f"{where}: asset: {thing.asset!r} is not in assets.jsonl{hint}"
        elif thing.variant not in info.variants:
            hint = did_you_mean(thing.variant, list(info.variants))
            yield f"{where}: variant: {thing.asset} has no {thing.variant!r}{hint}"
        if thing.category not in known:
            hint = did_you_mean(thing.category, sorted(known))
            yield f"{where}: category: {thing.category!r} is not in catalogue.json{hint}"
        if thing.room_id not in rooms:
            yield f"{where}: room_id: scene.json has no room {thing.room_id}"
