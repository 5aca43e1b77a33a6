"""Floors, walls and ceilings give back as much light as real ones, and are as even."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from sdgen.catalog.load import load_catalog

from tests.shipped import shipped_library

LIBRARY = shipped_library()
PAINTED = sorted(s for s in LIBRARY.surfaces if s.startswith(("plaster_", "ceiling_")))


def linear(surface: str) -> np.ndarray:
    with Image.open(LIBRARY.surface_texture(surface)) as image:
        share = np.asarray(image.convert("RGB"), dtype=np.float64) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


@pytest.mark.parametrize("surface", sorted(LIBRARY.surfaces))
def test_none_gives_back_more_light_than_white_paint(surface: str) -> None:
    mean = linear(surface).mean(axis=(0, 1))
    assert (mean < 0.83).all()
    assert mean.mean() > 0.03


@pytest.mark.parametrize("surface", sorted(LIBRARY.surfaces))
def test_it_goes_on_where_it_comes_again(surface: str) -> None:
    values = linear(surface).mean(axis=2)
    # A skirting has an upper and a lower edge.
    for axis in (1,) if LIBRARY.surfaces[surface].kind == "skirting" else (0, 1):
        turned = np.moveaxis(values, axis, 0)
        steps = np.abs(np.diff(turned, axis=0)).mean(axis=1)
        assert np.abs(turned[0] - turned[-1]).mean() <= 1.05 * steps.max()


@pytest.mark.parametrize("surface", PAINTED)
def test_paint_has_a_grain_and_no_clouds(surface: str) -> None:
    values = linear(surface).mean(axis=2)
    size = len(values) // 16
    blocks = values.reshape(16, size, 16, size).mean(axis=(1, 3))
    assert 0.002 < values.std() / values.mean() < 0.03
    assert np.ptp(blocks) / values.mean() < 0.006


def test_every_wall_and_floor_is_in_some_style() -> None:
    used = {
        name
        for style in load_catalog().styles
        for choices in (style.floors, style.walls, style.splashbacks, style.skirtings)
        for choice in choices
        for name in choice.of
    }
    rooms = {s for s, found in LIBRARY.surfaces.items() if found.kind != "ceiling"}
    assert rooms <= used
