"""What a scene says of itself: its graph and what its views show."""

from sdgen.truth.graph import build_graph, graph_nodes
from sdgen.truth.visibility import visibility_of

__all__ = ["build_graph", "graph_nodes", "visibility_of"]
