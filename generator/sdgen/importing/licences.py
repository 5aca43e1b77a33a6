"""Under which licence a source's models come, and who is to be named."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sdgen.errors import AssetError, did_you_mean
from sdgen.importing.tree import References, is_file
from sdgen.library.licences import LICENCES, NON_COMMERCIAL

_ALL = (*LICENCES, *NON_COMMERCIAL)
_MAX_BYTES = 200_000
_FILES = re.compile(r"^(licen[cs]e|copying|.*attribution).*", re.IGNORECASE)
#: What licence files say, the narrower before the wider.
_WORDS = (
    (r"attribution.noncommercial.sharealike|cc.by.nc.sa", "CC-BY-NC-SA-4.0"),
    (r"attribution.noncommercial|cc.by.nc|non.?commercial", "CC-BY-NC-4.0"),
    (r"attribution.sharealike|cc.by.sa", "CC-BY-SA-4.0"),
    (r"creative commons attribution 3|attribution 3\.0|cc.by.3", "CC-BY-3.0"),
    (r"creative commons attribution|attribution 4\.0|cc.by(.4)?", "CC-BY-4.0"),
    (r"cc0|public domain dedication", "CC0-1.0"),
    (r"apache license", "Apache-2.0"),
    (r"mit no attribution", "MIT-0"),
    (r"permission is hereby granted, free of charge", "MIT"),
    (r"redistribution and use in source and binary forms", "BSD-3-Clause"),
)


@dataclass(frozen=True)
class Terms:
    """A licence (SPDX), whom to name, and where it says so."""

    licence: str
    attribution: str
    where: str


#: Source -> what its home page says. ReplicaCAD's page says CC BY 4.0 and the file in its download
#: CC BY-NC 4.0: the stricter counts. Fantastic Breaks says nothing that we could find.
_KNOWN: Mapping[str, Terms] = {
    "ycb": Terms(
        "CC-BY-4.0",
        "YCB Object and Model Set (Calli et al., IEEE RAM 2015), https://www.ycbbenchmarks.com",
        "the source's page",
    ),
    "gso": Terms(
        "CC-BY-4.0",
        "Google Scanned Objects (Downs et al., ICRA 2022), Google LLC, https://app.gazebosim.org",
        "the source's page",
    ),
    "replicacad": Terms(
        "CC-BY-NC-4.0",
        "ReplicaCAD (Szot et al., NeurIPS 2021), https://aihabitat.org/datasets/replica_cad",
        "the licence file of its download",
    ),
}


def terms_of(source: str, root: Path, own: str | None, attribution: str | None) -> Terms:
    """The terms of all models below ``root``: what the user says, what the source is known for,
    what a licence file says. Raises AssetError where nobody knows."""
    known = _KNOWN.get(source)
    if own is not None:
        if own not in _ALL:
            near = did_you_mean(own, _ALL) or f" (one of: {', '.join(_ALL)})"
            raise AssetError(
                [f"--licence {own}: not one that a data set can be passed on under{near}"]
            )
        credit = attribution or (known.attribution if known else f"models of {root.name}")
        return Terms(own, credit, "--licence")
    if known is not None:
        return known if attribution is None else Terms(known.licence, attribution, known.where)
    found = _of_files(root, root)
    if found is None:
        raise AssetError(
            [f"{root}: no file says under which licence these models come: name it by --licence"]
        )
    return found if attribution is None else Terms(found.licence, attribution, found.where)


def nearer(terms: Terms, references: References) -> Terms:
    """The terms of one model: those of a licence file between its folder and the root."""
    if terms.where == "--licence":
        return terms
    found = _of_files(references.folder, references.root)
    if found is None or found.licence == terms.licence:
        return terms
    return Terms(found.licence, terms.attribution, found.where)


def _of_files(folder: Path, root: Path) -> Terms | None:
    """What the licence file nearest above a folder says; None when there is none, or no telling."""
    here = folder
    while here == root or root in here.parents:
        for file in sorted(here.iterdir()) if here.is_dir() else ():
            if _FILES.match(file.name) and is_file(file) and not file.is_symlink():
                with file.open("rb") as stream:
                    text = " ".join(stream.read(_MAX_BYTES).decode("utf-8", "replace").split())
                licence = _said(text.lower())
                if licence is not None:
                    return Terms(licence, _credit(text, here), file.relative_to(root).as_posix())
        if here == root:
            return None
        here = here.parent
    return None


def _said(text: str) -> str | None:
    return next((name for words, name in _WORDS if re.search(words, text)), None)


def _credit(text: str, folder: Path) -> str:
    found = re.search(
        r"copyright [^.;]{4,80}?(?=[.;(]| permission| all rights|$)", text, re.IGNORECASE
    )
    return f"{folder.name}: {found.group(0).strip()}" if found else f"models of {folder.name}"
