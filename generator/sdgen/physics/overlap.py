"""How deep two groups of convex pieces reach into one another."""

from __future__ import annotations

from collections.abc import Sequence

from sdgen.geometry import Array
from sdgen.physics.client import Client, convex_obj


def deepest_overlap_m(client: Client, still: Sequence[Array], moving: Sequence[Array]) -> float:
    """Depth in metres of the deepest contact between pieces (N, 3) of the groups; 0 when apart.

    Empties the client's world.
    """
    client.reset()
    bodies = [
        client.body(client.convex(convex_obj(list(pieces))), (0.0, 0.0, 0.0))
        for pieces in (still, moving)
    ]
    points = client.closest(bodies[0], bodies[1], 0.0)
    return max((-point.distance_m for point in points), default=0.0)
