"""The models a data set was built with, against those of the library at hand."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from sdgen.dataset import Dataset
from sdgen.library import Library
from sdgen.validate.problems import SHOWN, Check, Problem, differences


def other_models(data: Dataset, library: Library, check: Check) -> Iterator[Problem]:
    """What keeps scenes of ``data`` from being made or loaded anew from ``library``.

    Its digest first; where that is the same, the record of every model that the scenes use: the
    digest in ``dataset.json`` is only what the data set says of itself.
    """
    if library.sha256 != data.info.assets_sha256:
        text = "dataset.json: assets_sha256: other models than the ones at hand (--assets)"
        yield Problem(check, text)
        return
    for name, stored in data.infos.items():
        where = f"assets.jsonl: model {name}"
        if name not in library.infos:
            yield Problem(check, f"{where}: not in the library that assets_sha256 names")
            continue
        for text in islice(differences(stored, library.infos[name]), SHOWN):
            yield Problem(check, f"{where}: {text}")
