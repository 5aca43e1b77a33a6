"""What of an object shows that it is an anomaly or a near miss."""

from __future__ import annotations

from sdgen.catalog.records import Hazard
from sdgen.library.records import AssetInfo
from sdgen.library.states import derive_states, state_parts
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import EVIDENCE_PIXELS


def evidence_of(
    hazard: Hazard, info: AssetInfo, item: ObjectInstance
) -> tuple[tuple[str, ...], int]:
    """Drawn parts that show an object to be an anomaly or a near miss, and how many of their pixels
    do at the reference size: the parts of the hazard's state or of its names, else all."""
    drawn = info.variants[item.variant]
    state = hazard.evidence_state
    if state is not None and state in derive_states(info, item.variant, item.joints):
        parts = state_parts(info, state, item.variant, item.joints)
    else:
        parts = tuple(name for name in drawn if name in hazard.evidence_parts) or drawn
    whole = set(parts) >= set(drawn)
    return parts, EVIDENCE_PIXELS if whole else hazard.evidence_pixels
