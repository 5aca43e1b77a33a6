"""What is asked of a scene, before anything is tried: it survives every retry."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import partial

from sdgen.catalog.records import Catalog, HomeMix, HomeSpec
from sdgen.hazards.draw import draw
from sdgen.hazards.hosting import hosted
from sdgen.hazards.splits import Split, split_of_home
from sdgen.home.tenants import Homes, Tenants, words_of
from sdgen.households import draw_template, sample_household, wished_traits
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import HomeChoice, homes_of, pick_home
from sdgen.scene import LARGEST_ID, Household
from sdgen.seeding import Rng, lane


@dataclass(frozen=True)
class SceneSpec:
    """The drawn hazards, the home and its split, and who lives there (``tenants``: what that
    means for what is in the home). Near misses are of hazards of ``only``, of any where it is
    empty."""

    index: int
    seed: int
    hazards: tuple[str, ...]
    home: HomeChoice
    split: Split
    household: Household
    tenants: Tenants
    assets_only: bool = False
    only: tuple[str, ...] = ()

    def lane(self, name: str) -> Rng:
        """A generator of this scene's own."""
        return lane(self.seed, self.index, name)


def draw_spec(index: int, catalog: Catalog, options: BuildOptions, home_turn: int = 0) -> SceneSpec:
    """The specification of scene ``index``: each part from a lane of its own. ``home_turn`` counts
    the homes that were given up since something that is asked for fits nowhere in them.

    Hazards come first and know of nothing else, but for what an only home has nothing for; then
    the kind of household, by its weight; then a home that it can live in.
    """
    bases, mixes = homes_of(catalog, options)
    hazards = draw(
        options.seed,
        index,
        hosted(catalog, bases, bool(mixes), options.only),
        options.hazards_min,
        options.hazards_max,
        options.draw,
    )
    homes = Homes(catalog)
    among: list[HomeSpec | HomeMix] = [*bases, *mixes]
    asked = tuple(catalog.hazard(name) for name in hazards)
    wished = wished_traits(asked, catalog.categories, lane(options.seed, index, "wished"))
    able = [one for one in catalog.households if any(homes.fits(one, home) for home in among)]
    having = [one for one in able if not set(wished).isdisjoint(one.traits)]
    template = draw_template(
        catalog, lane(options.seed, index, "template"), lambda one: one in (having or able)
    )
    household = sample_household(catalog, template, lane(options.seed, index, "household"), wished)
    home = pick_home(catalog, options, index, partial(homes.fits, template), home_turn)
    return SceneSpec(
        index=index,
        seed=options.seed,
        hazards=hazards,
        home=home,
        split=split_of_home(home.id),
        household=household,
        tenants=Tenants(
            words_of(household, catalog.groups, lane(options.seed, index, "visitors")),
            template.sleepers,
            asked,
            float(lane(options.seed, index, "tidiness").uniform(*template.tidiness)),
        ),
        assets_only=options.assets_only,
        only=options.only,
    )


def node_ids(rng: Rng, taken: Collection[int] = ()) -> Iterator[int]:
    """Ids not ``taken``, in a random order, so that neither id nor order says anything."""
    used = frozenset(taken)
    order = rng.permutation(LARGEST_ID)
    # Few are ever asked for: each is made an int when it is.
    return (k for k in (int(n) + 1 for n in order) if k not in used)
