"""A scene's graph with what a task must not be told left out, and as networkx has it."""

from __future__ import annotations

from typing import Literal, get_args

import networkx as nx

from sdgen.scene import Graph

GraphView = Literal["full", "neutral", "perceived"]
GRAPH_VIEWS: tuple[GraphView, ...] = get_args(GraphView)

#: Attributes of nodes that a view does not tell.
_HIDDEN: dict[GraphView, tuple[str, ...]] = {
    "neutral": ("states", "tags", "prefab_name"),
    "perceived": ("prefab_name",),
}

VIRTUALHOME_RELATIONS = ("ON", "INSIDE", "BETWEEN", "CLOSE", "FACING")


def neutral(graph: Graph) -> Graph:
    """What things are and where, with VirtualHome's five relations: no states, no tags, no names of
    models and none of our further relations, which all but name some anomalies."""
    hidden = {"states": (), "tags": (), "prefab_name": ""}
    return Graph(
        nodes=tuple(node.model_copy(update=hidden) for node in graph.nodes),
        edges=tuple(e for e in graph.edges if e.relation_type in VIRTUALHOME_RELATIONS),
    )


def to_networkx(graph: Graph, graph_view: GraphView = "full") -> nx.MultiDiGraph:
    """A graph as ``networkx.MultiDiGraph``; nodes by id, edges keyed by their relation. Nodes lack
    the attributes that their ``graph_view`` hides."""
    hidden = {"id", *_HIDDEN.get(graph_view, ())}
    out = nx.MultiDiGraph()
    for node in graph.nodes:
        out.add_node(node.id, **node.model_dump(exclude=hidden))
    for edge in graph.edges:
        name = edge.relation_type
        out.add_edge(edge.from_id, edge.to_id, key=name, relation_type=name)
    return out
