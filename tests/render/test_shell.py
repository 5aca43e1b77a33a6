from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.render.shell import ShellFolder, ceiling_level_m, structure_faces
from sdgen.scene import Band, Box, Structure


def wall() -> Structure:
    """A wall along y with a doorway: two posts and a lintel."""
    pieces = (
        Box(center_m=(1.0, 0.5, 1.25), size_m=(0.06, 1.0, 2.5)),
        Box(center_m=(1.0, 2.5, 1.25), size_m=(0.06, 1.0, 2.5)),
        Box(center_m=(1.0, 1.5, 2.3), size_m=(0.06, 1.0, 0.4)),
    )
    return Structure(id=4, category="wall", room_id=1, surface="w", pieces=pieces)


def triangles(vertices: np.ndarray) -> np.ndarray:
    quads = vertices.reshape(-1, 4, 3)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def test_faces_look_outwards_and_cover_the_boxes() -> None:
    area = 0.0
    for face in structure_faces(wall(), lambda _: 1.0):
        corners = triangles(face.vertices_m)
        cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area += np.linalg.norm(cross, axis=1).sum() / 2
        drawn = np.tile(face.normals.reshape(-1, 4, 3)[:, 0], (2, 1))
        assert (np.einsum("ij,ij->i", cross, drawn) > 0).all()
        assert np.linalg.norm(face.normals, axis=1) == pytest.approx(1.0)
    boxes = [piece.size_m for piece in wall().pieces]
    assert area == pytest.approx(sum(2 * (x * y + y * z + x * z) for x, y, z in boxes))


def test_texture_coordinates_are_metres_and_run_on_across_pieces() -> None:
    for face in structure_faces(wall(), lambda _: 0.5):
        flat = np.ptp(face.vertices_m, axis=0).argmin() if len(face.vertices_m) else 0
        across = [axis for axis in range(3) if axis != flat]
        if np.ptp(face.vertices_m, axis=0)[flat] > 1e-9:
            continue  # jambs of several pieces lie in different planes
        assert face.uvs == pytest.approx(face.vertices_m[:, across] / 0.5)


def test_floors_show_their_top_and_ceilings_their_underside() -> None:
    box = Box(center_m=(0, 0, 0), size_m=(4, 3, 0.1))
    floor = Structure(id=1, category="floor", room_id=1, surface="f", pieces=(box,))
    ceiling = Structure(id=2, category="ceiling", room_id=1, surface="w", pieces=(box,))
    (top,), (under,) = (structure_faces(s, lambda _: 1.0) for s in (floor, ceiling))
    assert (top.vertices_m[:, 2] == 0.05).all()
    assert (top.normals == [0, 0, 1]).all()
    assert (under.vertices_m[:, 2] == -0.05).all()


def test_a_wall_up_to_the_ceiling_needs_no_top_and_a_sill_does() -> None:
    ceiling = Structure(
        id=2,
        category="ceiling",
        room_id=1,
        surface="w",
        pieces=(Box(center_m=(0, 0, 2.525), size_m=(4, 3, 0.05)),),
    )
    level = ceiling_level_m([wall(), ceiling])
    assert level == pytest.approx(2.5)
    assert ceiling_level_m([wall()]) == np.inf
    below = Box(center_m=(1.0, 1.5, 0.4), size_m=(0.06, 1.0, 0.8))
    sill = wall().model_copy(update={"pieces": (*wall().pieces, below)})

    def numbers(structure: Structure, ceiling_m: float) -> list[int]:
        return [face.number for face in structure_faces(structure, lambda _: 1.0, ceiling_m)]

    assert numbers(wall(), level) == [0, 1, 2, 3, 5]
    assert numbers(sill, level) == numbers(wall(), level + 0.1) == [0, 1, 2, 3, 4, 5]
    assert numbers(ceiling, level) == [0]


def test_files_are_named_by_content_and_share_textures(tmp_path: Path) -> None:
    texture = tmp_path / "stone.png"
    Image.new("RGB", (4, 4)).save(texture)
    folder = tmp_path / "out"
    folder.mkdir()
    shell = ShellFolder(folder)
    faces = structure_faces(wall(), lambda _: 1.0)
    paths = [shell.write(face, texture) for face in faces]
    assert len(set(paths)) == len(faces)
    assert [shell.write(face, texture) for face in faces] == paths
    assert len(list(folder.glob("*.png"))) == 1
    text = paths[0].read_text(encoding="utf-8")
    assert text.startswith("mtllib stone.mtl\n")
    assert "map_Kd stone.png" in (folder / "stone.mtl").read_text(encoding="utf-8")


def test_bands_wear_their_own_surface_on_one_side_of_a_wall() -> None:
    foot = Band(surface="oak", facing="-x", low_m=(0.0, 0.0), high_m=(3.0, 0.08))
    tiled = Band(surface="tile", facing="-x", low_m=(0.2, 0.9), high_m=(0.7, 1.4))
    banded = wall().model_copy(update={"bands": (foot, tiled)})
    plain = {face.number: face for face in structure_faces(wall(), lambda _: 1.0)}
    areas: dict[tuple[str, int], float] = {}
    for face in structure_faces(banded, lambda name: 0.08 if name == "oak" else 1.0):
        corners = triangles(face.vertices_m)
        cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        areas[face.surface, face.number % 6] = float(np.linalg.norm(cross, axis=1).sum() / 2)
        if face.surface == "oak":
            # One tile high: its picture stands upright on the floor.
            assert face.uvs[:, 1].min() == pytest.approx(0.0)
            assert face.uvs[:, 1].max() == pytest.approx(1.0)
    # Posts of 1 m beside a doorway: no band across it.
    assert areas["oak", 1] == pytest.approx(2 * 0.08)
    assert areas["tile", 1] == pytest.approx(0.5 * 0.5)
    assert {key for key in areas if key[0] != "w"} == {("oak", 1), ("tile", 1)}
    corners = triangles(plain[1].vertices_m)
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    whole = float(np.linalg.norm(cross, axis=1).sum() / 2)
    assert sum(areas[name, 1] for name in ("w", "oak", "tile")) == pytest.approx(whole)


def test_bands_that_end_in_a_corner_go_on_behind_the_wall_there() -> None:
    tiled = Band(surface="tile", facing="-x", low_m=(0.06, 0.9), high_m=(2.94, 1.4))
    banded = wall().model_copy(update={"bands": (tiled,)})
    faces = structure_faces(banded, lambda _: 1.0)
    (own,) = [face for face in faces if face.surface == "tile"]
    assert own.vertices_m[:, 1].min() == pytest.approx(0.0)
    assert own.vertices_m[:, 1].max() == pytest.approx(3.0)
