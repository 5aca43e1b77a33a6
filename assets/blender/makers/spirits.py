"""The look of spirit in clear glass."""

from __future__ import annotations

from toolkit.materials import Material, shade


def amber(drink: str, height: float) -> Material:
    """Clear glass full of spirit nearly to its neck, with an upright reflection."""
    m = Material(occlusion=0.5)
    z = m.remap(m.axis(2), 0, height)
    stops = [(0, shade(drink, 0.55)), (0.05, shade(drink, 0.9)), (0.45, shade(drink, 1.2))]
    stops += [(0.79, drink), (0.81, "dccfb0"), (1, "efe8d8")]
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.05, 0.2, 0.5, 0)
    return m.colour(m.mix(shine, m.ramp(z, stops), "ffffff"))
