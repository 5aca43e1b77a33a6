"""One home by itself: furnished, with everyday things and no hazard, to be looked at or exported.

It is the first scene of a build that asks for no hazard; nothing is drawn in any other way.
"""

from __future__ import annotations

from dataclasses import dataclass

from sdgen.catalog.records import Catalog, HomeSpec
from sdgen.errors import SdgenError, UsageError, did_you_mean
from sdgen.library import Library
from sdgen.options import MAX_SEED, BuildOptions
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.scene import furnish_for, make_scene
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Rejection
from sdgen.scene import SceneBundle


@dataclass(frozen=True)
class OneHome:
    """A home as it is specified, as it is furnished, and the whole of it with all its things."""

    spec: HomeSpec
    furnished: FurnishedHome
    bundle: SceneBundle


def one_home(
    which: str, catalog: Catalog, library: Library, options: BuildOptions | None = None
) -> OneHome:
    """The generated home of a seed (digits), or a base home by name as the seed of ``options``
    furnishes it.

    ``sdgen build --hazards 0`` makes the same one of the seed and ``--homes procedural``, or of a
    catalogue with this base home alone, as scene 0. Raises UsageError for an unknown name,
    SceneRejected when no try succeeds.
    """
    options = (options or BuildOptions()).model_copy(update={"hazards_min": 0, "hazards_max": 0})
    if which.isdecimal():
        if int(which) > MAX_SEED:
            raise UsageError(f"seed {which} is above {MAX_SEED}")
        options = options.model_copy(update={"homes": "procedural", "seed": int(which)})
    else:
        home = base_home(which, catalog)
        catalog = catalog.model_copy(update={"homes": (home,)})
        options = options.model_copy(update={"homes": "base"})
    bundle = make_scene(0, catalog, library, options)
    spec = draw_spec(0, catalog, options)
    attempt = bundle.physics.home_attempts - 1
    home_spec = spec.home.spec(catalog, spec.lane(f"plan:{attempt}"))
    furnished = furnish_for(spec, attempt, catalog, library)
    if isinstance(home_spec, Rejection) or isinstance(furnished, Rejection):
        raise SdgenError(f"home {which}: made again, it is another home (a bug in sdgen)")
    return OneHome(home_spec, furnished, bundle)


def base_home(name: str, catalog: Catalog) -> HomeSpec:
    """The base home of this name. Raises UsageError when there is none."""
    for home in catalog.homes:
        if home.id == name:
            return home
    known = [home.id for home in catalog.homes]
    raise UsageError(f"no base home {name!r}{did_you_mean(name, known)}; a seed is a whole number")
