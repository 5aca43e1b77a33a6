"""A file comes whole and is what its source says, or not at all; what has come is not lost."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path

import pytest
from sdgen.errors import AssetError, SdgenError, Stopped
from sdgen.importing import client as client_module
from sdgen.importing import download as download_module
from sdgen.importing.client import Answer, Client, NotThere
from sdgen.importing.download import Got, Wanted, changed, download

from tests.importing.file_server import Site

BODY = bytes(range(256)) * 2000
SHA256 = hashlib.sha256(BODY).hexdigest()


class Waits(list[float]):
    """How long it would have waited."""

    def __call__(self, seconds: float) -> None:
        self.append(seconds)


@pytest.fixture
def waits() -> Waits:
    return Waits()


@pytest.fixture
def client(site: Site, waits: Waits) -> Client:
    return Client(site.base, timeout_s=5.0, attempts=4, wait=waits)


def get(client: Client, folder: Path, path: str = "/a.tgz", **known: object) -> Got:
    return download(client, Wanted(f"{client.base}{path}", **known), folder)  # type: ignore[arg-type]


def refused(client: Client, folder: Path, path: str = "/a.tgz", **known: object) -> str:
    """The one problem, without the address; no part is left that could pass for a file."""
    with pytest.raises(AssetError) as caught:
        get(client, folder, path, **known)
    (problem,) = caught.value.problems
    start = f"{client.base}{path}: "
    assert problem.startswith(start)
    return problem.removeprefix(start)


def ranges_asked(site: Site) -> list[str]:
    return [headers.get("range", "") for _, headers in site.asked]


def test_a_file_comes_whole(site: Site, client: Client, tmp_path: Path, waits: Waits) -> None:
    site.put("/a.tgz", BODY)
    got = get(client, tmp_path)
    assert got.path.read_bytes() == BODY
    assert (got.bytes, got.sha256) == (len(BODY), SHA256)
    assert got.validator == site.files["/a.tgz"].tag()
    assert waits == []
    headers = site.asked[0][1]
    assert headers["user-agent"].startswith("sdgen/")
    assert headers["accept-encoding"] == "identity"
    got.discard()
    assert os.listdir(tmp_path) == []


def test_an_empty_file_comes_too(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", b"")
    assert get(client, tmp_path, size=0).bytes == 0


def test_the_servers_names_decide_nothing(site: Site, client: Client, tmp_path: Path) -> None:
    attach = {"Content-Disposition": 'attachment; filename="../../evil"'}
    site.put("/a/..%2f..%2fevil", BODY, headers=attach)
    got = get(client, tmp_path, "/a/..%2f..%2fevil")
    assert got.path.parent == tmp_path
    assert len(os.listdir(tmp_path)) == 2
    assert not (tmp_path.parent / "evil").exists()


def test_a_line_that_breaks_off_is_resumed(
    site: Site, client: Client, tmp_path: Path, waits: Waits
) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=3)
    assert get(client, tmp_path).sha256 == SHA256
    assert ranges_asked(site) == ["", "bytes=100000-", "bytes=200000-", "bytes=300000-"]
    assert {headers.get("if-range") for _, headers in site.asked[1:]} == {
        site.files["/a.tgz"].tag()
    }
    assert waits == [1.0, 2.0, 4.0]


def test_tries_are_counted_and_the_next_run_goes_on(
    site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY, cut_after=50_000, cuts=5)
    problem = refused(client, tmp_path)
    assert problem == f"broke off after 200000 of {len(BODY)} bytes (4 tries)"
    assert site.count("/a.tgz") == 4
    assert get(client, tmp_path).path.read_bytes() == BODY
    assert ranges_asked(site)[4:] == ["bytes=200000-", "bytes=250000-"]


def test_a_server_that_falls_silent_is_left(site: Site, tmp_path: Path, waits: Waits) -> None:
    site.put("/a.tgz", BODY, cut_after=1000, cuts=1, stall=True)
    client = Client(site.base, timeout_s=0.3, attempts=2, wait=waits)
    assert get(client, tmp_path).sha256 == SHA256
    assert len(waits) == 1


def test_a_server_without_ranges_starts_anew(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=2, ranges=False)
    assert get(client, tmp_path).path.read_bytes() == BODY
    assert len(ranges_asked(site)) == 3


def test_without_a_validator_it_starts_anew(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=2, etag=None)
    assert get(client, tmp_path).path.read_bytes() == BODY
    assert ranges_asked(site) == ["", "", ""]


@pytest.mark.parametrize("etag", [None, 'W/"weak"'])
def test_the_date_will_do_where_there_is_no_strong_etag(
    site: Site, client: Client, tmp_path: Path, etag: str | None
) -> None:
    date = {"Last-Modified": "Tue, 01 Sep 2020 10:00:00 GMT"}
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=1, etag=etag, headers=date)
    get(client, tmp_path)
    assert site.asked[1][1]["if-range"] == date["Last-Modified"]


def test_another_version_meanwhile_starts_anew(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=4)
    refused(client, tmp_path)
    site.put("/a.tgz", b"new" * 100_000)
    assert get(client, tmp_path).path.read_bytes() == b"new" * 100_000


def test_a_file_that_came_whole_and_was_not_used_is_not_fetched_again(
    site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY)
    get(client, tmp_path)
    assert get(client, tmp_path).sha256 == SHA256
    assert "if-none-match" in site.asked[1][1]
    site.put("/a.tgz", BODY[::-1])
    assert get(client, tmp_path).path.read_bytes() == BODY[::-1]


@pytest.mark.parametrize("told", ["bytes 0-9/10", "bytes 5-511999/512000", "bytes */512000", "x"])
def test_ranges_that_do_not_fit_are_not_glued(
    told: str, site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=1, says_range=told)
    assert get(client, tmp_path).path.read_bytes() == BODY
    assert ranges_asked(site) == ["", "bytes=100000-", ""]


@pytest.mark.parametrize("spoil", ["json", "longer", "link", "nonsense", "address"])
def test_a_part_that_is_not_ours_is_not_gone_on_with(
    spoil: str, site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY, cut_after=100_000, cuts=4)
    refused(client, tmp_path)
    (part,), (begun,) = tmp_path.glob("*.part"), tmp_path.glob("*.json")
    mine = tmp_path / "mine"
    mine.write_bytes(b"mine")
    known = json.loads(begun.read_text())
    if spoil == "json":
        begun.unlink()
    elif spoil == "longer":
        part.write_bytes(BODY * 2)
    elif spoil == "link":
        part.unlink()
        part.symlink_to(mine)
    elif spoil == "nonsense":
        begun.write_text(json.dumps({**known, "total": "12"}))
    else:
        begun.write_text(json.dumps({**known, "address": "http://elsewhere/"}))
    site.put("/a.tgz", BODY)
    assert get(client, tmp_path).path.read_bytes() == BODY
    assert mine.read_bytes() == b"mine"


def test_a_stopped_run_keeps_what_has_come(
    site: Site, client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    site.put("/a.tgz", BODY)
    pieces = Answer.pieces

    def stopped(self: Answer):  # type: ignore[no-untyped-def]
        for number, piece in enumerate(pieces(self)):
            if number == 3:
                raise Stopped(2)
            yield piece

    monkeypatch.setattr(Answer, "pieces", stopped)
    with pytest.raises(Stopped):
        get(client, tmp_path)
    (part,) = tmp_path.glob("*.part")
    have = part.stat().st_size
    assert 0 < have < len(BODY)
    monkeypatch.setattr(Answer, "pieces", pieces)
    assert get(client, tmp_path).sha256 == SHA256
    assert ranges_asked(site) == ["", f"bytes={have}-"]


@pytest.mark.parametrize("status", [408, 429, 500, 502, 503, 504])
def test_a_busy_server_is_asked_again(
    status: int, site: Site, client: Client, tmp_path: Path, waits: Waits
) -> None:
    site.put("/a.tgz", BODY, fail=[status, status])
    assert get(client, tmp_path).sha256 == SHA256
    assert waits == [1.0, 2.0]


def test_it_waits_as_long_as_asked_within_reason(
    site: Site, client: Client, tmp_path: Path, waits: Waits
) -> None:
    site.put("/a.tgz", BODY, fail=[429], headers={"Retry-After": "7"})
    get(client, tmp_path)
    site.put("/b", BODY, fail=[429], headers={"Retry-After": "9999"})
    get(client, tmp_path, "/b")
    site.put("/c", BODY, fail=[429], headers={"Retry-After": "Fri, 31 Dec 2999 23:59:59 GMT"})
    get(client, tmp_path, "/c")
    assert waits == [7.0, client_module.LONGEST_WAIT_S, 1.0]


@pytest.mark.parametrize("status", [403, 404, 410])
def test_what_is_not_there_is_asked_for_once(
    status: int, site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", fail=[status])
    with pytest.raises(NotThere, match=f"is not there \\(answer {status}\\)"):
        get(client, tmp_path)
    assert site.count("/a.tgz") == 1
    assert os.listdir(tmp_path) == []


def test_a_refusal_is_told(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", fail=[401])
    assert refused(client, tmp_path) == "the server refuses (answer 401)"
    site.put("/b", BODY, headers={"Content-Encoding": "gzip"})
    assert "packed in a way" in refused(client, tmp_path, "/b")


def test_a_server_that_is_not_there_is_told(tmp_path: Path, waits: Waits) -> None:
    client = Client("http://127.0.0.1:9", timeout_s=2.0, attempts=3, wait=waits)
    assert refused(client, tmp_path).startswith("cannot be reached (")
    assert len(waits) == 2


@pytest.mark.parametrize(
    "known",
    [
        {"digest": ("sha256", "0" * 64)},
        {"digest": ("git", "0" * 40)},
        {"etag_is_md5": True},
    ],
)
def test_a_wrong_checksum_is_never_taken(
    known: dict[str, object], site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY, etag='"' + "0" * 32 + '"')
    problem = refused(client, tmp_path, **known)
    assert problem == "its checksum is not the one its source states (4 tries)"
    assert os.listdir(tmp_path) == []


def test_the_right_checksum_is_taken(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", BODY)
    git = hashlib.sha1(b"blob %d\0" % len(BODY) + BODY).hexdigest()
    for known in ({"digest": ("sha256", SHA256)}, {"digest": ("git", git)}, {"etag_is_md5": True}):
        get(client, tmp_path, **known).discard()
    site.put("/a.tgz", BODY, etag=f'"{"0" * 32}-7"')  # sent to S3 in pieces: no MD5
    get(client, tmp_path, etag_is_md5=True)


def test_damage_on_the_way_is_mended_by_another_try(
    site: Site, client: Client, tmp_path: Path
) -> None:
    served = site.put("/a.tgz", BODY, cut_after=100_000, cuts=1)
    tag = served.tag()
    with pytest.raises(AssetError):
        download(Client(site.base, attempts=1), Wanted(f"{site.base}/a.tgz"), tmp_path)
    (part,) = tmp_path.glob("*.part")
    part.write_bytes(b"x" * 100_000)  # the disk has forgotten it
    assert served.tag() == tag
    assert get(client, tmp_path, digest=("sha256", SHA256)).path.read_bytes() == BODY


def test_a_huge_file_is_refused_before_it_comes(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", BODY, says_length=10**15)
    assert refused(client, tmp_path) == "has 1000000000 MB, more than 2000 MB"
    assert os.listdir(tmp_path) == []


def test_a_file_without_a_length_is_counted(
    site: Site, client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    site.put("/a.tgz", BODY, says_length=-1)
    assert get(client, tmp_path).path.read_bytes() == BODY
    monkeypatch.setattr(download_module, "MAX_FILE_BYTES", 300_000)
    site.put("/b", BODY, says_length=-1)
    assert refused(client, tmp_path, "/b") == "is larger than 300000 bytes"


def test_a_size_that_is_not_the_lists_is_refused(
    site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", BODY)
    assert "its list says 5" in refused(client, tmp_path, size=5)
    site.put("/b", BODY, says_length=-1)
    assert refused(client, tmp_path, "/b", size=5) == "is larger than 5 bytes"
    site.put("/c", BODY, says_length=-1)
    assert f"has {len(BODY)} bytes, expected" in refused(client, tmp_path, "/c", size=10**6)
    assert not list(tmp_path.glob("*.part"))


def test_a_full_disk_is_told_before_it_is_full(
    site: Site, client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    site.put("/a.tgz", BODY)
    monkeypatch.setattr(download_module, "SPARE_BYTES", 10**18)
    with pytest.raises(SdgenError, match=r"needed, .* free; free some space"):
        get(client, tmp_path)


def test_redirects_stay_at_the_source(site: Site, client: Client, tmp_path: Path) -> None:
    site.put("/a.tgz", status=302, headers={"Location": "/über?x=1"})
    site.put("/%C3%BCber?x=1", BODY)
    # Headers are Latin-1: what servers put there is quoted before it is asked for.
    site.files["/a.tgz"].headers["Location"] = "/%C3%BCber?x=1"
    assert get(client, tmp_path).path.read_bytes() == BODY
    site.put("/loop", status=302, headers={"Location": "/loop"})
    assert refused(client, tmp_path, "/loop") == "redirects more than 5 times"


@pytest.mark.parametrize(
    "target",
    [
        "http://elsewhere.example/a.tgz",
        "https://elsewhere.example/a.tgz",
        "https://evil-cdn.example/a.tgz",
        "https://cdn.example.evil/a.tgz",
        "https://user@good.cdn.example/a.tgz",
        "https://good.cdn.example:8443/a.tgz",
        "http://good.cdn.example/a.tgz",
        "http://127.0.0.1:1/a.tgz",
        "https://127.0.0.1/a.tgz",
        "file:///etc/passwd",
        "ftp://good.cdn.example/a.tgz",
        "data:text/plain,evil",
        "http://[/",
    ],
)
def test_redirects_go_nowhere_else(target: str, site: Site, waits: Waits, tmp_path: Path) -> None:
    client = Client(site.base, [".cdn.example", "one.example"], attempts=2, wait=waits)
    site.put("/a.tgz", status=302, headers={"Location": target})
    assert "sends us to" in refused(client, tmp_path)
    assert os.listdir(tmp_path) == []


def test_redirects_to_listed_hosts_are_followed() -> None:
    client = Client("https://source.example", [".cdn.example", "one.example"])
    for target in (
        "https://eu.cdn.example/a?sig=1",
        "https://one.example/",
        "https://source.example/b",
    ):
        assert client._may_go(target)
    for target in ("https://cdn.example/", "https://two.one.example/", "http://source.example/b"):
        assert not client._may_go(target)


@pytest.mark.parametrize("base", ["file:///etc", "ftp://host/x", "https://", "https://me@host/"])
def test_a_source_is_asked_by_http_only(base: str) -> None:
    with pytest.raises(AssetError, match=r"is no http\(s\) address"):
        Client(base)


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"garbage\r\n\r\n",
        b"HTTP/1.1 999 Odd\r\n\r\n",
        b"HTTP/1.1 200 " + b"x" * 70_000 + b"\r\n\r\n",
        b"HTTP/1.1 200 OK\r\n" + b"A: b\r\n" * 200 + b"\r\n",
        b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nZZ\r\nhello",
        b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nff\r\nhello",
        b"HTTP/1.1 206 Part\r\nContent-Range: bytes 0-4/5\r\nContent-Length: 5\r\n\r\nhello",
        b"HTTP/1.1 200 OK\r\nContent-Length: 500\r\n\r\nhello",
        b"HTTP/1.1 302 Found\r\n\r\n",
        b"HTTP/1.1 302 Found\r\nLocation: \xff\xfe\r\n\r\n",
        b"HTTP/1.1 304 Not Modified\r\n\r\n",
        b"HTTP/1.1 416 Range\r\nContent-Length: 0\r\n\r\n",
    ],
)
def test_an_answer_that_makes_no_sense_is_one_clear_error(
    raw: bytes, site: Site, client: Client, tmp_path: Path
) -> None:
    site.put("/a.tgz", raw=raw)
    assert len(refused(client, tmp_path)) < 200
    with pytest.raises(AssetError):
        client.json(f"{site.base}/a.tgz")


def test_changes_are_noticed_without_fetching(site: Site, client: Client) -> None:
    site.put("/a.tgz", BODY)
    wanted, tag = Wanted(f"{site.base}/a.tgz"), site.files["/a.tgz"].tag()
    assert not changed(client, wanted, tag, len(BODY))
    site.put("/a.tgz", BODY[::-1])
    assert changed(client, wanted, tag, len(BODY))
    # A server that has only dates, and answers in full whatever one has (as Gazebo Fuel does).
    date = {"Last-Modified": "Tue, 01 Sep 2020 10:00:00 GMT"}
    site.put("/a.tgz", BODY, etag=None, headers=date)
    assert not changed(client, wanted, date["Last-Modified"], len(BODY))
    assert changed(client, wanted, "Tue, 01 Sep 2019 10:00:00 GMT", len(BODY))
    # One that has nothing but the length.
    site.put("/a.tgz", BODY, etag=None)
    assert not changed(client, wanted, "", len(BODY))
    assert changed(client, wanted, "", len(BODY) + 1)


def test_lists_are_read_page_by_page(site: Site, client: Client, waits: Waits) -> None:
    site.put("/list", b'[1, "\xc3\xbc"]', headers={"Link": '</list?2>; rel="next"'}, fail=[503])
    assert client.json(f"{site.base}/list") == ([1, "ü"], f"{site.base}/list?2")
    assert waits == [1.0]
    for body in (b"", b"<html>", b"[" * 100_000, b"\xff\xff"):
        site.put("/bad", body)
        with pytest.raises(AssetError, match="is no JSON"):
            client.json(f"{site.base}/bad")
    site.put("/away", b"[]", headers={"Link": '<https://evil.example/2>; rel="next"'})
    with pytest.raises(AssetError, match="goes on at another host"):
        client.json(f"{site.base}/away")


def test_lists_are_of_bounded_length(
    site: Site, client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(client_module, "MAX_LIST_BYTES", 1000)
    site.put("/list", b"[" + b" " * 100_000 + b"]")
    with pytest.raises(AssetError, match="more than 20 MB"):
        client.json(f"{site.base}/list")
