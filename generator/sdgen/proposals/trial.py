"""Placements tried as a build tries them: put into furnished homes, at rest, proved."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from sdgen.catalog.records import Catalog, Hazard
from sdgen.home.things import NO_THINGS
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline.attempt import attempt
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import SceneSpec, draw_spec
from sdgen.proposals.check import Idea, Refused
from sdgen.rejection import Cause, Rejection, most_frequent

#: Homes that a placement is tried in, and tries in each. One that fits in a home in four is missed
#: in one of thirty.
HOMES_TRIED = 12
TRIES = 3


@dataclass
class _Trial:
    """What became of one idea: the try that was proved, or why none was."""

    idea: Idea
    also: tuple[str, ...] | None = None
    tries: int = 0
    causes: Counter[Cause] = field(default_factory=Counter)


def tried(
    ideas: Sequence[Idea], hazard: Hazard, catalog: Catalog, library: Library, seed: int = 0
) -> Iterator[Idea | Refused]:
    """Each idea, in order: as it is (``also``: every other hazard that it turned out to be), or
    refused as ``unfit``. The same each time."""
    trials = [_Trial(idea) for idea in ideas]
    options = BuildOptions(seed=seed, hazards_min=1, hazards_max=1)
    only = catalog.model_copy(update={"hazards": (hazard,)})
    homes = 0
    with Client() as client:
        for index in range(HOMES_TRIED):
            left = [trial for trial in trials if trial.also is None]
            if not left:
                break
            # Nothing is withheld, and nobody lives there for whom it would be no hazard.
            spec = replace(draw_spec(index, only, options), split="test")
            home = furnish_for(spec, 0, catalog, library)
            if isinstance(home, Rejection):
                continue
            homes += 1
            for trial in left:
                _try(trial, spec, home, hazard, library, client)
    for trial in trials:
        yield _outcome(trial, homes)


def _try(
    trial: _Trial,
    spec: SceneSpec,
    home: FurnishedHome,
    hazard: Hazard,
    library: Library,
    client: Client,
) -> None:
    context = home.context
    alone = hazard.model_copy(update={"anomalies": (trial.idea.recipe,)})
    hazards = tuple(alone if h.id == hazard.id else h for h in context.catalog.hazards)
    catalog = context.catalog.model_copy(update={"hazards": hazards})
    # As it is drawn, without the things that it draws: nothing else is strewn about, which would
    # take time and could be in the way, or be labelled.
    context = replace(context, catalog=catalog)
    home = replace(home, context=context, things=NO_THINGS, as_drawn=True)
    for placement in range(TRIES):
        proved = attempt(spec, home, 0, placement, library, client)
        trial.tries += 1
        if not isinstance(proved, Rejection):
            (object_id,) = {key for key, _ in proved.drawn}
            also = {p.hazard for p in proved.surveyed.positives if p.object_id == object_id}
            trial.also = tuple(sorted(also - {hazard.id}))
            return
        trial.causes[proved.cause] += 1
        if proved.cause.check == "no_place":
            return  # the home has nothing for it, or no room there


def _outcome(trial: _Trial, homes: int) -> Idea | Refused:
    if trial.also is not None:
        return replace(trial.idea, also=trial.also)
    why = most_frequent(trial.causes)[0][0].what() if trial.causes else "no home could be furnished"
    text = f"no place in {trial.tries} tries in {homes} homes ({why})"
    return Refused(trial.idea.line, trial.idea.what, "unfit", text)
