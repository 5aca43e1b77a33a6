"""A perceived home: a scene's own records, of what was seen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts
from sdgen.library.records import AssetInfo
from sdgen.scene import Graph, Scene
from sdgen.truth import build_graph


@dataclass(frozen=True)
class Perceived:
    """A perceived home: a scene of what was seen, the models of that (one an object: outlines, no
    meshes), and the catalogue that has its classes."""

    scene: Scene
    infos: Mapping[str, AssetInfo]
    catalog: Catalog

    @cached_property
    def facts(self) -> Facts:
        """What follows from it."""
        properties = {c.name: c.properties for c in self.catalog.categories}
        return Facts(self.scene, self.infos, properties, climbs=self.catalog.climbs)

    @cached_property
    def graph(self) -> Graph:
        """Its graph, built as the true one is; models have no names."""
        graph = build_graph(self.scene, self.infos, self.catalog, self.facts)
        nodes = tuple(node.model_copy(update={"prefab_name": ""}) for node in graph.nodes)
        return Graph(nodes=nodes, edges=graph.edges)
