"""One file from a source: resumed where it broke off, counted, and its checksum held to.

What has come so far is ``KEY.part`` beside ``KEY.json``, which says of which version of which file
it is; KEY is a digest of the address. Nothing a server says decides where we write.
"""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.output_file import write_output
from sdgen.errors import AssetError, InputError, SdgenError, naming
from sdgen.files import read_plain
from sdgen.importing.client import Answer, Client, TryAgain

#: The largest file of the sources known has a tenth of it.
MAX_FILE_BYTES = 2_000_000_000
#: Left free on the disk.
SPARE_BYTES = 50_000_000


@dataclass(frozen=True)
class Wanted:
    """A file: its address, and what its source says of it where it does.

    ``digest`` is ``(algorithm, hex)``: sha256, or git (SHA-1 of a git object). ``etag_is_md5`` says
    that the server's ETag is a digest, where it has the form of one.
    """

    address: str
    size: int | None = None
    digest: tuple[str, str] | None = None
    etag_is_md5: bool = False


@dataclass(frozen=True)
class Got:
    """A file that has come whole: where it is for now, and what it is."""

    path: Path
    address: str
    bytes: int
    sha256: str
    validator: str

    def discard(self) -> None:
        """Take it away, once it is moved or unpacked, or good for nothing."""
        self.path.unlink(missing_ok=True)
        self.path.with_suffix(".json").unlink(missing_ok=True)


@dataclass(frozen=True)
class _Begun:
    """Of which version of the file its part is; ``total`` is None where the server did not say."""

    validator: str
    total: int | None


def download(client: Client, wanted: Wanted, parts: Path) -> Got:
    """Fetch a file into the folder ``parts``, going on with what is there of it.

    Raises NotThere, or AssetError ``address: problem``; what has come stays for the next time.
    """
    key = hashlib.sha256(wanted.address.encode()).hexdigest()[:24]
    part = parts / f"{key}.part"
    return client.trying(wanted.address, lambda: _attempt(client, wanted, part))


def changed(client: Client, wanted: Wanted, validator: str, size: int) -> bool:
    """Whether the source has another version than the one with this validator and size."""

    def ask() -> bool:
        headers = {"If-None-Match": validator} if validator.startswith('"') else {}
        with client.get(wanted.address, headers) as answer:
            if answer.status == 304:
                return False
            # Some servers answer in full whatever one has; then nothing of it is read.
            if validator and answer.validator:
                return answer.validator != validator
            return answer.length is not None and answer.length != size

    return client.trying(wanted.address, ask)


def _attempt(client: Client, wanted: Wanted, part: Path) -> Got:
    begun = _begun(part, wanted.address)
    have = part.stat().st_size if begun else 0
    if begun is None or have != begun.total:
        headers = {}
        if begun and have:
            headers = {"Range": f"bytes={have}-", "If-Range": begun.validator}
        with client.get(wanted.address, headers) as answer:
            begun, have = _begin(answer, wanted, part, begun, have)
            have = _append(answer, wanted, part, have)
    elif wanted.digest is None and changed(client, wanted, begun.validator, have):
        _forget(part)  # it had come whole, and was not used before there was another version
        raise TryAgain("has changed meanwhile")
    if begun.total is not None and have != begun.total:
        raise TryAgain(f"broke off after {have} of {begun.total} bytes")
    return _verified(wanted, part, begun)


def _begin(
    answer: Answer, wanted: Wanted, part: Path, begun: _Begun | None, have: int
) -> tuple[_Begun, int]:
    """Where this answer's bytes belong: behind the ``have`` that are there, or at the start."""
    if answer.status == 206 and begun is not None:
        total = _range_from(answer.header("Content-Range"), have)
        if total is not None and begun.total in (None, total):
            return _Begun(begun.validator, total), have
    if answer.status != 200:  # what is there fits no version of the file
        _forget(part)
        raise TryAgain("could not be resumed")
    begun = _Begun(answer.validator, answer.length)
    _check_size(wanted, begun.total, part)
    _forget(part)
    written = {"address": wanted.address, "validator": begun.validator, "total": begun.total}
    write_output(part.with_suffix(".json"), json.dumps(written).encode())
    return begun, 0


