"""Does every hazard fit somewhere? Said before a long build starts.

Each hazard is tried in some furnished homes without physics: seconds, and it finds the hazard
whose target no home has. What always is another hazard, too, is told: its objects are labelled as
both. Homes in which the furniture satisfies a hazard as it stands are counted, too (``untouched``).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass, field

from sdgen.catalog.enumeration import check_against_library
from sdgen.catalog.records import Catalog, Hazard, SetRecipe
from sdgen.catalog.styles import check_styles
from sdgen.engines.early_stop import none_left
from sdgen.engines.untouched import Untouched
from sdgen.hazards.certify import facts_of
from sdgen.hazards.hosting import hosted
from sdgen.hazards.inject import ALREADY_SET, inject
from sdgen.hazards.splits import SplitModels, small_categories
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, HomeChoice, furnished_home, homes_of, pick_home
from sdgen.pipeline.spec import node_ids
from sdgen.rejection import Cause, Rejection, most_frequent
from sdgen.seeding import lane

#: 240 tries in all: of hazards that fit once in fifty tries, one in a hundred is missed.
HOMES_TRIED = 12
TRIES = 20
#: Placements of which all are another hazard, too, say enough.
ENOUGH_PLACED = 20


@dataclass
class _Trial:
    """What became of the tries to place one hazard."""

    tries: int = 0
    placed: int = 0
    claimed: Counter[str] = field(default_factory=Counter)
    alone: int = 0
    causes: Counter[Cause] = field(default_factory=Counter)

    @property
    def open(self) -> bool:
        """True while further tries could tell something."""
        return not self.alone and self.placed < ENOUGH_PLACED


@dataclass(frozen=True)
class Misfits:
    """What a build would meet: ``problems`` that no build should start with, one line a hazard,
    and ``warnings`` of hazards that cost it some homes."""

    problems: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()


def check_buildable(catalog: Catalog, library: Library) -> None:
    """Raise InputError for what the catalogue names and no model of the library can be, hold, or
    match."""
    check_against_library(
        catalog, library.states_by_category(), parts_by_category(library), library.holding()
    )
    check_against_styles(catalog, library)


def check_against_styles(catalog: Catalog, library: Library) -> None:
    """Raise InputError for what the catalogue's styles name and the library does not have."""
    models = library.assets.values()
    check_styles(
        catalog,
        {surface.id: surface.kind for surface in library.surfaces.values()},
        {model.suite for model in models if model.suite},
        {tag for model in models for tag in model.tags},
    )


def parts_by_category(library: Library) -> dict[str, set[str]]:
    """All parts that some model of each category has."""
    out: dict[str, set[str]] = {}
    for category in library.categories:
        assets = library.by_category(category)
        out[category] = {part.name for asset in assets for part in asset.parts}
    return out


def misfits(catalog: Catalog, library: Library, options: BuildOptions) -> Misfits:
    """Hazards that found no place in any of some homes, or that are true of the homes as they
    stand; and those that always are another, too."""
    bases, mixes = homes_of(catalog, options)
    drawn = hosted(catalog, bases, bool(mixes), options.only)
    trials = {name: _Trial() for name in drawn}
    untouched = Untouched(catalog, library)
    seen: set[str] = set()
    homes = 0
    for index in range(HOMES_TRIED):
        left = {name for name, trial in trials.items() if trial.open}
        if not left and not untouched.at_risk:
            break
        home = home_to_try(index, catalog, library, options)
        if isinstance(home, Rejection):
            continue
        homes += 1
        seen.update(item.category for item in home.layout.items.values())
        # In a home that is rejected for its sake, no placement of a hazard is ever kept.
        for name in sorted(left - untouched.look(home)):
            _try(trials[name], name, index, home, library, options)
    # Without a single home, the homes are at fault; the build says how.
    if homes == 0:
        return Misfits()
    problems = untouched.problems()
    warnings = untouched.warnings()
    for name, trial in trials.items():
        if not trial.placed and name not in problems:
            problems[name] = _problem(catalog.hazard(name), trial, homes, seen, library)
        elif trial.placed and not trial.alone:
            warnings.setdefault(name, _overlap(name, trial, homes))
    left_out = [
        f"hazard {hazard.id!r} is not drawn: {bases[0].id} has nothing for it"
        for hazard in catalog.hazards
        if hazard.id in (options.only or {hazard.id}) and hazard.id not in drawn
    ]
    return Misfits(
        tuple(problems[name] for name in sorted(problems)),
        (*left_out, *warnings.values()),
    )


def home_to_try(
    index: int,
    catalog: Catalog,
    library: Library,
    options: BuildOptions,
    choice: HomeChoice | None = None,
) -> FurnishedHome | Rejection:
    """A furnished home in which hazards are tried: one for anybody, with all models. ``choice``
    says which; None: as the scene of this number would pick it."""
    rng = lane(options.seed, index, "fit")
    ids = node_ids(rng)
    spec = (choice or pick_home(catalog, options, index)).spec(catalog, rng)
    if isinstance(spec, Rejection):
        return spec
    models = SplitModels(library, "test", small_categories(catalog) if options.assets_only else ())
    return furnished_home(spec, catalog, library, models, ids, rng)


def _try(
    trial: _Trial,
    hazard: str,
    index: int,
    home: FurnishedHome,
    library: Library,
    options: BuildOptions,
) -> None:
    """Place the hazard in this home until it fits, TRIES times at most."""
    rng = lane(options.seed, index, f"fit:{hazard}")
    for _ in range(TRIES):
        layout = home.layout.copy()
        injected = inject([hazard], layout, home.context, False, rng)
        trial.tries += 1
        if isinstance(injected, Rejection):
            trial.causes[injected.cause] += 1
            continue
        trial.placed += 1
        facts = facts_of(
            home.scene(index, layout.items), library.infos, home.context.catalog, home.facts
        )
        others = [
            other.id
            for other in home.context.catalog.hazards
            if other.id != hazard
            and all(other.predicate.evaluate(m.object_id, facts).value for m in injected)
        ]
        trial.claimed.update(others)
        trial.alone += not others
        if not trial.open:
            return


def _problem(
    hazard: Hazard, trial: _Trial, homes: int, seen: Collection[str], library: Library
) -> str:
    return (
        f"hazard {hazard.id!r} fits nowhere: no place found in {trial.tries} tries in {homes} "
        f"homes; {_missing(hazard, trial, seen, library)}"
    )


def _overlap(hazard: str, trial: _Trial, homes: int) -> str:
    other, count = max(trial.claimed.items(), key=lambda pair: (pair[1], pair[0]))
    return (
        f"hazard {hazard!r} overlaps {other!r}: {count} of the {trial.placed} placements that its "
        f"recipes made in {homes} homes are that, too; each will be labelled as both"
    )


def _missing(hazard: Hazard, trial: _Trial, seen: Collection[str], library: Library) -> str:
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
    if trial.causes:
        cause = most_frequent(trial.causes)[0][0]
        if cause.check == ALREADY_SET:
            return none_left(cause)
    return (
        "its targets are there, but nothing fits: look at the sizes, rooms, zones and heights of "
        "its recipes"
    )


def _any_of(names: Collection[str]) -> str:
    some = sorted(names)
    more = f" or {len(some) - 6} more" if len(some) > 6 else ""
    return ", ".join(some[:6]) + more
