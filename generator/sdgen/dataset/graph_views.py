"""A scene's graph with what a task must not be told left out, and as networkx has it."""

from __future__ import annotations

from typing import Literal, get_args

import networkx as nx

from sdgen.scene import Graph

GraphView = Literal["full", "neutral", "perceived"]
GRAPH_VIEWS: tuple[GraphView, ...] = get_args(GraphView)

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
    """A graph as ``networkx.MultiDiGraph``; nodes by id, edges keyed by their relation. Of a
    ``neutral`` one nodes lack the attributes that it hides."""
    hidden = {"id"}
    if graph_view == "neutral":
        hidden |= {"states", "tags", "prefab_name"}
    out = nx.MultiDiGraph()
    for node in graph.nodes:
        out.add_node(node.id, **node.model_dump(exclude=hidden))
    for edge in graph.edges:
        name = edge.relation_type
        out.add_edge(edge.from_id, edge.to_id, key=name, relation_type=name)
    return out


def seen_in_views(graph: Graph, seen: set[int]) -> Graph:
    """The nodes with these ids and the rooms, and what relates them."""
    kept = seen | {node.id for node in graph.nodes if node.category == "Rooms"}
    return Graph(
        nodes=tuple(node for node in graph.nodes if node.id in kept),
        edges=tuple(e for e in graph.edges if e.from_id in kept and e.to_id in kept),
    )
