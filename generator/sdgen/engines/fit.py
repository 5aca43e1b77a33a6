"""Does every hazard fit somewhere? Said before a long build starts, or soon after.

``misfits`` tries each hazard in some furnished homes without physics: a second, and it finds the
hazard whose target no home has. ``Blame`` watches the build for one that can be put somewhere but
never proved: a predicate that its recipe does not meet, or two hazards that overlap.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from sdgen.catalog.records import Catalog, Hazard, SetRecipe
from sdgen.hazards.draw import draw
from sdgen.hazards.inject import inject
from sdgen.hazards.splits import SplitModels
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.pipeline.stage import Stage, pick_home, stage_home
from sdgen.seeding import lane

HOMES_TRIED = 12
TRIES = 20
#: Scenes that fail for good, mostly through one hazard that no scene has, before a build ends.
FAILURES = 2
MOSTLY = 0.5


def misfits(catalog: Catalog, library: Library, options: BuildOptions) -> list[str]:
    """One line a hazard that found no place in any of some homes."""
    left = {hazard.id: hazard for hazard in catalog.hazards}
    seen: set[str] = set()
    homes = 0
    for index in range(HOMES_TRIED):
        if not left:
            return []
        stage = _stage(index, catalog, library, options)
        if isinstance(stage, str):
            continue
        homes += 1
        seen.update(item.category for item in stage.layout.items.values())
        for hazard_id in [name for name in left if _fits(name, index, stage, options)]:
            del left[hazard_id]
    if homes == 0:
        return []  # the homes are at fault; the build says how
    return [
        f"hazard {name!r} fits nowhere: no place found in {TRIES * homes} tries in {homes} homes; "
        f"{_missing(hazard, seen, library)}"
        for name, hazard in sorted(left.items())
    ]


def _stage(index: int, catalog: Catalog, library: Library, options: BuildOptions) -> Stage | str:
    rng = lane(options.seed, index, "fit")
    ids = iter((rng.permutation(65535) + 1).tolist())
    base = pick_home(catalog, options, index).plan(catalog, rng)
    if base is None:
        return "home: no floor plan"
    return stage_home(base, catalog, library, SplitModels(library, "test"), ids, rng)


def _fits(hazard: str, index: int, stage: Stage, options: BuildOptions) -> bool:
    rng = lane(options.seed, index, f"fit:{hazard}")
    for _ in range(TRIES):
        if inject([hazard], stage.layout.copy(), stage.site, False, rng).failed is None:
            return True
    return False


def _missing(hazard: Hazard, seen: Collection[str], library: Library) -> str:
    """What the homes or the library lack, or what else to look at."""
    targets: set[str] = set()
    things: set[str] = set()
    for recipe in hazard.anomalies:
        if isinstance(recipe, SetRecipe):
            targets.update(recipe.categories)
        else:
            targets.update(recipe.targets)
            things.update(recipe.categories)
    if not targets & {*seen, "floor"}:
        return f"no home has {_any_of(targets)}: give rooms one of them, or choose other targets"
    if things and not things & set(library.categories):
        return f"the library has no model of {_any_of(things)}"
    return (
        "its targets are there, but nothing fits: look at the sizes, rooms, zones and heights of "
        "its recipes"
    )


def _any_of(names: Collection[str]) -> str:
    some = sorted(names)
    more = f" or {len(some) - 6} more" if len(some) > 6 else ""
    return ", ".join(some[:6]) + more


@dataclass
class Blame:
    """Finds the hazard for whose sake scenes fail, while no scene of the build has it."""

    catalog: Catalog
    options: BuildOptions
    made: set[str] = field(default_factory=set)
    _failures: list[tuple[tuple[str, ...], Mapping[str, int]]] = field(default_factory=list)

    def failed(self, index: int, reasons: Mapping[str, int]) -> str | None:
        """Take in a scene that failed for good; what to say when going on is in vain."""
        options = self.options
        names = [hazard.id for hazard in self.catalog.hazards]
        drawn = draw(
            options.seed, index, names, options.hazards_min, options.hazards_max, options.draw
        )
        self._failures.append((drawn, reasons))
        suspects = {name: self._against(name) for name in names if name not in self.made}
        name = max(suspects, key=lambda key: (suspects[key].total(), key), default=None)
        if name is None or not suspects[name]:
            return None
        scenes = sum(
            drawn_for(name, drawn, reasons).total() >= MOSTLY * sum(reasons.values())
            for drawn, reasons in self._failures
        )
        if scenes < FAILURES:
            return None
        why = suspects[name]
        shown = ", ".join(f"{reason} x{count}" for reason, count in why.most_common(4))
        return (
            f"hazard {name!r} fits nowhere: never made in {why.total()} tries for {scenes} scenes "
            f"({shown}); {_hint(name, why)}"
        )

    def _against(self, name: str) -> Counter[str]:
        out: Counter[str] = Counter()
        for drawn, reasons in self._failures:
            out.update(drawn_for(name, drawn, reasons))
        return out


def drawn_for(name: str, drawn: Collection[str], reasons: Mapping[str, int]) -> Counter[str]:
    """The rejections of one scene that speak against hazard ``name``, if it was drawn.

    ``other: accidental`` does too: what one hazard's recipe made, another's predicate claimed.
    """
    if name not in drawn:
        return Counter()
    out: Counter[str] = Counter()
    for reason, count in reasons.items():
        whose, _, what = reason.partition(": ")
        if (whose == name) != what.startswith("accidental"):
            out[reason] += count
    return out


def _hint(name: str, why: Counter[str]) -> str:
    reason = why.most_common(1)[0][0]
    whose, _, what = reason.partition(": ")
    if what.startswith("accidental"):
        return f"what it puts there also is {whose}: make the two predicates exclude each other"
    if what == "no place found":
        return "look at the targets, rooms, zones and heights of its recipes"
    if what == "not proved":
        return "its recipes make what its predicate does not accept"
    if what == "cannot be seen":
        return "no camera sees enough of it: look at the size and the place"
    return "look at its recipes and models"
