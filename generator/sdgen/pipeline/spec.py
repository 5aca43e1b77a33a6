"""What is asked of a scene, before anything is tried: it survives every retry."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass

from sdgen.catalog.records import Catalog
from sdgen.hazards.draw import draw
from sdgen.hazards.splits import Split, split_of_home
from sdgen.households import sample_household
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import HomeChoice, pick_home
from sdgen.scene import LARGEST_ID, Household
from sdgen.seeding import Rng, lane


@dataclass(frozen=True)
class SceneSpec:
    """The drawn hazards, the home and its split, and who lives there."""

    index: int
    seed: int
    hazards: tuple[str, ...]
    home: HomeChoice
    split: Split
    household: Household

    def lane(self, name: str) -> Rng:
        """A generator of this scene's own."""
        return lane(self.seed, self.index, name)


def draw_spec(index: int, catalog: Catalog, options: BuildOptions) -> SceneSpec:
    """The specification of scene ``index``: each part from a lane of its own."""
    home = pick_home(catalog, options, index)
    return SceneSpec(
        index=index,
        seed=options.seed,
        hazards=draw(
            options.seed,
            index,
            [hazard.id for hazard in catalog.hazards],
            options.hazards_min,
            options.hazards_max,
            options.draw,
        ),
        home=home,
        split=split_of_home(home.id),
        household=sample_household(catalog, lane(options.seed, index, "household")),
    )


def node_ids(rng: Rng, taken: Collection[int] = ()) -> Iterator[int]:
    """Ids not ``taken``, in a random order, so that neither id nor order says anything."""
    used = frozenset(taken)
    order = rng.permutation(LARGEST_ID)
    # Few are ever asked for: each is made an int when it is.
    return (k for k in (int(n) + 1 for n in order) if k not in used)
