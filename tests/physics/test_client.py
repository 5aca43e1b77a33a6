"""What a client keeps between worlds has a bound, and what it let go comes back the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from sdgen.physics import client as client_module
from sdgen.physics.client import Client, convex_obj


def box(size_m: float) -> str:
    half = size_m / 2
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    return convex_obj([np.array(corners)])


def top_of(client: Client, obj: str) -> float:
    """Height of a shape's upper side, by a ray."""
    body = client.body(client.convex(obj), (0.0, 0.0, 0.0))
    start, end = np.array([[0.0, 0.0, 5.0]]), np.array([[0.0, 0.0, -5.0]])
    height = 5.0 - 10.0 * float(client.rays(start, end).fraction[0])
    client.remove(body)
    return height


def test_files_of_pieces_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client_module, "WRITTEN", 3)
    sizes = [1.0 + 0.1 * k for k in range(8)]
    with Client() as client:
        first = [top_of(client, box(size)) for size in sizes]
        folder = Path(client._folder.name)
        assert len(list(folder.iterdir())) == 3
        client.reset()
        assert [top_of(client, box(size)) for size in sizes] == first
        assert len(list(folder.iterdir())) == 3
    assert not folder.exists()
    assert first == pytest.approx([size / 2 for size in sizes], abs=0.01)


def test_what_bullet_parsed_is_let_go_with_a_world(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Seen from outside: a file that changed is read again once it was let go, and only then."""
    path = tmp_path / "mesh.obj"

    def height() -> float:
        client.reset()
        client.body(client.trimesh(path), (0.0, 0.0, 0.0))
        start, end = np.array([[0.1, 0.1, 5.0]]), np.array([[0.1, 0.1, -5.0]])
        return 5.0 - 10.0 * float(client.rays(start, end).fraction[0])

    def write(z: float) -> None:
        path.write_text(f"v -1 -1 {z}\nv 1 -1 {z}\nv 0 1 {z}\nf 1 2 3\n")

    with Client() as client:
        write(1.0)
        assert height() == pytest.approx(1.0)
        write(2.0)
        assert height() == pytest.approx(1.0)
        monkeypatch.setattr(client_module, "PARSED", 0)
        assert height() == pytest.approx(2.0)
