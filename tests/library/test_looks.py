"""What people misjudged in pictures of the shipped library, and what keeps it from coming back."""

import networkx as nx
import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image
from sdgen.catalog.load import load_catalog
from sdgen.hazards.certify import categories_of
from sdgen.library import Library

from tests.shipped import shipped_library

Corners = NDArray[np.float64]


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


def bodies(corners: Corners) -> list[Corners]:
    """Triangles (N, 3, 3) parted into what hangs together."""
    keys = [[tuple(p) for p in t] for t in np.rint(corners * 1e4).astype(int).tolist()]
    graph = nx.Graph((a, b) for t in keys for a, b in ((t[0], t[1]), (t[1], t[2])))
    number = {key: k for k, part in enumerate(nx.connected_components(graph)) for key in part}
    owner = np.array([number[t[0]] for t in keys])
    return [corners[owner == k] for k in range(int(owner.max()) + 1)]


@pytest.mark.parametrize("bed", ["bed_01", "bed_05", "bed_09", "child_bed_01", "child_bed_04"])
def test_pillows_lie_on_their_bed(library: Library, bed: str) -> None:
    """As high at the front as at the head: none stands on an edge in the air."""
    mesh = library.mesh(bed)["body"]
    tilts = []
    for body in bodies(np.asarray(mesh.vertices, dtype=float)[mesh.faces]):
        low, high = body.reshape(-1, 3).min(axis=0), body.reshape(-1, 3).max(axis=0)
        deep, wide, tall = high - low
        at_the_head = low[0] < -0.4 and (low + high)[0] / 2 < -0.3
        if at_the_head and 0.25 < deep < 0.5 and wide > 0.35 and tall < 0.35:
            points = body.reshape(-1, 3)
            front, back = (
                points[points[:, 0] > high[0] - 0.05],
                points[points[:, 0] < low[0] + 0.05],
            )
            tilts.append(float(front[:, 2].mean() - back[:, 2].mean()))
    assert tilts
    assert max(tilts) < 0.02


def test_a_flame_is_seen_from_across_the_room(library: Library) -> None:
    """At 2 m a pixel of a 320 x 240 view is 9 mm wide: three of them and more, two across."""
    burning = categories_of(load_catalog().hazard("candle_on").predicate)
    for candle in (model for name in sorted(burning or ()) for model in library.by_category(name)):
        flames = library.mesh(candle.id)["flame"]
        corners = np.asarray(flames.vertices, dtype=float)[flames.faces]
        for flame in bodies(corners):
            size = np.ptp(flame.reshape(-1, 3), axis=0)
            assert size[2] > 0.03, candle.id
            assert size[:2].min() > 0.012, candle.id


@pytest.mark.parametrize("seat", ["sofa_01", "sofa_02", "sofa_03", "armchair_03"])
def test_no_black_slit_runs_along_an_upholstered_piece(library: Library, seat: str) -> None:
    """Long faces that look up are not black: a strip too narrow for its texture came out so."""
    mesh = library.mesh(seat)["body"]
    texture = library.file(seat, f"textures/{seat}.jpg")
    picture = np.asarray(Image.open(texture).convert("L"), dtype=float)
    corners = np.asarray(mesh.vertices, dtype=float)[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    up = normals[:, 2] > 0.8 * np.linalg.norm(normals, axis=1)
    long = np.ptp(corners, axis=1).max(axis=1) > 0.3
    high = corners[:, :, 2].min(axis=1) > 0.5
    uv = np.asarray(mesh.uvs, dtype=float)[mesh.faces].mean(axis=1)[up & long & high]
    rows = ((1 - uv[:, 1]) * (picture.shape[0] - 1)).astype(int)
    tones = picture[rows, (uv[:, 0] * (picture.shape[1] - 1)).astype(int)]
    assert len(tones)
    assert tones.min() > 0.5 * np.median(picture)


def test_coasters_of_a_set_lie_on_one_another(library: Library) -> None:
    """Discs side by side were taken for coins."""
    mesh = library.mesh("coaster_08")["body"]
    discs = bodies(np.asarray(mesh.vertices, dtype=float)[mesh.faces])
    middles = sorted(tuple(disc.reshape(-1, 3).mean(axis=0)[[2, 0, 1]]) for disc in discs)
    steps = np.linalg.norm(np.diff(np.array(middles), axis=0)[:, 1:], axis=1)
    assert steps.max() < 0.06


def test_rubber_gloves_lie(library: Library) -> None:
    """None stands on its cuff, fingers up, as if worn."""
    for gloves in library.by_category("rubber_gloves"):
        assert gloves.extents_m[2] < 0.1, gloves.id


def test_a_rolled_magazine_is_round(library: Library) -> None:
    """No loose leaf lies below it, on which it would hover."""
    (rolled,) = (m for m in library.by_category("magazine") if m.title == "rolled magazine")
    _, wide, tall = rolled.extents_m
    assert abs(wide - tall) < 0.01
