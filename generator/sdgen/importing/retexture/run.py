"""A model in a new state: its variant in an asset folder, with a texture baked by Blender."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.output_file import write_output
from sdgen.errors import AssetError, UsageError, did_you_mean
from sdgen.importing.blender import Blender, find_blender
from sdgen.importing.manifest import folder_manifest, with_entry
from sdgen.importing.retexture import texture
from sdgen.importing.retexture.looks import WORN, Kind, kind_of, oddity, worn_word
from sdgen.importing.retexture.variants import (
    glb_with_nodes,
    hulls_with_parts,
    renamed,
    with_variant,
    worn_parts,
)
from sdgen.importing.shelf import held, origins, record_bytes, record_name
from sdgen.library import Library
from sdgen.library.manifest import read_manifest
from sdgen.library.meshes import check_extents, read_glb, read_hulls
from sdgen.library.plausible import inconsistencies
from sdgen.library.raw import file_bytes
from sdgen.library.records import Asset
from sdgen.library.unpack import check_texture
from sdgen.resources import data_path
from sdgen.scratch import scratch_folder
from sdgen.yaml_source import show_path

_MANIFEST = "manifest.yaml"


@dataclass(frozen=True)
class Retextured:
    """What came of it: the model, its folder, the files written (none: it was there already).

    ``notes`` are for the user; ``blender`` is the one that baked.
    """

    asset_id: str
    folder: Path
    state: str
    variant: str
    files: tuple[str, ...]
    notes: tuple[str, ...]
    blender: str = ""


@dataclass(frozen=True)
class _Place:
    """Where a model is read from and where its new record goes: the same folder, or a copy."""

    asset: Asset
    source: Path
    folder: Path
    asset_id: str


def retexture(
    model: str,
    word: str,
    folders: Sequence[Path] = (),
    out: Path | None = None,
    seed: int = 0,
    overwrite: bool = False,
) -> Retextured:
    """Give ``model``, of the shipped library or of ``folders``, the state that ``word`` means.

    The variant is added where the model is. With ``out``, an asset folder or a new one, the model
    is copied there first, under ``<id>_copy``, and the copy gets it. Raises UsageError for what
    makes no sense, AssetError for a broken folder or model, BlenderError and BakeError when it
    cannot be baked; then nothing is changed.
    """
    word = worn_word(word)
    state = WORN[word].state
    place = _place(model, folders, out)
    category = place.asset.category
    food, known = _in_catalogue(category)
    odd = oddity(WORN[word], category, food, known)
    notes = () if odd is None else (odd,)
    if not _to_do(place, word, overwrite):
        return Retextured(place.asset.id, place.source, state, word, (), notes)
    blender = find_blender()
    files = _baked(place, word, kind_of(category, food), seed, blender)
    with held(place.folder):
        # Anew: others may have changed the folder meanwhile.
        place = _place(model, folders, out)
        if _to_do(place, word, overwrite):
            if state not in place.asset.state_names:
                files |= _variant_files(place, word, tuple(files))
            _write(place, files)
    return Retextured(place.asset_id, place.folder, state, word, tuple(files), notes, blender.name)


def _place(model: str, folders: Sequence[Path], out: Path | None) -> _Place:
    shipped = data_path("assets")
    if out is not None and _same(out, shipped):
        raise UsageError(f"{out}: is the shipped library, which is never changed; name another")
    every = [shipped, *(folder for folder in folders if not _same(folder, shipped))]
    if out is not None and out.exists() and not any(_same(out, folder) for folder in every):
        if not out.is_dir():
            raise UsageError(f"{out}: is no folder")
        if folder_manifest(out) is not None:
            every.append(out)
    library = Library(every)
    if model not in library.assets:
        raise UsageError(f"no model {model!r}{did_you_mean(model, sorted(library.assets))}")
    source = library.folder_of(model)
    if out is None and _same(source, shipped):
        raise UsageError(
            f"{model} is a shipped model, and those are never changed: name a folder with --out, "
            "and a copy there is retextured"
        )
    if out is None or _same(source, out):
        return _Place(library.assets[model], source, source, model)
    copy = f"{model}_copy"
    if copy not in library.assets:
        return _Place(library.assets[model], source, out, copy)
    if not _same(library.folder_of(copy), out):
        text = f"{library.folder_of(copy)} has {copy} already, which {out} would need"
        raise UsageError(f"{text}; ids are unique among folders")
    return _Place(library.assets[copy], out, out, copy)


def _same(a: Path, b: Path) -> bool:
    return a.resolve() == b.resolve()


def _texture_names(place: _Place, word: str) -> dict[str, str]:
    """The new texture's file for each part: one for every texture that the parts have now."""
    asset = place.asset
    before = {part.name: part.texture or asset.texture for part in worn_parts(asset)}
    distinct = list(dict.fromkeys(before.values()))
    ends = {old: "" if k == 0 else f"_{k + 1}" for k, old in enumerate(distinct)}
    return {
        part: f"textures/{place.asset_id}_{word}{ends[old]}.jpg" for part, old in before.items()
    }


def _to_do(place: _Place, word: str, overwrite: bool) -> bool:
    """False when the model has the state already, and is to keep it.

    Raises UsageError for a state to overwrite, or a variant, that the model came with.
    """
    asset, state = place.asset, WORN[word].state
    textures = {asset.part(name).texture for name in asset.variants.get(word, ())}
    ours = bool(textures & set(_texture_names(place, word).values()))
    if not ours and state not in asset.state_names and word not in asset.variants:
        return True
    if not overwrite and state in asset.state_names:
        return False
    if not ours:
        raise UsageError(
            f"{asset.id} came with a variant that is {state} or called {word!r}: it is no work of "
            "retexturing, and stays"
        )
    return True


