"""The formats a data set can be exported to: what each writes, and which module does it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias

from sdgen.errors import UsageError, did_you_mean

if TYPE_CHECKING:
    from sdgen.dataset import Dataset
    from sdgen.library import Library

#: Told ``(done, total)`` after each scene.
OnScene: TypeAlias = "Callable[[int, int], None] | None"


@dataclass(frozen=True)
class Format:
    """One format. ``function`` of ``module`` writes it: ``(data, output, on_scene)``, with the
    library between the last two where it needs the ``models``, after them where it can do without
    and writes ``meshes`` with it."""

    module: str
    function: str
    words: str
    output: Literal["file", "folder"] = "folder"
    models: bool = False
    meshes: bool = False


FORMATS: Mapping[str, Format] = {
    "tar": Format("tar", "export_tar", "the files as they are, one archive", "file"),
    "webdataset": Format("webdataset", "export_webdataset", "tar shards, a sample a view"),
    "huggingface": Format(
        "huggingface", "export_huggingface", "Parquet for load_dataset", meshes=True
    ),
    "croissant": Format("huggingface", "export_huggingface", "the same folder: its croissant.json"),
    "rerun": Format("rerun", "export_rerun", "a recording a scene for the Rerun viewer"),
    "glb": Format("glb", "export_glb", "a GLB a scene", models=True),
    "mjcf": Format("mjcf", "export_mjcf", "an XML a scene for MuJoCo, shared meshes", models=True),
    "mjz": Format("mjcf", "export_mjz", "one file a scene for MuJoCo", models=True),
    "urdf": Format("urdf", "export_urdf", "a URDF a scene, shared meshes", models=True),
    "usd": Format("usd", "export_usd", "a USD a scene with physics, shared models", models=True),
    "virtualhome": Format("virtualhome", "export_virtualhome", "scene graphs in Unity's axes"),
    "questions": Format(
        "question_files", "export_questions", "boxed pictures, options, answers for language models"
    ),
    "coco": Format("coco", "export_coco", "instances, hazards and panoptic masks"),
}


def export(
    data: Dataset,
    name: str,
    output: Path,
    on_scene: OnScene = None,
    library: Library | None = None,
) -> None:
    """Export a data set to a file, or a folder that is new or empty; whole or not at all.

    ``library`` has the models of formats that need them (default: the shipped ones); given for one
    that can do without, that writes each scene's mesh, too. UsageError for a format nobody knows,
    SdgenError for a bad place, InputError for a data set that is not whole.
    """
    if name not in FORMATS:
        near = did_you_mean(name, list(FORMATS)) or f" (one of: {', '.join(FORMATS)})"
        raise UsageError(f"no format {name!r}{near}")
    known = FORMATS[name]
    write = getattr(import_module(f"sdgen.export.{known.module}"), known.function)
    if not known.models:
        more = (library,) if known.meshes and library is not None else ()
        write(data, output, on_scene, *more)
        return
    from sdgen.library import load_library

    write(data, output, library or load_library(), on_scene)
