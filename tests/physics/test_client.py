"""What a client keeps between worlds has a bound, and what it let go comes back the same."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from sdgen.physics import client as client_module
from sdgen.physics.bodies import STRUCTURE_FRICTION
from sdgen.physics.bullet import pb
from sdgen.physics.client import FRICTION, Client, convex_obj


def box(size_m: float) -> str:
    half = size_m / 2
    corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    return convex_obj([np.array(corners)])


def top_of(client: Client, obj: str) -> float:
    """Height of a shape's upper side, by how far a probe is above it."""
    body = client.body(client.convex(obj), (0.0, 0.0, 0.0))
    probe = client.body(client.box((0.01, 0.01, 0.02)), (0.0, 0.0, 5.0))
    distance = client.closest(probe, body, 10.0)[0].distance_m
    client.remove(body)
    client.remove(probe)
    return 4.99 - distance


def test_files_of_pieces_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client_module, "WRITTEN", 3)
    sizes = [1.0 + 0.1 * k for k in range(8)]
    with Client() as client:
        first = [top_of(client, box(size)) for size in sizes]
        folder = client._folder
        assert len(list(folder.glob("*.obj"))) == 3
        client.reset()
        assert [top_of(client, box(size)) for size in sizes] == first
        assert len(list(folder.glob("*.obj"))) == 3
    assert not folder.exists()
    assert first == pytest.approx([size / 2 for size in sizes], abs=0.01)


def test_what_bullet_parsed_is_let_go_with_a_world(monkeypatch: pytest.MonkeyPatch) -> None:
    """Seen from outside: a file that changed is read again once it was let go, and only then."""
    with Client() as client:
        client.convex(box(1.0))
        (path,) = client._folder.glob("*.obj")
        path.write_text(box(2.0))
        for parsed, height in ((1, 0.5), (0, 1.0)):
            monkeypatch.setattr(client_module, "PARSED", parsed)
            client.reset()
            assert top_of(client, box(1.0)) == pytest.approx(height, abs=0.01)


def test_no_renderer_takes_the_pieces() -> None:
    with Client() as client:
        body = client.body(client.convex(box(1.0)), (0.0, 0.0, 0.0))
        (drawn,) = pb.getVisualShapeData(body, physicsClientId=client._id)
    assert drawn[2] == pb.GEOM_BOX


def test_what_sleeps_on_something_fixed_costs_no_collision_until_it_wakes() -> None:
    with Client() as client:
        client.body(client.box((1.0, 1.0, 1.0)), (0.0, 0.0, 0.0))
        cube = client.body(client.box((0.1, 0.1, 0.1)), (0.0, 0.0, 0.549), mass_kg=1.0)
        client.sleep(cube)
        client.step(3)
        assert client.contacts() == ()
        client.wake(cube)
        client.step(24)
        assert client.contacts()
        assert client.pose(cube).position_m[2] == pytest.approx(0.55, abs=0.002)


def test_what_a_killed_simulator_left_the_next_one_takes_away(tmp_path: Path) -> None:
    begin = "import os, signal; from sdgen.physics.client import Client; client = Client();"
    killed, closed = begin + "os.kill(os.getpid(), signal.SIGKILL)", begin + "client.close()"
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    for _ in range(2):
        subprocess.run([sys.executable, "-c", killed], env=environment, check=False)
        assert len(list(tmp_path.iterdir())) == 1
    subprocess.run([sys.executable, "-c", closed], env=environment, check=True)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("ground", "degrees", "slides"),
    [
        (FRICTION, 18, False),
        (FRICTION, 22, True),
        (STRUCTURE_FRICTION, 24, False),
        (STRUCTURE_FRICTION, 28, True),
    ],
)
def test_frictions_of_two_bodies_multiply(ground: float, degrees: float, slides: bool) -> None:
    """On a slope a thing stays as long as its tangent is below the product of the two."""
    angle = np.radians(degrees)
    quat = (0.0, float(np.sin(angle / 2)), 0.0, float(np.cos(angle / 2)))
    up = np.array([np.sin(angle), 0.0, np.cos(angle)])
    with Client() as client:
        client.body(client.box((20.0, 20.0, 1.0)), (0, 0, 0), quat, friction=ground)
        thing = client.body(client.box((0.4, 0.4, 0.1)), (up * 0.551).tolist(), quat, mass_kg=1.0)
        client.step(120)  # it has met the slope
        before = client.pose(thing).position_m
        client.step(240)
        moved = float(np.linalg.norm(np.subtract(client.pose(thing).position_m, before)))
    assert (moved > 0.1) == slides
    assert slides or moved < 0.001
