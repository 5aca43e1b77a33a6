"""Light in a home, found by rays: sun and sky through windows, lamps, and what walls give on."""

from importlib.util import find_spec

#: Whether there is embree to trace rays with: it has no wheels for some machines.
HAS_RAYS = find_spec("embreex") is not None

__all__ = ["HAS_RAYS"]
