"""What shows an appliance to be open is hidden while it is shut: labels are held to its pixels."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np
import pytest
from sdgen.cameras.parts import part_numbers, world_triangles
from sdgen.catalog.load import load_catalog
from sdgen.library.alone import MODEL_ID, alone_on_floor
from sdgen.library.records import AssetInfo, StateRule
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames
from sdgen.render.portraits import portrait_camera
from sdgen.render.protocol import Renderer

from tests.shipped import shipped_library

SIDES, PIXELS = 8, 192
#: Pixels of a crack between two parts, and of the inside that the best side shows of what is open
#: as little as the state allows (today's models: 1, and 400 or more).
CRACK, SHOWN = 2, 200


def opened() -> Iterator[tuple[AssetInfo, StateRule]]:
    """What a hazard asks to be seen open, and the rule: its doors and drawers. A lid is left out:
    raised, it tells by itself."""
    library = shipped_library()
    hazards = [h for h in load_catalog().hazards if h.evidence_state == "OPEN"]
    recipes = [r for h in hazards if not h.evidence_outdoors for r in h.anomalies]
    asked = {category for recipe in recipes for category in recipe.categories}
    for _, info in sorted(library.infos.items()):
        for rule in info.states if info.category in asked else ():
            if rule.state == "OPEN" and rule.joint is not None:
                joint = info.joint(rule.joint)
                if joint.type == "prismatic" or abs(joint.axis[2]) == 1.0:
                    yield info, rule


def pixels(
    renderer: Renderer, info: AssetInfo, joints: Mapping[str, float], parts: tuple[str, ...]
) -> list[int]:
    """How many pixels of the parts each side shows."""
    library = shipped_library()
    scene = alone_on_floor(library, info.id, "default", joints, None)
    item = scene.object(MODEL_ID)
    points = world_triangles(library, item).reshape(-1, 3)
    cameras = [portrait_camera(points, PIXELS, math.tau * k / SIDES) for k in range(SIDES)]
    numbers = list(part_numbers(library, item, parts))
    frames = render_frames(renderer, library, scene, cameras, ("instance",))
    return [
        int(((frame.instance == MODEL_ID) & np.isin(frame.part, numbers)).sum()) for frame in frames
    ]


@pytest.mark.library
def test_what_shows_it_open_is_seen_only_then() -> None:
    rules = list(opened())
    assert any(info.joint(rule.joint).type == "prismatic" for info, rule in rules)
    wrong = {}
    with open_renderer("auto") as renderer:
        for info, rule in rules:
            shut = max(pixels(renderer, info, {}, rule.parts))
            ajar = max(pixels(renderer, info, {rule.joint: rule.min}, rule.parts))
            if shut > CRACK or ajar < SHOWN:
                wrong[info.id, rule.joint] = (shut, ajar)
    assert wrong == {}
