"""XML of strangers: read without entities, which can unpack to anything or fetch files."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from xml.parsers import expat

from sdgen.errors import AssetError

#: A wrapper of a model takes kilobytes; a furnished home a few megabytes.
MAX_BYTES = 50_000_000
_MOST_DEEP = 200


def refuse_entities(raw: bytes, shown: str) -> None:
    """Raise AssetError, located, for XML that declares entities, is nested too deeply or broken."""
    parser = expat.ParserCreate()
    depth = 0

    def entity(*_: object) -> None:
        raise _Refused("declares entities, which are not read")

    def start(*_: object) -> None:
        nonlocal depth
        depth += 1
        if depth > _MOST_DEEP:
            raise _Refused("is nested too deeply")

    def end(*_: object) -> None:
        nonlocal depth
        depth -= 1

    parser.EntityDeclHandler = entity
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    try:
        parser.Parse(raw, True)
    except _Refused as error:
        raise AssetError([f"{shown}:{parser.CurrentLineNumber}: {error}"]) from None
    except expat.ExpatError as error:
        text = expat.errors.messages.get(error.code, "cannot be read")
        raise AssetError([f"{shown}:{error.lineno}: not valid XML: {text}"]) from None
    except (ValueError, LookupError) as error:
        raise AssetError([f"{shown}: not valid XML: {error}"]) from None


def parse_xml(raw: bytes, shown: str, max_bytes: int = MAX_BYTES) -> ElementTree.Element:
    """The root element. Raises AssetError, located, for what is no plain XML."""
    if len(raw) > max_bytes:
        raise AssetError([f"{shown}: is larger than {max_bytes // 1_000_000} MB"])
    refuse_entities(raw, shown)
    try:
        return ElementTree.fromstring(raw)
    except (ElementTree.ParseError, ValueError) as error:  # prefixes of no namespace
        raise AssetError([f"{shown}: not valid XML: {error}"]) from None


class _Refused(Exception):
    """What stops the parser."""
