"""What a scene says of itself: its graph and what its views show."""

from sdgen.truth.graph import build_graph
from sdgen.truth.visibility import visibility_of

__all__ = ["build_graph", "visibility_of"]
