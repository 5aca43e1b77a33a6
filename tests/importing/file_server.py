"""A server on this machine that behaves as sources do, and as badly as they may."""

from __future__ import annotations

import contextlib
import hashlib
import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any


@dataclass
class Served:
    """What one path answers: a body, and how badly.

    ``cut_after`` bytes of each answer the connection is closed, ``cuts`` times; ``fail`` holds
    statuses to answer first. ``stall`` waits instead of closing, until the client has enough.
    """

    body: bytes = b""
    status: int = 200
    headers: dict[str, str] = field(default_factory=dict)
    etag: str | None = ""  # "": of the body's MD5; None: no ETag
    ranges: bool = True
    cut_after: int = 0
    cuts: int = 0
    stall: bool = False
    fail: list[int] = field(default_factory=list)
    says_length: int | None = None
    says_range: str = ""
    raw: bytes | None = None  # all of the answer, status line and headers too

    def tag(self) -> str:
        """The ETag's header."""
        made = f'"{hashlib.md5(self.body).hexdigest()}"'
        return made if self.etag == "" else self.etag or ""


@dataclass
class Site:
    """Its address, its files by path (with the query), and the requests it got."""

    base: str = ""
    files: dict[str, Served] = field(default_factory=dict)
    asked: list[tuple[str, dict[str, str]]] = field(default_factory=list)
    over: threading.Event = field(default_factory=threading.Event)

    def put(self, path: str, body: bytes = b"", **how: Any) -> Served:
        """Serve a file."""
        self.files[path] = Served(body, **how)
        return self.files[path]

    def count(self, path: str) -> int:
        """Requests for a path."""
        return sum(one == path for one, _ in self.asked)


@contextmanager
def serving() -> Iterator[Site]:
    """A site, served while the block runs."""
    site = Site()

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def log_message(self, *args: object) -> None:
            pass

        def do_GET(self) -> None:
            site.asked.append((self.path, {k.lower(): v for k, v in self.headers.items()}))
            served = site.files.get(self.path)
            self.close_connection = True
            if served is not None and served.raw is not None:
                self.wfile.write(served.raw)
                return
            if served is None or served.fail:
                status = served.fail.pop(0) if served else 404
                self.send_response(status)
                for name, value in (served.headers if served else {}).items():
                    self.send_header(name, value)
                self.send_header("Content-Length", "0")
                self.end_headers()
                return
            self._answer(served)

        def _answer(self, served: Served) -> None:
            tag, start, status = served.tag(), 0, served.status
            if tag and self.headers.get("If-None-Match") == tag:
                status = 304
            wanted = re.fullmatch(r"bytes=(\d+)-", self.headers.get("Range") or "")
            if wanted and served.ranges and self.headers.get("If-Range") in (None, tag):
                start, status = int(wanted[1]), 206
                if start >= len(served.body):
                    start, status = len(served.body), 416
            body = b"" if status == 304 else served.body[start:]
            self.send_response(status)
            length = len(body) if served.says_length is None else served.says_length
            if length >= 0:
                self.send_header("Content-Length", str(length))
            if status == 206:
                end = len(served.body)
                told = served.says_range or f"bytes {start}-{end - 1}/{end}"
                self.send_header("Content-Range", told)
            if tag:
                self.send_header("ETag", tag)
            for name, value in served.headers.items():
                self.send_header(name, value)
            self.end_headers()
            if served.cuts > 0:
                served.cuts -= 1
                self.wfile.write(body[: served.cut_after])
                self.wfile.flush()
                if served.stall:
                    site.over.wait(20)
                self.connection.close()
                return
            with contextlib.suppress(OSError):  # the client has read enough
                self.wfile.write(body)

    class Server(ThreadingHTTPServer):
        daemon_threads = True

        def handle_error(self, *args: object) -> None:
            pass

    server = Server(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    site.base = f"http://127.0.0.1:{server.server_address[1]}"
    try:
        yield site
    finally:
        site.over.set()
        server.shutdown()
        server.server_close()
        thread.join()
