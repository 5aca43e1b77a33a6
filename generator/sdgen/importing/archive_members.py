"""Members of a zip or a tar, one after another, read with bounded memory.

``tarfile`` takes a damaged header for the end and reads long names and pax headers of any length
into memory, so only its reader of single headers is used here. ``zipfile`` is handed a file that
reads no directory of any length.
"""

from __future__ import annotations

import bz2
import errno
import gzip
import io
import lzma
import stat
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import BinaryIO

from sdgen.files import kind_of

PIECE = 1 << 18
BLOCK = tarfile.BLOCKSIZE
#: Long names and pax headers of a tar, the directory of a zip (20,000 members take 2 MB), and the
#: dictionary of an xz (its strongest setting takes 64 MB).
MAX_HEADER_BYTES = 1 << 16
MAX_DIRECTORY_BYTES = 8_000_000
XZ_MEMORY_BYTES = 128_000_000

#: What unpacking damaged bytes raises.
_DAMAGED = (
    gzip.BadGzipFile,
    lzma.LZMAError,
    zlib.error,
    zipfile.BadZipFile,
    # What zipfile lets through: offsets and versions that make no sense.
    ValueError,
    OverflowError,
    NotImplementedError,
    struct.error,
)
_LONG_NAME, _LONG_LINK = tarfile.GNUTYPE_LONGNAME, tarfile.GNUTYPE_LONGLINK
_PAX, _PAX_ALL = (tarfile.XHDTYPE, tarfile.SOLARIS_XHDTYPE), (tarfile.XGLTYPE,)
_TAR_KINDS = {
    tarfile.LNKTYPE: "is a hard link",
    tarfile.SYMTYPE: "is a symbolic link",
    tarfile.CHRTYPE: "is a device",
    tarfile.BLKTYPE: "is a device",
    tarfile.FIFOTYPE: "is a FIFO",
    tarfile.GNUTYPE_SPARSE: "is a sparse file",
}


class BadArchive(Exception):
    """Reading any further makes no sense: it is damaged, too large, or nothing we read."""


@dataclass(frozen=True)
class Member:
    """One entry, as its header has it: ``refused`` says why it may not be (a link), else empty.

    ``pieces`` reads the content piece by piece, before the next member is asked for.
    """

    name: str
    folder: bool
    size: int
    refused: str
    pieces: Callable[[], Iterator[bytes]]


def archive_kind(head: bytes) -> str:
    """``zip``, ``tar``, ``gzip``, ``bzip2``, ``xz``, or nothing we read, by the first 512 bytes."""
    if head.startswith((b"PK\x03\x04", b"PK\x05\x06")):
        return "zip"
    for kind, magic in (("gzip", b"\x1f\x8b"), ("bzip2", b"BZh"), ("xz", b"\xfd7zXZ\x00")):
        if head.startswith(magic):
            return kind
    return "tar" if _header(head) is not None else ""


def members_of(file: BinaryIO, kind: str, spend: Callable[[int], None]) -> Iterator[Member]:
    """Members of an archive of this kind; ``spend`` is told of all bytes that come out of it.

    Raises BadArchive when it is damaged, at the end too.
    """
    with _damage_in_words():
        if kind == "zip":
            yield from _zip_members(file, spend)
            return
        with _unpacked(file, kind) as stream:
            yield from _Tar(stream, spend).members()


@contextmanager
def _damage_in_words() -> Iterator[None]:
    try:
        yield
    except EOFError:
        raise BadArchive("ends too early: fetch it again") from None
    except _DAMAGED as error:
        raise BadArchive(f"is damaged ({error})") from None
    except OSError as error:
        # bzip2 has no error of its own; a zip may name a place before its beginning.
        if error.errno not in (None, errno.EINVAL):
            raise
        raise BadArchive(f"is damaged ({error})") from None


def _told(pieces: Iterator[bytes]) -> Iterator[bytes]:
    with _damage_in_words():
        yield from pieces


def _unpacked(file: BinaryIO, kind: str) -> BinaryIO | io.BufferedIOBase:
    """The bytes of a packed file, as they come."""
    if kind == "gzip":
        return gzip.GzipFile(fileobj=file, mode="rb")
    if kind == "bzip2":
        return bz2.BZ2File(file)
    return io.BufferedReader(_Xz(file), PIECE) if kind == "xz" else file


