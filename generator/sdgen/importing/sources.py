"""The sources that scans are fetched from: addresses and licences, from ``addresses.yaml``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal
from urllib.parse import urlsplit

from pydantic import Field

from sdgen.errors import InputError, UsageError
from sdgen.scene import Record
from sdgen.strict import no_mapping, read
from sdgen.yaml_source import read_yaml

_FILE = Path(__file__).with_name("addresses.yaml")
Text = Annotated[str, Field(min_length=1, max_length=1000)]


class Source(Record):
    """One source; ``addresses.yaml`` says what each field means.

    ``licence`` is its SPDX identifier, as a model's record has it; ``asks`` what it asks, in words.
    Without a ``base`` nothing can be fetched: ``by_hand`` says what to do.
    """

    id: Text
    title: Text
    homepage: Text
    licence: Text
    licence_name: Text
    licence_url: str = ""
    non_commercial: bool
    asks: tuple[Text, ...]
    note: str = ""
    attribution: Text
    base: str = ""
    listing: Literal["objects_json", "fuel_pages", "hub_tree"] | None = None
    list_path: str = ""
    model_paths: tuple[Text, ...] = ()
    checksum: Literal["s3_etag"] | None = None
    redirects: tuple[Text, ...] = ()
    by_hand: str = ""

    def at(self, base_url: str) -> Source:
        """The same source on a mirror, laid out alike. Raises UsageError for no http(s) address."""
        try:
            parts = urlsplit(base_url)
            known = parts.scheme in ("http", "https") and parts.hostname and parts.port != 0
        except ValueError:
            known = False
        if not known or parts.query or parts.fragment or not base_url.isprintable():
            raise UsageError(f"--base-url {base_url!r}: expected http://HOST or https://HOST/PATH")
        if "@" in parts.netloc:
            raise UsageError("--base-url: names and passwords are not sent; leave them out")
        return self.model_copy(update={"base": base_url.rstrip("/")})


def load_sources(path: Path = _FILE) -> dict[str, Source]:
    """All sources by id, in the file's order. Raises InputError with every problem, located."""
    source = read_yaml(path, path.name)
    value = source.value.get("sources") if isinstance(source.value, dict) else None
    found: list[Source] = []
    if isinstance(value, list):
        for index, item in enumerate(value):
            record = read(source, ("sources", index), item, Source)
            if record is None:
                continue
            found.append(record)
            if bool(record.base) == bool(record.by_hand):
                source.problem(("sources", index), "expected either 'base' or 'by_hand'")
            if bool(record.base) != bool(record.listing and record.model_paths):
                source.problem(("sources", index), "'base', 'listing', 'model_paths': all or none")
    elif not source.noted:
        source.problem((), no_mapping(source.value))
    if source.noted:
        raise InputError(source.problems)
    return {record.id: record for record in found}
