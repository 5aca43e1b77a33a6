"""The records of a data set as a whole: ``dataset.json`` and ``manifest.jsonl``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Annotated, Literal

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sdgen.catalog.records import Label
from sdgen.options import MAX_SCENES, MAX_SEED, MAX_VIEWS, BuildOptions
from sdgen.scene import (
    FORMAT_VERSION,
    CauseCount,
    Notify,
    Record,
    anomaly_id,
    toggle_id,
    twin_id,
)

LICENCE = "CC-BY-4.0"

#: Files at the top of a finished data set, ``dataset.json`` written last.
TOP_FILES = ("catalogue.json", "assets.jsonl", "README.md", "manifest.jsonl", "dataset.json")

#: Files of every scene folder that decide its ``content_sha256``, in this order.
CONTENT_FILES = ("scene.json", "graph.json", "anomalies.json", "household.json", "physics.json")
VISIBILITY_FILE = "visibility.json"
#: Of scenes that were built with it.
OBSERVABILITY_FILE = "observability.json"
#: What homes are split into, in the order that pages have them.
SPLITS = ("train", "val", "test")

#: A scene's index, as its id and its folder have it: below ``MAX_SCENES``.
_INDEX = "[0-9]{6}"
SCENE_ID = rf"^{_INDEX}(-twin|-undo-a[0-9]{{2,4}})?$"
SHA256 = r"^[0-9a-f]{64}$"


def _with_sdgen(versions: dict[str, str]) -> dict[str, str]:
    if "sdgen" not in versions:
        raise PydanticCustomError("problem", "{text}", {"text": "does not name 'sdgen'"})
    return versions


#: Versions of what decides bytes, by package; of sdgen itself at least.
Versions = Annotated[
    dict[str, str],
    AfterValidator(_with_sdgen),
    Field(json_schema_extra={"required": ["sdgen"]}),
]
#: A scene, its benign twin, or the scene with one of its anomalies undone.
Kind = Literal["scene", "twin", "toggle"]
#: The id of a scene that is no twin.
FirstId = Annotated[str, Field(pattern=rf"^{_INDEX}$")]


class ManifestEntry(Record):
    """One line of ``manifest.jsonl``: what a scene holds and the digest of each of its files."""

    id: str = Field(pattern=SCENE_ID)
    index: int = Field(ge=0, lt=MAX_SCENES)
    twin_of: str | None = None
    home: str
    split: str
    anomalies: int = Field(ge=0)
    hazards: dict[str, int] = Field(default_factory=dict)
    lookalikes: int = Field(ge=0)
    objects: int = Field(ge=0)
    views: int = Field(ge=0, le=MAX_VIEWS)
    all_visible: bool
    content_sha256: str = Field(pattern=SHA256)
    files: dict[str, str]

    @property
    def kind(self) -> Kind:
        """What a scene is: one of the ``n``, its benign twin, or one with one anomaly undone."""
        if self.twin_of is None:
            return "scene"
        return "twin" if self.id == twin_id(self.twin_of) else "toggle"

    def twins_promised(self, options: BuildOptions) -> frozenset[str]:
        """Ids of all that a build with these options writes beside a scene."""
        ids = {twin_id(self.id)} if options.twins else set()
        if options.toggles:
            ids |= {toggle_id(self.id, anomaly_id(k)) for k in range(self.anomalies)}
        return frozenset(ids)


class Vocabularies(Record):
    """The words the files use, sorted."""

    hazards: tuple[str, ...]
    groups: tuple[str, ...]
    labels: tuple[str, ...]
    notify: tuple[str, ...]
    categories: tuple[str, ...]
    superclasses: tuple[str, ...]
    properties: tuple[str, ...]
    states: tuple[str, ...]
    relations: tuple[str, ...]
    tags: tuple[str, ...]
    room_types: tuple[str, ...]


class Counts(Record):
    """Totals over all scenes (twins and toggles apart)."""

    scenes: int
    twins: int
    toggles: int = 0
    views: int
    objects: int
    anomalies: int
    lookalikes: int
    anomalies_by_hazard: dict[str, int]
    scenes_by_anomalies: dict[str, int]
    scenes_by_split: dict[str, int]
    scenes_by_home: dict[str, int]
    scenes_not_all_visible: int


class Build(Record):
    """What decides a data set's bytes; the same for all of its scenes."""

    format_version: str = FORMAT_VERSION
    versions: Versions
    options: BuildOptions
    catalogue_sha256: str = Field(pattern=SHA256)
    assets_sha256: str = Field(pattern=SHA256)
    hazards_enabled: tuple[str, ...]


class DatasetInfo(Record):
    """``dataset.json``.

    ``versions`` names what decides bytes (sdgen, pybullet, numpy, deflate …, the architecture),
    ``renderers`` whatever drew the pictures, ``failed`` the scenes that could not be made, with
    the causes counted.
    """

    format_version: str
    versions: Versions
    renderers: tuple[str, ...]
    seed: int = Field(ge=0, le=MAX_SEED)
    n: int = Field(ge=0, le=MAX_SCENES)
    options: BuildOptions
    catalogue_sha256: str = Field(pattern=SHA256)
    assets_sha256: str = Field(pattern=SHA256)
    hazards_enabled: tuple[str, ...]
    vocabularies: Vocabularies
    splits: dict[str, tuple[str, ...]]
    counts: Counts
    failed: dict[FirstId, tuple[CauseCount, ...]] = Field(
        default_factory=dict, json_schema_extra={"additionalProperties": False}
    )
    licence: str = LICENCE

    def build(self) -> Build:
        """What decided the bytes of this data set."""
        return Build(
            format_version=self.format_version,
            versions=self.versions,
            options=self.options,
            catalogue_sha256=self.catalogue_sha256,
            assets_sha256=self.assets_sha256,
            hazards_enabled=self.hazards_enabled,
        )


class Report(Record):
    """One detected object of a prediction; ``silent`` = noticed, but not reported. ``score``: how
    sure the detector is, 0 to 1; None where it does not say."""

    object_id: int
    label: Label
    notify: Notify = "now"
    score: float | None = Field(default=None, ge=0.0, le=1.0)


class Prediction(Record):
    """One line of ``predictions.jsonl``: what was detected in a scene."""

    scene: str
    reports: tuple[Report, ...]


#: Reports by scene id.
Predictions = Mapping[str, tuple[Report, ...]]


def count(entries: tuple[ManifestEntry, ...]) -> Counts:
    """Totals of these scenes."""
    scenes = [entry for entry in entries if entry.twin_of is None]

    def tally(values: Iterable[str]) -> dict[str, int]:
        return dict(sorted(Counter(values).items()))

    hazards: Counter[str] = Counter()
    for entry in scenes:
        hazards.update(entry.hazards)
    return Counts(
        scenes=len(scenes),
        twins=sum(entry.kind == "twin" for entry in entries),
        toggles=sum(entry.kind == "toggle" for entry in entries),
        views=sum(entry.views for entry in scenes),
        objects=sum(entry.objects for entry in scenes),
        anomalies=sum(entry.anomalies for entry in scenes),
        lookalikes=sum(entry.lookalikes for entry in scenes),
        anomalies_by_hazard=dict(sorted(hazards.items())),
        scenes_by_anomalies=tally(str(entry.anomalies) for entry in scenes),
        scenes_by_split=tally(entry.split for entry in scenes),
        scenes_by_home=tally(entry.home for entry in scenes),
        scenes_not_all_visible=sum(not entry.all_visible for entry in scenes),
    )
