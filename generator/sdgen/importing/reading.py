"""Reads one model of a source, whatever it lies in there."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing.layouts import Candidate
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.mjcf import read_mjcf_model
from sdgen.importing.scan import Box, Piece, Scan, Up
from sdgen.importing.sdf import fuel_words, read_sdf
from sdgen.importing.tree import References
from sdgen.importing.urdf import read_urdf

#: Axes of sources whose meshes do not say theirs.
_UP: Mapping[str, Up] = {"ycb": "z", "gso": "z", "fantastic-breaks": "z"}
_MAX_JSON = 5_000_000


def read_model(source: str, candidate: Candidate, references: References) -> Scan:
    """The model as its source has it. Raises AssetError, located, for a broken one."""
    if candidate.kind == "sdf":
        return read_sdf(candidate.entry, references)
    if candidate.kind == "urdf":
        # Habitat's world is Y up, its URDFs too.
        scan = read_urdf(candidate.entry, references, "y" if source == "replicacad" else "z")
        return _with_link_boxes(scan, candidate, references)
    if candidate.kind == "mjcf":
        return read_mjcf_model(candidate.entry, references)
    if candidate.kind == "object_config":
        return _configured(candidate.entry, references)
    if candidate.kind == "break":
        return _broken_pair(candidate.entry, references)
    pieces, up = read_mesh(candidate.entry, references)
    words = fuel_words(candidate.folder, references) if source in ("gso", "folder") else ()
    return Scan(pieces, up=_UP.get(source, up) if up == "unknown" else up, words=words)


def _configured(path: Path, references: References) -> Scan:
    """A ``*.object_config.json`` of Habitat: mesh, mass and receptacle boxes, Y up."""
    shown = references.shown(path)
    given = _json(path, references)
    name = given.get("render_asset")
    if not isinstance(name, str):
        raise AssetError([f"{shown}: render_asset: expected the name of a mesh"])
    mesh = references.find(path.parent, name)
    if mesh is None or mesh.suffix.lower() not in MESHES:
        raise AssetError([f"{shown}: render_asset: {name}: no such mesh"])
    pieces, _ = read_mesh(mesh, references)
    scale = given.get("scale", [1.0, 1.0, 1.0])
    try:
        matrix = np.diag([*(float(v) for v in scale), 1.0])
        mass = float(given["mass"]) if "mass" in given else None
        boxes = tuple(box for box, _ in _boxes(given.get("user_defined")))
    except (TypeError, ValueError) as error:
        raise AssetError([f"{shown}: {error}"]) from None
    return Scan(
        tuple(piece.moved(matrix) for piece in pieces), up="y", mass_kg=mass, receptacles=boxes
    )


def _with_link_boxes(scan: Scan, candidate: Candidate, references: References) -> Scan:
    """The scan of a URDF with the receptacle boxes of the ``ao_config.json`` beside it. Those are
    in the frames of links; of a body that is only turned by quarters the mesh tells the rest."""
    file = candidate.entry.with_suffix("").with_suffix(".ao_config.json")
    if not file.is_file():
        return scan
    references.note("receptacle boxes of its links are not used: surfaces are found on the mesh")
    return scan


def _boxes(given: Any) -> list[tuple[Box, str]]:
    """Receptacle boxes of ``user_defined``: ``scale`` is half of each side."""
    out = []
    for name, entry in given.items() if isinstance(given, dict) else ():
        if not str(name).startswith("receptacle_aabb") or not isinstance(entry, dict):
            continue
        center = np.array([float(v) for v in entry["position"]])
        half = np.array([abs(float(v)) for v in entry["scale"]])
        if center.shape != (3,) or half.shape != (3,) or not np.isfinite([center, half]).all():
            raise ValueError(f"{name}: expected three numbers")
        out.append((Box(center, 2 * half), str(entry.get("parent_link", "body"))))
    return out


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
        with np.load(io.BytesIO(references.bytes_of(path)), allow_pickle=False) as data:
            if "transform" not in data.files:
                references.note(f"{shown}: has no transform: its size is unknown")
                return np.eye(4)
            matrix = np.asarray(data["transform"], dtype=np.float64).reshape(-1, 4, 4)[0]
    except Exception as error:  # zip, npy and their headers are a stranger's
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        raise AssetError([f"{shown}: cannot be read ({reason})"]) from None
    scales = np.linalg.norm(matrix[:3, :3], axis=0)
    even = np.isfinite(matrix).all() and scales.min() > 0.9 * scales.max() > 1e-6
    if not even or abs(np.linalg.det(matrix[:3, :3])) < 1e-12:
        raise AssetError([f"{shown}: transform: is no rotation with one scale"])
    return np.asarray(matrix)


def _json(path: Path, references: References) -> dict[str, Any]:
    shown = references.shown(path)
    try:
        given = json.loads(references.bytes_of(path, _MAX_JSON))
    except (ValueError, RecursionError) as error:
        raise AssetError([f"{shown}: not JSON ({error})"]) from None
    if not isinstance(given, dict):
        raise AssetError([f"{shown}: expected an object"])
    return given
