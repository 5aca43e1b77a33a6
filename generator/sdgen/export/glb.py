"""Scenes as GLB: ``000041.glb`` each, with names and PBR materials."""

from __future__ import annotations

from pathlib import Path

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.output_folder import output_folder
from sdgen.export.each_scene import each_scene
from sdgen.export.formats import OnScene
from sdgen.export.home_glb import home_glb
from sdgen.library import Library


def export_glb(data: Dataset, output: Path, library: Library, on_scene: OnScene = None) -> None:
    """Write a GLB a scene into a new folder.

    Raises SdgenError for a bad place, InputError for scenes whose files disagree or that other
    models were built of.
    """
    with output_folder(output) as folder:

        def write(item: SceneItem) -> None:
            (folder / f"{item.id}.glb").write_bytes(home_glb(item.scene, library))

        each_scene(data, library, on_scene, write)
