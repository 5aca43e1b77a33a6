"""Bullet as an adapter: settling, plausibility checks and ray tests. Scene in, values out."""

from sdgen.physics.checks import penetrations, unsupported
from sdgen.physics.client import Client
from sdgen.physics.rays import Hits, RayWorld
from sdgen.physics.settle import Settled, settle, settle_scene
from sdgen.physics.world import World, standing

__all__ = [
    "Client",
    "Hits",
    "RayWorld",
    "Settled",
    "World",
    "penetrations",
    "settle",
    "settle_scene",
    "standing",
    "unsupported",
]
