"""Where each source keeps its models: what lies in a download, model by model."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal
from xml.etree.ElementTree import ParseError, iterparse

from sdgen.errors import AssetError, InputError
from sdgen.files import open_plain
from sdgen.importing.mesh_files import MESHES

Kind = Literal["mesh", "sdf", "urdf", "mjcf", "object_config", "break"]

#: Folders looked through, and levels of them.
_MOST_FOLDERS, _MOST_DEEP = 200_000, 12
#: Resolutions of YCB, the lightest that is good enough first; older ones have no google_16k.
_YCB = ("google_16k", "google_64k", "google_512k", "poisson", "tsdf")
_YCB_NAME = re.compile(r"^\d{3}([-_][a-z0-9]+)?[_-]")
#: Meshes that are not there to be seen.
_UNSEEN = re.compile(
    r"(collision|collider|_coll?\b|convex|_cv_decomp|vhacd|coacd|_hull|nontextured|physics|_lod[1-9])",
    re.IGNORECASE,
)
#: Names that say nothing: the folder's is the model's.
_NAMELESS = {"model", "mesh", "textured", "scene", "object", "visual", "base", "model_normalized"}
_PREFERRED = (".glb", ".gltf", ".obj", ".dae", ".ply", ".stl")


@dataclass(frozen=True)
class Candidate:
    """A model found: its name in its source, how to read it, its file and its own folder, and the
    folder that was looked through."""

    name: str
    kind: Kind
    entry: Path
    folder: Path
    root: Path = Path()

    @property
    def place(self) -> str:
        """Its file as seen from the folder that was looked through."""
        return self.entry.relative_to(self.root).as_posix()


def find_models(source: str, root: Path) -> list[Candidate]:
    """The models below ``root``, by name. Raises AssetError when there is none."""
    found = {}
    for candidate in FINDERS[source](root):
        name, number = candidate.name, 2
        while name in found:  # of two folders of one name
            name, number = f"{candidate.name}_{number}", number + 1
        found[name] = replace(candidate, name=name, root=root)
    if not found:
        raise AssetError([f"{root}: no model of {source} here; {_EXPECTED[source]}"])
    return [found[name] for name in sorted(found)]


def ycb(root: Path) -> Iterator[Candidate]:
    """``<nnn_name>/google_16k/textured.obj``, and older resolutions."""
    for folder, folders, _ in _walk(root):
        here = [name for name in _YCB if name in folders]
        if folder.name in _YCB and folder == root:
            here, folder = [folder.name], folder.parent
        if not here or not _YCB_NAME.match(folder.name):
            continue
        folders[:] = []
        for level in here:
            file = _first(folder / level, ("textured.obj", "textured.dae", "textured.ply"))
            file = file or _first(folder / level, ("nontextured.ply", "nontextured.stl"))
            if file is not None:
                yield Candidate(folder.name, "mesh", file, folder)
                break
        else:
            yield Candidate(folder.name, "mesh", folder / here[0] / "textured.obj", folder)


def gso(root: Path) -> Iterator[Candidate]:
    """``<Name>/meshes/model.obj`` as Fuel packs it; ``<Name>/model.obj`` as others do."""
    for folder, folders, names in _walk(root):
        file = folder / "meshes" / "model.obj"
        if "meshes" in folders and file.is_file():
            folders[:] = []
            yield Candidate(folder.name, "mesh", file, folder)
        elif "model.obj" in names and folder.name != "meshes":
            yield Candidate(folder.name, "mesh", folder / "model.obj", folder)


def replicacad(root: Path) -> Iterator[Candidate]:
    """``configs/objects/*.object_config.json`` and ``urdf/<name>/<name>.urdf`` of Habitat."""
    configured: set[str] = set()
    bare: list[Path] = []
    for folder, _, names in _walk(root):
        for name in names:
            path = folder / name
            if name.endswith(".object_config.json"):
                stem = name.removesuffix(".object_config.json")
                configured.add(stem)
                yield Candidate(stem, "object_config", path, folder)
            elif name.endswith(".urdf") and not name.endswith("_dynamic.urdf"):
                yield Candidate(f"urdf_{path.stem}", "urdf", path, folder)
            elif name.endswith(".glb") and folder.name == "objects":
                bare.append(path)
    for path in bare:
        if path.stem not in configured and not _UNSEEN.search(path.stem):
            yield Candidate(path.stem, "mesh", path, path.parent)


def fantastic_breaks(root: Path) -> Iterator[Candidate]:
    """``<category>/<object>/model_c.ply`` with the broken part beside it."""
    for folder, folders, names in _walk(root):
        if "model_c.ply" in names:
            folders[:] = []
            name = f"{folder.parent.name}_{folder.name}"
            yield Candidate(name, "break", folder / "model_c.ply", folder)


def folder(root: Path) -> Iterator[Candidate]:
    """Any folder: what a wrapper (SDF, URDF, MJCF) describes, else every mesh there to be seen."""
    for here, folders, names in _walk(root):
        sdf = [name for name in names if name.endswith(".sdf")]
        if sdf:
            folders[:] = []
            best = "model.sdf" if "model.sdf" in sdf else max(sdf)
            yield Candidate(here.name, "sdf", here / best, here)
            continue
        wrapped = list(_wrappers(here, names))
        if wrapped:
            yield from wrapped
            # Their meshes lie below, or here, and are theirs.
            folders[:] = [name for name in folders if _has_wrapper(here / name)]
            continue
        fuel = here / "meshes" / "model.obj"
        if "meshes" in folders and fuel.is_file():
            folders[:] = []
            yield Candidate(here.name, "mesh", fuel, here)
            continue
        yield from _bare(here, names)


def _wrappers(here: Path, names: Sequence[str]) -> Iterator[Candidate]:
    for name in names:
        path = here / name
        if name.endswith(".urdf") and not name.endswith("_dynamic.urdf"):
            yield Candidate(_named(path, here), "urdf", path, here)
        elif name.endswith((".xml", ".mjcf")) and _root_tag(path) == "mujoco":
            yield Candidate(_named(path, here), "mjcf", path, here)


def _has_wrapper(folder_: Path) -> bool:
    return any(
        name.endswith((".sdf", ".urdf"))
        or (name.endswith(".xml") and _root_tag(here / name) == "mujoco")
        for here, _, names in _walk(folder_)
        for name in names
    )


def _bare(here: Path, names: Sequence[str]) -> Iterator[Candidate]:
    meshes = [n for n in names if Path(n).suffix.lower() in MESHES and not _UNSEEN.search(n)]
    best: dict[str, str] = {}
    for name in sorted(meshes, key=lambda n: _PREFERRED.index(Path(n).suffix.lower())):
        best.setdefault(Path(name).stem.casefold(), name)  # one model, exported in several formats
    for name in sorted(best.values()):
        yield Candidate(_named(here / name, here), "mesh", here / name, here)


def _named(path: Path, here: Path) -> str:
    if path.stem.casefold() not in _NAMELESS:
        return path.stem
    generic = {"meshes", "mesh", "visual", "assets", *_YCB}
    return here.parent.name if here.name.casefold() in generic else here.name


def _root_tag(path: Path) -> str | None:
    """The name of an XML file's first element; None when it is none."""
    try:
        if path.stat().st_size > 50_000_000:
            return None
        with open_plain(path, path.name) as stream:
            for _, element in iterparse(stream, events=("start",)):
                return str(element.tag)
    except (InputError, OSError, ParseError, ValueError, LookupError):
        return None
    return None


def _first(folder_: Path, names: Sequence[str]) -> Path | None:
    return next((folder_ / name for name in names if (folder_ / name).is_file()), None)


def _walk(root: Path) -> Iterator[tuple[Path, list[str], list[str]]]:
    """Folders below ``root`` with their folders, which the caller may empty, and files, sorted."""
    deep = len(root.parts)
    for count, (here, folders, names) in enumerate(os.walk(root)):
        path = Path(here)
        folders[:] = sorted(n for n in folders if not n.startswith((".", "__MACOSX")))
        if len(path.parts) - deep >= _MOST_DEEP:
            folders[:] = []
        if count > _MOST_FOLDERS:
            raise AssetError([f"{root}: more than {_MOST_FOLDERS} folders"])
        yield path, folders, sorted(n for n in names if not n.startswith("."))


#: Source -> what finds its models.
FINDERS: Mapping[str, Callable[[Path], Iterator[Candidate]]] = {
    "ycb": ycb,
    "gso": gso,
    "replicacad": replicacad,
    "fantastic-breaks": fantastic_breaks,
    "folder": folder,
}
_EXPECTED = {
    "ycb": "expected folders such as 025_mug/google_16k/textured.obj",
    "gso": "expected folders such as Mug_Name/meshes/model.obj",
    "replicacad": "expected configs/objects/*.object_config.json and objects/*.glb",
    "fantastic-breaks": "expected folders such as 00/00001/model_c.ply",
    "folder": f"expected meshes ({', '.join(MESHES)}) or .sdf, .urdf, MuJoCo .xml",
}