def _in_catalogue(category: str) -> tuple[bool, bool]:
    """Whether a category is food, and whether the shipped catalogue knows it at all."""
    from sdgen.catalog.load import load_catalog

    for known in load_catalog().categories:
        if known.name == category:
            return known.superclass == "Food", True
    return False, False


def _baked(place: _Place, word: str, kind: Kind, seed: int, blender: Blender) -> dict[str, bytes]:
    """The new textures' bytes by file."""
    texture_of = _texture_names(place, word)
    asset, source = place.asset, place.source
    meshes = read_glb(source / asset.mesh, asset)
    check_extents(source / asset.mesh, asset, meshes)
    files = {}
    for target in dict.fromkeys(texture_of.values()):
        parts = [part for part, name in texture_of.items() if name == target]
        old = source / (asset.part(parts[0]).texture or asset.texture)
        check_texture(old)
        before = texture.read_texture(file_bytes(old))
        shown = [meshes[part] for part in parts]
        with scratch_folder() as scratch:
            try:
                pixels = texture.bake(blender, shown, before, WORN[word].look, kind, seed, scratch)
            except texture.BakeError as error:
                raise texture.BakeError(f"{asset.id} as {word}: {error}") from None
        files[target] = texture.jpeg(pixels)
    return files


def _variant_files(place: _Place, word: str, textures: Sequence[str]) -> dict[str, bytes]:
    """All further files of the model with its new variant, and the manifest that names them.

    Until the manifest is written, last, all is as the old one says: the mesh only has more nodes,
    and the collision pieces are a new file.
    """
    files: dict[str, bytes] = {}
    before = _copied(place, files)
    names = renamed(before, word)
    after = with_variant(before, word, WORN[word].state, _texture_names(place, word))
    after = after.model_copy(update={"hulls": f"meshes/{place.asset_id}_{word}.hulls.json"})
    path = place.folder / "manifest.yaml"
    wrong = [f"{path}: {after.id}: {show_path(at)}: {text}" for at, text in inconsistencies(after)]
    if wrong:
        raise AssetError(wrong)
    raw_mesh, raw_hulls = (
        files.pop(name) if name in files else file_bytes(place.folder / name)
        for name in (before.mesh, before.hulls)
    )
    try:
        files[after.mesh] = glb_with_nodes(raw_mesh, names)
    except ValueError as error:
        raise AssetError([f"{place.source / place.asset.mesh}: {error}"]) from None
    files[after.hulls] = hulls_with_parts(raw_hulls, names)
    read_glb(place.source / place.asset.mesh, after, files[after.mesh])
    read_hulls(place.source / place.asset.hulls, after, files[after.hulls])
    _check_free(place, [*textures, *(name for name in files if name != before.mesh)])
    origin = origins(place.folder).get(after.id)
    if origin is not None:  # or the next import would make the manifest without the variant
        noted = origin.model_copy(update={"asset": after})
        files[record_name(after.id)] = record_bytes(noted)
    files[_MANIFEST] = with_entry(folder_manifest(place.folder), str(path), after)
    return files


def _check_free(place: _Place, names: Sequence[str]) -> None:
    """Raises AssetError when another model of the folder has a file of one of these names."""
    raw = folder_manifest(place.folder)
    taken: dict[str, str] = {}
    for asset in read_manifest(place.folder, raw).assets if raw is not None else ():
        if asset.id != place.asset_id:
            owned = (asset.mesh, asset.hulls, asset.texture, *(p.texture for p in asset.parts))
            taken |= {name: asset.id for name in owned if name}
    clash = [f"{place.folder / n}: {taken[n]} has it already" for n in names if n in taken]
    if clash:
        raise AssetError(clash)


def _copied(place: _Place, files: dict[str, bytes]) -> Asset:
    """The record as it is in the folder; of a model from elsewhere, ``files`` get its own."""
    asset = place.asset
    if place.asset_id == asset.id:
        return asset
    moved: dict[str, str] = {}

    def move(old: str, new: str) -> str:
        if old not in moved:
            moved[old] = f"{new}{Path(old).suffix}"
            files[moved[old]] = file_bytes(place.source / old)
        return moved[old]

    name = place.asset_id
    whole = move(asset.texture, f"textures/{name}")
    parts = tuple(
        part.model_copy(update={"texture": move(part.texture, f"textures/{name}_{part.name}")})
        if part.texture
        else part
        for part in asset.parts
    )
    mesh, hulls = f"meshes/{name}.glb", f"meshes/{name}.hulls.json"
    files[mesh] = file_bytes(place.source / asset.mesh)
    files[hulls] = file_bytes(place.source / asset.hulls)
    return asset.model_copy(
        update={"id": name, "texture": whole, "parts": parts, "mesh": mesh, "hulls": hulls}
    )


def _write(place: _Place, files: Mapping[str, bytes]) -> None:
    """Write files, those that name others last; then take away pieces that nobody names any more.

    When the disk is full, what was new is taken away again.
    """
    naming = [name for name in (record_name(place.asset_id), _MANIFEST) if name in files]
    made: list[Path] = []
    try:
        for name in files:
            if name not in naming:
                path = place.folder / name
                made += [] if path.exists() else [path]
                write_output(path, files[name])
    except BaseException:
        for path in made:
            path.unlink(missing_ok=True)
        raise
    for name in naming:
        write_output(place.folder / name, files[name])
    if _MANIFEST in files and place.folder == place.source:
        named = set(read_manifest(place.folder, files[_MANIFEST]).files())
        if place.asset.hulls not in named:
            (place.folder / place.asset.hulls).unlink(missing_ok=True)
