"""Archives as nobody should send them, made by hand."""

from __future__ import annotations

import io
import tarfile
import zipfile
from collections.abc import Mapping
from pathlib import Path

LINK, DEVICE, FIFO, SOCKET = 0o120777, 0o060644, 0o010644, 0o140644


def tar_bytes(members: list[tarfile.TarInfo], contents: Mapping[str, bytes] | None = None) -> bytes:
    """A tar of these members, whatever they are called."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for member in members:
            raw = (contents or {}).get(member.name, b"")
            member.size = len(raw)
            archive.addfile(member, io.BytesIO(raw))
    return out.getvalue()


def entry(name: str, kind: bytes = tarfile.REGTYPE, target: str = "") -> tarfile.TarInfo:
    """A header of a tar."""
    member = tarfile.TarInfo(name)
    member.type, member.linkname = kind, target
    return member


def tar_of(files: Mapping[str, bytes]) -> bytes:
    """A tar of plain files."""
    return tar_bytes([entry(name) for name in files], files)


def zip_of(files: Mapping[str, bytes], modes: Mapping[str, int] | None = None) -> bytes:
    """A zip of these files; ``modes`` makes links and devices of some."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, raw in files.items():
            info = zipfile.ZipInfo(name)
            info.filename = name  # ZipInfo changes some names
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = (modes or {}).get(name, 0o100644) << 16
            archive.writestr(info, raw)
    return out.getvalue()


def everything_below(folder: Path) -> set[str]:
    """Names of all files and folders below a folder."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}
