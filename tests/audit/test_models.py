"""What the audit asks of models wherever they stand: every broken one lies on the floor."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from tests.audit.dataset import ROOT, Scene, Thing
from tests.audit.drafts import library
from tests.audit.meshes import read_glb
from tests.audit.physics import shards_in_air

#: Their glass stays in the frame, which holds it however it hangs or lies.
FRAMED = {"mirror", "picture_frame"}
#: One model in so many is laid down here; `make test-library` lays them all.
STRIDE = 7


def broken() -> list[str]:
    """One model of each mesh that has a broken variant."""
    found: dict[str, str] = {}
    for asset, record in sorted(library().items()):
        if "broken" in record["variants"] and record["category"] not in FRAMED:
            found.setdefault(record["mesh"], asset)
    return list(found.values())


def on_a_floor(asset: str) -> list[object]:
    """What the audit finds of a broken model whose lowest point is on a floor."""
    record = library()[asset]
    item: dict[str, Any] = {
        "id": 1,
        "category": record["category"],
        "asset": asset,
        "pose": {"position_m": [0.0, 0.0, 0.0], "quat_xyzw": [0.0, 0.0, 0.0, 1.0]},
        "room_id": 1,
        "joints": {},
        "variant": "broken",
        "states": ["BROKEN"],
        "fixed": False,
    }
    meshes = read_glb(ROOT / "assets" / record["mesh"])
    item["pose"]["position_m"][2] = -Thing(item, record, meshes).bottom
    thing = Thing(item, record, meshes)
    scene = SimpleNamespace(small=[thing], things={1: thing}, found=lambda thing, *what: what)
    return list(shards_in_air(cast(Scene, scene)))


@pytest.mark.parametrize("asset", broken()[::STRIDE])
def test_the_shards_of_a_broken_model_lie_on_the_floor(asset: str) -> None:
    assert on_a_floor(asset) == []


@pytest.mark.library
@pytest.mark.parametrize("asset", broken())
def test_the_shards_of_every_broken_model_lie_on_the_floor(asset: str) -> None:
    assert on_a_floor(asset) == []
