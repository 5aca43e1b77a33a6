"""A home to explore, and what is true of it: of a data set, or made afresh."""

from __future__ import annotations

from dataclasses import dataclass

from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.errors import InputError
from sdgen.geometry import Vec2
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.scene import Anomaly, Household, Scene
from sdgen.truth.observable import Observability
from sdgen.validate.at_hand import other_models
from sdgen.validate.problems import Problem


@dataclass(frozen=True)
class Stage:
    """A scene, who lives there, its anomalies, the catalogue they are of, and certificates of from
    where they can be seen (None: nobody has looked)."""

    scene: Scene
    household: Household
    anomalies: tuple[Anomaly, ...]
    catalog: Catalog
    certificates: Observability | None = None

    @property
    def id(self) -> str:
        """The scene's id."""
        return self.scene.id

    @property
    def places(self) -> dict[str, Vec2]:
        """Where the object of each anomaly is on the plan, by the anomaly's id."""
        at = {one.id: self.scene.object(one.object_id).pose.position_m for one in self.anomalies}
        return {key: (x, y) for key, (x, y, _) in at.items()}


def stage_of(data: Dataset, item: SceneItem) -> Stage:
    """A scene of a data set. Raises InputError where its files disagree."""
    with derived_from(data, item):
        anomalies = item.anomalies.anomalies
        return Stage(item.scene, item.household, anomalies, data.catalog, item.observability)


def fresh_stage(
    index: int, catalog: Catalog, library: Library, options: BuildOptions | None = None
) -> Stage:
    """A scene that is made now: number ``index`` of what ``sdgen build`` with these options would
    write. Raises SceneRejected where it cannot be made."""
    bundle = make_scene(index, catalog, library, options or BuildOptions(views=0))
    return Stage(bundle.scene, bundle.household, bundle.anomalies.anomalies, catalog)


def check_models(data: Dataset, library: Library) -> None:
    """InputError where the models at hand are not those that a data set was built with."""
    found: list[Problem] = list(other_models(data, library, "file"))
    if found:
        hint = "its scenes cannot be entered with others"
        raise InputError([f"{data.path}: {found[0].text}; {hint}"])