class _Xz(io.RawIOBase):
    """A reader of xz whose dictionary may not fill the memory (``LZMAFile`` has no such limit)."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._decoder = self._new()

    @staticmethod
    def _new() -> lzma.LZMADecompressor:
        return lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=XZ_MEMORY_BYTES)

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: object) -> int:
        view = memoryview(buffer)  # type: ignore[arg-type]
        while True:
            rest = b""
            if self._decoder.eof:  # pieces that several workers packed follow each other
                rest = (self._decoder.unused_data or self._file.read(PIECE)).lstrip(b"\0")
                if not rest:
                    return 0
                self._decoder = self._new()
            elif self._decoder.needs_input and not (rest := self._file.read(PIECE)):
                raise EOFError
            if out := self._decoder.decompress(rest, max_length=len(view)):
                view[: len(out)] = out
                return len(out)


class _Tar:
    """A tar read from its beginning to its end."""

    def __init__(self, stream: BinaryIO | io.BufferedIOBase, spend: Callable[[int], None]) -> None:
        self._stream = stream
        self._spend = spend

    def members(self) -> Iterator[Member]:
        """Its members, until its end mark; what is behind that is read and thrown away."""
        extra: dict[str, str] = {}
        first = True
        while any(block := self._block()):
            info = _header(block)
            if info is None:
                raise BadArchive("holds no tar" if first else "is damaged (a header of its tar)")
            first = False
            if info.type in (_LONG_NAME, _LONG_LINK, *_PAX, *_PAX_ALL):
                text = self._text(info.size)
                if info.type == _LONG_NAME:
                    extra["path"] = _decoded(text.rstrip(b"\0"))
                elif info.type in _PAX:
                    extra |= _pax(text)
                elif info.type in _PAX_ALL and _pax(text).keys() & {"path", "size"}:
                    raise BadArchive("names all its members alike (a global pax header)")
                continue
            yield from self._member(info, extra)
            extra = {}
        while piece := self._stream.read(PIECE):  # their check sum is at the end
            self._spend(len(piece))

    def _member(self, info: tarfile.TarInfo, extra: dict[str, str]) -> Iterator[Member]:
        size = info.size
        if "size" in extra:
            if not extra["size"].isdecimal() or len(extra["size"]) > 18:
                raise BadArchive("is damaged (a size in its pax header)")
            size = int(extra["size"])
        if size < 0:
            raise BadArchive("is damaged (a size below zero)")
        refused = _TAR_KINDS.get(info.type, "")
        if any(key.startswith("GNU.sparse") for key in extra):
            refused = _TAR_KINDS[tarfile.GNUTYPE_SPARSE]
        elif not refused and not (info.isreg() or info.isdir()):
            refused = "is no plain file"
        if info.islnk() or info.issym() or info.isdir() or info.isdev():
            size = 0  # whatever it says, nothing follows
        content = self._pieces(size)
        name = extra.get("path", info.name)
        yield Member(name, info.isdir(), size, refused, lambda: _told(content))
        for _ in content:  # what nobody wanted
            pass
        self._exactly(-size % BLOCK)

    def _pieces(self, size: int) -> Iterator[bytes]:
        while size:
            piece = self._stream.read(min(size, PIECE))
            if not piece:
                raise EOFError
            self._spend(len(piece))
            size -= len(piece)
            yield piece

    def _exactly(self, size: int) -> bytes:
        return b"".join(self._pieces(size))

    def _block(self) -> bytes:
        return self._exactly(BLOCK)

    def _text(self, size: int) -> bytes:
        if not 0 <= size <= MAX_HEADER_BYTES:
            raise BadArchive(f"has a header of more than {MAX_HEADER_BYTES // 1024} kB")
        text = self._exactly(size)
        self._exactly(-size % BLOCK)
        return text


def _header(block: bytes) -> tarfile.TarInfo | None:
    """The header in these 512 bytes; None when they are none."""
    try:
        return tarfile.TarInfo.frombuf(block, "utf-8", "surrogateescape")
    except (tarfile.HeaderError, ValueError):
        return None


def _pax(text: bytes) -> dict[str, str]:
    """``{"path": ...}`` of a pax header: records ``LENGTH KEY=VALUE\\n``."""
    out = {}
    while text.strip(b"\0"):
        length, _, _ = text.partition(b" ")
        size = int(length) if length.isdigit() and len(length) < 8 else 0
        key, equals, value = text[len(length) + 1 : size].partition(b"=")
        if not len(length) + 4 <= size <= len(text) or not equals or not value.endswith(b"\n"):
            raise BadArchive("is damaged (a pax header)")
        out[_decoded(key)] = _decoded(value[:-1])
        text = text[size:]
    return out


def _decoded(raw: bytes) -> str:
    return raw.decode("utf-8", "surrogateescape")


class _Bounded:
    """A zip's file, of which no more is read at once than a directory may take."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self.seek, self.tell, self.seekable = file.seek, file.tell, file.seekable

    def read(self, size: int = -1) -> bytes:
        if size > MAX_DIRECTORY_BYTES:
            raise BadArchive(f"has a directory of more than {MAX_DIRECTORY_BYTES // 1_000_000} MB")
        return self._file.read(size)


def _zip_members(file: BinaryIO, spend: Callable[[int], None]) -> Iterator[Member]:
    try:
        archive = zipfile.ZipFile(_Bounded(file))
    except UnicodeDecodeError:
        raise BadArchive("a member's name is no UTF-8") from None
    except zipfile.BadZipFile as error:
        raise BadArchive(f"ends too early or is damaged ({error}): fetch it again") from None
    infos = archive.infolist()
    if any(info.flag_bits & 1 for info in infos):
        raise BadArchive("is encrypted: unpack it by hand")
    for info in infos:
        mode = info.external_attr >> 16
        refused = ""
        if stat.S_IFMT(mode) not in (0, stat.S_IFREG, stat.S_IFDIR):
            refused = f"is {kind_of(mode)}"
        elif info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            # The others may take any memory.
            refused = f"is packed by method {info.compress_type}: pack it anew, by deflate"

        def pieces(info: zipfile.ZipInfo = info) -> Iterator[bytes]:
            with _damage_in_words(), archive.open(info) as content:
                while piece := content.read(PIECE):
                    spend(len(piece))
                    yield piece

        name = _zip_name(info)
        yield Member(name, name.endswith("/"), info.file_size, refused, pieces)


def _zip_name(info: zipfile.ZipInfo) -> str:
    """Its name as it is in the file; what is not marked as UTF-8 mostly is, all the same."""
    if info.flag_bits & 0x800 or info.orig_filename.isascii():
        return info.orig_filename
    return _decoded(info.orig_filename.encode("cp437"))