def _append(answer: Answer, wanted: Wanted, part: Path, have: int) -> int:
    most = wanted.size if wanted.size is not None else MAX_FILE_BYTES
    with naming(part), part.open("ab" if have else "wb") as file:
        for piece in answer.pieces():
            have += len(piece)
            if have > most:
                break
            file.write(piece)
    if have > most:
        _forget(part)
        raise AssetError([f"{wanted.address}: is larger than {_megabytes(most)}"])
    return have


def _check_size(wanted: Wanted, total: int | None, part: Path) -> None:
    if total is None:
        return
    if total > MAX_FILE_BYTES:
        limit = _megabytes(MAX_FILE_BYTES)
        raise AssetError([f"{wanted.address}: has {_megabytes(total)}, more than {limit}"])
    if wanted.size is not None and total != wanted.size:
        raise AssetError(
            [f"{wanted.address}: has {total} bytes, its list says {wanted.size}; try again later"]
        )
    free = shutil.disk_usage(part.parent).free
    if total + SPARE_BYTES > free:
        raise SdgenError(
            f"{part.parent}: {_megabytes(total)} needed, {_megabytes(free)} free; free some space"
        )


def _verified(wanted: Wanted, part: Path, begun: _Begun) -> Got:
    size = part.stat().st_size
    sums = {
        "sha256": hashlib.sha256(),
        "md5": hashlib.md5(usedforsecurity=False),
        "git": hashlib.sha1(b"blob %d\0" % size, usedforsecurity=False),
    }
    with part.open("rb") as file:
        while piece := file.read(1 << 20):
            for one in sums.values():
                one.update(piece)
    expected = [wanted.digest] if wanted.digest else []
    tag = re.fullmatch(r'"([0-9a-f]{32})"', begun.validator)
    if wanted.etag_is_md5 and tag:
        expected.append(("md5", tag[1]))
    if wanted.size is not None and size != wanted.size:
        _forget(part)
        raise TryAgain(f"has {size} bytes, expected {wanted.size}")
    if any(sums[name].hexdigest() != digest for name, digest in expected):
        _forget(part)
        raise TryAgain("its checksum is not the one its source states")
    return Got(part, wanted.address, size, sums["sha256"].hexdigest(), begun.validator)


def _begun(part: Path, address: str) -> _Begun | None:
    """What is known of the part; None when it is of no use."""
    try:
        value = json.loads(read_plain(part.with_suffix(".json"), "", 10_000, links=False))
        there = part.is_file() and not part.is_symlink()
    except (InputError, ValueError, OSError):
        value, there = None, False
    if there and isinstance(value, dict) and value.get("address") == address:
        validator, total = value.get("validator"), value.get("total")
        # Without a validator nobody can tell whether the rest is of the same version.
        fits = total is None or (isinstance(total, int) and part.stat().st_size <= total)
        if fits and isinstance(validator, str) and validator and validator.isprintable():
            return _Begun(validator, total)
    _forget(part)
    return None


def _forget(part: Path) -> None:
    part.unlink(missing_ok=True)
    part.with_suffix(".json").unlink(missing_ok=True)


def _range_from(text: str, start: int) -> int | None:
    """Bytes of the whole file, of a ``Content-Range`` that begins at ``start``; None for others."""
    match = re.fullmatch(r"bytes (\d{1,18})-(\d{1,18})/(\d{1,18})", text)
    if match is None or int(match[1]) != start or int(match[2]) + 1 != int(match[3]):
        return None
    return int(match[3])


def _megabytes(count: int) -> str:
    return f"{count / 1_000_000:.0f} MB" if count >= 1_000_000 else f"{count} bytes"
