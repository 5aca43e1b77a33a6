"""Opens a data set: scenes, filters, flat tables, views as arrays. Files may come from anybody."""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdgen.catalog.records import Catalog
from sdgen.dataset.eyes import Eyes
from sdgen.dataset.filters import having_hazard, having_household, having_room, having_twin
from sdgen.dataset.frames import Frames
from sdgen.dataset.item import SceneItem
from sdgen.dataset.knowledge import Knowledge
from sdgen.dataset.notebook import page
from sdgen.dataset.opening import open_info, read_manifest, refuse_incomplete
from sdgen.dataset.records import Kind, ManifestEntry
from sdgen.dataset.tables import (
    ANOMALY_COLUMNS,
    OBJECT_COLUMNS,
    VIEW_COLUMNS,
    Table,
    anomaly_rows,
    object_rows,
    view_rows,
)
from sdgen.errors import InputError, did_you_mean
from sdgen.library.records import AssetInfo
from sdgen.perception import Perception

if TYPE_CHECKING:
    import networkx as nx

    from sdgen.dataset.graph_views import GraphView

#: Scenes that a data set shows in a notebook.
_SHOWN = 6


class Dataset(Sequence[SceneItem]):
    """A data set as a sequence of scenes, in the order of their index (twins left out).

    ``filter`` keeps some of them, ``frames`` gives their views as arrays; ``anomalies``,
    ``objects`` and ``views`` are flat tables, ``shown`` the scenes' lines of the manifest.

    ``split`` keeps one of ``train``, ``val``, ``test``; ``twins`` gives each scene's benign twin
    instead, ``toggles`` those in which one anomaly is undone (with both: all of these);
    ``graph_view`` says what the scenes' ``.graph`` shows, ``perception`` how well a ``perceived``
    one is made out. Picklable. Raises InputError for a
    folder that is no data set, or one that lacks scenes it was finished with, and on reading
    what changed since it was written. ``partial`` opens what is left of it, and takes its files
    for what they are.
    """

    def __init__(
        self,
        path: str | Path,
        split: str | None = None,
        twins: bool = False,
        graph_view: GraphView = "full",
        partial: bool = False,
        toggles: bool = False,
        perception: Perception | None = None,
    ) -> None:
        self.path = Path(path)
        self.split = split
        self.twins = twins
        self.toggles = toggles
        self.graph_view = graph_view
        self.partial = partial
        self.info = open_info(self.path)
        expected = None if partial else self.info.catalogue_sha256
        self._knowledge = Knowledge(self.path, self.info.format_version, expected)
        self.perception = perception or Perception()
        self._eyes = Eyes(self._knowledge, self.perception)
        if split is not None:
            self._refuse_split(split)
        self.entries = read_manifest(self.path)
        if not partial:
            refuse_incomplete(self.path, self.info, self.entries)
        self.shown = tuple(
            entry
            for entry in self.entries
            if entry.kind in self._kinds and split in (None, entry.split)
        )

    def _refuse_split(self, split: str) -> None:
        if split not in self.info.splits:
            known = list(self.info.splits)
            raise InputError([f"{self.path}: no split {split!r}{did_you_mean(split, known)}"])

    def __repr__(self) -> str:
        shown = len(self)
        wrong = sum(entry.anomalies for entry in self.shown)
        part = f" of {self.split}" if self.split is not None else ""
        noun = " and ".join(kind + "s" * (shown != 1) for kind in self._kinds)
        options = self.info.options
        views = f"{options.views} views" if options.views_mode == "chosen" else "turns of views"
        views = views if options.sensors else "no pictures"
        return (
            f"<sdgen.Dataset {str(self.path)!r}: {shown} {noun}{part}, {views}, "
            f"{wrong} anomalies of {len(self.info.hazards_enabled)} hazards, "
            f"seed {self.info.seed}>"
        )

    @property
    def _kinds(self) -> tuple[Kind, ...]:
        asked: tuple[tuple[Kind, bool], ...] = (("twin", self.twins), ("toggle", self.toggles))
        return tuple(kind for kind, wanted in asked if wanted) or ("scene",)

    def __len__(self) -> int:
        return len(self.shown)

    def __getitem__(self, index: int) -> SceneItem:  # type: ignore[override]
        return self._item(self.shown[operator.index(index)])

    def __iter__(self) -> Iterator[SceneItem]:
        return map(self._item, self.shown)

    def _item(self, entry: ManifestEntry) -> SceneItem:
        twin = self._twins.get(entry.id)
        checked = not self.partial
        return SceneItem(self.path, entry, self.graph_view, twin, checked, self._eyes)

    def filter(
        self,
        hazard: str | None = None,
        split: str | None = None,
        room: str | None = None,
        household: str | None = None,
        twin: bool | None = None,
    ) -> Dataset:
        """The scenes that are all that is asked for, as a data set of its own.

        ``hazard``: with an anomaly of it (of twins: whose scene has one). ``split``: of it.
        ``room``: with a room of this type; with ``hazard`` too, with such an anomaly there.
        ``household``: of this kind. ``twin``: with a benign twin, or without one. Pixels are never
        read. Raises InputError for a word the data set does not have, and for bad files.
        """
        out = copy(self)
        shown: Iterable[ManifestEntry] = self.shown
        if split is not None:
            self._refuse_split(split)
            shown = [entry for entry in shown if entry.split == split]
            out.split = split
        if twin is not None:
            shown = list(having_twin(tuple(shown), twin, self._twins))
        if hazard is not None:
            shown = list(having_hazard(tuple(shown), hazard, self.info, self._by_id))
        if household is not None:
            shown = list(having_household(tuple(shown), household, self._item))
        if room is not None:
            shown = list(having_room(tuple(shown), room, hazard, self.info, self._item))
        out.shown = tuple(shown)
        return out

    def frames(
        self,
        pixels: Collection[str] = ("rgb", "instance"),
        transform: Callable[[dict[str, Any]], Any] | None = None,
    ) -> Frames:
        """The scenes' views as a map-style data set of arrays; see :class:`Frames`."""
        views = [entry.views for entry in self.shown]
        return Frames(self, views, self.info.options.sensors, pixels, transform)

    @property
    def anomalies(self) -> Table:
        """A flat table with a row an anomaly; see :mod:`sdgen.dataset.tables`."""
        return Table(ANOMALY_COLUMNS, self, anomaly_rows)

    @property
    def objects(self) -> Table:
        """A flat table with a row an object."""
        return Table(OBJECT_COLUMNS, self, object_rows)

    @property
    def views(self) -> Table:
        """A flat table with a row a view."""
        return Table(VIEW_COLUMNS, self, view_rows)

    def _repr_html_(self) -> str:
        figures = []
        for item in islice(self, _SHOWN):
            words = ", ".join(item.entry.hazards) or "no hazard"
            figures.append(item.figure(item.best_view(), f"{item.id}: {words}"))
        rest = [f"and {len(self) - _SHOWN} more"] if len(self) > _SHOWN else []
        return page(repr(self), rest, figures)

    def scene(self, scene_id: str) -> SceneItem:
        """The scene of this id, twins too. Raises InputError when there is none."""
        if scene_id in self._by_id:
            return self._item(self._by_id[scene_id])
        hint = did_you_mean(scene_id, list(self._by_id))
        raise InputError([f"{self.path}: no scene {scene_id!r}{hint}"])

    @cached_property
    def _twins(self) -> Mapping[str, ManifestEntry]:
        """The benign twin of each scene that has one."""
        return {e.twin_of: e for e in self.entries if e.kind == "twin" and e.twin_of is not None}

    @cached_property
    def _by_id(self) -> Mapping[str, ManifestEntry]:
        return {entry.id: entry for entry in self.entries}

    def graph(self, index: int, graph_view: GraphView = "full") -> nx.MultiDiGraph:
        """The graph of a scene as ``networkx.MultiDiGraph``; see ``graph_views``."""
        return replace(self[index], graph_view=graph_view).graph

    @property
    def catalog(self) -> Catalog:
        """The catalogue the build used. Raises InputError for another one: labels would not follow
        from it."""
        return self._knowledge.catalog

    @property
    def catalogue_sha256(self) -> str:
        """Digest of ``catalogue.json`` as it was written: one of an older version lacks keys that
        its record has by now. Raises InputError."""
        return self._knowledge.catalogue_sha256

    @property
    def infos(self) -> Mapping[str, AssetInfo]:
        """Records of the models the scenes use, by id."""
        return self._knowledge.infos
