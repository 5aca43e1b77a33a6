"""The probes find a cue that is there, and none where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from tests.audit.dataset import ROOT, DataSet, Floats, Scene
from tests.audit.features import (
    PICTURE,
    PLACEMENT,
    SHAPE,
    Rows,
    picture_rows,
    placement_rows,
    scene_tables,
)
from tests.audit.probes import Bools, Strings, measure, stratified_auc

N, HOMES = 1500, 60


@pytest.fixture(scope="module")
def scenes() -> list[Scene]:
    return list(DataSet(ROOT / "output" / "sample").scenes())


def rows(cue: float) -> tuple[Floats, Bools, Strings, Strings]:
    """Made-up rows of which one column in five tells that much."""
    rng = np.random.default_rng(3)
    positive = rng.random(N) < 0.15
    features = rng.normal(size=(N, 5))
    features[:, 2] += cue * positive
    features[rng.random((N, 5)) < 0.1] = np.nan
    return (
        features,
        positive,
        rng.choice(["a", "b", "c"], N),
        rng.integers(HOMES, size=N).astype(str),
    )


def test_a_cue_is_found_and_noise_is_not() -> None:
    found, none = measure("cue", *rows(1.5)), measure("noise", *rows(0.0))
    assert found is not None
    assert none is not None
    assert found.auc > 0.75
    assert abs(none.auc - 0.5) < 4 * none.error
    assert none.planted > 0.65


def test_what_differs_between_strata_tells_nothing() -> None:
    features, positive, _, home = rows(0.0)
    stratum = np.array(
        ["rich" if flag else "poor" for flag in np.random.default_rng(5).random(N) < 0.5]
    )
    positive = positive | ((stratum == "rich") & (np.random.default_rng(6).random(N) < 0.5))
    features[:, 0] = stratum == "rich"
    within = measure("within", features, positive, stratum, home)
    across = measure("across", features, positive, np.array(["all"] * N), home)
    assert within is not None
    assert across is not None
    assert across.auc > 0.65
    assert abs(within.auc - 0.5) < 4 * within.error


def test_an_auc_counts_pairs_and_half_of_ties() -> None:
    told = np.array([0.9, 0.5, 0.5, 0.1])
    positive = np.array([True, True, False, False])
    one = np.array(["all"] * 4)
    assert stratified_auc(told, positive, one, np.ones(4)) == pytest.approx(3.5 / 4)


def test_pictures_and_placement_are_read(scenes: list[Scene]) -> None:
    pictures, places = picture_rows(scenes), placement_rows(scenes)
    assert pictures.features.shape[1] == len(PICTURE)
    assert places.features.shape[1] == len(PLACEMENT)
    kinds = set(pictures.column("kind"))
    assert kinds == {"anomaly", "lookalike", "clutter"}
    seen = pictures.column("seen").astype(bool)
    middle = pictures.features[seen][:, PICTURE.index("from the middle")]
    placed = pictures.without(SHAPE)
    assert placed.features.shape[1] == len(PICTURE) - len(SHAPE)
    assert np.array_equal(placed.features[seen][:, placed.names.index("from the middle")], middle)
    assert ((middle >= 0) & (middle < 2)).all()
    tables, hazards, _ = scene_tables(scenes)
    assert all(len(table) == len(hazards) == len(scenes) for table in tables.values())


def test_what_is_left_free_tells_no_row_by_what_it_lacks() -> None:
    """Of a category that may be a tripping hazard, what lies there as clutter loses as much."""
    shared = {"category": "shoe", "band": "floor"}
    kinds = [("anomaly", "tripping_hazard"), ("lookalike", "spill"), ("clutter", "")]
    about = [{"kind": kind, "hazard": hazard, **shared} for kind, hazard in kinds]
    places = Rows(PLACEMENT, [[1.0] * len(PLACEMENT) for _ in about], list(about))
    wall = PLACEMENT.index("from the wall")
    assert np.isnan(places.free("category")[:, wall]).all()
    assert np.isnan(places.free("hazard")[:, wall]).tolist() == [True, False, False]
    assert np.isnan(places.free("hazard")[:, PLACEMENT.index("height")]).all()
    assert not np.isnan(places.features).any()
