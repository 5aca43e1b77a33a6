"""Scenes as MJCF for MuJoCo: ``000041.xml`` and one folder of meshes and textures for all, or
``000041.mjz`` each, which has all of its own.

MuJoCo reads ``.mjz`` by ``mujoco.MjSpec.from_file``. What bodies, joints and masses are, and what
``custom`` text says: :mod:`sdgen.export.home_mjcf`.
"""

from __future__ import annotations

import zipfile
from pathlib import Path
from tempfile import TemporaryDirectory

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.output_folder import output_folder
from sdgen.export.each_scene import each_scene
from sdgen.export.formats import OnScene
from sdgen.export.home_mjcf import write_home_mjcf
from sdgen.export.model_files import ModelFiles
from sdgen.library import Library

#: Folder of meshes and textures.
ASSETS = "assets"
#: Zip files know no time before.
_NO_TIME = (1980, 1, 1, 0, 0, 0)


def export_mjcf(data: Dataset, output: Path, library: Library, on_scene: OnScene = None) -> None:
    """Write an XML a scene into a new folder, and what they share into ``assets`` there.

    Raises SdgenError for a bad place, InputError for scenes whose files disagree or that other
    models were built of.
    """
    with output_folder(output) as folder:
        (folder / ASSETS).mkdir()
        files = ModelFiles(library, folder / ASSETS)

        def write(item: SceneItem) -> None:
            text = write_home_mjcf(item.scene, library, files, ASSETS)
            (folder / f"{item.id}.xml").write_bytes(text)

        each_scene(data, library, on_scene, write)


def export_mjz(data: Dataset, output: Path, library: Library, on_scene: OnScene = None) -> None:
    """Write a ``.mjz`` a scene into a new folder. Raises as ``export_mjcf``."""
    with output_folder(output) as folder:
        each_scene(
            data, library, on_scene, lambda item: _pack(item, library, folder / f"{item.id}.mjz")
        )


def _pack(item: SceneItem, library: Library, path: Path) -> None:
    with TemporaryDirectory() as name, zipfile.ZipFile(path, "x") as archive:
        text = write_home_mjcf(item.scene, library, ModelFiles(library, Path(name)), ASSETS)
        # MuJoCo looks for the model under the name of the archive.
        _add(archive, f"{item.id}.xml", text)
        for file in sorted(Path(name).iterdir()):
            _add(archive, f"{ASSETS}/{file.name}", file.read_bytes())


def _add(archive: zipfile.ZipFile, name: str, content: bytes) -> None:
    member = zipfile.ZipInfo(name, _NO_TIME)
    member.external_attr = 0o644 << 16
    packed = zipfile.ZIP_STORED if name.endswith(".png") else zipfile.ZIP_DEFLATED
    archive.writestr(member, content, packed, compresslevel=1)
