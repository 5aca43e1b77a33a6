"""What strangers send is unpacked whole and inside its folder, or not at all."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import os
import random  # noqa: TID251
import struct
import tarfile
import warnings
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.errors import AssetError, InputError
from sdgen.importing import archive_members
from sdgen.importing.archives import Limits, is_archive, unpack

from tests.importing.evil_archives import (
    DEVICE,
    FIFO,
    LINK,
    SOCKET,
    entry,
    everything_below,
    tar_bytes,
    tar_of,
    zip_of,
)

FILES = {
    "mug/model.obj": b"v 0 0 0\n" * 100,
    "mug/textures/blue one.png": bytes(range(256)) * 40,
    "mug/Überzug.txt": b"",
}
PACKED: dict[str, Callable[[], bytes]] = {
    "zip": lambda: zip_of(FILES),
    "tar": lambda: tar_of(FILES),
    "tar.gz": lambda: gzip.compress(tar_of(FILES)),
    "tar.bz2": lambda: bz2.compress(tar_of(FILES)),
    "tar.xz": lambda: lzma.compress(tar_of(FILES)),
}
SMALL = Limits(members=50, member_bytes=2_000_000, total_bytes=3_000_000, ratio_from=10**9)


def send(tmp_path: Path, raw: bytes) -> Path:
    """What a stranger sent; its name says nothing."""
    path = tmp_path / "sent"
    path.write_bytes(raw)
    return path


def refused(tmp_path: Path, raw: bytes, limits: Limits = SMALL) -> list[str]:
    """Problems of an archive, without its name; nothing of it is left anywhere."""
    path, before = send(tmp_path, raw), everything_below(tmp_path) | {"sent", "in"}
    with pytest.raises(AssetError) as caught:
        unpack(path, tmp_path / "in" / "out", limits, "sent.zip")
    assert everything_below(tmp_path) == before
    assert all(line.startswith("sent.zip: ") for line in caught.value.problems)
    return [line.removeprefix("sent.zip: ") for line in caught.value.problems]


@pytest.fixture(autouse=True)
def _nothing_beside(tmp_path: Path) -> Iterator[None]:
    """Whatever is sent, nothing outside the folder changes."""
    outside = tmp_path.parent / f"{tmp_path.name}-outside"
    outside.write_text("mine")
    yield
    assert not [name for name in os.listdir(tmp_path.parent) if name in ("evil", "mine")]
    assert outside.read_text() == "mine"


@pytest.mark.parametrize("kind", PACKED)
def test_it_is_unpacked_whatever_its_name(kind: str, tmp_path: Path) -> None:
    path = send(tmp_path, PACKED[kind]())
    assert is_archive(path)
    out = unpack(path, tmp_path / "deep" / "out")
    found = {str(p.relative_to(out)): p.read_bytes() for p in out.rglob("*") if p.is_file()}
    assert found == FILES
    assert os.listdir(tmp_path / "deep") == ["out"]


def test_real_tools_are_understood(tmp_path: Path) -> None:
    # Folders of their own, "./" before names, names of more than 100 bytes in both forms.
    deep = f"{'a' * 90}/{'b' * 90}.obj"
    for number, form in enumerate((tarfile.GNU_FORMAT, tarfile.PAX_FORMAT, tarfile.USTAR_FORMAT)):
        out = io.BytesIO()
        with tarfile.open(fileobj=out, mode="w:gz", format=form) as archive:
            for name in (".", "./mug"):
                archive.addfile(entry(name, tarfile.DIRTYPE))
            member = entry(f"./mug/{deep}")
            member.size = 700
            archive.addfile(member, io.BytesIO(b"x" * 700))
        folder = unpack(send(tmp_path, out.getvalue()), tmp_path / str(number))
        assert (folder / "mug" / deep).read_bytes() == b"x" * 700


def test_several_packed_streams_are_one(tmp_path: Path) -> None:
    raw = tar_of(FILES)
    for number, pack in enumerate((gzip.compress, bz2.compress, lzma.compress)):
        out = unpack(send(tmp_path, pack(raw[:1000]) + pack(raw[1000:])), tmp_path / str(number))
        assert (out / "mug/model.obj").read_bytes() == FILES["mug/model.obj"]


def test_no_file_of_it_can_be_run(tmp_path: Path) -> None:
    member = entry("run.sh")
    member.mode = 0o6777
    out = unpack(send(tmp_path, tar_bytes([member])), tmp_path / "out")
    assert (out / "run.sh").stat().st_mode & 0o7111 == 0


@pytest.mark.parametrize(
    ("name", "problem"),
    [
        ("../evil", "climbs out of its folder ('..')"),
        ("mug/../../evil", "climbs out of its folder ('..')"),
        ("/etc/evil", "is an absolute path"),
        ("//host/evil", "is an absolute path"),
        ("C:/evil", "names a drive"),
        ("mug/c:evil", "names a drive"),
        ("mug\\..\\evil", "its name has a backslash"),
        ("mug/new\nline", "its name has a control character"),
        ("x" * 256, "has a name of more than 255 bytes"),
        ("ü" * 128, "has a name of more than 255 bytes"),
        ("/".join(["long" * 25] * 12), "has a path of more than 1024 bytes"),
        ("a/" * 33 + "b", "is more than 32 folders deep"),
    ],
)
@pytest.mark.parametrize("make", [zip_of, tar_of])
def test_a_name_that_leaves_its_folder_is_refused(
    make: Callable[[dict[str, bytes]], bytes], name: str, problem: str, tmp_path: Path
) -> None:
    (told,) = refused(tmp_path, make({"mug.obj": b"v", name: b"evil"}))
    assert told.endswith(f": {problem}")
    assert told.startswith(name[:20].replace("\n", "\\n"))
    assert "\n" not in told
    assert len(told) < 200


def test_a_name_with_a_nul_is_refused(tmp_path: Path) -> None:
    raw = zip_of({"mug.obj#.sh": b"v"}).replace(b"mug.obj#.sh", b"mug.obj\0.sh")
    assert refused(tmp_path, raw) == ["mug.obj\\x00.sh: its name has a control character"]


def test_names_that_are_no_utf8_are_refused(tmp_path: Path) -> None:
    told = refused(tmp_path, tar_of({"caf?": b"v"}).replace(b"caf?", b"caf\xe9", 1))
    assert len(told) == 1  # its check sum is wrong now
    member = entry("caf\udce9")
    raw = member.tobuf(tarfile.GNU_FORMAT, "utf-8", "surrogateescape") + b"\0" * 1024
    assert refused(tmp_path, raw) == ["caf\\udce9: its name is no UTF-8"]
    latin = zip_of({"caf?": b"v"}).replace(b"caf?", b"caf\xe9")
    assert refused(tmp_path, latin) == ["caf\\udce9: its name is no UTF-8"]


def test_a_zip_whose_names_are_utf8_without_saying_so_is_read(tmp_path: Path) -> None:
    raw = zip_of({"caf??": b"v"}).replace(b"caf??", "café".encode())
    assert (unpack(send(tmp_path, raw), tmp_path / "out") / "café").read_bytes() == b"v"


@pytest.mark.parametrize(
    ("kind", "problem"),
    [
        (tarfile.SYMTYPE, "is a symbolic link"),
        (tarfile.LNKTYPE, "is a hard link"),
        (tarfile.CHRTYPE, "is a device"),
        (tarfile.BLKTYPE, "is a device"),
        (tarfile.FIFOTYPE, "is a FIFO"),
        (tarfile.GNUTYPE_SPARSE, "is a sparse file"),
        (b"V", "is no plain file"),
    ],
)
def test_a_tar_holds_files_and_folders_only(kind: bytes, problem: str, tmp_path: Path) -> None:
    raw = tar_bytes([entry("ok"), entry("odd", kind, "../outside"), entry("odd/through")])
    assert refused(tmp_path, raw) == [f"odd: {problem}"]


@pytest.mark.parametrize(
    ("mode", "problem"),
    [
        (LINK, "is a symbolic link"),
        (DEVICE, "is a device"),
        (FIFO, "is a FIFO"),
        (SOCKET, "is a socket"),
    ],
)
def test_a_zip_holds_files_and_folders_only(mode: int, problem: str, tmp_path: Path) -> None:
    raw = zip_of({"ok": b"", "odd": b"../outside"}, {"odd": mode})
    assert refused(tmp_path, raw) == [f"odd: {problem}"]


@pytest.mark.parametrize(
    ("first", "second", "problem"),
    [
        ("a/mug", "a/mug", "comes twice"),
        ("a/mug", "a/Mug", "differs from 'a/mug' only in capitals or accents' form"),
        ("a/mug", "A/jug", "differs from 'a' only in capitals or accents' form"),
        ("é", "e\u0301", "differs from 'é' only in capitals or accents' form"),
        ("straße", "STRASSE", "differs from 'straße' only in capitals or accents' form"),
        ("mug", "mug/model", "is both a file and a folder"),
        ("mug/model", "mug", "is both a file and a folder"),
    ],
)
@pytest.mark.parametrize("make", [zip_of, tar_of])
def test_names_that_cannot_lie_together_are_refused(
    make: Callable[..., bytes], first: str, second: str, problem: str, tmp_path: Path
) -> None:
    if first == second:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            out = io.BytesIO()
            with zipfile.ZipFile(out, "w") as archive:
                archive.writestr(first, b"1")
                archive.writestr(second, b"2")
        raw = out.getvalue() if make is zip_of else tar_bytes([entry(first), entry(second)])
    else:
        raw = make({first: b"1", second: b"2"})
    assert refused(tmp_path, raw) == [f"{second}: {problem}"]


@pytest.mark.parametrize("pack", [lambda raw: raw, gzip.compress, bz2.compress, lzma.compress])
def test_all_problems_are_told_at_once(pack: Callable[[bytes], bytes], tmp_path: Path) -> None:
    raw = tar_bytes([entry("/a"), entry("b"), entry("../c"), entry("d", tarfile.FIFOTYPE)])
    told = refused(tmp_path, pack(raw))
    assert [line.split(":")[0] for line in told] == ["/a", "../c", "d"]


def test_sizes_are_counted_as_they_come(tmp_path: Path) -> None:
    big = b"\0" * 2_000_001
    assert refused(tmp_path, zip_of({"a": big})) == ["a: is larger than 2 MB"]
    assert refused(tmp_path, gzip.compress(tar_of({"a": big}))) == ["a: is larger than 2 MB"]
    three = dict.fromkeys("abc", b"\x00" * 1500000)
    for raw in (zip_of(three), tar_of(three), lzma.compress(tar_of(three))):
        (told,) = refused(tmp_path, raw)
        assert told.endswith("unpacks to more than 3 MB")
    told = refused(tmp_path, tar_of({str(number): b"" for number in range(51)}))
    assert told == ["holds more than 50 members"]


def test_a_bomb_is_told_by_its_ratio(tmp_path: Path) -> None:
    limits = Limits(ratio_from=5_000_000)
    bomb = b"\0" * 20_000_000
    for raw in (zip_of({"a": bomb}), bz2.compress(tar_of({"a": bomb}))):
        (told,) = refused(tmp_path, raw, limits)
        assert told == "a: unpacks to more than 100 times its size: a bomb"
    # Behind the end of the tar, where no member is.
    (told,) = refused(tmp_path, gzip.compress(tar_of({"a": b"v"}) + bomb), limits)
    assert told == "unpacks to more than 100 times its size: a bomb"
    dense = random.Random(1).randbytes(6_000_000)
    unpack(send(tmp_path, gzip.compress(tar_of({"a": dense}))), tmp_path / "out", limits)


def test_a_zip_that_says_it_is_small_is_not_believed(tmp_path: Path) -> None:
    raw = bytearray(zip_of({"a": b"\0" * 1_000_000}))
    directory = raw.index(b"PK\x01\x02")
    raw[directory + 24 : directory + 28] = struct.pack("<I", 10)
    (told,) = refused(tmp_path, bytes(raw))
    assert told.startswith("a: is damaged")


def test_a_zip_that_names_places_outside_itself_is_damaged(tmp_path: Path) -> None:
    raw = zip_of({"a": b"v"})
    for magic, field in ((b"PK\x05\x06", 16), (b"PK\x01\x02", 42), (b"PK\x05\x06", 12)):
        for value in (0xFFFFFFF0, 0x7FFFFFFF, 10**6, 1):
            hurt = bytearray(raw)
            at = hurt.rindex(magic) + field
            hurt[at : at + 4] = struct.pack("<I", value)
            assert "is damaged" in refused(tmp_path, bytes(hurt))[-1]


def test_a_header_takes_no_memory_of_its_choice(tmp_path: Path) -> None:
    for kind in (tarfile.GNUTYPE_LONGNAME, tarfile.XHDTYPE, tarfile.XGLTYPE):
        member = entry("long", kind)
        member.size = 1 << 40
        assert refused(tmp_path, member.tobuf(tarfile.GNU_FORMAT) + b"\0" * 2048) == [
            "has a header of more than 64 kB"
        ]
    whole = zip_of({"a": b""})
    raw = bytearray(whole[:30] + b"\0" * 9_000_000 + whole)
    end = raw.rindex(b"PK\x05\x06")
    raw[end + 12 : end + 16] = struct.pack("<I", 8_500_000)
    assert refused(tmp_path, bytes(raw)) == ["has a directory of more than 8 MB"]


def test_an_xz_takes_no_memory_of_its_choice(tmp_path: Path) -> None:
    filters = [{"id": lzma.FILTER_LZMA2, "dict_size": 1 << 28}]
    packer = lzma.LZMACompressor(lzma.FORMAT_XZ, filters=filters)
    raw = packer.compress(tar_of(FILES)) + packer.flush()
    (told,) = refused(tmp_path, raw)
    assert told.startswith("is damaged (Memory usage limit")


def test_a_bomb_in_pax_headers_counts(tmp_path: Path) -> None:
    record = b"60000 comment=" + b"x" * (60000 - 15) + b"\n"
    header = entry("h", tarfile.XHDTYPE)
    header.size = len(record)
    one = header.tobuf() + record + b"\0" * (-len(record) % 512)
    (told,) = refused(tmp_path, gzip.compress(one * 100 + tar_of({"a": b""})))
    assert told == "unpacks to more than 3 MB"


def test_a_pax_header_that_renames_is_checked_too(tmp_path: Path) -> None:
    def renamed(record: bytes, kind: bytes = tarfile.XHDTYPE) -> bytes:
        header = entry("h", kind)
        header.size = len(record)
        return header.tobuf() + record + b"\0" * (-len(record) % 512) + tar_of({"a": b"v"})

    assert refused(tmp_path, renamed(b"16 path=../evil\n")) == [
        "../evil: climbs out of its folder ('..')"
    ]
    (told,) = refused(tmp_path, renamed(b"16 path=../evil\n", tarfile.XGLTYPE))
    assert "global pax header" in told
    for bad in (b"99 path=a\n", b"path=a\n", b"11 size=-1\n", b"13 size=1e99\n"):
        assert "is damaged" in refused(tmp_path, renamed(bad))[-1]
    assert refused(tmp_path, renamed(b"22 GNU.sparse.major=1\n")) == ["a: is a sparse file"]


def test_an_encrypted_zip_is_one_clear_error(tmp_path: Path) -> None:
    raw = bytearray(zip_of({"a": b"v", "b": b"w"}))
    for magic, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = -1
        while (at := raw.find(magic, at + 1)) >= 0:
            raw[at + offset] |= 1
    assert refused(tmp_path, bytes(raw)) == ["is encrypted: unpack it by hand"]


def test_a_zip_packed_in_another_way_says_so(tmp_path: Path) -> None:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("a", b"v" * 100)
    assert refused(tmp_path, out.getvalue()) == [
        "a: is packed by method 14: pack it anew, by deflate"
    ]


@pytest.mark.parametrize("kind", PACKED)
def test_a_truncated_archive_is_one_clear_error(kind: str, tmp_path: Path) -> None:
    whole = PACKED[kind]()
    for part in (0.3, 0.6, 0.9):
        cut = whole[: int(len(whole) * part)]
        if kind == "tar" and part == 0.9:
            cut = whole.rstrip(b"\0")  # the mark of its end is all that is missing
        (told,) = refused(tmp_path, cut)
        assert any(word in told for word in ("ends too early", "is damaged")), told


@pytest.mark.parametrize("kind", ["zip", "tar.gz", "tar.bz2", "tar.xz"])
def test_damage_is_found_wherever_it_is(kind: str, tmp_path: Path) -> None:
    whole = PACKED[kind]()
    silent = 0
    for at in range(0, len(whole), max(1, len(whole) // 60)):
        hurt = bytearray(whole)
        hurt[at] ^= 0xFF
        try:
            out = unpack(send(tmp_path, bytes(hurt)), tmp_path / f"out{at}")
        except AssetError:
            continue
        # Headers hold times and the like; contents never change unseen.
        got = {str(p.relative_to(out)): p.read_bytes() for p in out.rglob("*") if p.is_file()}
        assert set(got.values()) <= set(FILES.values())
        silent += 1
    assert silent < 30


@pytest.mark.parametrize(
    "raw", [b"", b"hello", b"\0" * 2048, b"PK", b"\x1f\x8b", b"BZh9", b"\xfd7zXZ\0", b"Rar!\x1a\7"]
)
def test_what_is_no_archive_says_so(raw: bytes, tmp_path: Path) -> None:
    (told,) = refused(tmp_path, raw)
    assert any(words in told for words in ("is no zip and no tar", "ends too early", "is damaged"))


def test_a_packed_file_that_is_no_tar_says_so(tmp_path: Path) -> None:
    assert refused(tmp_path, gzip.compress(b"hello" * 500)) == ["holds no tar"]


def test_an_empty_archive_says_so(tmp_path: Path) -> None:
    assert refused(tmp_path, zip_of({})) == ["holds no file"]
    assert refused(tmp_path, tar_bytes([entry("a", tarfile.DIRTYPE)])) == ["holds no file"]


def test_an_archive_within_stays_closed(tmp_path: Path) -> None:
    inner = zip_of({"mug.obj": b"v"})
    out = unpack(send(tmp_path, tar_of({"a/mug.zip": inner})), tmp_path / "out")
    assert (out / "a/mug.zip").read_bytes() == inner
    assert is_archive(out / "a/mug.zip")
    assert (unpack(out / "a/mug.zip", out / "mug") / "mug.obj").read_bytes() == b"v"


def test_what_is_there_already_is_left_alone(tmp_path: Path) -> None:
    path = send(tmp_path, zip_of(FILES))
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine").write_text("mine")
    (tmp_path / "empty").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "empty")
    for name in ("full", "link", "sent"):
        with pytest.raises(AssetError, match="is there already"):
            unpack(path, tmp_path / name)
    assert os.listdir(tmp_path / "full") == ["mine"]
    assert unpack(path, tmp_path / "empty") == tmp_path / "empty"


def test_what_is_no_file_is_no_archive(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for name in ("pipe", "missing", "."):
        assert not is_archive(tmp_path / name)
        with pytest.raises(InputError):
            unpack(tmp_path / name, tmp_path / "out")


def test_memory_stays_bounded(tmp_path: Path) -> None:
    import tracemalloc

    # The dictionary of xz takes 8 MB, the block of bzip2 4 MB.
    raw = tar_of({"a": b"\0" * 50_000_000})
    for number, pack in enumerate((gzip.compress, bz2.compress, lzma.compress)):
        path = send(tmp_path, pack(raw))
        tracemalloc.start()
        unpack(path, tmp_path / str(number), Limits(ratio=10**9))
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert peak < 12_000_000


NAMES = st.one_of(
    st.text(max_size=30).filter(lambda name: "\0" not in name),
    st.lists(
        st.sampled_from(
            ["..", ".", "", "a", "A", "b", "mug", "C:", "é", "e\u0301", " ", "x" * 200]
        ),
        max_size=6,
    ).map("/".join),
)


@given(st.lists(NAMES, min_size=1, max_size=6, unique=True), st.booleans())
def test_whatever_names_there_are_nothing_is_written_elsewhere(
    tmp_path_factory: pytest.TempPathFactory, names: list[str], as_zip: bool
) -> None:
    tmp_path = tmp_path_factory.mktemp("names")
    try:
        contents = {name: str(number).encode() for number, name in enumerate(names)}
        raw = zip_of(contents) if as_zip else tar_of(contents)
    except (UnicodeEncodeError, ValueError):
        return  # nobody can send these
    path = send(tmp_path, raw)
    try:
        out = unpack(path, tmp_path / "out")
    except AssetError as error:
        told = str(error)
    else:
        told = ""
    if told:
        assert os.listdir(tmp_path) == ["sent"]
        assert told.replace("\n", "").isprintable()
        return
    assert set(os.listdir(tmp_path)) == {"sent", "out"}
    found = sorted(p.read_bytes() for p in out.rglob("*") if p.is_file())
    assert len(found) == sum(not (as_zip and name.endswith("/")) for name in names)
    assert all(p.resolve().is_relative_to(out.resolve()) for p in out.rglob("*"))


@given(st.binary(max_size=2000), st.sampled_from([b"", b"PK\x03\x04", b"\x1f\x8b\x08", b"BZh9"]))
def test_noise_is_a_clear_error(
    tmp_path_factory: pytest.TempPathFactory, noise: bytes, head: bytes
) -> None:
    tmp_path = tmp_path_factory.mktemp("noise")
    with pytest.raises(AssetError):
        unpack(send(tmp_path, head + noise), tmp_path / "out")
    assert os.listdir(tmp_path) == ["sent"]


@given(st.data())
def test_a_tar_hurt_anywhere_is_a_clear_error_or_whole(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    raw = bytearray(tar_of({"a/b": b"1" * 600, "c": b"2"}))
    for _ in range(data.draw(st.integers(1, 4))):
        raw[data.draw(st.integers(0, len(raw) - 1))] = data.draw(st.integers(0, 255))
    tmp_path = tmp_path_factory.mktemp("hurt")
    try:
        out = unpack(send(tmp_path, bytes(raw)), tmp_path / "out")
    except AssetError:
        assert os.listdir(tmp_path) == ["sent"]
    else:
        assert sum(p.is_file() for p in out.rglob("*")) == 2


def test_the_limits_stated_are_those_of_real_models() -> None:
    limits = Limits()
    assert (limits.members, limits.member_bytes, limits.total_bytes) == (
        20_000,
        3 * 10**8,
        4 * 10**9,
    )
    assert archive_members.MAX_HEADER_BYTES <= 1 << 20
