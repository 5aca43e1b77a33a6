"""What a scene says of itself: its graph and what its views show."""

from sdgen.truth.graph import build_graph
from sdgen.truth.visibility import all_visible, evidence_pixels_needed, visibility_of

__all__ = ["all_visible", "build_graph", "evidence_pixels_needed", "visibility_of"]
