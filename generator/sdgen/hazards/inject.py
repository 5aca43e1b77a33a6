"""Brings a scene's drawn anomalies and some lookalikes about."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from sdgen.hazards.splits import withheld_anomaly
from sdgen.hazards.ways import Made, Site, Way, bring_about, shuffled, ways
from sdgen.home.layout import Layout
from sdgen.rejection import Rejection, reject
from sdgen.seeding import Rng

WAYS_TRIED = 20
LOOKALIKE_SHARE = 0.85
LOOKALIKE_WAYS_TRIED = 6


def inject(
    hazards: Sequence[str], layout: Layout, site: Site, training: bool, rng: Rng
) -> tuple[Made, ...] | Rejection:
    """One anomaly of each drawn hazard. ``training`` leaves withheld unique anomalies out."""
    made: list[Made] = []
    for hazard_id in hazards:
        hazard = site.catalog.hazard(hazard_id)
        found = ways(hazard_id, hazard.anomalies, layout, site)
        if training:
            found = [way for way in found if not withheld_anomaly(way.unique)]
        taken = {m.object_id for m in made}
        one = _first(shuffled(found, rng)[:WAYS_TRIED], layout, site, taken, rng)
        if one is None:
            return reject("hazards", "no_place", hazard=hazard_id)
        made.append(one)
    return tuple(made)


def add_lookalikes(
    layout: Layout, site: Site, anomalies: Sequence[Made], rng: Rng
) -> tuple[Made, ...]:
    """One benign near miss for most hazards, whether or not they were drawn."""
    made: list[Made] = []
    for hazard in site.catalog.hazards:
        wanted = rng.random() < LOOKALIKE_SHARE
        order = shuffled(ways(hazard.id, hazard.lookalikes, layout, site), rng)
        if not wanted:
            continue
        taken = {m.object_id for m in (*anomalies, *made)}
        one = _first(order[:LOOKALIKE_WAYS_TRIED], layout, site, taken, rng, keep_off=taken)
        if one is not None:
            made.append(one)
    return tuple(made)


def _first(
    order: Sequence[Way],
    layout: Layout,
    site: Site,
    taken: Collection[int],
    rng: Rng,
    keep_off: Collection[int] = (),
) -> Made | None:
    for way in order:
        one = bring_about(way, layout, site, taken, rng, keep_off)
        if one is not None:
            return one
    return None
