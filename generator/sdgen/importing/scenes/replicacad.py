"""A ReplicaCAD scene (Habitat's ``*.scene_instance.json``) as a found scene.

Habitat is Y up: (x, y, z)_ours = (x, -z, y); its quaternions are wxyz. What a thing measures is
asked of its mesh, where that is there; rooms are those of the stage's mesh, else one around all.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from pydantic import Field

from sdgen.catalog.records import Catalog
from sdgen.errors import InputError
from sdgen.geometry import Z_UP_FROM_Y_UP, apply, box_corners, lowest_highest
from sdgen.importing.scenes.found import FoundPiece, FoundScene, box_piece, pose_of
from sdgen.importing.scenes.gltf_document import GltfDocument
from sdgen.importing.scenes.json_text import Four, Loose, Number, Three, read_json
from sdgen.importing.scenes.mesh_bounds import Bounds
from sdgen.importing.scenes.naming import Namer, opening_of
from sdgen.importing.scenes.openings import opening_from
from sdgen.importing.scenes.stage import stage_walls
from sdgen.importing.scenes.urdf_box import urdf_box
from sdgen.importing.tree import inside, is_file

#: A door whose file is missing: about as large as doors are (deep, wide, high), metres.
_DOOR_M = (0.1, 0.9, 2.1)
#: How the library calls where a model is from.
_SOURCE, _ARTICULATED = "replicacad", "urdf_"


class _Instance(Loose):
    template_name: str
    translation: Three = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    rotation: Four = Field(default_factory=lambda: [1.0, 0.0, 0.0, 0.0])
    translation_origin: str = ""
    motion_type: str = ""
    uniform_scale: Number = 1.0
    non_uniform_scale: Three | None = None


class _Stage(Loose):
    template_name: str = ""
    translation: Three = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    rotation: Four = Field(default_factory=lambda: [1.0, 0.0, 0.0, 0.0])


class _Scene(Loose):
    stage_instance: _Stage | None = None
    object_instances: list[_Instance] = Field(default_factory=list)
    articulated_object_instances: list[_Instance] = Field(default_factory=list)


class _Config(Loose):
    render_asset: str = ""
    COM: Three | None = None
    scale: Three | None = None


def read_replicacad(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of a ``*.scene_instance.json`` that lies where the data set has it,
    ``configs/scenes``.

    Raises InputError, located, with all that is wrong with the file itself. Of things whose own
    files are missing or broken it is told.
    """
    said = read_json(path, _Scene)
    title = path.name.removesuffix(".json").removesuffix(".scene_instance")
    reading = _Reading(_root_of(path), FoundScene(source=str(path), title=title))
    if said.stage_instance is not None:
        reading.stage(said.stage_instance)
    for instance in said.object_instances:
        reading.thing(instance, reading.object_box, "")
    for instance in said.articulated_object_instances:
        reading.thing(instance, reading.articulated_box, _ARTICULATED)
    reading.tell()
    return reading.scene


def _root_of(path: Path) -> Path:
    """The folder of the data set: that above ``configs``, else the scene's own."""
    folder = path.resolve().parent
    for above in (folder, *folder.parents):
        if above.name == "configs":
            return above.parent
    return folder


