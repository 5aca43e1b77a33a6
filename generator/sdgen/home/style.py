"""The style of a home: one set of surfaces, and models that match.

A style of the catalogue says what may be; of each of its choices a home draws one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import Style, SurfaceChoice
from sdgen.home.context import Models
from sdgen.library import Library
from sdgen.library.records import Asset
from sdgen.seeding import Rng, unit_hash
from sdgen.vocabulary import SurfaceKind

#: Walls of wet rooms are tiled so high, to the basin or as high as doors: of all of our tiles whole
#: ones (0.1, 0.15, 0.3 m). The first in so many homes.
TILED_M, LOW_SHARE = (1.2, 2.1), 0.6


class DrawnSurface(NamedTuple):
    """A surface of all floors, walls, ... in rooms of these types; of none: in all others."""

    kind: SurfaceKind
    rooms: tuple[str, ...]
    surface: str


@dataclass(frozen=True)
class HomeStyle:
    """What one home has of a style: a surface for each choice, a suite for each part; the walls of
    its wet rooms are tiled up to ``tiled_m``."""

    name: str = ""
    surfaces: tuple[DrawnSurface, ...] = ()
    suites: frozenset[str] = frozenset()
    tags: frozenset[str] = frozenset()
    tiled_m: float = TILED_M[0]

    def surface(self, kind: SurfaceKind, room_type: str) -> str | None:
        """A surface of a room; None: the style says nothing of it."""
        for drawn in self.surfaces:
            if drawn.kind == kind and (not drawn.rooms or room_type in drawn.rooms):
                return drawn.surface
        return None

    def matching(self, found: Sequence[Asset]) -> tuple[Asset, ...]:
        """Of models of one category those of the home's suites; where there are none, those with
        one of its tags; where there are none either, all."""
        of_suite = tuple(m for m in found if m.suite in self.suites)
        return of_suite or tuple(m for m in found if self.tags & set(m.tags)) or tuple(found)

    def models(self, models: Models) -> Models:
        """The models a home of this style uses, of those there are."""
        known: dict[str, tuple[Asset, ...]] = {}

        def matching(category: str) -> tuple[Asset, ...]:
            if category not in known:
                known[category] = self.matching(models(category))
            return known[category]

        return matching


def style_random(
    styles: Sequence[Style],
    library: Library,
    has_suite: Callable[[str], bool],
    rng: Rng,
    others: Sequence[Style] = (),
) -> HomeStyle:
    """The style of one home, of these by weight; no style where there are none.

    ``has_suite`` says of which suites there are models. Where a home may show none of a part's
    suites, it has one that another style names for that part, of these or of ``others``: never
    strangers side by side.
    """
    if not styles:
        return HomeStyle()
    weights = np.array([style.weight for style in styles])
    style = styles[int(rng.choice(len(styles), p=weights / weights.sum()))]
    choices: tuple[tuple[SurfaceKind, tuple[SurfaceChoice, ...]], ...] = (
        ("floor", style.floors),
        ("wall", style.walls),
        ("ceiling", style.ceilings),
        ("skirting", style.skirtings),
        ("splashback", style.splashbacks),
    )
    surfaces = []
    for kind, several in choices:
        for choice in several:
            found = [name for name in choice.of if name in library.surfaces]
            if found:
                name = found[int(rng.integers(len(found)))]
                surfaces.append(DrawnSurface(kind, choice.rooms, name))
    suites = []
    for part, names in style.suites:
        elsewhere = (dict(other.suites).get(part, ()) for other in (*styles, *others))
        found = [name for name in names if has_suite(name)]
        found = found or [name for other in elsewhere for name in other if has_suite(name)]
        if found:
            suites.append(found[int(rng.integers(len(found)))])
    # By what else was drawn: one draw more would change all that is furnished after it.
    low = unit_hash("tiles", style.name, *(d.surface for d in surfaces), *suites) < LOW_SHARE
    tags, tiled_m = frozenset(style.tags), TILED_M[0 if low else 1]
    return HomeStyle(style.name, tuple(surfaces), frozenset(suites), tags, tiled_m)
