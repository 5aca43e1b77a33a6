"""A scene's graph as networkx sees it, whole or with what a task must not be told left out."""

from __future__ import annotations

from typing import Literal

import networkx as nx

from sdgen.scene import Graph, GraphNode, Visibility

GraphView = Literal["full", "neutral", "perceived"]

VIRTUALHOME_RELATIONS = ("ON", "INSIDE", "BETWEEN", "CLOSE", "FACING")
ROOMS = "Rooms"


def to_networkx(
    graph: Graph, visibility: Visibility, graph_view: GraphView = "full"
) -> nx.MultiDiGraph:
    """A graph as ``networkx.MultiDiGraph``; nodes by id, edges keyed by their relation.

    ``full``: all that graph.json has. ``neutral``: what things are and where, with VirtualHome's
    five relations; no states, no tags and none of our further relations, which all but name some
    anomalies. ``perceived``: the nodes some view shows, and the rooms they are in.
    ValueError for another view.
    """
    if graph_view not in ("full", "neutral", "perceived"):
        raise ValueError(f"graph_view {graph_view!r}: full, neutral or perceived expected")
    out = nx.MultiDiGraph()
    kept = {node.id for node in graph.nodes}
    if graph_view == "perceived":
        seen = {item.object_id for view in visibility.views for item in view.objects}
        kept = {n.id for n in graph.nodes if n.id in seen or n.category == ROOMS}
    for node in graph.nodes:
        if node.id in kept:
            out.add_node(node.id, **_attributes(node, graph_view))
    for edge in graph.edges:
        if graph_view == "neutral" and edge.relation_type not in VIRTUALHOME_RELATIONS:
            continue
        if edge.from_id in kept and edge.to_id in kept:
            out.add_edge(
                edge.from_id, edge.to_id, key=edge.relation_type, relation_type=edge.relation_type
            )
    return out


def _attributes(node: GraphNode, graph_view: GraphView) -> dict[str, object]:
    hidden = {"id"}
    if graph_view == "neutral":
        hidden |= {"states", "tags", "prefab_name"}
    return node.model_dump(exclude=hidden)
