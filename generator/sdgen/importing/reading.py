"""Reads one model of a source, whatever it lies in there."""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path
from zipfile import ZipFile

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing.habitat import read_articulated, read_configured
from sdgen.importing.layouts import Candidate
from sdgen.importing.mesh_files import read_mesh
from sdgen.importing.mjcf import read_mjcf_model
from sdgen.importing.scan import Piece, Scan, Up
from sdgen.importing.sdf import fuel_words, read_sdf
from sdgen.importing.tree import References
from sdgen.importing.urdf import read_urdf

#: Axes of sources whose meshes do not say theirs.
_UP: Mapping[str, Up] = {"ycb": "z", "gso": "z", "fantastic-breaks": "z"}
#: Bytes of the matrix of a pair, which takes a few hundred.
_MAX_TRANSFORM = 100_000


def read_model(source: str, candidate: Candidate, references: References) -> Scan:
    """The model as its source has it. Raises AssetError, located, for a broken one."""
    if candidate.kind == "sdf":
        return read_sdf(candidate.entry, references)
    if candidate.kind == "urdf":
        if source == "replicacad":
            return read_articulated(candidate.entry, references)
        return read_urdf(candidate.entry, references)
    if candidate.kind == "mjcf":
        return read_mjcf_model(candidate.entry, references)
    if candidate.kind == "object_config":
        return read_configured(candidate.entry, references)
    if candidate.kind == "break":
        return _broken_pair(candidate.entry, references)
    pieces, up = read_mesh(candidate.entry, references)
    words = fuel_words(candidate.folder, references) if source in ("gso", "folder") else ()
    return Scan(pieces, up=_UP.get(source, up) if up == "unknown" else up, words=words)


def _broken_pair(path: Path, references: References) -> Scan:
    """A pair of Fantastic Breaks: the whole thing, and what was left of it when it broke.

    Lamb et al., "Fantastic Breaks" (CVPR 2023). ``meta_0.npz`` says by a matrix what takes the
    meshes, normalised, to their real size.
    """
    folder = path.parent
    whole, _ = read_mesh(path, references)
    broken: tuple[Piece, ...] = ()
    rest = folder / "model_b_0.ply"
    if rest.is_file():
        broken, _ = read_mesh(rest, references)
    else:
        references.note(f"{references.shown(rest)}: not there: no broken variant")
    matrix = _transform(folder / "meta_0.npz", references)
    scan = Scan(whole, up="z", broken=broken)
    return scan.moved(matrix)


def _transform(path: Path, references: References) -> Array:
    if not path.is_file():
        references.note(f"{references.shown(path)}: not there: its size is unknown")
        return np.eye(4)
    shown = references.shown(path)
    try:
        # Nothing pickled: that would run what strangers wrote.
        with ZipFile(io.BytesIO(references.bytes_of(path))) as members:
            if "transform.npy" not in members.namelist():
                references.note(f"{shown}: has no transform: its size is unknown")
                return np.eye(4)
            with members.open("transform.npy") as member:
                raw = member.read(_MAX_TRANSFORM + 1)
        if len(raw) > _MAX_TRANSFORM:
            raise ValueError("transform: is larger than a few matrices")
        given = np.load(io.BytesIO(raw), allow_pickle=False)
        if given.dtype.kind not in "fiu":
            raise ValueError("transform: is no matrix of real numbers")
        matrix = given.astype(np.float64).reshape(-1, 4, 4)[0]
    except Exception as error:  # zip, npy and their headers are a stranger's
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        raise AssetError([f"{shown}: cannot be read ({reason})"]) from None
    scales = np.linalg.norm(matrix[:3, :3], axis=0)
    even = np.isfinite(matrix).all() and scales.min() > 0.9 * scales.max() > 1e-6
    if not even or abs(np.linalg.det(matrix[:3, :3])) < 1e-12:
        raise AssetError([f"{shown}: transform: is no rotation with one scale"])
    return np.asarray(matrix)
