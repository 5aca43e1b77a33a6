"""Tries every unique anomaly of a catalogue in furnished homes: does it fit, and if not, why?

Jobs are handfuls of anomalies. Each goes from home to home until it fits; a worker furnishes a
home once. What becomes of an anomaly follows from the catalogue, the models, the seed and itself,
whichever others are tried.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

from PIL import Image

from sdgen.catalog.records import Catalog, UniqueAnomaly
from sdgen.closing import Closing
from sdgen.engines.early_stop import hint
from sdgen.engines.fit import home_to_try
from sdgen.engines.in_order import in_order
from sdgen.engines.trial_picture import trial_picture
from sdgen.households import draw_template, sample_household
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline.furnished import FurnishedHome, HomeChoice, homes_of
from sdgen.pipeline.scene import PLACEMENT_ATTEMPTS
from sdgen.pipeline.trial import Fits, TrialHome
from sdgen.rejection import Cause, Rejection, most_frequent
from sdgen.render import Choice, open_renderer
from sdgen.scene import Household
from sdgen.seeding import lane

#: Homes that are looked at for an anomaly: rooms that few homes have are in some of so many.
MOST_HOMES = 40
#: And that it is tried in, all tries of each: as many as a build tries a scene in.
HOMES_TRIED = 8
#: Anomalies of one job: loading a home into Bullet is shared by so many.
HANDFUL = 24


@dataclass(frozen=True)
class Tried:
    """What became of one unique anomaly.

    ``home`` is the name of the home in which it fits, None where it does not; ``homes`` how many
    it was tried in, ``tries`` how often, and ``causes`` why tries failed. ``message`` is what a
    household is told of it, ``picture`` the name of its picture's file.
    """

    unique: UniqueAnomaly
    home: str | None = None
    homes: int = 0
    tries: int = 0
    causes: Counter[Cause] = field(default_factory=Counter)
    message: str | None = None
    picture: str | None = None

    @property
    def fits(self) -> bool:
        """True when it could be made."""
        return self.home is not None


def in_words(unique: UniqueAnomaly) -> str:
    """``spill: SPILLED milk_puddle ON floor (kitchen)``."""
    parts = (unique.state, unique.category, unique.relation, unique.target)
    words = " ".join(part for part in parts if part is not None)
    room = "" if unique.room is None else f" ({unique.room})"
    return f"{unique.hazard}: {words}{room}"


def why_not(tried: Tried, library: Library) -> str:
    """Why an anomaly fitted nowhere, in words: most frequent rejections first, and what to do."""
    unique = tried.unique
    if not tried.tries:
        for name in (unique.category, unique.target):
            if name not in (None, "floor", *library.categories):
                return f"there is no model of {name}"
        return f"none of {MOST_HOMES} homes has anything for it: look at its targets and rooms"
    causes = ", ".join(f"{c.what()} x{n}" for c, n in most_frequent(tried.causes)[:3])
    first = most_frequent(tried.causes)[0][0]
    return f"{tried.tries} tries in {tried.homes} homes: {causes}; {hint(first)}"


@dataclass(frozen=True)
class Trials:
    """What to try, and how: ``attempts`` in each home; with a ``choice`` of renderer a picture of
    each goes into the folder ``pictures``."""

    catalog: Catalog
    library_folders: tuple[Path, ...]
    library_sha256: str
    unique: tuple[UniqueAnomaly, ...]
    seed: int = 0
    attempts: int = PLACEMENT_ATTEMPTS
    choice: Choice | None = None
    pictures: Path | None = None

    @property
    def jobs(self) -> int:
        """Handfuls of anomalies."""
        return -(-len(self.unique) // HANDFUL)


def try_all(
    trials: Trials, workers: int, on_progress: Callable[[int, int], None] | None = None
) -> list[Tried]:
    """What became of each anomaly, in their order. Raises SdgenError when workers keep dying."""
    found: list[Tried] = []
    with closing(in_order(_Worker, (trials,), trials.jobs, workers)) as outcomes:
        for outcome in outcomes:
            if outcome.error is not None:
                raise outcome.error
            found += outcome.result
            if on_progress is not None:
                on_progress(len(found), len(trials.unique))
    return found


def home_in_turn(catalog: Catalog, seed: int, index: int) -> HomeChoice:
    """The home of this number: generated ones of each mix in turn, a base home after each, until
    all of these have come: every type of room occurs."""
    bases, mixes = homes_of(catalog, BuildOptions(homes="mixed" if catalog.homes else "procedural"))
    pairs = len(bases)
    if index < 2 * pairs and index % 2:
        base = bases[index // 2]
        return HomeChoice(base.id, base)
    turn = index // 2 if index < 2 * pairs else index - pairs
    return HomeChoice(f"procedural_{seed}_{index:06d}", None, (mixes[turn % len(mixes)],))


@dataclass(frozen=True)
class _Home:
    name: str
    furnished: FurnishedHome
    household: Household


@dataclass
class _State:
    """An anomaly that is being tried."""

    unique: UniqueAnomaly
    number: int
    homes: int = 0
    tries: int = 0
    causes: Counter[Cause] = field(default_factory=Counter)
    done: Tried | None = None


class _Worker(Closing):
    """Does handfuls, one after another."""

    def __init__(self, trials: Trials) -> None:
        if trials.jobs > 1:
            # As many workers as cores: more threads in Mesa would only get in each other's way.
            os.environ.setdefault("LP_NUM_THREADS", "1")
        self._trials = trials
        self._library = Library(trials.library_folders, trials.library_sha256)
        self._clients = (Client(), Client())
        self._renderer = open_renderer(trials.choice) if trials.choice is not None else None
        self._homes: dict[int, _Home | None] = {}

    def close(self) -> None:
        """Let go of simulators and renderer."""
        for client in self._clients:
            client.close()
        if self._renderer is not None:
            self._renderer.close()

    def __call__(self, job: int) -> list[Tried]:
        first = job * HANDFUL
        some = self._trials.unique[first : first + HANDFUL]
        states = [_State(unique, first + k) for k, unique in enumerate(some)]
        for index in range(MOST_HOMES):
            left = [one for one in states if one.done is None and one.homes < HOMES_TRIED]
            home = self._home(index) if left else None
            if home is not None:
                trial = TrialHome(home.furnished, home.household, self._library, self._clients)
                for one in left:
                    self._try(one, index, home.name, trial)
        return [
            one.done or Tried(one.unique, None, one.homes, one.tries, one.causes) for one in states
        ]

    def _home(self, index: int) -> _Home | None:
        """The home of this number, furnished; None where it does not come out."""
        if index not in self._homes:
            self._homes[index] = self._furnish(index)
        return self._homes[index]

    def _furnish(self, index: int) -> _Home | None:
        catalog, seed = self._trials.catalog, self._trials.seed
        choice = home_in_turn(catalog, seed, index)
        home = home_to_try(index, catalog, self._library, BuildOptions(seed=seed), choice)
        if isinstance(home, Rejection):
            return None
        rng = lane(seed, index, "trial:household")
        household = sample_household(catalog, draw_template(catalog, rng), rng)
        return _Home(home.context.home.id, home, household)

    def _try(self, one: _State, index: int, name: str, trial: TrialHome) -> None:
        words = "|".join(word or "" for word in one.unique.model_dump().values())
        rng = lane(self._trials.seed, index, f"trial:{words}")
        for attempt in range(self._trials.attempts):
            found = trial.attempt(one.unique, rng)
            if found is None:
                return
            one.homes += attempt == 0
            one.tries += 1
            if isinstance(found, Rejection):
                one.causes[found.cause] += 1
                continue
            picture = self._picture(one, found)
            one.done = Tried(
                one.unique, name, one.homes, one.tries, one.causes, found.anomaly.message, picture
            )
            return

    def _picture(self, one: _State, found: Fits) -> str | None:
        folder = self._trials.pictures
        if self._renderer is None or folder is None:
            return None
        name = f"{one.number:05d}.jpg"
        rgb = trial_picture(found, self._library, self._renderer)
        Image.fromarray(rgb).save(folder / name, quality=85)
        return name
