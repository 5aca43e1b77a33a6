"""Pieces that stand: found by number, drawn by nobody, the same whatever stood before."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.physics import still as still_module
from sdgen.physics.bullet import pb
from sdgen.physics.rays import RayWorld
from sdgen.physics.still import Piece, Still

from tests.fakes import box_room, thing


@pytest.fixture
def still() -> Iterator[Still]:
    made = Still()
    yield made
    made.close()


def down(at: Array) -> tuple[Array, Array]:
    """Rays from 5 m above points (N, 2) to 5 m below."""
    top = np.column_stack([at, np.full(len(at), 5.0)])
    return top, top - [0.0, 0.0, 10.0]


def test_more_pieces_than_a_body_takes_keep_their_numbers(still: Still) -> None:
    at = np.array([[0.5 * (k % 20), 0.5 * (k // 20)] for k in range(300)])
    sizes = [0.1 + 0.001 * k for k in range(300)]
    pieces = [
        Piece(still.box((0.2, 0.2, size)), (x, y, 0.0))
        for size, (x, y) in zip(sizes, at.tolist(), strict=True)
    ]
    still.add(pieces[:100])
    still.add(pieces[100:])
    hits = still.cast(*down(np.concatenate([at, [[-3.0, 0.0]]])))
    assert hits.piece.tolist() == [*range(300), -1]
    assert (5.0 - 10.0 * hits.fraction[:300]) == pytest.approx(np.array(sizes) / 2, abs=1e-6)
    assert hits.fraction[300] == 1.0


def test_nothing_is_met_where_nothing_stands(still: Still) -> None:
    assert still.cast(*down(np.zeros((2, 2)))).piece.tolist() == [-1, -1]


def test_pieces_are_turned(still: Still) -> None:
    upright = (0.0, np.sqrt(0.5), 0.0, np.sqrt(0.5))
    still.add([Piece(still.box((2.0, 0.2, 0.4)), (1.0, 0.0, 0.0), upright)])
    assert 5.0 - 10.0 * still.cast(*down(np.array([[1.1, 0.0]]))).fraction[0] == pytest.approx(1.0)


def triangle(path: Path, z: float) -> Path:
    path.write_text(f"v -1 -1 {z}\nv 1 -1 {z}\nv 0 1 {z}\nf 1 2 3\n")
    return path


def test_shapes_stay_until_there_are_too_many(
    still: Still, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Seen from outside: a file that changed is read again once its shape was let go."""

    def height(z: float) -> float:
        still.clear()
        still.add([Piece(still.trimesh(triangle(tmp_path / "mesh.obj", z)), (0.0, 0.0, 0.0))])
        return 5.0 - 10.0 * float(still.cast(*down(np.array([[0.1, 0.1]]))).fraction[0])

    assert height(1.0) == pytest.approx(1.0)
    assert height(2.0) == pytest.approx(1.0)
    monkeypatch.setattr(still_module, "KEPT", 0)
    assert height(2.0) == pytest.approx(2.0)


def test_no_renderer_takes_the_triangles(still: Still, tmp_path: Path) -> None:
    still.add([Piece(still.trimesh(triangle(tmp_path / "mesh.obj", 1.0)), (0.0, 0.0, 0.0))])
    (drawn,) = pb.getVisualShapeData(still._bodies[0], physicsClientId=still._id)
    assert drawn[2] == pb.GEOM_BOX


def test_hits_do_not_depend_on_what_stood_before(library: Library) -> None:
    """Not even where faces coincide: a cube's underside lies in the table's top."""
    scene = box_room([thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0, 0, 0.75))])
    others = [
        box_room([thing(k, "cabinet_01", (0.4 * k - 1, 0.3 * k - 1, 0)) for k in range(10, 14)]),
        box_room([thing(11, "cube_01", (0, 1, 0)), thing(12, "cube_02", (0, 0, 0.75))]),
    ]
    rng = np.random.default_rng(3)
    origins, targets = rng.uniform((-1.5, -1.5, -0.5), (1.5, 1.5, 2.5), (2, 5000, 3))

    def cast(used: Still | None) -> tuple[list[int], list[int], list[float]]:
        with RayWorld(library, scene, used) as world:
            # Piece by piece, as rays come near.
            parts = [world.cast(origins[:50], targets[:50]), world.cast(origins, targets)]
        return tuple(
            np.concatenate([getattr(hits, name) for hits in parts]).tolist()
            for name in ("object_id", "part", "distance_m")
        )  # type: ignore[return-value]

    alone, still = cast(None), Still()
    for other in others:
        with RayWorld(library, other, still) as world:
            world.cast(origins, targets)
        assert cast(still) == alone
    still.close()
    assert {10, 11} <= set(alone[0])