@dataclass
class _Reading:
    root: Path
    scene: FoundScene
    _boxes: dict[str, Bounds | str] = field(default_factory=dict)
    _missing: dict[str, int] = field(default_factory=dict)

    def stage(self, stage: _Stage) -> None:
        """Walls from the stage's mesh, where it is there."""
        name = _last(stage.template_name)
        try:
            config = self._json("configs/stages", name, "stage_config.json")
            mesh = self._file(self.root / "configs" / "stages", config.render_asset)
            w, x, y, z = stage.rotation
            place = pose_of(stage.translation, (x, y, z, w))
            walls = stage_walls(mesh, Z_UP_FROM_Y_UP @ place)
        except InputError as error:
            self.scene.told.append(f"the stage {name!r} cannot be read: {error.problems[0]}")
            return
        self.scene.walls += walls

    def thing(self, instance: _Instance, box_of: Callable[[str], Bounds], kind: str) -> None:
        """Add an object; its model's source is called by its ``kind`` and name."""
        name = _last(instance.template_name)
        sized = True
        try:
            low, high = box_of(name)
        except InputError as error:
            sized = False
            half = np.full(3, 1e-3)
            if opening_of(name) is None:
                text = f"{name}: its size is not known ({error.problems[0]})"
                self._missing[text] = self._missing.get(text, 0) + 1
            else:
                half = np.array((_DOOR_M[0], _DOOR_M[2], _DOOR_M[1])) / 2
            low, high = -half, half
        scale = np.array(instance.non_uniform_scale or [1.0] * 3) * instance.uniform_scale
        w, x, y, z = instance.rotation
        place = pose_of(instance.translation, (x, y, z, w))
        place[:3, :3] *= scale
        # Of the box as it is with Z up, so that its own axes are those of a model made from it.
        ours = Z_UP_FROM_Y_UP @ place @ Z_UP_FROM_Y_UP.T
        ends = apply(Z_UP_FROM_Y_UP, box_corners(low.tolist(), high.tolist()))
        try:
            piece = box_piece(name, ours, *lowest_highest(ends))
        except ValueError as error:
            self.scene.unresolved.append(f"{name}: {error}")
            return
        piece = replace(piece, source=f"{_SOURCE}:{kind}{name}", names=(name,), sized=sized)
        self._add(piece, name)

    def _add(self, piece: FoundPiece, name: str) -> None:
        kind = opening_of(name)
        if kind is not None:
            self.scene.openings.append(opening_from(piece, kind))
        else:
            self.scene.pieces.append(piece)

    def tell(self) -> None:
        """Tell of what has no file, once each."""
        for text, count in self._missing.items():
            times = f"; {count} times" if count > 1 else ""
            self.scene.told.append(f"{text}: one of usual size stands for it{times}")

    # --- sizes -----------------------------------------------------------------------------------

    def object_box(self, name: str) -> Bounds:
        """The box of an object about what its translation means. Raises InputError."""
        return self._known(f"objects/{name}", lambda: self._object_box(name))

    def articulated_box(self, name: str) -> Bounds:
        """The box of an articulated object in its root's frame. Raises InputError."""
        return self._known(f"urdf/{name}", lambda: self._articulated_box(name))

    def _known(self, key: str, make: Callable[[], Bounds]) -> Bounds:
        if key not in self._boxes:
            try:
                self._boxes[key] = make()
            except InputError as error:
                self._boxes[key] = error.problems[0]
        found = self._boxes[key]
        if isinstance(found, str):
            raise InputError([found])
        return found

    def _object_box(self, name: str) -> Bounds:
        config = self._json("configs/objects", name, "object_config.json")
        low, high = self._mesh(self.root / "configs" / "objects", config.render_asset)
        scale = np.array(config.scale or [1.0, 1.0, 1.0])
        low, high = low * scale, high * scale
        middle = (low + high) / 2 if config.COM is None else np.array(config.COM)
        return low - middle, high - middle

    def _articulated_box(self, name: str) -> Bounds:
        for folder in sorted((self.root / "urdf").glob("*")):
            path = folder / f"{name}.urdf"
            if path.is_file():
                return urdf_box(path, self._mesh)
        raise InputError([f"urdf/*/{name}.urdf: no such file"])

    def _json(self, folder: str, name: str, ending: str) -> _Config:
        path = self._file(self.root / folder, f"{name}.{ending}")
        return read_json(path, _Config, f"{folder}/{name}.{ending}")

    def _mesh(self, folder: Path, name: str) -> Bounds:
        """The box of a GLB, all of its nodes."""
        document = GltfDocument(self._file(folder, name))
        every = document.corners(document.all_meshes(np.eye(4)))
        if not len(every):
            raise InputError([f"{name}: has no mesh"])
        return lowest_highest(every)

    def _file(self, folder: Path, name: str) -> Path:
        """A file of the data set. Raises InputError for one outside it, or none."""
        path = folder / name
        if not name or not inside(self.root, path):
            raise InputError([f"{name[:80]!r}: lies outside the data set's folder"])
        if not is_file(path):
            raise InputError([f"{name}: no such file"])
        return path


def _last(template: str) -> str:
    """``objects/frl_apartment_sofa`` -> frl_apartment_sofa."""
    return template.rsplit("/", 1)[-1]
