"""One scene, the whole way: home, hazards, physics, proof, views."""

from sdgen.pipeline.scene import make_scene

__all__ = ["make_scene"]
