"""What the scenes of a data set have in common: its catalogue and its models, read once."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path

from sdgen.catalog.records import Catalog, canonical_sha256
from sdgen.dataset.older import asset_as_now, catalogue_as_now
from sdgen.dataset.text import read_bytes, read_lines, to_record
from sdgen.errors import InputError
from sdgen.library.records import AssetInfo


@dataclass(frozen=True)
class Knowledge:
    """``catalogue.json`` and ``assets.jsonl`` of a data set, each read on first use. Pickled
    without what was read: whoever unpickles it reads again what it needs.

    ``catalogue_expected``: the digest that the catalogue must have, None for any.
    """

    root: Path
    format_version: str
    catalogue_expected: str | None

    def __reduce__(self) -> tuple[type[Knowledge], tuple[Path, str, str | None]]:
        return type(self), (self.root, self.format_version, self.catalogue_expected)

    @cached_property
    def catalog(self) -> Catalog:
        """The catalogue. Raises InputError for another one than was expected."""
        as_now = partial(catalogue_as_now, version=self.format_version)
        catalog = to_record(Catalog, self._catalogue, "catalogue.json", as_now)
        if self.catalogue_expected not in (None, self.catalogue_sha256):
            raise InputError(["catalogue.json: not the catalogue whose digest dataset.json has"])
        return catalog

    @cached_property
    def catalogue_sha256(self) -> str:
        """Digest of ``catalogue.json`` as it was written. Raises InputError."""
        try:
            return canonical_sha256(json.loads(self._catalogue))
        except ValueError as error:
            raise InputError([f"catalogue.json: {error}"]) from None

    @cached_property
    def _catalogue(self) -> bytes:
        return read_bytes(self.root / "catalogue.json", "catalogue.json")

    @cached_property
    def infos(self) -> Mapping[str, AssetInfo]:
        """Records of the models by id. Raises InputError."""
        as_now = partial(asset_as_now, version=self.format_version)
        assets = read_lines(AssetInfo, self.root / "assets.jsonl", "assets.jsonl", as_now)
        return {asset.id: asset for asset in assets}
